// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHarmonicDiskMap.h"

#include "Core/CapQuads/SweepProjection.h"
#include "Core/Common/Describe.h"
#include "Core/DiskMaps/CanonicalDiskMap.h"
#include "Core/Linking/LoopMatching.h"
#include "Core/Solvers/SurfaceLaplacian.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "HexSweepBridge.h"
#include "HexSweepCapDiskGrid.h"

#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkUnstructuredGrid.h>

#include <utility>

vtkStandardNewMacro(vtkHarmonicDiskMap);

//------------------------------------------------------------------------------
vtkHarmonicDiskMap::vtkHarmonicDiskMap()
{
  this->SetNumberOfInputPorts(3);
}

//------------------------------------------------------------------------------
int vtkHarmonicDiskMap::FillInputPortInformation(int port, vtkInformation* info)
{
  hexsweep::acceptSurfaces(info);
  info->Set(INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkHarmonicDiskMap::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using namespace hexsweep;
  return runFilter(this, outputs, [&] {
    vtkDataSet* input = inputDataSet(inputs, 0);
    if (isIdleRank(outputs, inputs, { "input surface", "partner surface", "linking sides" }))
    {
      return;
    }
    if (this->HoleTreatment < KOEBE || this->HoleTreatment > FILLED)
    {
      throw InvalidInput("HoleTreatment " + std::to_string(this->HoleTreatment) +
        " does not exist. Choose Koebe (0), ArcLength (1) or Filled (2).");
    }
    if (this->ImproveTriangulation < OFF || this->ImproveTriangulation > ON)
    {
      throw InvalidInput("ImproveTriangulation " + std::to_string(this->ImproveTriangulation) +
        " does not exist. Choose Off (0), Automatic (1) or On (2).");
    }
    const auto improvement = this->ImproveTriangulation == OFF ? TriangulationImprovement::Off
      : this->ImproveTriangulation == AUTOMATIC                ? TriangulationImprovement::Automatic
                                                               : TriangulationImprovement::On;
    const SurfaceInput surface = readTriangles(input, "input surface");
    checkAreas(surface, "input surface");
    const hexsweep::Weights weights =
      this->Weights == COTANGENT ? hexsweep::Weights::Cotangent : hexsweep::Weights::MeanValue;
    const TriangleMesh mesh{ surface.points, surface.faces };
    CapDisk cap;
    std::vector<double> startFractions;
    if (vtkDataSet* partner = inputDataSet(inputs, 1))
    {
      const SurfaceInput other = readTriangles(partner, "partner surface");
      checkAreas(other, "partner surface");
      LinkedDisks linked = mapLinkedCaps(mesh, { other.points, other.faces },
        readOptionalQuads(inputDataSet(inputs, 2), "linking sides"), weights, this->MatchTolerance,
        pipelineProgress(this, 0.1, 0.9), improvement);
      cap = std::move(linked.first);
      startFractions = std::move(linked.startFractions);
      for (const std::string& warning : { describeDoubts(linked.doubts),
             describeMismatch(
               linked.mismatch, "input surface", "ring of the linking sides at this cap") })
      {
        if (!warning.empty())
        {
          vtkWarningMacro(<< warning);
        }
      }
    }
    else
    {
      cap = canonicalDiskMap({ mesh.points, orientFaces(mesh.triangles, "input surface") },
        static_cast<hexsweep::HoleTreatment>(this->HoleTreatment), weights, improvement,
        { this->Tolerance, this->MaximumIterations }, pipelineProgress(this, 0.1, 0.9));
    }
    if (!cap.koebeFailure.empty())
    {
      vtkWarningMacro(
        << "the input surface: holes are circles by arc length, as with HoleTreatment "
           "ArcLength, since Koebe's iteration cannot be used: "
        << cap.koebeFailure);
    }
    if (!cap.converged)
    {
      vtkWarningMacro(
        << "Koebe's iteration has not come to its Tolerance " << this->Tolerance << " in "
        << this->MaximumIterations << " rounds; the last one still changed centres and radii by "
        << (cap.rounds.size() > 1 ? describe(cap.rounds.back().change) : "an unknown amount")
        << " (sum of squares). Raise MaximumIterations, or improve the triangulation.");
    }
    const std::string flips = describeFlips(cap, "input surface");
    if (!flips.empty())
    {
      vtkWarningMacro(<< flips);
    }
    writeCapDisk(cap, surface, input, this->OutputPointsPrecision, this->OutputDisk,
      vtkUnstructuredGrid::GetData(outputs));
    if (!startFractions.empty())
    {
      addReport(vtkUnstructuredGrid::GetData(outputs)->GetFieldData(), "SweepReportLoopStarts",
        startFractions);
    }
    reportProgress(pipelineProgress(this), 1.0);
  });
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
