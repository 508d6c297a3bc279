// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOneToOneSweep.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Describe.h"
#include "Core/Solids/FaceQuads.h"
#include "Core/Solids/FoundTarget.h"
#include "Core/Solids/SolidCage.h"
#include "Core/Solids/SolidInput.h"
#include "Core/Solids/SourceQuads.h"
#include "Core/Solids/TargetFaces.h"
#include "HexSweepArrays.h"
#include "HexSweepBoundaryGrid.h"
#include "HexSweepLayers.h"
#include "HexSweepLinkingReport.h"
#include "HexSweepLists.h"
#include "HexSweepRun.h"
#include "HexSweepSolidQuads.h"
#include "HexSweepSolidReader.h"
#include "HexSweepVolumeId.h"
#include "HexSweepWriter.h"

#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkOneToOneSweep);

namespace
{
using namespace hexsweep;

std::vector<InteriorStep> stagesOf(const SolidCage& cage)
{
  std::vector<InteriorStep> stages;
  for (const auto& [name, seconds] : cage.seconds)
  {
    stages.push_back({ name, 0, 0, seconds });
  }
  return stages;
}

void addReports(const SolidCage& cage, const SolidSurface& solid, const SweepTopology& topology,
  const std::string& quadsFrom, vtkFieldData* fieldData)
{
  addReport(fieldData, reports::SourceQuads, quadsFrom);
  addIds(fieldData, reports::SourceFaceIds, topology.sourceFaceIds);
  addIds(fieldData, reports::TargetFaceIds, topology.targetFaceIds);
  addReport(fieldData, reports::MergedPoints, solid.mergedPoints);
  addLinkingReport(fieldData, cage.linking);
  addReport(fieldData, reports::InvertedQuads, cage.projection.quality.inverted);
  addReport(fieldData, reports::MaximumSourceDistance, cage.greatestDistance);
}
}

//------------------------------------------------------------------------------
vtkOneToOneSweep::vtkOneToOneSweep()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkOneToOneSweep::FillInputPortInformation(int port, vtkInformation* info)
{
  // Composite data come here too, to be refused in words instead of block by block.
  acceptSurfaces(info);
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

//------------------------------------------------------------------------------
void vtkOneToOneSweep::AddSourceFaceId(vtkIdType id)
{
  addToList(this, this->SourceFaceIds, id);
}

//------------------------------------------------------------------------------
void vtkOneToOneSweep::RemoveAllSourceFaceIds()
{
  clearList(this, this->SourceFaceIds);
}

//------------------------------------------------------------------------------
vtkIdType vtkOneToOneSweep::GetSourceFaceId(int i) const
{
  return this->SourceFaceIds.at(static_cast<std::size_t>(i));
}

//------------------------------------------------------------------------------
void vtkOneToOneSweep::AddTargetFaceId(vtkIdType id)
{
  addToList(this, this->TargetFaceIds, id);
}

//------------------------------------------------------------------------------
void vtkOneToOneSweep::RemoveAllTargetFaceIds()
{
  clearList(this, this->TargetFaceIds);
}

//------------------------------------------------------------------------------
vtkIdType vtkOneToOneSweep::GetTargetFaceId(int i) const
{
  return this->TargetFaceIds.at(static_cast<std::size_t>(i));
}

//------------------------------------------------------------------------------
int vtkOneToOneSweep::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(this, outputs, [&] { this->Execute(inputs, outputs); });
}

//------------------------------------------------------------------------------
void vtkOneToOneSweep::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  for (const int port : { 0, 1 })
  {
    if (vtkCompositeDataSet::GetData(inputs[port], 0))
    {
      throw InvalidInput(std::string("the ") + (port == 0 ? "solid comes" : "source quads come") +
        " as a composite data set. Sweep one volume at a time: extract its block (in "
        "ParaView: Extract Block, then Merge Blocks).");
    }
  }
  if (isIdleRank(outputs, inputs, { "solid", "source quads" }))
  {
    return;
  }
  const LayerRequest layers = requestedLayers(this);
  StageClock clock;
  vtkDataSet* solidData = inputDataSet(inputs, 0);
  const SolidInput input = readSolid(solidData, chosenArray(this)).surface;
  clock.finish("Read");
  reportProgress(pipelineProgress(this), 0.02);

  SolidOptions options;
  options.matchTolerance = this->MatchTolerance;
  options.featureAngle = this->FeatureAngle * Pi / 180.0;
  const SolidSurface solid = makeSolidSurface(input, options);
  const SweepTopology topology =
    findSweepTopology(solid, { this->SourceFaceIds.begin(), this->SourceFaceIds.end() },
      { this->TargetFaceIds.begin(), this->TargetFaceIds.end() });
  clock.finish("Topology");
  reportProgress(pipelineProgress(this), 0.05);

  SourceCapQuads quads = sourceQuads(inputDataSet(inputs, 1), solidData, input, solid, topology,
    this->QuadSize, pipelineProgress(this, 0.05, 0.15));
  clock.finish("Source quads");
  SolidCageInput cageInput{ solid, topology, std::move(quads.mesh),
    sidePatches(input, solid, topology), {}, this->MatchTolerance,
    this->OutputPointsPrecision == SINGLE_PRECISION, this->EnsureValid, this->ImproveQuality };
  cageInput.layers = layers;
  const SolidCage cage = makeSolidCage(cageInput, pipelineProgress(this, 0.15, 0.5));
  clock.finish(stagesOf(cage));
  if (this->TargetFaceIds.empty())
  {
    checkFoundTarget(cage.boundary, topology.targetFaceIds);
  }

  HexOutputSettings settings;
  settings.method = this->Method;
  settings.ensureValid = this->EnsureValid;
  settings.improveQuality = this->ImproveQuality;
  settings.certify = this->Certify;
  settings.failIfInvalid = this->FailIfInvalid;
  settings.precision = this->OutputPointsPrecision;
  auto* output = vtkUnstructuredGrid::GetData(outputs, 0);
  auto* boundary = vtkUnstructuredGrid::GetData(outputs, 1);
  output->GetFieldData()->PassData(solidData->GetFieldData());
  boundary->GetFieldData()->PassData(solidData->GetFieldData());
  const HexOutput hexes =
    writeHexes(cage, quads.attributes, settings, clock, pipelineProgress(this, 0.5, 0.97), output);
  writeBoundary(cage, solid, topology, hexes.sourceIsBottom, output, boundary);
  carryVolumeId(solidData, output);

  addReports(cage, solid, topology, quads.origin, output->GetFieldData());
  clock.finish("Output");
  clock.report(output->GetFieldData());

  std::vector<std::string> warnings = linkingWarnings(cage.linking);
  if (quads.inverted > 0)
  {
    warnings.push_back(std::to_string(quads.inverted) +
      " of the quads that were made on the source cap are inverted: edges of length " +
      describe(quads.size) +
      " are too long for its holes or walls. Set QuadSize to a smaller length, or give quads of "
      "the source cap.");
  }
  warnings.push_back(describeMismatch(
    cage.projection.sourceMismatch, "source cap of the solid", "boundary of the source quads"));
  warnings.insert(warnings.end(), hexes.warnings.begin(), hexes.warnings.end());
  constexpr double CoarseTurn = 30.0;
  const double facetTurn = greatestFacetTurn(solid, topology);
  if (facetTurn > CoarseTurn && !hexes.warnings.empty())
  {
    warnings.push_back("the triangles of the solid turn by up to " +
      describe(std::round(facetTurn)) +
      " degrees from facet to facet round a curve of the source cap, which bends the quads on it. "
      "Export the solid with finer triangles on its curves.");
  }
  if (this->TargetFaceIds.empty() && !hexes.warnings.empty())
  {
    warnings.push_back("no target face was named, and face " +
      std::to_string(topology.targetFaceIds.front()) +
      " was found to fit. If the sweep is not meant to end there, name its target.");
  }
  for (const std::string& warning : warnings)
  {
    if (!warning.empty())
    {
      vtkWarningMacro(<< warning);
    }
  }
}

//------------------------------------------------------------------------------
void vtkOneToOneSweep::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  printList(os, indent, "SourceFaceIds", this->SourceFaceIds);
  printList(os, indent, "TargetFaceIds", this->TargetFaceIds);
  os << indent << "QuadSize: " << this->QuadSize << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MatchTolerance: " << this->MatchTolerance << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "EnsureValid: " << (this->EnsureValid ? "On" : "Off") << "\n";
  os << indent << "ImproveQuality: " << (this->ImproveQuality ? "On" : "Off") << "\n";
  os << indent << "Certify: " << (this->Certify ? "On" : "Off") << "\n";
  os << indent << "FailIfInvalid: " << (this->FailIfInvalid ? "On" : "Off") << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
