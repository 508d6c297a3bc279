// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/CapFaces.h"

#include "Core/CapQuads/CapMeshing.h"
#include "Core/CapQuads/QuadQuality.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Geometry/SurfaceSearch.h"
#include "Core/Stacks/ConstrainedTriangulation.h"
#include "Core/Surfaces/SurfacePart.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace hexsweep
{
namespace
{
/// Of the shortest edge beside it: no node moves farther to reach a CAD face.
constexpr double FarthestFace = 0.5;

std::vector<GivenCurve> givenCurves(const AssemblyComplex& complex, const ComplexFace& face,
  const SurfacePart& part, const AssemblyMesh& mesh)
{
  std::vector<GivenCurve> given;
  for (const std::vector<CurveUse>& loop : face.loops)
  {
    for (const CurveUse& use : loop)
    {
      const MeshedCurve& divided = mesh.curves[at(use.curve)];
      GivenCurve curve;
      for (const Index point : complex.curves[at(use.curve)].points)
      {
        curve.points.push_back(part.idOf(point));
      }
      curve.fractions = divided.fractions;
      curve.places = mesh.nodes.placesOf(divided.nodes);
      given.push_back(std::move(curve));
    }
  }
  return given;
}

/// A face in a plane as a cap whose corners are every second node of its curves: where curves come
/// close to each other at a small angle, the face's own triangles leave no room to take points
/// away.
struct CapOfFace
{
  TriangleMesh mesh;
  std::vector<GivenCurve> given;
};

/// Of the face's size: all of its points are this near to a plane.
constexpr double FlatFace = 1e-9;

/// Places in the plane of a face; nothing where it is none.
class FacePlane
{
public:
  static std::optional<FacePlane> of(const TriangleMesh& mesh)
  {
    Eigen::RowVector3d normal = Eigen::RowVector3d::Zero();
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
    {
      const Eigen::RowVector3d a = mesh.points.row(mesh.triangles(t, 0));
      const Eigen::RowVector3d b = mesh.points.row(mesh.triangles(t, 1));
      const Eigen::RowVector3d c = mesh.points.row(mesh.triangles(t, 2));
      normal += (b - a).cross(c - a);
    }
    normal.normalize();
    FacePlane plane;
    plane.Origin = mesh.points.row(mesh.triangles(0, 0));
    const Points away = mesh.points.rowwise() - plane.Origin;
    const double size = away.rowwise().norm().maxCoeff();
    if ((away * normal.transpose()).cwiseAbs().maxCoeff() > FlatFace * size)
    {
      return std::nullopt;
    }
    plane.X = normal.unitOrthogonal();
    plane.Y = normal.cross(plane.X);
    return plane;
  }

  Eigen::RowVector2d operator()(const Eigen::RowVector3d& place) const
  {
    return { (place - this->Origin).dot(this->X), (place - this->Origin).dot(this->Y) };
  }

private:
  Eigen::RowVector3d Origin;
  Eigen::RowVector3d X;
  Eigen::RowVector3d Y;
};

/// The triangles of the region that lies left of all directed edges of the rims.
std::optional<Triangles> trianglesWithin(
  const PlaneGraph& graph, const std::vector<std::pair<Index, Index>>& rims)
{
  const ConstrainedTriangles all = triangulateGraph(graph);
  std::map<std::pair<Index, Index>, Index> triangleAt;
  for (Index t = 0; t < all.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      triangleAt[{ all.triangles(t, c), all.triangles(t, (c + 1) % 3) }] = t;
    }
  }
  Index region = -1;
  for (const auto& edge : rims)
  {
    const auto left = triangleAt.find(edge);
    if (left == triangleAt.end() || (region >= 0 && all.regionOf[at(left->second)] != region))
    {
      return std::nullopt;
    }
    region = all.regionOf[at(left->second)];
  }
  if (region < 0)
  {
    return std::nullopt; // a face without a rim
  }
  const Index count = std::count(all.regionOf.begin(), all.regionOf.end(), region);
  Triangles triangles(count, 3);
  Index row = 0;
  for (Index t = 0; t < all.triangles.rows(); ++t)
  {
    if (all.regionOf[at(t)] == region)
    {
      triangles.row(row++) = all.triangles.row(t);
    }
  }
  return triangles;
}

/// @return nothing where the face is not flat, or chords of its curves cross.
std::optional<CapOfFace> flatCap(
  const ComplexFace& face, const SurfacePart& part, const AssemblyMesh& mesh)
{
  const std::optional<FacePlane> plane = FacePlane::of(part.mesh);
  if (!plane)
  {
    return std::nullopt;
  }
  std::map<Index, Index> pointOf;
  std::vector<Index> nodes;
  const auto point = [&](Index node) {
    const auto [known, isNew] = pointOf.try_emplace(node, static_cast<Index>(nodes.size()));
    if (isNew)
    {
      nodes.push_back(node);
    }
    return known->second;
  };
  CapOfFace cap;
  std::vector<std::pair<Index, Index>> rims;
  for (const std::vector<CurveUse>& loop : face.loops)
  {
    for (const CurveUse& use : loop)
    {
      const MeshedCurve& divided = mesh.curves[at(use.curve)];
      GivenCurve curve;
      curve.places = mesh.nodes.placesOf(divided.nodes);
      double length = 0.0;
      for (std::size_t k = 0; k < divided.nodes.size(); k += 2)
      {
        curve.points.push_back(point(divided.nodes[k]));
        if (k > 0)
        {
          const Index here = static_cast<Index>(k);
          const double chord = (curve.places.row(here) - curve.places.row(here - 2)).norm();
          curve.fractions.push_back(length + 0.5 * chord);
          length += chord;
          std::pair<Index, Index> edge{ curve.points[k / 2 - 1], curve.points[k / 2] };
          rims.push_back(use.reversed ? std::pair(edge.second, edge.first) : edge);
        }
        curve.fractions.push_back(length);
      }
      for (double& fraction : curve.fractions)
      {
        fraction /= length;
      }
      cap.given.push_back(std::move(curve));
    }
  }
  cap.mesh.points = mesh.nodes.placesOf(nodes);
  PlaneGraph graph;
  graph.points.resize(cap.mesh.points.rows(), 2);
  for (Index i = 0; i < cap.mesh.points.rows(); ++i)
  {
    graph.points.row(i) = (*plane)(cap.mesh.points.row(i));
    graph.pointOf.push_back(i);
  }
  graph.corner.assign(nodes.size(), false);
  for (const auto& [a, b] : rims)
  {
    graph.edges.push_back(std::minmax({ a, b }));
  }
  std::sort(graph.edges.begin(), graph.edges.end());
  graph.tolerance.assign(graph.edges.size(), 0.0);
  try
  {
    std::optional<Triangles> triangles = trianglesWithin(graph, rims);
    if (!triangles)
    {
      return std::nullopt;
    }
    cap.mesh.triangles = *std::move(triangles);
  }
  catch (const InvalidInput&)
  {
    return std::nullopt;
  }
  return cap;
}

/// Lengths of the shortest edges at points.
std::vector<double> shortestEdges(const Points& points, const Quads& quads)
{
  std::vector<double> shortest(at(points.rows()), -1.0);
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      const Index a = quads(q, c);
      const Index b = quads(q, (c + 1) % 4);
      const double length = (points.row(b) - points.row(a)).norm();
      for (const Index end : { a, b })
      {
        double& own = shortest[at(end)];
        own = own < 0.0 ? length : std::min(own, length);
      }
    }
  }
  return shortest;
}
}

void snapToFaces(const AssemblyComplex& complex, const AssemblyGeometry& geometry, Index volume,
  const std::vector<Index>& faces, const Quads& quads, const std::vector<bool>& isFixed,
  Points& points)
{
  const std::vector<Index> rows = trianglesOfFaces(complex, faces);
  const SurfaceSearch surface(partOfVolume(complex, volume, rows).mesh);
  const std::vector<double> shortest = shortestEdges(points, quads);
  const QuadQuality before = quadQuality(points, quads, surface.normals(points));
  Points moved = points;
  Index near = -1;
  for (Index i = 0; i < points.rows(); ++i)
  {
    if (isFixed[at(i)] || shortest[at(i)] < 0.0)
    {
      continue;
    }
    near = surface.project(points.row(i), near).triangle;
    const Index face = complex.faceOf[at(rows[at(near)])];
    const std::optional<Eigen::RowVector3d> exact = geometry.onFace(face, points.row(i));
    if (exact && (*exact - points.row(i)).norm() < FarthestFace * shortest[at(i)])
    {
      moved.row(i) = *exact;
    }
  }
  if (quadQuality(moved, quads, surface.normals(moved)).inverted <= before.inverted)
  {
    points = std::move(moved);
  }
}

void meshCapFace(const AssemblyComplex& complex, const AssemblyGeometry& geometry, Index face,
  double size, AssemblyMesh& mesh, const Progress& progress, const ParallelFor& parallelFor)
{
  const ComplexFace& own = complex.faces[at(face)];
  const SurfacePart part = surfacePart(complex.points, complex.triangles, own.triangles);
  std::optional<CapOfFace> cap = flatCap(own, part, mesh);
  if (!cap)
  {
    cap = { part.mesh, givenCurves(complex, own, part, mesh) };
  }
  CapQuadOptions options;
  options.size = size;
  options.given = cap->given;
  options.parallelFor = parallelFor;
  CapQuads made;
  try
  {
    made = meshCapWithQuads(cap->mesh, {}, options, progress);
  }
  catch (const InvalidInput& error)
  {
    throw InvalidInput("face " + std::to_string(own.id) + ": " + error.what());
  }
  Points points = std::move(made.mesh.points);
  snapToFaces(
    complex, geometry, own.volumes.front(), { face }, made.mesh.quads, made.onCurve, points);
  std::vector<Index> nodeOf(at(points.rows()), -1);
  std::size_t curve = 0;
  for (const std::vector<CurveUse>& loop : own.loops)
  {
    for (const CurveUse& use : loop)
    {
      const std::vector<Index>& nodes = mesh.curves[at(use.curve)].nodes;
      for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        nodeOf[at(made.givenNodes[curve][k])] = nodes[k];
      }
      ++curve;
    }
  }
  const Index begin = mesh.nodes.size();
  Quads quads = std::move(made.mesh.quads);
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      Index& node = nodeOf[at(quads(q, c))];
      if (node < 0)
      {
        node = mesh.nodes.add(points.row(quads(q, c)));
      }
      quads(q, c) = node;
    }
  }
  mesh.blocks.push_back({ face, begin, mesh.nodes.size() - begin });
  mesh.faces[at(face)] = std::move(quads);
}
}
