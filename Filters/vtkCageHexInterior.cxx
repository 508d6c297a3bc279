// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCageHexInterior.h"

#include "Core/BlendInterior.h"
#include "Core/BoundaryErrorInterior.h"
#include "Core/Describe.h"
#include "Core/HexQuality.h"
#include "Core/LinkingRings.h"
#include "Core/SurfaceTopology.h"
#include "Core/SweepBoundary.h"
#include "Core/SweptHexes.h"
#include "HexSweepBridge.h"
#include "HexSweepQualityArrays.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <chrono>
#include <numeric>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkCageHexInterior);

namespace
{
using hexsweep::HexQuality;
using hexsweep::Index;
using hexsweep::Points;

constexpr Index NumberOfNamedCells = 10;

// Seconds of each stage of the work, for the report.
class StageClock
{
public:
  void finish(const std::string& stage)
  {
    const auto now = std::chrono::steady_clock::now();
    this->Names.push_back(stage);
    this->Seconds.push_back(std::chrono::duration<double>(now - this->Start).count());
    this->Start = now;
  }

  void report(vtkFieldData* fieldData) const
  {
    hexsweep::addReport(fieldData, "SweepReportStages", this->Names);
    hexsweep::addReport(fieldData, "SweepReportSeconds", this->Seconds);
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
  std::vector<std::string> Names;
  std::vector<double> Seconds;
};

std::string methodName(int method)
{
  switch (method)
  {
    case vtkCageHexInterior::AUTOMATIC:
    case vtkCageHexInterior::BLEND:
      return "Blend";
    case vtkCageHexInterior::AFFINE_BOUNDARY_ERROR:
      return "AffineBoundaryError";
    default:
      throw hexsweep::InvalidInput("Method " + std::to_string(method) +
        " is not available in this version. Use AUTOMATIC (0), BLEND (1) or "
        "AFFINE_BOUNDARY_ERROR (6).");
  }
}

// The inputs, checked against each other.
struct Cage
{
  hexsweep::SurfaceInput source;
  hexsweep::SurfaceInput target;
  hexsweep::Quads quads;
  hexsweep::SweepBoundary boundary;
};

Cage readCage(
  vtkDataSet* sourceData, vtkDataSet* targetData, vtkDataSet* linkingData, double matchTolerance)
{
  Cage cage;
  cage.source = hexsweep::readQuads(sourceData, "source quads");
  cage.target = hexsweep::readQuads(targetData, "target quads");
  const hexsweep::SurfaceInput linking = hexsweep::readQuads(linkingData, "linking sides");
  const Index n = cage.source.points.rows();
  if (cage.target.points.rows() != n)
  {
    throw hexsweep::InvalidInput(
      "the target quads do not have the connectivity of the source quads: " +
      std::to_string(cage.target.points.rows()) + " points instead of " + std::to_string(n) +
      ". Make them from the source quads (SweepQuadProjector).");
  }
  const hexsweep::SurfaceTopology topology =
    hexsweep::checkSurface(cage.source.faces, n, "source quads");
  hexsweep::checkCap(topology, "source quads");
  cage.quads = cage.source.faces;
  hexsweep::checkSameQuads(cage.quads, hexsweep::Quads(cage.target.faces));

  const hexsweep::LinkingRings rings = hexsweep::traceLinkingRings(cage.source.points,
    topology.loops, linking.points, hexsweep::Quads(linking.faces), matchTolerance);
  hexsweep::matchTargetLoops(
    cage.target.points, topology.loops, rings, linking.points, matchTolerance);
  cage.boundary = hexsweep::gatherSweepBoundary(
    cage.source.points, cage.target.points, topology.loops, rings, linking.points);
  return cage;
}

struct SweptMesh
{
  Index layers = 0;
  Points points;
  hexsweep::Hexes hexes;
  std::vector<HexQuality> qualities;
};

// The ids of one layer, repeated on each of them.
vtkSmartPointer<vtkIdTypeArray> newRepeatedIds(
  const char* name, const std::vector<Index>& ids, Index layers)
{
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  array->SetName(name);
  const Index n = static_cast<Index>(ids.size());
  array->SetNumberOfValues(n * layers);
  for (Index i = 0; i < n * layers; ++i)
  {
    array->SetValue(i, ids[static_cast<std::size_t>(i % n)]);
  }
  return array;
}

vtkSmartPointer<vtkIdTypeArray> newLayerNumbers(Index perLayer, Index layers)
{
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  array->SetName("SweepLayer");
  array->SetNumberOfValues(perLayer * layers);
  for (Index i = 0; i < perLayer * layers; ++i)
  {
    array->SetValue(i, i / perLayer);
  }
  return array;
}

// Copies tuples `ids` of the source to each layer.
void carryAttributes(vtkDataSetAttributes* source, const std::vector<Index>& ids, Index layers,
  vtkDataSetAttributes* output)
{
  const Index n = static_cast<Index>(ids.size());
  // Copies of one point are not one point, and ghosts were dropped on reading.
  output->CopyAllOn();
  output->CopyGlobalIdsOff();
  output->CopyFieldOff(vtkDataSetAttributes::GhostArrayName());
  output->CopyAllocate(source, n * layers);
  vtkNew<vtkIdList> from;
  from->SetNumberOfIds(n);
  vtkNew<vtkIdList> to;
  to->SetNumberOfIds(n);
  for (Index k = 0; k < layers; ++k)
  {
    for (Index i = 0; i < n; ++i)
    {
      from->SetId(i, ids[static_cast<std::size_t>(i)]);
      to->SetId(i, k * n + i);
    }
    output->CopyData(source, from, to);
  }
}

bool isBad(const HexQuality& quality)
{
  return quality.validity == hexsweep::Validity::InvertedCorner ||
    quality.validity == hexsweep::Validity::InvertedInside ||
    quality.validity == hexsweep::Validity::Degenerate;
}

std::string describeProblem(
  const SweptMesh& mesh, const hexsweep::HexQualitySummary& summary, const std::string& method)
{
  std::string text = std::to_string(summary.inverted) + " of " + std::to_string(summary.hexes) +
    " hexahedra are inverted";
  if (summary.degenerate > 0)
  {
    text +=
      " and " + std::to_string(summary.degenerate) + " are degenerate (an edge has no length)";
  }
  text += ". The first:";
  Index named = 0;
  for (Index h = 0; h < mesh.hexes.rows() && named < NumberOfNamedCells; ++h)
  {
    const HexQuality& quality = mesh.qualities[static_cast<std::size_t>(h)];
    if (isBad(quality))
    {
      Eigen::RowVector3d center = Eigen::RowVector3d::Zero();
      for (int c = 0; c < 8; ++c)
      {
        center += 0.125 * mesh.points.row(mesh.hexes(h, c));
      }
      text += "\n  cell " + std::to_string(h) + " at " + hexsweep::describe(center) +
        ", scaled Jacobian " + hexsweep::describe(quality.scaledJacobian);
      ++named;
    }
  }
  return text +
    "\nThreshold the cell array Validity (1, 2 and 4) to see all of them. Check the target "
    "quads and the linking sides there first (folded quads make inverted hexahedra); " +
    (method == "Blend" ? "refine the quads, or use more layers where the section changes quickly."
                       : "the method Blend copes with more.");
}

void addPointArrays(vtkDataSet* source, const SweptMesh& mesh, vtkUnstructuredGrid* output)
{
  std::vector<Index> ids(static_cast<std::size_t>(source->GetNumberOfPoints()));
  std::iota(ids.begin(), ids.end(), Index{ 0 });
  vtkPointData* pointData = output->GetPointData();
  carryAttributes(source->GetPointData(), ids, mesh.layers + 1, pointData);
  pointData->AddArray(newRepeatedIds("SourcePointIds", ids, mesh.layers + 1));
  pointData->AddArray(newLayerNumbers(source->GetNumberOfPoints(), mesh.layers + 1));
}

void addCellArrays(vtkDataSet* source, const std::vector<Index>& sourceCellIds,
  const SweptMesh& mesh, vtkUnstructuredGrid* output)
{
  vtkCellData* cellData = output->GetCellData();
  carryAttributes(source->GetCellData(), sourceCellIds, mesh.layers, cellData);
  cellData->AddArray(newRepeatedIds("SourceCellIds", sourceCellIds, mesh.layers));
  cellData->AddArray(newLayerNumbers(static_cast<Index>(sourceCellIds.size()), mesh.layers));
  hexsweep::QualityArrays arrays(mesh.hexes.rows());
  for (Index h = 0; h < mesh.hexes.rows(); ++h)
  {
    arrays.set(h, mesh.qualities[static_cast<std::size_t>(h)]);
  }
  arrays.addTo(cellData);
  cellData->SetActiveScalars("ScaledJacobian");
}
}

vtkCageHexInterior::vtkCageHexInterior()
{
  this->SetNumberOfInputPorts(3);
}

int vtkCageHexInterior::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  // All three are needed; optional here so that RequestData says which one is missing, and why.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkCageHexInterior::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "MatchTolerance: " << this->MatchTolerance << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "Certify: " << (this->Certify ? "On" : "Off") << "\n";
  os << indent << "FailIfInvalid: " << (this->FailIfInvalid ? "On" : "Off") << "\n";
}

int vtkCageHexInterior::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const auto body = [&]() {
    vtkDataSet* sourceData = hexsweep::inputDataSet(inputs, 0);
    vtkDataSet* targetData = hexsweep::inputDataSet(inputs, 1);
    vtkDataSet* linkingData = hexsweep::inputDataSet(inputs, 2);
    if (hexsweep::isIdleRank(outputs, inputs, { "source quads", "target quads", "linking sides" }))
    {
      return;
    }
    StageClock clock;
    const std::string method = methodName(this->Method);
    const Cage cage = readCage(sourceData, targetData, linkingData, this->MatchTolerance);
    clock.finish("Read");

    const auto interior =
      method == "Blend" ? hexsweep::blendInterior : hexsweep::boundaryErrorInterior;
    SweptMesh mesh;
    mesh.points = interior(cage.source.points, cage.target.points, cage.quads, cage.boundary,
      hexsweep::pipelineProgress(this, 0.1, 0.8));
    if (this->OutputPointsPrecision == SINGLE_PRECISION)
    {
      // Judged as stored.
      mesh.points = mesh.points.cast<float>().cast<double>().eval();
    }
    clock.finish("Interior");

    mesh.layers = cage.boundary.numberOfLayers();
    mesh.hexes = hexsweep::sweptHexes(cage.quads, mesh.points, mesh.layers);
    mesh.qualities =
      hexsweep::hexQualities(mesh.points, mesh.hexes, this->Certify, hexsweep::smpFor());
    const hexsweep::HexQualitySummary summary = hexsweep::summarize(mesh.qualities);
    clock.finish("Quality");
    if (summary.inverted + summary.degenerate > 0)
    {
      const std::string problem = describeProblem(mesh, summary, method);
      if (this->FailIfInvalid)
      {
        throw hexsweep::InvalidInput(problem);
      }
      vtkWarningMacro(<< problem);
    }

    vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs);
    output->SetPoints(vtkSmartPointer<vtkPoints>::Take(
      hexsweep::newPoints(mesh.points, this->OutputPointsPrecision)));
    hexsweep::setCells(output, mesh.hexes, VTK_HEXAHEDRON);
    addPointArrays(sourceData, mesh, output);
    addCellArrays(sourceData, cage.source.cellIds, mesh, output);

    vtkFieldData* fieldData = output->GetFieldData();
    fieldData->PassData(targetData->GetFieldData());
    fieldData->PassData(sourceData->GetFieldData());
    hexsweep::addQualityReport(fieldData, summary);
    hexsweep::addReport(fieldData, "SweepReportMethod", method);
    clock.finish("Output");
    clock.report(fieldData);
  };
  return hexsweep::runFilter(this, outputs, body);
}
