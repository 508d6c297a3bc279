// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSweepQuadProjector.h"

#include "Core/CapQuads/SweepProjection.h"
#include "Core/Common/Errors.h"
#include "Core/Linking/LinkingRings.h"
#include "Core/Surfaces/QuadHalving.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "HexSweepArrays.h"
#include "HexSweepAsking.h"
#include "HexSweepCapDiskGrid.h"
#include "HexSweepChoices.h"
#include "HexSweepMemory.h"
#include "HexSweepProjectionReport.h"
#include "HexSweepReader.h"
#include "HexSweepRun.h"
#include "HexSweepWriter.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSweepQuadProjector);

namespace
{
using namespace hexsweep;

/// The data sets on the ports.
struct Ports
{
  vtkDataSet* source;
  vtkDataSet* target;
  vtkDataSet* linking;
  vtkDataSet* sourceSurface; ///< nullptr: the source quads are the source cap
};

/// What was read, and what its cells were on the ports.
struct Caps
{
  SweepProjectionInput input;
  std::vector<Index> quadCells;
  Index ignoredCells = 0; ///< of the source quads
  CapOrigin source;
  CapOrigin target;
};

Caps readCaps(const Ports& ports)
{
  Caps caps;
  QuadInput quads = readQuads(ports.source, "source quads");
  TriangleInput target = readTriangles(ports.target, "target surface");
  if (ports.sourceSurface)
  {
    TriangleInput surface = readTriangles(ports.sourceSurface, "source surface");
    caps.input.sourceSurface = std::move(surface.mesh);
    caps.source = { ports.sourceSurface, std::move(surface.cellIds), surface.ignoredCells };
  }
  else
  {
    std::vector<Index> halves;
    halves.reserve(quads.cellIds.size() * 2);
    for (const Index id : quads.cellIds)
    {
      halves.insert(halves.end(), 2, id);
    }
    caps.source = { ports.source, std::move(halves), quads.ignoredCells };
  }
  caps.target = { ports.target, std::move(target.cellIds), target.ignoredCells };
  caps.input.source = std::move(quads.mesh);
  caps.input.target = std::move(target.mesh);
  caps.quadCells = std::move(quads.cellIds);
  caps.ignoredCells = quads.ignoredCells;
  return caps;
}

/// The rings of the linking sides, where there are any.
void traceRings(vtkDataSet* linkingSides, SweepProjectionInput& input)
{
  if (const auto linking = readOptionalQuads(linkingSides, "linking sides"))
  {
    const QuadMesh& source = input.source;
    const SurfaceTopology topology =
      checkSurface(source.quads, source.points.rows(), "source quads");
    checkCap(topology, "source quads");
    input.linking = traceLinkingRings(
      source.points, topology.loops, linking->points, linking->quads, input.matchTolerance);
  }
}

void readDisks(const Ports& ports, SweepProjectionInput& input)
{
  if (!ports.sourceSurface)
  {
    throw InvalidInput("DiskMaps is FromInput, but the source surface is missing. Connect the "
                       "source cap with its disk map to SourceSurface.");
  }
  input.sourceDisk = readCapDisk(ports.sourceSurface, "source surface");
  input.targetDisk = readCapDisk(ports.target, "target surface");
}

void checkAreas(const Caps& caps)
{
  const SweepProjectionInput& input = caps.input;
  hexsweep::checkAreas(
    input.target.points, input.target.triangles, caps.target.cellIds, "target surface");
  if (input.sourceSurface)
  {
    hexsweep::checkAreas(input.sourceSurface->points, input.sourceSurface->triangles,
      caps.source.cellIds, "source surface");
  }
  else
  {
    hexsweep::checkAreas(input.source.points, halveQuads(input.source.points, input.source.quads),
      caps.source.cellIds, "source quads");
  }
}

/// The source quads' cells and data on new points, with their quality.
void writeQuads(const SweepProjection& projection, const Caps& caps, vtkDataSet* source,
  int precision, vtkUnstructuredGrid* output)
{
  const Quads& quads = caps.input.source.quads;
  output->SetPoints(
    vtkSmartPointer<vtkPoints>::Take(newPoints(projection.quads.points, precision)));
  setCells(output, quads, VTK_QUAD);
  output->GetPointData()->PassData(source->GetPointData());
  vtkCellData* cellData = output->GetCellData();
  allocateTuples(source->GetCellData(), quads.rows(), cellData);
  vtkNew<vtkDoubleArray> jacobian;
  jacobian->SetName(arrays::ScaledJacobian);
  setTuples(jacobian.Get(), quads.rows());
  for (Index q = 0; q < quads.rows(); ++q)
  {
    cellData->CopyData(source->GetCellData(), caps.quadCells[static_cast<std::size_t>(q)], q);
    jacobian->SetValue(q, projection.quality.scaledJacobian[q]);
  }
  cellData->AddArray(jacobian);
  output->GetFieldData()->PassData(source->GetFieldData());
}
}

//------------------------------------------------------------------------------
vtkSweepQuadProjector::vtkSweepQuadProjector()
{
  this->SetNumberOfInputPorts(4);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
int vtkSweepQuadProjector::FillInputPortInformation(int, vtkInformation* info)
{
  acceptSurfaces(info);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSweepQuadProjector::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(this, outputs, [&] { this->Execute(inputs, outputs); });
}

//------------------------------------------------------------------------------
void vtkSweepQuadProjector::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (isIdleRank(
        outputs, inputs, { "source quads", "target surface", "linking sides", "source surface" }))
  {
    return;
  }
  const ProjectionMethod method = projectionMethod("Method", this->Method);
  checkChoice("DiskMaps", this->DiskMaps, { "Automatic", "FromInput" });
  checkPrecision(this->OutputPointsPrecision);
  const Ports ports = { inputDataSet(inputs, 0), inputDataSet(inputs, 1), inputDataSet(inputs, 2),
    inputDataSet(inputs, 3) };
  Caps caps = readCaps(ports);
  SweepProjectionInput& input = caps.input;
  input.method = method;
  input.weights = chosenWeights(this->Weights);
  input.improvement = chosenImprovement(this->ImproveTriangulation);
  input.matchTolerance = this->MatchTolerance;
  input.singlePrecision = this->OutputPointsPrecision == SINGLE_PRECISION;
  input.ensureValid = this->EnsureValid;
  input.improveQuality = this->ImproveQuality;
  input.parallelFor = askingFor(pipelineProgress(this));
  if (method != ProjectionMethod::AffineLeastSquares)
  {
    if (this->DiskMaps == FROM_INPUT)
    {
      readDisks(ports, input);
    }
    else
    {
      checkAreas(caps);
    }
  }
  traceRings(ports.linking, input);
  const SweepProjection projection = projectSweep(input, pipelineProgress(this, 0.1, 0.9));

  auto* output = vtkUnstructuredGrid::GetData(outputs, 0);
  writeQuads(projection, caps, ports.source, this->OutputPointsPrecision, output);
  addProjectionReport(output->GetFieldData(), projection, nameOf(method));
  addReport(output->GetFieldData(), reports::IgnoredCells, caps.ignoredCells);
  if (projection.source)
  {
    writeCapDisk(*projection.source, caps.source, this->OutputPointsPrecision, false,
      vtkUnstructuredGrid::GetData(outputs, 1));
    writeCapDisk(*projection.target, caps.target, this->OutputPointsPrecision, false,
      vtkUnstructuredGrid::GetData(outputs, 2));
  }
  for (const std::string& warning : projectionWarnings(projection, input.source.quads))
  {
    if (!warning.empty())
    {
      vtkWarningMacro(<< warning);
    }
  }
}

//------------------------------------------------------------------------------
void vtkSweepQuadProjector::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "DiskMaps: " << this->DiskMaps << "\n";
  os << indent << "Weights: " << this->Weights << "\n";
  os << indent << "ImproveTriangulation: " << this->ImproveTriangulation << "\n";
  os << indent << "EnsureValid: " << this->EnsureValid << "\n";
  os << indent << "ImproveQuality: " << this->ImproveQuality << "\n";
  os << indent << "MatchTolerance: " << this->MatchTolerance << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
