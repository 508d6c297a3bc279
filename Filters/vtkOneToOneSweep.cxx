// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOneToOneSweep.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Describe.h"
#include "Core/Solids/SolidInput.h"
#include "Core/Solids/SweepChoice.h"
#include "HexSweepArrays.h"
#include "HexSweepChoices.h"
#include "HexSweepLayers.h"
#include "HexSweepLists.h"
#include "HexSweepReader.h"
#include "HexSweepRun.h"
#include "HexSweepSolidReader.h"
#include "HexSweepSolidSweep.h"
#include "HexSweepWriter.h"

#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkUnstructuredGrid.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkOneToOneSweep);

namespace
{
using namespace hexsweep;

using Sweep = std::function<SolidSweepResult(
  const SweepTopology& topology, vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary)>;

double badHexes(vtkUnstructuredGrid* hexes)
{
  return hexes->GetFieldData()->GetArray(reports::NotCertified)->GetTuple1(0);
}

/**
 * Tries one sweep after the other until one gives a valid mesh; else the one with the fewest bad
 * hexahedra is taken.
 *
 * @return what to tell the user.
 * @throw InvalidInput when none gives a mesh.
 */
std::vector<std::string> bestOfSweeps(const SweepChoice& choice, const Sweep& sweep,
  vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary)
{
  std::vector<std::string> warnings;
  std::string failed;
  bool found = false;
  for (const SweepTopology& topology : choice.sweeps)
  {
    const std::string way = describeWay(topology.sourceFaceIds, topology.targetFaceIds);
    vtkNew<vtkUnstructuredGrid> newHexes;
    vtkNew<vtkUnstructuredGrid> newBoundary;
    try
    {
      const SolidSweepResult result = sweep(topology, newHexes, newBoundary);
      if (result.valid || !found || badHexes(newHexes) < badHexes(hexes))
      {
        hexes->ShallowCopy(newHexes);
        boundary->ShallowCopy(newBoundary);
        warnings = result.warnings;
        if (!failed.empty())
        {
          warnings.insert(warnings.begin(),
            "no source face is named, and this is the sweep " + way +
              ", since others that looked better did not work:" + failed +
              " Name SourceFaceIds if another sweep is meant.");
        }
        found = true;
      }
      if (result.valid)
      {
        return warnings;
      }
      failed +=
        " " + way + " has " + describe(badHexes(newHexes)) + " hexahedra that are not certified.";
    }
    catch (const InvalidInput& error)
    {
      failed += " " + way + ": " + error.what();
    }
    catch (const SolverFailure& error)
    {
      failed += " " + way + ": " + error.what();
    }
  }
  if (!found)
  {
    throw InvalidInput("no source face is named, and of the sweeps that look best none works:" +
      failed + " Name SourceFaceIds and TargetFaceIds if another sweep is meant.");
  }
  return warnings;
}
}

//------------------------------------------------------------------------------
vtkOneToOneSweep::vtkOneToOneSweep()
{
  this->SetNumberOfLayers(0);
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkOneToOneSweep::FillInputPortInformation(int, vtkInformation* info)
{
  // Composite data come here too, to be refused in words instead of block by block.
  acceptSurfaces(info);
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
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
  checkInteriorMethod(this->Method);
  checkPrecision(this->OutputPointsPrecision);
  checkFeatureAngle(this->FeatureAngle);
  SolidSweepSettings settings;
  settings.size = this->Size;
  settings.quadSize = this->QuadSize;
  settings.layers = requestedLayers(this, true);
  settings.matchTolerance = this->MatchTolerance;
  settings.projection = projectionMethod("ProjectionMethod", this->ProjectionMethod);
  settings.weights = chosenWeights(this->Weights);
  settings.improvement = chosenImprovement(this->ImproveTriangulation);
  settings.targetIsNamed = !this->TargetFaceIds.empty();
  settings.hexes = { this->Method, this->EnsureValid, this->ImproveQuality, this->Certify,
    this->FailIfInvalid, this->OutputPointsPrecision };
  StageClock clock;
  vtkDataSet* solidData = inputDataSet(inputs, 0);
  const SolidInput input = readSolid(solidData, chosenArray(this)).surface;
  clock.finish("Read");
  reportProgress(pipelineProgress(this), 0.02);

  SolidOptions options;
  options.matchTolerance = this->MatchTolerance;
  options.featureAngle = this->FeatureAngle * Pi / 180.0;
  const SolidSurface solid = makeSolidSurface(input, options);
  std::vector<Index> sourceIds(this->SourceFaceIds.begin(), this->SourceFaceIds.end());
  const std::optional<QuadMesh> quads = readOptionalQuads(inputDataSet(inputs, 1), "source quads");
  if (quads && sourceIds.empty())
  {
    sourceIds = facesUnder(solid, *quads);
  }
  const SweepChoice choice =
    chooseSweeps(solid, sourceIds, { this->TargetFaceIds.begin(), this->TargetFaceIds.end() });
  clock.finish("Topology");
  reportProgress(pipelineProgress(this), 0.05);

  const SolidToSweep toSweep{ solidData, inputDataSet(inputs, 1), input, solid };
  auto* hexes = vtkUnstructuredGrid::GetData(outputs, 0);
  auto* boundary = vtkUnstructuredGrid::GetData(outputs, 1);
  const auto sweep = [&](const SweepTopology& topology, vtkUnstructuredGrid* hexGrid,
                       vtkUnstructuredGrid* boundaryGrid) {
    return sweepSolid(
      toSweep, topology, settings, clock, pipelineProgress(this, 0.05, 1.0), hexGrid, boundaryGrid);
  };
  std::vector<std::string> warnings;
  if (sourceIds.empty() && this->TargetFaceIds.empty())
  {
    warnings = bestOfSweeps(choice, sweep, hexes, boundary);
  }
  else
  {
    warnings = sweep(choice.sweeps.front(), hexes, boundary).warnings;
  }
  addReport(hexes->GetFieldData(), reports::Candidates, describeRanking(choice.ranking));
  addStageReport(hexes->GetFieldData(), clock);
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
  os << indent << "Size: " << this->Size << "\n";
  os << indent << "QuadSize: " << this->QuadSize << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MatchTolerance: " << this->MatchTolerance << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "ProjectionMethod: " << this->ProjectionMethod << "\n";
  os << indent << "Weights: " << this->Weights << "\n";
  os << indent << "ImproveTriangulation: " << this->ImproveTriangulation << "\n";
  os << indent << "EnsureValid: " << (this->EnsureValid ? "On" : "Off") << "\n";
  os << indent << "ImproveQuality: " << (this->ImproveQuality ? "On" : "Off") << "\n";
  os << indent << "Certify: " << (this->Certify ? "On" : "Off") << "\n";
  os << indent << "FailIfInvalid: " << (this->FailIfInvalid ? "On" : "Off") << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
