// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSweepCandidates.h"

#include "Core/Solids/SweepCandidates.h"
#include "HexSweepArrays.h"
#include "HexSweepBodies.h"
#include "HexSweepLists.h"
#include "HexSweepRun.h"
#include "HexSweepSolidPort.h"
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

/// A body's own ways to sweep it.
struct RankedBody
{
  hexsweep::Index volumeId = 0;
  hexsweep::SweepCandidates candidates;
};

/// @param sourceFaceIds empty: any source.
RankedBody rankedBody(
  const hexsweep::ReadBody& body, const std::vector<hexsweep::Index>& sourceFaceIds)
{
  return hexsweep::aboutBody(body, [&] {
    RankedBody ranked{ body.volumeId,
      sourceFaceIds.empty() ? hexsweep::findSweepCandidates(body.surface)
                            : hexsweep::findTargetCandidates(body.surface, sourceFaceIds) };
    for (hexsweep::SweepCandidate& candidate : ranked.candidates.list)
    {
      candidate.reasons = hexsweep::reflectedPlaces(candidate.reasons, body.solid.reflection);
    }
    return ranked;
  });
}

void addRows(const std::vector<RankedBody>& bodies, vtkTable* table)
{
  vtkNew<vtkIdTypeArray> volumes;
  vtkNew<vtkIdTypeArray> ranks;
  vtkNew<vtkStringArray> sources;
  vtkNew<vtkStringArray> targets;
  vtkNew<vtkDoubleArray> scores;
  vtkNew<vtkStringArray> verdicts;
  vtkNew<vtkStringArray> reasons;
  volumes->SetName(hexsweep::arrays::VolumeId);
  ranks->SetName("Rank");
  sources->SetName("SourceFaceIds");
  targets->SetName("TargetFaceIds");
  scores->SetName("Score");
  verdicts->SetName("Verdict");
  reasons->SetName("Reasons");
  for (const RankedBody& body : bodies)
  {
    vtkIdType rank = 0;
    for (const hexsweep::SweepCandidate& candidate : body.candidates.list)
    {
      volumes->InsertNextValue(body.volumeId);
      ranks->InsertNextValue(++rank);
      sources->InsertNextValue(textOf(candidate.sourceFaceIds));
      targets->InsertNextValue(textOf(candidate.targetFaceIds));
      scores->InsertNextValue(candidate.score);
      verdicts->InsertNextValue(verdictOn(candidate));
      reasons->InsertNextValue(candidate.reasons);
    }
  }
  table->AddColumn(ranks);
  table->AddColumn(sources);
  table->AddColumn(targets);
  table->AddColumn(scores);
  table->AddColumn(verdicts);
  table->AddColumn(reasons);
  table->AddColumn(volumes);
}
}

//------------------------------------------------------------------------------
int vtkSweepCandidates::FillInputPortInformation(int, vtkInformation* info)
{
  hexsweep::acceptSolids(info);
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
    const hexsweep::SolidPort port = hexsweep::readSolidPort(inputs, 0, false);
    if (hexsweep::isIdleRank(outputs, { { port.data, "solid" } }))
    {
      return;
    }
    const std::vector<hexsweep::ReadBody> bodies =
      hexsweep::readBodies(port.data, hexsweep::chosenArray(this),
        hexsweep::solidOptions(this->MatchTolerance, this->FeatureAngle));
    hexsweep::checkAreSolids(bodies);
    const std::vector<hexsweep::Index> sources(
      this->SourceFaceIds.begin(), this->SourceFaceIds.end());
    hexsweep::checkNamedFaces(bodies, sources);
    std::vector<RankedBody> ranked;
    bool cut = false;
    for (const hexsweep::ReadBody& body : bodies)
    {
      const std::vector<hexsweep::Index> own = hexsweep::facesOnBody(body, sources);
      if (sources.empty() || !own.empty())
      {
        ranked.push_back(rankedBody(body, own));
        cut = cut || ranked.back().candidates.cut;
      }
    }
    vtkTable* table = vtkTable::GetData(outputs);
    addRows(ranked, table);
    hexsweep::addReport(
      table->GetFieldData(), hexsweep::reports::CandidatesCut, static_cast<hexsweep::Index>(cut));
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
