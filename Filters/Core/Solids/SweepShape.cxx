// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SweepShape.h"

#include "Core/Common/Constants.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Geometry/TriangleSearch.h"
#include "Core/Surfaces/SurfacePart.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
namespace
{
/// Of the solid's size: single precision coordinates must do.
constexpr double Rounding = 1e-6;
/// Times the sagittas of both curves or surfaces.
constexpr double SagittaAllowance = 2.0;
constexpr double SharpTurn = Pi / 6.0;
constexpr Index Levels = 8; // of a side, between source and target

/// The edges of a closed polygon, as triangles without area.
Points edgeCorners(const Points& polygon)
{
  const Index n = polygon.rows();
  Points corners(3 * n, 3);
  for (Index i = 0; i < n; ++i)
  {
    corners.row(3 * i) = polygon.row(i);
    corners.row(3 * i + 1) = corners.row(3 * i + 2) = polygon.row((i + 1) % n);
  }
  return corners;
}

/// Turning angle at each node; infinite at corners of the shape, which say nothing of its curves.
std::vector<double> smoothTurns(const Points& polygon)
{
  const Index n = polygon.rows();
  std::vector<double> turns;
  for (Index i = 0; i < n; ++i)
  {
    const Eigen::RowVector3d in = polygon.row(i) - polygon.row((i + n - 1) % n);
    const Eigen::RowVector3d out = polygon.row((i + 1) % n) - polygon.row(i);
    const double turn = std::atan2(in.cross(out).norm(), in.dot(out));
    turns.push_back(turn < SharpTurn ? turn : std::numeric_limits<double>::infinity());
  }
  return turns;
}

/// How far each edge may be from the curve through the nodes.
std::vector<double> sagittas(const Points& polygon)
{
  const std::vector<double> turns = smoothTurns(polygon);
  const std::size_t n = turns.size();
  std::vector<double> result;
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t j = (i + 1) % n;
    const double length =
      (polygon.row(static_cast<Index>(j)) - polygon.row(static_cast<Index>(i))).norm();
    const double turn = std::min(turns[i], turns[j]); // a straight edge may end in an arc
    result.push_back(std::isfinite(turn) ? length * turn / 8.0 : 0.0);
  }
  return result;
}

double greatestOf(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
}

/// Whether each node of one polygon is as near to the other one as their sagittas explain.
bool isOnPolygon(const Points& nodes, const Points& polygon, double slack)
{
  const TriangleSearch search(edgeCorners(polygon));
  const std::vector<double> own = sagittas(nodes);
  const std::vector<double> others = sagittas(polygon);
  const std::size_t n = own.size();
  Index near = -1;
  for (std::size_t i = 0; i < n; ++i)
  {
    const TrianglePoint place = search.closest(nodes.row(static_cast<Index>(i)), near);
    near = place.triangle;
    const double explained =
      std::max(own[i], own[(i + n - 1) % n]) + others[static_cast<std::size_t>(place.triangle)];
    if (!(place.distance <= slack + SagittaAllowance * explained))
    {
      return false;
    }
  }
  return true;
}

bool isOnSurface(const Points& points, const TriangleMesh& surface, double allowed)
{
  const TriangleSearch search(surface.points, surface.triangles);
  Index near = -1;
  for (Index i = 0; i < points.rows(); ++i)
  {
    const TrianglePoint place = search.closest(points.row(i), near);
    near = place.triangle;
    if (!(place.distance <= allowed))
    {
      return false;
    }
  }
  return true;
}

/// The straight lines between two polygons, cut into levels: a row of nodes a level.
Points ruledNodes(const Points& from, const Points& to)
{
  Points nodes((Levels + 1) * from.rows(), 3);
  for (Index k = 0; k <= Levels; ++k)
  {
    const double along = static_cast<double>(k) / static_cast<double>(Levels);
    nodes.middleRows(k * from.rows(), from.rows()) = (1.0 - along) * from + along * to;
  }
  return nodes;
}

TriangleMesh ruledSurface(const Points& from, const Points& to)
{
  const Index n = from.rows();
  TriangleMesh mesh{ ruledNodes(from, to), Triangles(2 * Levels * n, 3) };
  Index row = 0;
  for (Index k = 0; k < Levels; ++k)
  {
    for (Index i = 0; i < n; ++i)
    {
      const Index a = k * n + i;
      const Index b = k * n + (i + 1) % n;
      mesh.triangles.row(row++) << a, b, b + n;
      mesh.triangles.row(row++) << a, b + n, a + n;
    }
  }
  return mesh;
}

bool isRuledSide(const SideShape& side, const AffineMap& map, const AffineMap& back, double slack)
{
  const Points image = map.apply(side.source);
  if (!isOnPolygon(image, side.target, slack) || !isOnPolygon(side.target, image, slack))
  {
    return false;
  }
  const double explained = facetSagitta(side.surface) +
    std::max(greatestOf(sagittas(side.source)), greatestOf(sagittas(side.target)));
  const double allowed = slack + SagittaAllowance * explained;
  return isOnSurface(ruledNodes(side.source, image), side.surface, allowed) &&
    isOnSurface(ruledNodes(back.apply(side.target), side.target), side.surface, allowed) &&
    isOnSurface(side.surface.points, ruledSurface(side.source, image), allowed);
}
}

SweepShape sweepShape(const SolidSurface& solid, const SweepTopology& topology)
{
  SweepShape shape;
  shape.source = surfacePart(solid.points, solid.triangles, topology.sourceTriangles).mesh;
  shape.target = surfacePart(solid.points, solid.triangles, topology.targetTriangles).mesh;
  shape.sourceMoments = surfaceMoments(shape.source);
  shape.targetMoments = surfaceMoments(shape.target);
  for (const SweepSide& side : topology.sides)
  {
    // Seen from outside the solid, loops of the two caps run against each other.
    shape.sides.push_back({ surfacePart(solid.points, solid.triangles, side.triangles).mesh,
      loopPoints(solid.points, side.sourceLoop),
      loopPoints(solid.points, side.targetLoop).colwise().reverse() });
  }
  shape.size = (solid.points.colwise().maxCoeff() - solid.points.colwise().minCoeff()).norm();
  return shape;
}

Points nearestOnPolygon(const Points& polygon, const Points& points)
{
  const TriangleSearch search(edgeCorners(polygon));
  Points nearest(points.rows(), 3);
  Index near = -1;
  for (Index i = 0; i < points.rows(); ++i)
  {
    const TrianglePoint place = search.closest(points.row(i), near);
    near = place.triangle;
    const Eigen::RowVector3d a = polygon.row(place.triangle);
    const double along = 1.0 - place.coordinates[0];
    nearest.row(i) = a + along * (polygon.row((place.triangle + 1) % polygon.rows()) - a);
  }
  return nearest;
}

bool isRuledImage(const SweepShape& shape, const AffineMap& map)
{
  const double slack = Rounding * shape.size;
  const AffineMap back = inverse(map);
  double rims = 0.0;
  for (const SideShape& side : shape.sides)
  {
    rims = std::max({ rims, greatestOf(sagittas(side.source)), greatestOf(sagittas(side.target)) });
    if (!isRuledSide(side, map, back, slack))
    {
      return false;
    }
  }
  const TriangleMesh image{ map.apply(shape.source.points), shape.source.triangles };
  const double allowed =
    slack + SagittaAllowance * (rims + facetSagitta(image) + facetSagitta(shape.target));
  return isOnSurface(image.points, shape.target, allowed) &&
    isOnSurface(shape.target.points, image, allowed);
}
}
