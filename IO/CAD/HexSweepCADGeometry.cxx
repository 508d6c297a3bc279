// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepCADGeometry.h"

#include "Core/Common/Errors.h"
#include "HexSweepCADFacets.h"
#include "HexSweepCADRun.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
/// For the search of starting places, of the solid's size and radians.
constexpr double StartDeflection = 2e-3;
constexpr double StartAngle = 0.2;

double sizeOf(const TopoDS_Shape& shape)
{
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);
  return box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
}
}

//------------------------------------------------------------------------------
CADGeometry::CADGeometry(NumberedSolid solid)
  : Solid(std::move(solid))
  , Scale(sizeOf(this->Solid.shape))
{
  // Triangles are kept in shapes: these get their own, whoever else has the solid.
  const TopoDS_Shape shape = BRepBuilderAPI_Copy(this->Solid.shape, false, false).Shape();
  divideShape(shape, StartDeflection * this->Scale, StartAngle, {});
  TopTools_IndexedMapOfShape faces;
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  if (static_cast<std::size_t>(faces.Extent()) != this->Solid.faceIds.size() ||
    static_cast<std::size_t>(edges.Extent()) != this->Solid.edgeIds.size())
  {
    throw InvalidInput("the geometry of the solid has " + std::to_string(faces.Extent()) +
      " faces and " + std::to_string(edges.Extent()) + " edges, and " +
      std::to_string(this->Solid.faceIds.size()) + " and " +
      std::to_string(this->Solid.edgeIds.size()) + " ids of them.");
  }
  for (int f = 1; f <= faces.Extent(); ++f)
  {
    this->Surfaces.try_emplace(this->Solid.faceIds[static_cast<std::size_t>(f - 1)],
      TopoDS::Face(faces.FindKey(f)), this->Scale);
  }
  TopTools_IndexedDataMapOfShapeListOfShape facesOfEdges;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, facesOfEdges);
  for (int e = 1; e <= edges.Extent(); ++e)
  {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.FindKey(e));
    const Index id = this->Solid.edgeIds[static_cast<std::size_t>(e - 1)];
    if (BRep_Tool::Degenerated(edge) || id == 0)
    {
      continue;
    }
    this->Curves.try_emplace(id, edge, this->Scale);
    std::vector<Index> beside;
    for (const TopoDS_Shape& face : facesOfEdges.FindFromKey(edge))
    {
      beside.push_back(this->Solid.faceIds[static_cast<std::size_t>(faces.FindIndex(face) - 1)]);
    }
    std::sort(beside.begin(), beside.end());
    beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
    for (std::size_t i = 0; i < beside.size(); ++i)
    {
      for (std::size_t j = i + 1; j < beside.size(); ++j)
      {
        this->Between[{ beside[i], beside[j] }].push_back(id);
      }
    }
  }
  for (auto& [pair, ids] : this->Between)
  {
    std::sort(ids.begin(), ids.end());
  }
}

//------------------------------------------------------------------------------
const CADSurface* CADGeometry::surface(Index faceId) const
{
  const auto found = this->Surfaces.find(faceId);
  return found == this->Surfaces.end() ? nullptr : &found->second;
}

//------------------------------------------------------------------------------
const CADCurve* CADGeometry::curve(Index edgeId) const
{
  const auto found = this->Curves.find(edgeId);
  return found == this->Curves.end() ? nullptr : &found->second;
}

//------------------------------------------------------------------------------
std::optional<Eigen::RowVector3d> CADGeometry::closestOnFace(
  Index faceId, const Eigen::RowVector3d& place) const
{
  const CADSurface* surface = this->surface(faceId);
  const std::optional<CADSurfacePlace> found =
    surface ? surface->closest(place) : std::optional<CADSurfacePlace>();
  return found ? std::optional<Eigen::RowVector3d>(found->point) : std::nullopt;
}

//------------------------------------------------------------------------------
std::optional<Eigen::RowVector3d> CADGeometry::normalOnFace(
  Index faceId, const Eigen::RowVector3d& place) const
{
  const CADSurface* surface = this->surface(faceId);
  const std::optional<CADSurfacePlace> found =
    surface ? surface->closest(place) : std::optional<CADSurfacePlace>();
  return found ? surface->normal(*found) : std::nullopt;
}

//------------------------------------------------------------------------------
std::string CADGeometry::surfaceType(Index faceId) const
{
  const CADSurface* surface = this->surface(faceId);
  return surface ? surface->type() : std::string();
}

//------------------------------------------------------------------------------
std::vector<Index> CADGeometry::edgesBetween(Index faceId, Index otherFaceId) const
{
  const auto found = this->Between.find(std::minmax(faceId, otherFaceId));
  return found == this->Between.end() ? std::vector<Index>() : found->second;
}

//------------------------------------------------------------------------------
std::optional<Eigen::RowVector3d> CADGeometry::closestOnEdge(
  Index edgeId, const Eigen::RowVector3d& place) const
{
  const CADCurve* curve = this->curve(edgeId);
  return curve ? curve->closest(place) : std::nullopt;
}

//------------------------------------------------------------------------------
Points CADGeometry::endsOfEdge(Index edgeId) const
{
  const CADCurve* curve = this->curve(edgeId);
  return curve ? curve->ends() : Points(0, 3);
}

//------------------------------------------------------------------------------
std::optional<ModelFacets> CADGeometry::facets(
  double deflection, double angle, const Progress& progress) const
{
  const TopoDS_Shape shape = BRepBuilderAPI_Copy(this->Solid.shape, false, false).Shape();
  try
  {
    divideShape(shape, deflection, angle, progress);
  }
  catch (const InvalidInput&)
  {
    return std::nullopt;
  }
  TopTools_IndexedMapOfShape faces;
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  CADSolidFacets made = facetsOfSolid(shape, faces, edges);
  if (!made.emptyFaces.empty())
  {
    return std::nullopt;
  }
  for (Index& id : made.facets.faceIds)
  {
    id = this->Solid.faceIds[static_cast<std::size_t>(id - 1)];
  }
  return std::move(made.facets);
}
}
