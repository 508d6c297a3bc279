// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/TriangleSearch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace hexsweep
{
namespace
{
constexpr Index LeafSize = 4;

/// Each level halves the triangles; ids have 63 bits.
constexpr std::size_t MaximumDepth = 64;

/// The distance to a box and that to a triangle in it are rounded differently: boxes that are
/// farther by no more than rounding may hold the triangle of lower id.
constexpr double TieSlack = 1.0 + 1e-9;

Points cornersOf(const PointsRef& points, const TrianglesRef& triangles)
{
  Points corners(triangles.rows() * 3, 3);
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      corners.row(3 * t + c) = points.row(triangles(t, c));
    }
  }
  return corners;
}

double squaredDistanceToBox(
  const Eigen::RowVector3d& p, const Eigen::RowVector3d& low, const Eigen::RowVector3d& high)
{
  return (low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm();
}

/// Fraction along the segment a b nearest to p.
double closestFraction(
  const Eigen::RowVector3d& p, const Eigen::RowVector3d& a, const Eigen::RowVector3d& b)
{
  const Eigen::RowVector3d d = b - a;
  const double length2 = d.squaredNorm();
  return length2 > 0.0 ? std::min(1.0, std::max(0.0, (p - a).dot(d) / length2)) : 0.0;
}
}

TrianglePoint closestPointOnTriangle(const Eigen::RowVector3d& p, const Eigen::RowVector3d& a,
  const Eigen::RowVector3d& b, const Eigen::RowVector3d& c)
{
  const Eigen::RowVector3d corner[3] = { a, b, c };
  TrianglePoint best;
  const Eigen::RowVector3d normal = (b - a).cross(c - a);
  const double area2 = normal.squaredNorm();
  if (area2 > 0.0)
  {
    Eigen::RowVector3d inside;
    for (int i = 0; i < 3; ++i)
    {
      const Eigen::RowVector3d& q = corner[(i + 1) % 3];
      const Eigen::RowVector3d& r = corner[(i + 2) % 3];
      inside[i] = (r - q).cross(p - q).dot(normal) / area2;
    }
    if ((inside.array() >= 0.0).all())
    {
      best.coordinates = inside / inside.sum();
      best.distance = std::abs((p - a).dot(normal)) / std::sqrt(area2);
      return best;
    }
  }
  best.distance = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const double f = closestFraction(p, corner[i], corner[j]);
    const double distance = (p - (1.0 - f) * corner[i] - f * corner[j]).norm();
    if (distance < best.distance)
    {
      best.distance = distance;
      best.coordinates.setZero();
      best.coordinates[i] = 1.0 - f;
      best.coordinates[j] = f;
    }
  }
  return best;
}

TriangleSearch::TriangleSearch(Points corners)
  : Corners(std::move(corners))
{
  this->build();
}

TriangleSearch::TriangleSearch(const PointsRef& points, const TrianglesRef& triangles)
  : TriangleSearch(cornersOf(points, triangles))
{
}

void TriangleSearch::build()
{
  const Index count = this->Corners.rows() / 3;
  this->Order.resize(static_cast<std::size_t>(count));
  std::iota(this->Order.begin(), this->Order.end(), Index(0));
  Points centers(count, 3);
  for (Index t = 0; t < count; ++t)
  {
    centers.row(t) = this->Corners.middleRows<3>(3 * t).colwise().mean();
  }

  struct Task
  {
    Index begin;
    Index end;
    Index parent; // whose right child this is, or -1
  };
  std::vector<Task> tasks{ { 0, count, -1 } };
  while (!tasks.empty())
  {
    const Task task = tasks.back();
    tasks.pop_back();
    const Index self = static_cast<Index>(this->Nodes.size());
    if (task.parent >= 0)
    {
      this->Nodes[static_cast<std::size_t>(task.parent)].right = self;
    }
    Eigen::AlignedBox3d box;
    Eigen::AlignedBox3d centerBox;
    for (Index i = task.begin; i < task.end; ++i)
    {
      const Index t = this->Order[static_cast<std::size_t>(i)];
      for (Index c = 0; c < 3; ++c)
      {
        box.extend(this->Corners.row(3 * t + c).transpose());
      }
      centerBox.extend(centers.row(t).transpose());
    }
    this->Nodes.push_back(
      { box.min().transpose(), box.max().transpose(), task.begin, task.end, 0 });
    if (task.end - task.begin <= LeafSize)
    {
      continue;
    }
    Index axis = 0;
    centerBox.sizes().maxCoeff(&axis);
    const Index middle = (task.begin + task.end) / 2;
    std::nth_element(this->Order.begin() + task.begin, this->Order.begin() + middle,
      this->Order.begin() + task.end, [&](Index s, Index t) {
        return std::make_pair(centers(s, axis), s) < std::make_pair(centers(t, axis), t);
      });
    // The left half is taken next, so that it follows its parent.
    tasks.push_back({ middle, task.end, self });
    tasks.push_back({ task.begin, middle, -1 });
  }

  // Triangles of one leaf lie together in memory, next to those of leaves near by.
  this->Place.resize(this->Order.size());
  Points sorted(this->Corners.rows(), 3);
  for (Index i = 0; i < count; ++i)
  {
    const Index t = this->Order[static_cast<std::size_t>(i)];
    this->Place[static_cast<std::size_t>(t)] = i;
    sorted.middleRows<3>(3 * i) = this->Corners.middleRows<3>(3 * t);
  }
  this->Corners = std::move(sorted);
}

TrianglePoint TriangleSearch::onTriangle(const Eigen::RowVector3d& p, Index place) const
{
  TrianglePoint found = closestPointOnTriangle(p, this->Corners.row(3 * place),
    this->Corners.row(3 * place + 1), this->Corners.row(3 * place + 2));
  found.triangle = this->Order[static_cast<std::size_t>(place)];
  return found;
}

double TriangleSearch::squaredDistanceToBoxOf(const Eigen::RowVector3d& p, Index place) const
{
  const auto corners = this->Corners.middleRows<3>(3 * place);
  return squaredDistanceToBox(p, corners.colwise().minCoeff(), corners.colwise().maxCoeff());
}

TrianglePoint TriangleSearch::closest(const Eigen::RowVector3d& p, Index start) const
{
  TrianglePoint best;
  best.distance = std::numeric_limits<double>::infinity();
  if (start >= 0)
  {
    best = this->onTriangle(p, this->Place[static_cast<std::size_t>(start)]);
  }
  const auto boxDistance = [&](Index node) {
    const Node& n = this->Nodes[static_cast<std::size_t>(node)];
    return squaredDistanceToBox(p, n.low, n.high);
  };
  // Halves wait here, one a level.
  std::array<std::pair<double, Index>, MaximumDepth> stack;
  std::size_t waiting = 0;
  if (!this->Order.empty())
  {
    stack[waiting++] = { boxDistance(0), 0 };
  }
  while (waiting > 0)
  {
    const auto [distance2, self] = stack[--waiting];
    if (distance2 > TieSlack * best.distance * best.distance)
    {
      continue;
    }
    const Node& node = this->Nodes[static_cast<std::size_t>(self)];
    if (node.right == 0)
    {
      for (Index i = node.begin; i < node.end; ++i)
      {
        if (this->squaredDistanceToBoxOf(p, i) > TieSlack * best.distance * best.distance)
        {
          continue;
        }
        const TrianglePoint found = this->onTriangle(p, i);
        // Some triangle is found even for a point that is not finite.
        if (best.triangle < 0 || found.distance < best.distance ||
          (found.distance == best.distance && found.triangle < best.triangle))
        {
          best = found;
        }
      }
      continue;
    }
    std::pair<double, Index> nearer(boxDistance(self + 1), self + 1);
    std::pair<double, Index> farther(boxDistance(node.right), node.right);
    if (farther.first < nearer.first)
    {
      std::swap(nearer, farther);
    }
    stack[waiting++] = farther;
    stack[waiting++] = nearer;
  }
  return best;
}
}
