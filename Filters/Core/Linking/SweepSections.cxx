// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/SweepSections.h"

#include "Core/Common/DenseAlgebra.h"
#include "Core/Geometry/AffineMap.h"
#include "Core/Geometry/LoopGeometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexsweep
{
namespace
{
/// Vector area over the square of the length; a circle has 0.08. Less has no plane.
constexpr double LeastArea = 1e-3;
/// Cosine between the normals of two rings that one follows the other.
constexpr double SharpestBend = -0.9;

/// Of the vector from `a` to `b`, both in the plane; 0 where one has no length.
double angleBetween(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b)
{
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

Eigen::RowVector2d edge(const PlanePoints& ring, Index begin, Index size, Index j)
{
  return ring.row(begin + (j + 1) % size) - ring.row(begin + j);
}

/// Mean angle by which the edges of a loop turn from one ring to the next.
double edgeTurn(const PlanePoints& from, const PlanePoints& to, Index begin, Index size)
{
  double sum = 0.0;
  for (Index j = 0; j < size; ++j)
  {
    sum += angleBetween(edge(from, begin, size, j), edge(to, begin, size, j));
  }
  return sum / static_cast<double>(size);
}

/// Centroid of a ring's nodes.
Eigen::RowVector2d middle(const PlanePoints& ring, Index begin, Index size)
{
  return ring.middleRows(begin, size).colwise().mean();
}

bool hasPlane(const Points& ring)
{
  const double length = closedLength(ring);
  return areaVector(ring).norm() > LeastArea * length * length;
}

SectionFrame firstFrame(const Points& ring)
{
  SectionFrame frame;
  frame.center = ring.colwise().mean();
  frame.normal = areaVector(ring).normalized();
  // The longest direction from the middle: the axes then turn with the sweep.
  Index farthest = 0;
  (ring.rowwise() - frame.center).rowwise().squaredNorm().maxCoeff(&farthest);
  Eigen::RowVector3d first = ring.row(farthest) - frame.center;
  first -= first.dot(frame.normal) * frame.normal;
  if (!(first.norm() > 0.0))
  {
    first = frame.normal.unitOrthogonal();
  }
  frame.axes.row(0) = first.normalized();
  frame.axes.row(1) = frame.normal.cross(Eigen::RowVector3d(frame.axes.row(0)));
  return frame;
}

SectionFrame nextFrame(const SectionFrame& last, const Points& ring)
{
  SectionFrame frame;
  frame.center = ring.colwise().mean();
  frame.normal = areaVector(ring).normalized();
  const Eigen::Matrix3d bend = leastRotation(last.normal, frame.normal);
  frame.axes.row(0) = last.axes.row(0) * bend.transpose();
  frame.axes.row(1) = last.axes.row(1) * bend.transpose();
  return frame;
}

void turnAxes(SectionFrame& frame, double angle)
{
  const Eigen::RowVector3d first = frame.axes.row(0);
  const Eigen::RowVector3d second = frame.axes.row(1);
  frame.axes.row(0) = std::cos(angle) * first + std::sin(angle) * second;
  frame.axes.row(1) = std::cos(angle) * second - std::sin(angle) * first;
}
}

PlanePoints SectionFrame::flatten(const PointsRef& points) const
{
  return (points.rowwise() - this->center) * this->axes.transpose();
}

Eigen::VectorXd SectionFrame::heights(const PointsRef& points) const
{
  return (points.rowwise() - this->center) * this->normal.transpose();
}

Points SectionFrame::lift(const PlanePoints& points, const Eigen::VectorXd& heights) const
{
  return (points * this->axes + heights * this->normal).rowwise() + this->center;
}

std::optional<SweepSections> sweepSections(
  std::vector<Index> nodes, std::vector<Index> begins, const std::vector<Points>& rings)
{
  SweepSections sections;
  sections.nodes = std::move(nodes);
  sections.begins = std::move(begins);
  double largest = -1.0;
  for (std::size_t l = 0; l < sections.numberOfLoops(); ++l)
  {
    const Index begin = sections.begins[l];
    const double area =
      areaVector(rings.front().middleRows(begin, sections.begins[l + 1] - begin)).norm();
    if (area > largest)
    {
      largest = area;
      sections.outer = l;
    }
  }
  const Index begin = sections.begins[sections.outer];
  const Index size = sections.begins[sections.outer + 1] - begin;
  for (std::size_t k = 0; k < rings.size(); ++k)
  {
    const Points outer = rings[k].middleRows(begin, size);
    if (!hasPlane(outer))
    {
      return std::nullopt;
    }
    SectionFrame frame = k == 0 ? firstFrame(outer) : nextFrame(sections.frames.back(), outer);
    if (k > 0)
    {
      if (frame.normal.dot(sections.frames.back().normal) < SharpestBend)
      {
        return std::nullopt;
      }
      turnAxes(frame, edgeTurn(sections.rings.back(), frame.flatten(rings[k]), begin, size));
    }
    sections.rings.push_back(frame.flatten(rings[k]));
    sections.frames.push_back(frame);
  }
  return sections;
}

std::optional<SweepSections> sweepSections(const RingStack& rings)
{
  std::vector<Index> nodes;
  std::vector<Index> begins{ 0 };
  for (const Loop& loop : rings.loops)
  {
    nodes.insert(nodes.end(), loop.begin(), loop.end());
    begins.push_back(static_cast<Index>(nodes.size()));
  }
  std::vector<Points> layers;
  for (Index k = 0; k <= rings.numberOfLayers(); ++k)
  {
    Points layer(static_cast<Index>(nodes.size()), 3);
    for (std::size_t l = 0; l < rings.loops.size(); ++l)
    {
      layer.middleRows(begins[l], begins[l + 1] - begins[l]) = ringPoints(rings, l, k);
    }
    layers.push_back(std::move(layer));
  }
  return sweepSections(std::move(nodes), std::move(begins), layers);
}

double LoopWinding::greatest() const
{
  double greatest = 0.0;
  for (const double turn : this->own)
  {
    greatest = std::max(greatest, std::abs(turn));
  }
  for (const Pair& pair : this->pairs)
  {
    greatest = std::max(greatest, std::abs(pair.turn));
  }
  return greatest;
}

LoopWinding loopWinding(const SweepSections& sections)
{
  const std::size_t loops = sections.numberOfLoops();
  LoopWinding winding;
  winding.own.assign(loops, 0.0);
  for (std::size_t i = 0; i < loops; ++i)
  {
    for (std::size_t j = i + 1; j < loops; ++j)
    {
      if (i != sections.outer && j != sections.outer)
      {
        winding.pairs.push_back({ i, j, 0.0 });
      }
    }
  }
  for (std::size_t k = 0; k + 1 < sections.rings.size(); ++k)
  {
    const PlanePoints& from = sections.rings[k];
    const PlanePoints& to = sections.rings[k + 1];
    PlanePoints before(static_cast<Index>(loops), 2);
    PlanePoints after(static_cast<Index>(loops), 2);
    for (std::size_t l = 0; l < loops; ++l)
    {
      const Index begin = sections.begins[l];
      const Index size = sections.begins[l + 1] - begin;
      winding.own[l] += edgeTurn(from, to, begin, size);
      before.row(static_cast<Index>(l)) = middle(from, begin, size);
      after.row(static_cast<Index>(l)) = middle(to, begin, size);
    }
    for (LoopWinding::Pair& pair : winding.pairs)
    {
      const auto first = static_cast<Index>(pair.first);
      const auto second = static_cast<Index>(pair.second);
      pair.turn +=
        angleBetween(before.row(second) - before.row(first), after.row(second) - after.row(first));
    }
  }
  return winding;
}
}
