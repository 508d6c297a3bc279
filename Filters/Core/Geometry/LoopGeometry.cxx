// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/LoopGeometry.h"

#include "Core/Common/Constants.h"

#include <algorithm>

namespace hexsweep
{
Points loopPoints(const PointsRef& points, const Loop& loop)
{
  Points result(static_cast<Index>(loop.size()), 3);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    result.row(static_cast<Index>(i)) = points.row(loop[i]);
  }
  return result;
}

std::vector<Index> nextOnLoops(const std::vector<Loop>& loops, Index numberOfPoints)
{
  std::vector<Index> next(static_cast<std::size_t>(numberOfPoints), -1);
  for (const Loop& loop : loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      next[static_cast<std::size_t>(loop[i])] = loop[(i + 1) % loop.size()];
    }
  }
  return next;
}

std::vector<bool> boundaryFlags(Index n, const std::vector<Loop>& loops)
{
  std::vector<bool> flags(static_cast<std::size_t>(n), false);
  for (const Loop& loop : loops)
  {
    for (const Index v : loop)
    {
      flags[static_cast<std::size_t>(v)] = true;
    }
  }
  return flags;
}

std::vector<double> reachedLengths(const PointsRef& polygon)
{
  const Index n = polygon.rows();
  std::vector<double> reached(static_cast<std::size_t>(n) + 1, 0.0);
  for (Index i = 0; i < n; ++i)
  {
    reached[static_cast<std::size_t>(i) + 1] =
      reached[static_cast<std::size_t>(i)] + (polygon.row((i + 1) % n) - polygon.row(i)).norm();
  }
  return reached;
}

double closedLength(const PointsRef& polygon)
{
  return reachedLengths(polygon).back();
}

Eigen::RowVector3d nearestOnChain(const PointsRef& chain, const Eigen::RowVector3d& place)
{
  Eigen::RowVector3d nearest = chain.row(0);
  for (Index i = 0; i + 1 < chain.rows(); ++i)
  {
    const Eigen::RowVector3d way = chain.row(i + 1) - chain.row(i);
    const double squared = way.squaredNorm();
    const double along = squared > 0.0 ? (place - chain.row(i)).dot(way) / squared : 0.0;
    const Eigen::RowVector3d here = chain.row(i) + std::clamp(along, 0.0, 1.0) * way;
    if ((here - place).squaredNorm() < (nearest - place).squaredNorm())
    {
      nearest = here;
    }
  }
  return nearest;
}

std::size_t longestLoop(const PointsRef& points, const std::vector<Loop>& loops)
{
  const auto longest =
    std::max_element(loops.begin(), loops.end(), [&](const Loop& a, const Loop& b) {
      return closedLength(loopPoints(points, a)) < closedLength(loopPoints(points, b));
    });
  return static_cast<std::size_t>(longest - loops.begin());
}

std::vector<double> anglesOfLengths(std::vector<double> reached)
{
  const double whole = reached.back();
  reached.pop_back();
  for (double& length : reached)
  {
    length *= 2.0 * Pi / whole;
  }
  return reached;
}

std::vector<double> arcLengthAngles(const PointsRef& polygon)
{
  return anglesOfLengths(reachedLengths(polygon));
}

bool turnsOnce(const std::vector<double>& angles, double direction)
{
  for (std::size_t k = 0; k < angles.size(); ++k)
  {
    const double next = k + 1 < angles.size() ? angles[k + 1] : angles[0] + direction * 2.0 * Pi;
    if (!((next - angles[k]) * direction > 0.0))
    {
      return false;
    }
  }
  return true;
}
}
