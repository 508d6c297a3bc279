// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/SurfaceRegions.h"

#include "Core/Common/DisjointSets.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Surfaces/FaceSides.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace hexsweep
{
namespace
{
/// Number of a side of a triangle: the one that its normal points to, and the other one.
Index frontOf(Index triangle)
{
  return 2 * triangle;
}
Index backOf(Index triangle)
{
  return 2 * triangle + 1;
}

/// A triangle at an edge, by its angle about the edge.
struct Leaf
{
  double angle;
  Index triangle;
  bool forward; ///< runs from the edge's lower point to its higher one

  /// The side that looks to greater angles.
  Index ahead() const { return this->forward ? frontOf(this->triangle) : backOf(this->triangle); }
  Index behind() const { return this->forward ? backOf(this->triangle) : frontOf(this->triangle); }
};

std::vector<Leaf> leavesAt(const PointsRef& points, const TrianglesRef& triangles,
  const std::vector<FaceSide>& sides, std::size_t first, std::size_t last)
{
  const Eigen::RowVector3d origin = points.row(sides[first].low);
  const Eigen::RowVector3d axis = (points.row(sides[first].high) - origin).normalized();
  const auto wing = [&](const FaceSide& side) {
    const Eigen::RowVector3d arm = points.row(triangles(side.face, (side.corner + 2) % 3)) - origin;
    return Eigen::RowVector3d(arm - arm.dot(axis) * axis);
  };
  const Eigen::RowVector3d x = wing(sides[first]).normalized();
  const Eigen::RowVector3d y = axis.cross(x);
  std::vector<Leaf> leaves;
  for (std::size_t s = first; s < last; ++s)
  {
    const Eigen::RowVector3d arm = wing(sides[s]);
    const double angle = s == first ? 0.0 : std::atan2(arm.dot(y), arm.dot(x));
    leaves.push_back({ angle, sides[s].face, sides[s].forward });
  }
  std::sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) {
    return std::pair(a.angle, a.triangle) < std::pair(b.angle, b.triangle);
  });
  return leaves;
}

double sixfoldVolume(const PointsRef& points, const TrianglesRef& triangles, Index row)
{
  const Eigen::RowVector3d origin = points.row(triangles(0, 0));
  const Eigen::RowVector3d a = points.row(triangles(row, 0)) - origin;
  const Eigen::RowVector3d b = points.row(triangles(row, 1)) - origin;
  const Eigen::RowVector3d c = points.row(triangles(row, 2)) - origin;
  return a.dot(b.cross(c));
}
}

std::vector<SurfaceRegion> surfaceRegions(const PointsRef& points, const TrianglesRef& triangles)
{
  DisjointSets regions(2 * triangles.rows());
  const std::vector<FaceSide> sides = sortedSides(triangles, points.rows());
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    const std::vector<Leaf> leaves = leavesAt(points, triangles, sides, first, last);
    for (std::size_t i = 0; i < leaves.size(); ++i)
    {
      regions.join(leaves[i].ahead(), leaves[(i + 1) % leaves.size()].behind());
    }
  });
  struct Found
  {
    SurfaceRegion region;
    std::vector<bool> turned;
    double volume = 0.0;
  };
  std::map<Index, Found> found; // by the region's first side
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    const Index front = regions.find(frontOf(t));
    const Index back = regions.find(backOf(t));
    if (front == back)
    {
      continue;
    }
    for (const bool turned : { true, false })
    {
      // Outward is away from the region: the normal where it lies behind.
      Found& own = found[turned ? front : back];
      own.region.rows.push_back(t);
      own.turned.push_back(turned);
      own.volume += (turned ? -1.0 : 1.0) * sixfoldVolume(points, triangles, t);
    }
  }
  std::vector<SurfaceRegion> result;
  for (auto& [side, own] : found)
  {
    // That around everything has its surface inside out.
    if (own.volume <= 0.0)
    {
      continue;
    }
    own.region.triangles.resize(static_cast<Index>(own.region.rows.size()), 3);
    for (std::size_t r = 0; r < own.region.rows.size(); ++r)
    {
      auto corners = own.region.triangles.row(static_cast<Index>(r));
      corners = triangles.row(own.region.rows[r]);
      if (own.turned[r])
      {
        std::swap(corners[1], corners[2]);
      }
    }
    result.push_back(std::move(own.region));
  }
  std::sort(result.begin(), result.end(),
    [](const SurfaceRegion& a, const SurfaceRegion& b) { return a.rows < b.rows; });
  return result;
}
}
