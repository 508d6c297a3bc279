// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/RuledShape.h"

#include "Core/Common/StandardIndex.h"
#include "Core/Geometry/TriangleSearch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
constexpr double MostStepped = 0.5; // of the area

Eigen::RowVector3d pointOnLoop(const PlacedLoop& loop, double v)
{
  const LoopPlace place = placeOnLoop(loop.v, v);
  return place.between(loop.points.row(static_cast<Index>(place.edge)),
    loop.points.row(static_cast<Index>((place.edge + 1) % loop.v.size())));
}

struct RuledSurface
{
  TriangleMesh mesh;
  std::vector<double> v; ///< where the lines are: rows 2 i and 2 i + 1 of the points end line i
};

/// Straight lines between the loops at all places of both.
RuledSurface ruledSurface(const PlacedLoop& source, const PlacedLoop& target)
{
  std::vector<double> v;
  for (const PlacedLoop* loop : { &source, &target })
  {
    for (const double place : loop->v)
    {
      v.push_back(place - std::floor(place));
    }
  }
  std::sort(v.begin(), v.end());
  constexpr double Same = 1e-9;
  v.erase(
    std::unique(v.begin(), v.end(), [](double a, double b) { return b - a < Same; }), v.end());
  const Index n = static_cast<Index>(v.size());
  RuledSurface result;
  TriangleMesh& ruled = result.mesh;
  ruled.points.resize(2 * n, 3);
  ruled.triangles.resize(2 * n, 3);
  for (Index i = 0; i < n; ++i)
  {
    ruled.points.row(2 * i) = pointOnLoop(source, v[at(i)]);
    ruled.points.row(2 * i + 1) = pointOnLoop(target, v[at(i)]);
    const Index next = (i + 1) % n;
    ruled.triangles.row(2 * i) << 2 * i, 2 * next, 2 * next + 1;
    ruled.triangles.row(2 * i + 1) << 2 * i, 2 * next + 1, 2 * i + 1;
  }
  result.v = std::move(v);
  return result;
}
}

std::optional<RuledShape> ruledShape(const TriangleMesh& side, const PlacedLoop& source,
  const PlacedLoop& target, double negligible, double depthLeft)
{
  const RuledSurface lines = ruledSurface(source, target);
  const TriangleMesh& ruled = lines.mesh;
  const TriangleSearch search(ruled.points, ruled.triangles);
  RuledShape shape;
  shape.points.resize(side.points.rows(), 3);
  shape.onStep.resize(at(side.points.rows()));
  shape.v.resize(at(side.points.rows()));
  Index start = -1;
  for (Index i = 0; i < side.points.rows(); ++i)
  {
    const TrianglePoint near = search.closest(side.points.row(i), start);
    start = near.triangle; // neighbours have near numbers
    const auto corners = ruled.triangles.row(near.triangle);
    Eigen::RowVector3d base = Eigen::RowVector3d::Zero();
    double v = 0.0;
    for (Index c = 0; c < 3; ++c)
    {
      base += near.coordinates[c] * ruled.points.row(corners[c]);
      // The last line's triangles end at the first one.
      const bool isRoundAgain = corners[c] < corners[0];
      v += near.coordinates[c] * (lines.v[at(corners[c] / 2)] + (isRoundAgain ? 1.0 : 0.0));
    }
    shape.v[at(i)] = v;
    shape.onStep[at(i)] = near.distance > negligible;
    shape.points.row(i) = base + depthLeft * (side.points.row(i) - base);
  }
  double area = 0.0;
  double stepped = 0.0;
  for (Index t = 0; t < side.triangles.rows(); ++t)
  {
    const auto corners = side.triangles.row(t);
    const Eigen::RowVector3d a = side.points.row(corners[0]);
    const double own = Eigen::RowVector3d(side.points.row(corners[1]) - a)
                         .cross(Eigen::RowVector3d(side.points.row(corners[2]) - a))
                         .norm();
    area += own;
    if (std::any_of(
          corners.begin(), corners.end(), [&](Index corner) { return shape.onStep[at(corner)]; }))
    {
      stepped += own;
    }
  }
  if (stepped == 0.0 || stepped > MostStepped * area)
  {
    return std::nullopt;
  }
  return shape;
}
}
