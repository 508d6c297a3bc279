// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepQualityArrays.h"

#include "HexSweepWriter.h"

#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>

namespace hexsweep
{
QualityArrays::QualityArrays(vtkIdType cells)
{
  this->ScaledJacobian->SetName("ScaledJacobian");
  this->ScaledJacobian->SetNumberOfValues(cells);
  this->LowerBound->SetName("JacobianLowerBound");
  this->LowerBound->SetNumberOfValues(cells);
  this->Verdict->SetName("Validity");
  this->Verdict->SetNumberOfValues(cells);
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
  addReport(fieldData, "SweepReportHexes", summary.hexes);
  addReport(fieldData, "SweepReportInverted", summary.inverted);
  addReport(fieldData, "SweepReportInvertedInside", summary.invertedInside);
  addReport(fieldData, "SweepReportDegenerate", summary.degenerate);
  addReport(fieldData, "SweepReportUndecided", summary.undecided);
  addReport(fieldData, "SweepReportNotCertified", summary.notCertified);
  addReport(fieldData, "SweepReportMinScaledJacobian", summary.minScaledJacobian);
  addReport(fieldData, "SweepReportMeanScaledJacobian", summary.meanScaledJacobian);
  addReport(fieldData, "SweepReportMinJacobianLowerBound", summary.minJacobianLowerBound);
}
}
