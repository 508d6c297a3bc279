// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/TouchingSheets.h"

#include "Core/Common/DisjointSets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace hexsweep
{
namespace
{
/// A triangle at an edge.
struct Leaf
{
  double angle; ///< about the edge, from its lower point to its higher one
  bool forward; ///< whether the triangle runs along the edge from its lower point
  Index half;   ///< 3 triangle + corner where the edge begins
};

/// The half-edges between two points, in the order of their angles about the edge.
std::vector<Leaf> leavesOf(
  const SolidSurface& solid, Index low, Index high, const std::vector<Index>& halves)
{
  const Eigen::RowVector3d start = solid.points.row(low);
  const Eigen::RowVector3d axis = (solid.points.row(high) - start).normalized();
  const Eigen::RowVector3d x = axis.unitOrthogonal();
  const Eigen::RowVector3d y = axis.cross(x);
  std::vector<Leaf> leaves;
  for (const Index half : halves)
  {
    const Index t = half / 3;
    const Eigen::RowVector3d way = solid.points.row(solid.triangles(t, (half + 2) % 3)) - start;
    leaves.push_back(
      { std::atan2(way.dot(y), way.dot(x)), solid.triangles(t, half % 3) == low, half });
  }
  std::sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) {
    return a.angle != b.angle ? a.angle < b.angle : a.half < b.half;
  });
  return leaves;
}

/// Joins the corners of two triangles at the ends of an edge that they share.
void joinAlong(const SolidSurface& solid, Index half, Index other, DisjointSets& corners)
{
  const auto next = [](Index h) { return h % 3 == 2 ? h - 2 : h + 1; };
  const bool same = solid.triangles(half / 3, half % 3) == solid.triangles(other / 3, other % 3);
  corners.join(half, same ? other : next(other));
  corners.join(next(half), same ? next(other) : other);
}

/// Joins the two triangles of each edge, of more those with material between them.
void joinNeighbors(const SolidSurface& solid, DisjointSets& corners)
{
  std::map<std::pair<Index, Index>, std::vector<Index>> edges;
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      edges[std::minmax<Index>(solid.triangles(t, c), solid.triangles(t, (c + 1) % 3))].push_back(
        3 * t + c);
    }
  }
  for (const auto& [ends, halves] : edges)
  {
    std::vector<Leaf> leaves;
    if (halves.size() > 2)
    {
      leaves = leavesOf(solid, ends.first, ends.second, halves);
    }
    bool alternate = halves.size() % 2 == 0 && halves.size() > 2;
    for (std::size_t i = 0; i < leaves.size(); ++i)
    {
      alternate = alternate && leaves[i].forward != leaves[(i + 1) % leaves.size()].forward;
    }
    for (std::size_t i = 0; i < halves.size(); ++i)
    {
      if (!alternate)
      {
        joinAlong(solid, halves[i], halves[0], corners);
      }
      else if (leaves[i].forward)
      {
        // Material is on the side of a forward triangle where angles fall.
        const std::size_t before = (i + leaves.size() - 1) % leaves.size();
        joinAlong(solid, leaves[i].half, leaves[before].half, corners);
      }
    }
  }
}
}

Index partTouchingSheets(SolidSurface& solid)
{
  DisjointSets corners(3 * solid.triangles.rows());
  joinNeighbors(solid, corners);
  std::vector<Index> fanOf(static_cast<std::size_t>(solid.points.rows()), -1);
  std::map<Index, Index> pointOfFan;
  std::vector<Index> added;
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index fan = corners.find(3 * t + c);
      const Index point = solid.triangles(t, c);
      Index& first = fanOf[static_cast<std::size_t>(point)];
      first = first < 0 ? fan : first;
      if (first != fan)
      {
        const auto known =
          pointOfFan.emplace(fan, solid.points.rows() + static_cast<Index>(added.size()));
        if (known.second)
        {
          added.push_back(point);
        }
        solid.triangles(t, c) = known.first->second;
      }
    }
  }
  const Index before = solid.points.rows();
  Points points(before + static_cast<Index>(added.size()), 3);
  points.topRows(before) = solid.points;
  for (std::size_t i = 0; i < added.size(); ++i)
  {
    points.row(before + static_cast<Index>(i)) = solid.points.row(added[i]);
    solid.pointRows.push_back(solid.pointRows[static_cast<std::size_t>(added[i])]);
  }
  solid.points = std::move(points);
  return static_cast<Index>(added.size());
}
}
