// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHarmonicDiskMap.h"

#include "Core/CapQuads/SweepProjection.h"
#include "Core/Common/Describe.h"
#include "Core/DiskMaps/CanonicalDiskMap.h"
#include "Core/Linking/LoopMatching.h"
#include "Core/Solvers/SurfaceLaplacian.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "HexSweepArrays.h"
#include "HexSweepCapDiskGrid.h"
#include "HexSweepChoices.h"
#include "HexSweepReader.h"
#include "HexSweepRun.h"
#include "HexSweepWriter.h"

#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkUnstructuredGrid.h>

#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkHarmonicDiskMap);

namespace
{
using namespace hexsweep;

struct MapSettings
{
  Weights weights;
  TriangulationImprovement improvement;
  double matchTolerance;
};

struct MappedCap
{
  CapDisk disk;
  CapDisk partner;                    ///< with a partner
  std::vector<double> startFractions; ///< see MatchedLoops
  std::vector<std::string> warnings;
};

MappedCap mapWithPartner(const TriangleMesh& cap, const TriangleMesh& partner, vtkDataSet* linking,
  const MapSettings& settings, const Progress& progress)
{
  LinkedDisks linked = mapLinkedCaps(cap, partner, readOptionalQuads(linking, "linking sides"),
    settings.weights, settings.matchTolerance, progress, settings.improvement);
  return { std::move(linked.first), std::move(linked.second), std::move(linked.startFractions),
    { describeDoubts(linked.doubts),
      describeMismatch(
        linked.mismatch, "input surface", "ring of the linking sides at this cap") } };
}

/// What to tell the user of Koebe's iteration; empty where it did what it was to do.
std::string describeKoebe(const CapDisk& cap, double tolerance, int maximumIterations)
{
  if (!cap.koebeFailure.empty())
  {
    return "the input surface: holes are circles by arc length, as with HoleTreatment ArcLength, "
           "since Koebe's iteration cannot be used: " +
      cap.koebeFailure;
  }
  if (cap.converged)
  {
    return {};
  }
  return "Koebe's iteration has not come to its Tolerance " + describe(tolerance) + " in " +
    std::to_string(maximumIterations) +
    " rounds; the last one still changed centres and radii by " +
    (cap.rounds.size() > 1 ? describe(cap.rounds.back().change) : "an unknown amount") +
    " (sum of squares). Raise MaximumIterations, or improve the triangulation.";
}
}

//------------------------------------------------------------------------------
vtkHarmonicDiskMap::vtkHarmonicDiskMap()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkHarmonicDiskMap::FillInputPortInformation(int, vtkInformation* info)
{
  acceptSurfaces(info);
  return 1;
}

//------------------------------------------------------------------------------
int vtkHarmonicDiskMap::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(this, outputs, [&] { this->Execute(inputs, outputs); });
}

//------------------------------------------------------------------------------
void vtkHarmonicDiskMap::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (isIdleRank(outputs, inputs, { "input surface", "partner surface", "linking sides" }))
  {
    return;
  }
  checkChoice("HoleTreatment", this->HoleTreatment, { "Koebe", "ArcLength", "Filled" });
  checkPrecision(this->OutputPointsPrecision);
  const MapSettings settings = { chosenWeights(this->Weights),
    chosenImprovement(this->ImproveTriangulation), this->MatchTolerance };
  vtkDataSet* input = inputDataSet(inputs, 0);
  TriangleInput surface = readTriangles(input, "input surface");
  checkAreas(surface, "input surface");
  const hexsweep::Progress progress = pipelineProgress(this, 0.1, 0.9);
  MappedCap cap;
  if (vtkDataSet* partnerData = inputDataSet(inputs, 1))
  {
    TriangleInput partner = readTriangles(partnerData, "partner surface");
    checkAreas(partner, "partner surface");
    cap = mapWithPartner(surface.mesh, partner.mesh, inputDataSet(inputs, 2), settings, progress);
    writeCapDisk(cap.partner, { partnerData, std::move(partner.cellIds), partner.ignoredCells },
      this->OutputPointsPrecision, this->OutputDisk, vtkUnstructuredGrid::GetData(outputs, 1));
  }
  else
  {
    cap.disk = canonicalDiskMap(
      { surface.mesh.points, orientFaces(surface.mesh.triangles, "input surface") },
      static_cast<hexsweep::HoleTreatment>(this->HoleTreatment), settings.weights,
      settings.improvement, { this->Tolerance, this->MaximumIterations }, progress);
  }
  cap.warnings.push_back(describeKoebe(cap.disk, this->Tolerance, this->MaximumIterations));
  cap.warnings.push_back(describeFlips(cap.disk, "input surface"));
  for (const std::string& warning : cap.warnings)
  {
    if (!warning.empty())
    {
      vtkWarningMacro(<< warning);
    }
  }
  auto* output = vtkUnstructuredGrid::GetData(outputs);
  writeCapDisk(cap.disk, { input, std::move(surface.cellIds), surface.ignoredCells },
    this->OutputPointsPrecision, this->OutputDisk, output);
  if (!cap.startFractions.empty())
  {
    addReport(output->GetFieldData(), reports::LoopStarts, cap.startFractions);
  }
  reportProgress(pipelineProgress(this), 1.0);
}

//------------------------------------------------------------------------------
void vtkHarmonicDiskMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Weights: " << this->Weights << "\n";
  os << indent << "HoleTreatment: " << this->HoleTreatment << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "ImproveTriangulation: " << this->ImproveTriangulation << "\n";
  os << indent << "OutputDisk: " << this->OutputDisk << "\n";
  os << indent << "MatchTolerance: " << this->MatchTolerance << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
