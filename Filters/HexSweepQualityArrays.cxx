// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepQualityArrays.h"

#include "HexSweepArrays.h"
#include "HexSweepMemory.h"
#include "HexSweepWriter.h"

#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>

namespace hexsweep
{
QualityArrays::QualityArrays(vtkIdType cells)
{
  this->ScaledJacobian->SetName(arrays::ScaledJacobian);
  setTuples(this->ScaledJacobian.Get(), cells);
  this->LowerBound->SetName(arrays::JacobianLowerBound);
  setTuples(this->LowerBound.Get(), cells);
  this->Verdict->SetName(arrays::Validity);
  setTuples(this->Verdict.Get(), cells);
}

HexQuality QualityArrays::quality(vtkIdType cell) const
{
  HexQuality quality;
  quality.scaledJacobian = this->ScaledJacobian->GetValue(cell);
  quality.jacobianLowerBound = this->LowerBound->GetValue(cell);
  quality.validity = static_cast<Validity>(this->Verdict->GetValue(cell));
  return quality;
}

void QualityArrays::addTo(vtkDataSetAttributes* cellData) const
{
  cellData->AddArray(this->ScaledJacobian);
  cellData->AddArray(this->LowerBound);
  cellData->AddArray(this->Verdict);
}

void addQualityReport(vtkFieldData* fieldData, const HexQualitySummary& summary)
{
  addReport(fieldData, reports::Hexes, summary.hexes);
  addReport(fieldData, reports::Inverted, summary.inverted);
  addReport(fieldData, reports::InvertedInside, summary.invertedInside);
  addReport(fieldData, reports::Degenerate, summary.degenerate);
  addReport(fieldData, reports::Undecided, summary.undecided);
  addReport(fieldData, reports::NotCertified, summary.notCertified);
  addReport(fieldData, reports::MinScaledJacobian, summary.minScaledJacobian);
  addReport(fieldData, reports::MeanScaledJacobian, summary.meanScaledJacobian);
  addReport(fieldData, reports::MinJacobianLowerBound, summary.minJacobianLowerBound);
}
}
