// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLinkingSideMesher.h"

#include "Core/Common/Constants.h"
#include "Core/Geometry/BoundarySearch.h"
#include "Core/Linking/LinkingSides.h"
#include "Core/Solids/FeatureFaces.h"
#include "Core/Surfaces/OpenEdgeWelding.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "HexSweepLinkingReport.h"
#include "HexSweepReader.h"
#include "HexSweepRun.h"
#include "HexSweepSolidReader.h"
#include "HexSweepWriter.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <string>

vtkStandardNewMacro(vtkLinkingSideMesher);

namespace
{
using namespace hexsweep;

/// The surface with coincident points joined and with faces, by id or by angle.
LinkingSurface linkingSurface(SolidData data, double matchTolerance, double featureAngle)
{
  LinkingSurface surface;
  const std::vector<Index> welded = weldOpenEdges(data.points, data.triangles, matchTolerance);
  for (Index i = 0; i < data.triangles.size(); ++i)
  {
    Index& point = data.triangles.data()[i];
    point = welded[static_cast<std::size_t>(point)];
  }
  for (Index i = 0; i < data.quads.size(); ++i)
  {
    Index& point = data.quads.data()[i];
    point = welded[static_cast<std::size_t>(point)];
  }
  surface.mesh.points = std::move(data.points);
  surface.mesh.triangles = orientFaces(data.triangles, "linking surface");
  surface.quads = std::move(data.quads);
  surface.quadOfTriangle = std::move(data.quadOfTriangle);
  surface.faceIds = data.faceIds.empty()
    ? facesByFeatureAngle(surface.mesh.points, surface.mesh.triangles, featureAngle).faceOfTriangle
    : std::move(data.faceIds);
  return surface;
}

/// Number of the loop that each quad's side begins at.
std::vector<Index> loopsOfQuads(const LinkingMesh& linking, const std::vector<Loop>& loops)
{
  std::vector<Index> ids;
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    ids.insert(
      ids.end(), loops[l].size() * static_cast<std::size_t>(linking.layers), static_cast<Index>(l));
  }
  return ids;
}

/// What to say where the last rings miss the target cap; empty where they do not.
std::string checkTarget(vtkDataSet* target, const LinkingMesh& linking,
  const std::vector<Loop>& loops, double matchTolerance)
{
  const TriangleMesh cap = readTriangles(target, "target surface").mesh;
  const SurfaceTopology topology =
    checkSurface(orientFaces(cap.triangles, "target surface"), cap.points.rows(), "target surface");
  checkCap(topology, "target surface");
  std::vector<Points> rings;
  Index first = 0;
  for (const Loop& loop : loops)
  {
    const Index n = static_cast<Index>(loop.size());
    rings.emplace_back(linking.mesh.points.middleRows(first + linking.layers * n, n));
    first += (linking.layers + 1) * n;
  }
  return describeMismatch(boundaryMismatch(cap.points, topology.loops, rings, matchTolerance),
    "target surface", "last ring of the linking sides");
}
}

//------------------------------------------------------------------------------
vtkLinkingSideMesher::vtkLinkingSideMesher()
{
  this->SetNumberOfInputPorts(3);
}

//------------------------------------------------------------------------------
int vtkLinkingSideMesher::FillInputPortInformation(int port, vtkInformation* info)
{
  acceptSurfaces(info);
  info->Set(INPUT_IS_OPTIONAL(), port < 2 ? 0 : 1);
  return 1;
}

//------------------------------------------------------------------------------
void vtkLinkingSideMesher::AddLayerPosition(double position)
{
  this->LayerPositions.push_back(position);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkLinkingSideMesher::RemoveAllLayerPositions()
{
  if (!this->LayerPositions.empty())
  {
    this->LayerPositions.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkLinkingSideMesher::GetLayerPosition(int i) const
{
  return this->LayerPositions.at(static_cast<std::size_t>(i));
}

//------------------------------------------------------------------------------
int vtkLinkingSideMesher::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(this, outputs, [&] { this->Execute(inputs, outputs); });
}

//------------------------------------------------------------------------------
void vtkLinkingSideMesher::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (isIdleRank(outputs, inputs, { "source quads", "linking surface", "target surface" }))
  {
    return;
  }
  const QuadMesh quads = readQuads(inputDataSet(inputs, 0), "source quads").mesh;
  const SurfaceTopology topology = checkSurface(quads.quads, quads.points.rows(), "source quads");
  checkCap(topology, "source quads");
  const LinkingSurface surface =
    linkingSurface(readSolid(inputDataSet(inputs, 1), chosenArray(this)), this->MatchTolerance,
      this->FeatureAngle * Pi / 180.0);
  const std::vector<SideTube> sides = splitLinkingSides(surface, quads.points, topology.loops);
  LayerRequest layers;
  layers.layers = this->NumberOfLayers;
  layers.size = this->LayerSize;
  layers.growth = this->GrowthRatio;
  layers.bothEnds = this->GrowFromBothEnds;
  layers.positions = this->LayerPositions;
  const LinkingMesh linking = meshLinkingSides(quads.points, topology.loops, sides, layers,
    this->MatchTolerance, pipelineProgress(this, 0.1, 0.95));

  auto* output = vtkUnstructuredGrid::GetData(outputs);
  output->SetPoints(
    vtkSmartPointer<vtkPoints>::Take(newPoints(linking.mesh.points, this->OutputPointsPrecision)));
  setCells(output, linking.mesh.quads, VTK_QUAD);
  addIds(output->GetPointData(), "SourcePointIds", linking.sourcePoint);
  addIds(output->GetPointData(), "SweepLayer", linking.nodeRing);
  addIds(output->GetCellData(), "SweepLayer", linking.quadLayer);
  addIds(output->GetCellData(), "LoopId", loopsOfQuads(linking, topology.loops));
  std::vector<Index> faceIds;
  for (std::size_t q = 0; q < linking.quadSide.size(); ++q)
  {
    faceIds.push_back(sides[static_cast<std::size_t>(linking.quadSide[q])]
                        .faceIds[static_cast<std::size_t>(linking.quadTriangle[q])]);
  }
  addIds(output->GetCellData(), "BoundaryId", faceIds);
  output->GetFieldData()->PassData(inputDataSet(inputs, 1)->GetFieldData());
  addLinkingReport(output->GetFieldData(), linking);

  std::vector<std::string> warnings = linkingWarnings(linking);
  if (vtkDataSet* target = inputDataSet(inputs, 2))
  {
    warnings.push_back(checkTarget(target, linking, topology.loops, this->MatchTolerance));
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
void vtkLinkingSideMesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLayers: " << this->NumberOfLayers << "\n";
  os << indent << "LayerSize: " << this->LayerSize << "\n";
  os << indent << "GrowthRatio: " << this->GrowthRatio << "\n";
  os << indent << "GrowFromBothEnds: " << (this->GrowFromBothEnds ? "On" : "Off") << "\n";
  os << indent << "LayerPositions:";
  for (const double position : this->LayerPositions)
  {
    os << " " << position;
  }
  os << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MatchTolerance: " << this->MatchTolerance << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
