// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SourceQuads.h"

#include "Core/CapQuads/CapMeshing.h"
#include "Core/Common/Constants.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Surfaces/SurfacePart.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace hexsweep
{
namespace
{
/// Quads that are much smaller than the facets of a curve are bent at the facets' corners: the
/// shortest default edge, in facets.
constexpr double QuadsOnFacet = 0.5;

/// Facets that stand for curves of the source cap.
struct CurveFacets
{
  double length = 0.0; ///< median over the edges beside points that turn by more than 10 degrees
  double turn = 0.0;   ///< the greatest, radians
};

/// @param borders points where faces of the sides meet, which are corners of their own right.
CurveFacets curveFacets(
  const SolidSurface& solid, const SweepTopology& topology, std::vector<Index> borders)
{
  constexpr double LeastTurn = Pi / 18.0;
  std::sort(borders.begin(), borders.end());
  CurveFacets facets;
  std::vector<double> lengths;
  for (const SweepSide& side : topology.sides)
  {
    const std::size_t n = side.sourceLoop.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      const Index here = side.sourceLoop[i];
      const Eigen::RowVector3d in =
        solid.points.row(here) - solid.points.row(side.sourceLoop[(i + n - 1) % n]);
      const Eigen::RowVector3d out =
        solid.points.row(side.sourceLoop[(i + 1) % n]) - solid.points.row(here);
      const double turn = std::atan2(in.cross(out).norm(), in.dot(out));
      if (turn > LeastTurn && !std::binary_search(borders.begin(), borders.end(), here))
      {
        facets.turn = std::max(facets.turn, turn);
        lengths.push_back(in.norm());
        lengths.push_back(out.norm());
      }
    }
  }
  if (!lengths.empty())
  {
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    facets.length = *middle;
  }
  return facets;
}
}

std::vector<Index> edgeStarts(const SolidSurface& solid, const SweepTopology& topology)
{
  std::vector<Index> starts;
  const Index points = solid.points.rows();
  std::vector<Loop> loops;
  for (const SweepSide& side : topology.sides)
  {
    loops.push_back(side.sourceLoop);
  }
  const std::vector<Index> next = nextOnLoops(loops, points);
  std::vector<Index> faceOf(static_cast<std::size_t>(points), -1);
  for (const SweepSide& side : topology.sides)
  {
    // The side's face behind each edge of the loop, which runs the cap's way.
    for (const Index row : side.triangles)
    {
      for (Index c = 0; c < 3; ++c)
      {
        const Index here = solid.triangles(row, (c + 1) % 3);
        if (next[static_cast<std::size_t>(here)] == solid.triangles(row, c))
        {
          faceOf[static_cast<std::size_t>(here)] = solid.faceIds[static_cast<std::size_t>(row)];
        }
      }
    }
    Index before = faceOf[static_cast<std::size_t>(side.sourceLoop.back())];
    for (const Index here : side.sourceLoop)
    {
      const Index after = faceOf[static_cast<std::size_t>(here)];
      if (before != after)
      {
        starts.push_back(here);
      }
      before = after;
    }
  }
  return starts;
}

std::vector<std::pair<Index, Index>> meshedEdges(
  const SolidInput& input, const SolidSurface& solid, const SweepTopology& topology)
{
  std::vector<std::pair<Index, Index>> edges;
  if (input.quadOfTriangle.empty())
  {
    return edges;
  }
  for (const SweepSide& side : topology.sides)
  {
    std::map<std::pair<Index, Index>, bool> meshed;
    for (const Index row : side.triangles)
    {
      const Index given = solid.triangleRows[static_cast<std::size_t>(row)];
      const bool ofQuad = input.quadOfTriangle[static_cast<std::size_t>(given)] >= 0;
      for (Index c = 0; c < 3; ++c)
      {
        meshed[{ solid.triangles(row, (c + 1) % 3), solid.triangles(row, c) }] = ofQuad;
      }
    }
    const std::size_t n = side.sourceLoop.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::pair<Index, Index> edge(side.sourceLoop[i], side.sourceLoop[(i + 1) % n]);
      if (meshed.at(edge))
      {
        edges.push_back(edge);
      }
    }
  }
  return edges;
}

SourceQuads makeSourceQuads(const SolidInput& input, const SolidSurface& solid,
  const SweepTopology& topology, double size, const Progress& progress)
{
  if (!(size >= 0.0) || !std::isfinite(size))
  {
    throw InvalidInput("the quad size is not a length. Set QuadSize to a positive length, or to 0 "
                       "for a size that fits the source cap.");
  }
  const SurfacePart part = surfacePart(solid.points, solid.triangles, topology.sourceTriangles);
  const TriangleMesh& cap = part.mesh;
  std::vector<Index> faceIds;
  for (const Index row : topology.sourceTriangles)
  {
    faceIds.push_back(solid.faceIds[static_cast<std::size_t>(row)]);
  }
  CapQuadOptions options;
  const std::vector<Index> starts = edgeStarts(solid, topology);
  for (const Index point : starts)
  {
    options.keep.push_back(part.idOf(point));
  }
  double keptLength = 0.0;
  for (const auto& [from, to] : meshedEdges(input, solid, topology))
  {
    options.keepEdges.emplace_back(part.idOf(from), part.idOf(to));
    keptLength += (solid.points.row(from) - solid.points.row(to)).norm();
  }
  options.size = size > 0.0 ? size
    : options.keepEdges.empty()
    ? std::max(defaultQuadSize(cap), QuadsOnFacet * curveFacets(solid, topology, starts).length)
    : keptLength / static_cast<double>(options.keepEdges.size());
  SourceQuads result;
  CapQuads made = meshCapWithQuads(cap, faceIds, options, progress);
  result.mesh = std::move(made.mesh);
  result.inverted = made.inverted;
  result.size = options.size;
  return result;
}

double greatestFacetTurn(const SolidSurface& solid, const SweepTopology& topology)
{
  return curveFacets(solid, topology, edgeStarts(solid, topology)).turn * 180.0 / Pi;
}
}
