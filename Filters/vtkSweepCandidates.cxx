// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSweepCandidates.h"

#include "Core/Common/Constants.h"
#include "Core/Solids/SolidInput.h"
#include "Core/Solids/SweepCandidates.h"
#include "HexSweepArrays.h"
#include "HexSweepChoices.h"
#include "HexSweepLists.h"
#include "HexSweepRun.h"
#include "HexSweepSolidReader.h"
#include "HexSweepWriter.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

vtkStandardNewMacro(vtkSweepCandidates);

namespace
{
std::string textOf(const std::vector<hexsweep::Index>& ids)
{
  std::string text;
  for (const hexsweep::Index id : ids)
  {
    text += (text.empty() ? "" : " ") + std::to_string(id);
  }
  return text;
}

void addRows(const hexsweep::SweepCandidates& candidates, vtkTable* table)
{
  vtkNew<vtkIdTypeArray> ranks;
  vtkNew<vtkStringArray> sources;
  vtkNew<vtkStringArray> targets;
  vtkNew<vtkDoubleArray> scores;
  vtkNew<vtkStringArray> verdicts;
  vtkNew<vtkStringArray> reasons;
  ranks->SetName("Rank");
  sources->SetName("SourceFaceIds");
  targets->SetName("TargetFaceIds");
  scores->SetName("Score");
  verdicts->SetName("Verdict");
  reasons->SetName("Reasons");
  for (const hexsweep::SweepCandidate& candidate : candidates.list)
  {
    ranks->InsertNextValue(ranks->GetNumberOfValues() + 1);
    sources->InsertNextValue(textOf(candidate.sourceFaceIds));
    targets->InsertNextValue(textOf(candidate.targetFaceIds));
    scores->InsertNextValue(candidate.score);
    verdicts->InsertNextValue(verdictOn(candidate));
    reasons->InsertNextValue(candidate.reasons);
  }
  table->AddColumn(ranks);
  table->AddColumn(sources);
  table->AddColumn(targets);
  table->AddColumn(scores);
  table->AddColumn(verdicts);
  table->AddColumn(reasons);
}
}

//------------------------------------------------------------------------------
int vtkSweepCandidates::FillInputPortInformation(int, vtkInformation* info)
{
  hexsweep::acceptSurfaces(info);
  return 1;
}

//------------------------------------------------------------------------------
void vtkSweepCandidates::AddSourceFaceId(vtkIdType id)
{
  hexsweep::addToList(this, this->SourceFaceIds, id);
}

//------------------------------------------------------------------------------
void vtkSweepCandidates::RemoveAllSourceFaceIds()
{
  hexsweep::clearList(this, this->SourceFaceIds);
}

//------------------------------------------------------------------------------
vtkIdType vtkSweepCandidates::GetSourceFaceId(int i) const
{
  return this->SourceFaceIds.at(static_cast<std::size_t>(i));
}

//------------------------------------------------------------------------------
int vtkSweepCandidates::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return hexsweep::runFilter(this, outputs, [&] {
    if (hexsweep::isIdleRank(outputs, inputs, { "solid" }))
    {
      return;
    }
    hexsweep::checkFeatureAngle(this->FeatureAngle);
    hexsweep::SolidOptions options;
    options.matchTolerance = this->MatchTolerance;
    options.featureAngle = this->FeatureAngle * hexsweep::Pi / 180.0;
    const hexsweep::SolidSurface solid = hexsweep::makeSolidSurface(
      hexsweep::readSolid(hexsweep::inputDataSet(inputs, 0), hexsweep::chosenArray(this)).surface,
      options);
    const hexsweep::SweepCandidates candidates = this->SourceFaceIds.empty()
      ? hexsweep::findSweepCandidates(solid)
      : hexsweep::findTargetCandidates(
          solid, { this->SourceFaceIds.begin(), this->SourceFaceIds.end() });
    vtkTable* table = vtkTable::GetData(outputs);
    addRows(candidates, table);
    hexsweep::addReport(table->GetFieldData(), hexsweep::reports::CandidatesCut,
      static_cast<hexsweep::Index>(candidates.cut));
  });
}

//------------------------------------------------------------------------------
void vtkSweepCandidates::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  hexsweep::printList(os, indent, "SourceFaceIds", this->SourceFaceIds);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MatchTolerance: " << this->MatchTolerance << "\n";
}
