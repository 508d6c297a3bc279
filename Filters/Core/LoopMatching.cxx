// SPDX-License-Identifier: BSD-3-Clause
#include "LoopMatching.h"

#include "AffineMap.h"
#include "Errors.h"
#include "FilledDiskMap.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace hexsweep
{
namespace
{
/// A closed polygon that is asked for places by arc length.
class Polygon
{
public:
  explicit Polygon(Points nodes)
    : Nodes(std::move(nodes))
    , Length(static_cast<std::size_t>(this->Nodes.rows()) + 1, 0.0)
  {
    for (Index i = 0; i < this->Nodes.rows(); ++i)
    {
      const Index next = (i + 1) % this->Nodes.rows();
      this->Length[static_cast<std::size_t>(i) + 1] = this->Length[static_cast<std::size_t>(i)] +
        (this->Nodes.row(next) - this->Nodes.row(i)).norm();
    }
  }
  const Points& nodes() const { return this->Nodes; }
  double length() const { return this->Length.back(); }
  double fraction(Index node) const
  {
    return this->Length[static_cast<std::size_t>(node)] / this->length();
  }
  /// Centre of the curve (not of its nodes, which may be dense in places).
  Eigen::RowVector3d center() const
  {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (Index i = 0; i < this->Nodes.rows(); ++i)
    {
      const Index next = (i + 1) % this->Nodes.rows();
      const double edge =
        this->Length[static_cast<std::size_t>(i) + 1] - this->Length[static_cast<std::size_t>(i)];
      sum += 0.5 * edge * (this->Nodes.row(i) + this->Nodes.row(next));
    }
    return sum / this->length();
  }
  /// @param fraction of the whole length, any real number.
  Eigen::RowVector3d at(double fraction) const
  {
    const double along = (fraction - std::floor(fraction)) * this->length();
    const auto above = std::upper_bound(this->Length.begin() + 1, this->Length.end() - 1, along);
    const std::size_t edge = static_cast<std::size_t>(above - this->Length.begin()) - 1;
    const double edgeLength = this->Length[edge + 1] - this->Length[edge];
    const double t = edgeLength > 0.0 ? (along - this->Length[edge]) / edgeLength : 0.0;
    const Index a = static_cast<Index>(edge);
    return (1.0 - t) * this->Nodes.row(a) + t * this->Nodes.row((a + 1) % this->Nodes.rows());
  }

private:
  Points Nodes;
  std::vector<double> Length;
};

std::vector<Polygon> polygons(const PointsRef& points, const std::vector<Loop>& loops)
{
  std::vector<Polygon> result;
  for (const Loop& loop : loops)
  {
    result.emplace_back(loopPoints(points, loop));
  }
  return result;
}

std::size_t longest(const std::vector<Polygon>& loops)
{
  return static_cast<std::size_t>(
    std::max_element(loops.begin(), loops.end(),
      [](const Polygon& a, const Polygon& b) { return a.length() < b.length(); }) -
    loops.begin());
}

/// The supposed motion of the source: about its outer loop's centre, turned and scaled.
struct Motion
{
  Eigen::RowVector3d from;
  Eigen::RowVector3d to;
  Eigen::Matrix3d linear;
  Eigen::RowVector3d operator()(const Eigen::RowVector3d& p) const
  {
    return this->to + (this->linear * (p - this->from).transpose()).transpose();
  }
};

/// Pairs all holes, the nearest ones first.
std::vector<std::size_t> pairLoops(
  const std::vector<Polygon>& source, const std::vector<Polygon>& target, const Motion& motion)
{
  std::vector<std::size_t> partner(source.size(), target.size());
  std::vector<bool> taken(target.size(), false);
  partner[longest(source)] = longest(target);
  taken[longest(target)] = true;
  std::vector<std::tuple<double, std::size_t, std::size_t>> distances;
  for (std::size_t s = 0; s < source.size(); ++s)
  {
    for (std::size_t t = 0; t < target.size(); ++t)
    {
      distances.emplace_back((motion(source[s].center()) - target[t].center()).norm(), s, t);
    }
  }
  std::sort(distances.begin(), distances.end());
  for (const auto& [distance, s, t] : distances)
  {
    if (partner[s] == target.size() && !taken[t])
    {
      partner[s] = t;
      taken[t] = true;
    }
  }
  return partner;
}

/// The start on the target loop with the least sum of squared distances, as a fraction.
double bestStart(const Polygon& source, const Polygon& target, const Motion& motion)
{
  const Index n = source.nodes().rows();
  Points moved(n, 3);
  const Eigen::RowVector3d shift = target.center() - motion(source.center());
  for (Index i = 0; i < n; ++i)
  {
    moved.row(i) = motion(source.nodes().row(i)) + shift;
  }
  double least = std::numeric_limits<double>::infinity();
  double best = 0.0;
  for (Index start = 0; start < target.nodes().rows(); ++start)
  {
    double sum = 0.0;
    for (Index i = 0; i < n && sum < least; ++i)
    {
      sum += (moved.row(i) - target.at(target.fraction(start) + source.fraction(i))).squaredNorm();
    }
    if (sum < least)
    {
      least = sum;
      best = target.fraction(start);
    }
  }
  return best;
}
}

MatchedLoops matchLoopsByShape(const PointsRef& sourcePoints, const std::vector<Loop>& sourceLoops,
  const PointsRef& targetPoints, const std::vector<Loop>& targetLoops)
{
  if (sourceLoops.size() != targetLoops.size())
  {
    throw InvalidInput("the source has " + std::to_string(sourceLoops.size()) +
      " boundary loop(s), the target surface " + std::to_string(targetLoops.size()) +
      ". Both caps of a sweep have the same holes.");
  }
  const std::vector<Polygon> source = polygons(sourcePoints, sourceLoops);
  std::vector<Polygon> target = polygons(targetPoints, targetLoops);
  const Polygon& outer = source[longest(source)];
  const Eigen::RowVector3d normal = areaVector(outer.nodes());
  if (areaVector(target[longest(target)].nodes()).dot(normal) < 0.0)
  {
    for (Polygon& loop : target)
    {
      loop = Polygon(loop.nodes().colwise().reverse());
    }
  }
  const Polygon& targetOuter = target[longest(target)];
  Motion motion;
  motion.from = outer.center();
  motion.to = targetOuter.center();
  motion.linear = (targetOuter.length() / outer.length()) *
    Eigen::Quaterniond::FromTwoVectors(
      normal.transpose(), areaVector(targetOuter.nodes()).transpose())
      .toRotationMatrix();

  const std::vector<std::size_t> partner = pairLoops(source, target, motion);
  MatchedLoops matched;
  for (std::size_t s = 0; s < source.size(); ++s)
  {
    const Polygon& loop = target[partner[s]];
    const double start = bestStart(source[s], loop, motion);
    LoopPair pair{ source[s].nodes(), source[s].nodes() };
    for (Index i = 0; i < pair.first.rows(); ++i)
    {
      pair.second.row(i) = loop.at(start + source[s].fraction(i));
    }
    matched.pairs.push_back(std::move(pair));
    matched.startFractions.push_back(start);
  }
  return matched;
}
}
