// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/CapCurves.h"

#include "Core/Common/Constants.h"
#include "Core/Surfaces/FaceSides.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace hexsweep
{
namespace
{
constexpr double CornerAngle = 30.5 * Pi / 180.0; // a polygon of twelve sides is a circle still
constexpr double FilletAngle = 50.0 * Pi / 180.0;
constexpr double LongestReach = 0.125; // of the curve; a circle turns by 45 degrees within it
constexpr double ShortestEdge = 1e-2;  // of the reach; shorter ones have no direction

double angleBetween(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The edges that are to be kept; those of loops know it.
struct Network
{
  std::map<std::pair<Index, Index>, Index> loopOf; ///< in the direction of the loop
  std::map<Index, std::vector<Index>> neighbors;
};

Network networkOf(
  const TriangleMesh& cap, const std::vector<Loop>& loops, const std::vector<Index>& faceIds)
{
  Network network;
  const auto join = [&](Index a, Index b) {
    network.neighbors[a].push_back(b);
    network.neighbors[b].push_back(a);
  };
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    for (std::size_t i = 0; i < loops[l].size(); ++i)
    {
      const Index a = loops[l][i];
      const Index b = loops[l][(i + 1) % loops[l].size()];
      network.loopOf[{ a, b }] = static_cast<Index>(l);
      join(a, b);
    }
  }
  if (!faceIds.empty())
  {
    const std::vector<FaceSide> sides = sortedSides(cap.triangles, cap.points.rows());
    forEachEdge(sides, [&](std::size_t first, std::size_t last) {
      const auto id = [&](
                        std::size_t s) { return faceIds[static_cast<std::size_t>(sides[s].face)]; };
      if (last - first == 2 && id(first) != id(first + 1))
      {
        join(sides[first].low, sides[first].high);
      }
    });
  }
  return network;
}

/// Chains between `ends`, then those that none of them interrupts.
std::vector<CapCurve> chainsBetween(const Network& network, const std::map<Index, bool>& isEnd)
{
  std::map<std::pair<Index, Index>, bool> seen;
  std::vector<CapCurve> curves;
  const auto follow = [&](Index from, Index to) {
    CapCurve curve;
    curve.points = { from, to };
    seen[{ from, to }] = seen[{ to, from }] = true;
    while (to != curve.points.front() && !isEnd.at(to))
    {
      const std::vector<Index>& both = network.neighbors.at(to);
      const Index next = both[0] == from ? both[1] : both[0];
      from = to;
      to = next;
      curve.points.push_back(to);
      seen[{ from, to }] = seen[{ to, from }] = true;
    }
    const auto forward = network.loopOf.find({ curve.points[0], curve.points[1] });
    const auto backward = network.loopOf.find({ curve.points[1], curve.points[0] });
    if (forward != network.loopOf.end())
    {
      curve.loop = forward->second;
    }
    else if (backward != network.loopOf.end())
    {
      curve.loop = backward->second;
      std::reverse(curve.points.begin(), curve.points.end());
    }
    curves.push_back(std::move(curve));
  };
  for (const bool ends : { true, false })
  {
    for (const auto& [point, neighbors] : network.neighbors)
    {
      for (const Index next : neighbors)
      {
        if (isEnd.at(point) == ends && !seen[{ point, next }])
        {
          follow(point, next);
        }
      }
    }
  }
  return curves;
}

/// Places in a curve's points where it turns sharply, or most within a fillet.
std::vector<std::size_t> cornersOf(const PointsRef& points, const CapCurve& curve, double reach)
{
  const ArcLengthChain chain = chainOf(points, curve);
  const double length = chain.length();
  const double window = std::min(reach, LongestReach * length);
  const double shortest = ShortestEdge * window;
  const bool closed = curve.closed();
  const auto at = [&](double s) {
    return chain.at(closed ? s - length * std::floor(s / length) : s);
  };
  const std::size_t n = curve.points.size();
  std::vector<double> sharp(n, 0.0); // turn between directions, where it is a corner
  std::vector<double> rounded(n, 0.0);
  for (std::size_t k = closed ? 0 : 1; k + 1 < n; ++k)
  {
    const double s = chain.reached(static_cast<Index>(k));
    // The nearest places that are far enough away to show a direction.
    Eigen::RowVector3d ahead = Eigen::RowVector3d::Zero();
    Eigen::RowVector3d back = Eigen::RowVector3d::Zero();
    const Eigen::RowVector3d here = chain.nodes().row(static_cast<Index>(k));
    for (std::size_t step = 1; step + 1 < n && !(ahead.norm() > shortest); ++step)
    {
      const std::size_t next = closed ? (k + step) % (n - 1) : std::min(k + step, n - 1);
      ahead = chain.nodes().row(static_cast<Index>(next)) - here;
    }
    for (std::size_t step = 1; step + 1 < n && !(back.norm() > shortest); ++step)
    {
      const std::size_t previous = closed ? (k + (n - 1) - step) % (n - 1) : k - std::min(step, k);
      back = here - chain.nodes().row(static_cast<Index>(previous));
    }
    const double turn = angleBetween(back, ahead);
    sharp[k] = turn > CornerAngle ? turn : 0.0;
    if (closed || (s > window && s < length - window))
    {
      rounded[k] = angleBetween(here - at(s - window), at(s + window) - here);
    }
  }
  std::vector<std::size_t> corners;
  // Points within a distance of a place along the curve.
  const auto anyNear = [&](std::size_t k, double distance, const auto& test) {
    for (const bool forward : { true, false })
    {
      for (std::size_t step = 1; step + 1 < n; ++step)
      {
        if (!closed && (forward ? k + step >= n : step > k))
        {
          break;
        }
        const std::size_t other = (forward ? k + step : k + (n - 1) * step - step) % (n - 1);
        double apart =
          std::abs(chain.reached(static_cast<Index>(other)) - chain.reached(static_cast<Index>(k)));
        apart = closed ? std::min(apart, length - apart) : apart;
        if (apart > distance)
        {
          break;
        }
        if (test(other, forward))
        {
          return true;
        }
      }
    }
    return false;
  };
  for (std::size_t k = closed ? 0 : 1; k + 1 < n; ++k)
  {
    // Of several points that turn alike one is taken.
    const auto isHigher = [&](const std::vector<double>& turns, std::size_t other, bool forward) {
      return forward ? turns[other] > turns[k] * (1.0 + 1e-9)
                     : turns[other] >= turns[k] * (1.0 - 1e-9);
    };
    const bool corner = sharp[k] > 0.0 &&
      !anyNear(k, shortest,
        [&](std::size_t other, bool forward) { return isHigher(sharp, other, forward); });
    const bool fillet = sharp[k] <= 0.0 && rounded[k] > FilletAngle &&
      !anyNear(k, 2.0 * window, [&](std::size_t other, bool forward) {
        return sharp[other] > 0.0 || isHigher(rounded, other, forward);
      });
    if (corner || fillet)
    {
      corners.push_back(k);
    }
  }
  return corners;
}
}

std::vector<CapCurve> traceCapCurves(const TriangleMesh& cap, const std::vector<Loop>& loops,
  const std::vector<Index>& faceIds, const std::vector<Index>& keep, double reach)
{
  const Network network = networkOf(cap, loops, faceIds);
  std::map<Index, bool> isEnd;
  for (const auto& [point, neighbors] : network.neighbors)
  {
    isEnd[point] = neighbors.size() != 2;
  }
  for (const Index point : keep)
  {
    const auto end = isEnd.find(point);
    if (end != isEnd.end())
    {
      end->second = true;
    }
  }
  for (const CapCurve& curve : chainsBetween(network, isEnd))
  {
    for (const std::size_t k : cornersOf(cap.points, curve, reach))
    {
      isEnd[curve.points[k]] = true;
    }
  }
  return chainsBetween(network, isEnd);
}

ArcLengthChain::ArcLengthChain(Points nodes)
  : Nodes(std::move(nodes))
  , Reached(1, 0.0)
{
  for (Index i = 1; i < this->Nodes.rows(); ++i)
  {
    this->Reached.push_back(
      this->Reached.back() + (this->Nodes.row(i) - this->Nodes.row(i - 1)).norm());
  }
}

ArcLengthChain::Place ArcLengthChain::locate(double length) const
{
  const auto above = std::upper_bound(this->Reached.begin() + 1, this->Reached.end() - 1, length);
  const std::size_t edge = static_cast<std::size_t>(above - this->Reached.begin()) - 1;
  const double begin = this->Reached[edge];
  const double end = this->Reached[edge + 1];
  const double along = end > begin ? (length - begin) / (end - begin) : 0.0;
  return { static_cast<Index>(edge), std::clamp(along, 0.0, 1.0) };
}

Eigen::RowVector3d ArcLengthChain::at(double length) const
{
  const Place place = this->locate(length);
  return (1.0 - place.along) * this->Nodes.row(place.edge) +
    place.along * this->Nodes.row(place.edge + 1);
}

ArcLengthChain chainOf(const PointsRef& points, const CapCurve& curve)
{
  Points nodes(static_cast<Index>(curve.points.size()), 3);
  for (std::size_t i = 0; i < curve.points.size(); ++i)
  {
    nodes.row(static_cast<Index>(i)) = points.row(curve.points[i]);
  }
  return ArcLengthChain(std::move(nodes));
}
}
