// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/CapFaces.h"

#include "Core/CapQuads/CapMeshing.h"
#include "Core/CapQuads/QuadQuality.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Geometry/SurfaceSearch.h"
#include "Core/Surfaces/SurfacePart.h"

#include <algorithm>
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
  CapQuadOptions options;
  options.size = size;
  options.given = givenCurves(complex, own, part, mesh);
  options.parallelFor = parallelFor;
  CapQuads made;
  try
  {
    made = meshCapWithQuads(part.mesh, {}, options, progress);
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
