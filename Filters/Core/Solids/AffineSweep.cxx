// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/AffineSweep.h"

#include "Core/Common/DenseAlgebra.h"
#include "Core/Geometry/ClosedPolygon.h"
#include "Core/Geometry/TriangleSearch.h"
#include "Core/Solids/SweepShape.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr int GreatestRounds = 50;
/// Of the solid's size: what is nearer is the same place.
constexpr double Converged = 1e-14;
constexpr double Exact = 1e-9;
/// Of the columns' length, to tell equals apart.
constexpr double ShareOfLength = 1e-6;

/// Pairs of places that belong together.
struct Pairs
{
  Points from{ 0, 3 };
  Points to{ 0, 3 };

  void add(const Points& some, const Points& others)
  {
    const Index n = this->from.rows();
    this->from.conservativeResize(n + some.rows(), Eigen::NoChange);
    this->to.conservativeResize(n + some.rows(), Eigen::NoChange);
    this->from.bottomRows(some.rows()) = some;
    this->to.bottomRows(some.rows()) = others;
  }
};

double leastEdge(const Points& polygon, Index i)
{
  const Index n = polygon.rows();
  return std::min((polygon.row((i + 1) % n) - polygon.row(i)).norm(),
    (polygon.row((i + n - 1) % n) - polygon.row(i)).norm());
}

/// Rows from `first` on, round and round.
Points rotated(const Points& polygon, Index first)
{
  const Index n = polygon.rows();
  Points result(n, 3);
  for (Index i = 0; i < n; ++i)
  {
    result.row(i) = polygon.row((i + first + n) % n);
  }
  return result;
}

/// The nodes of the target loop in the order of those of the source loop, if there is one each.
std::optional<Points> matchingNodes(const Points& image, const Points& target)
{
  const Index n = image.rows();
  if (target.rows() != n)
  {
    return std::nullopt;
  }
  Index shift = 0;
  (target.rowwise() - image.row(0)).rowwise().squaredNorm().minCoeff(&shift);
  Points matched = rotated(target, shift);
  for (Index i = 0; i < n; ++i)
  {
    if (!((image.row(i) - matched.row(i)).norm() < 0.25 * leastEdge(matched, i)))
    {
      return std::nullopt;
    }
  }
  return matched;
}

/// Of all loops, where each node has its own on the target.
std::optional<Pairs> matchingPairs(const SweepShape& shape, const AffineMap& map)
{
  Pairs nodes;
  for (const SideShape& side : shape.sides)
  {
    const std::optional<Points> matched = matchingNodes(map.apply(side.source), side.target);
    if (!matched)
    {
      return std::nullopt;
    }
    nodes.add(side.source, *matched);
  }
  return nodes;
}

std::optional<Pairs> nearestPairs(const SweepShape& shape, const AffineMap& map)
{
  const AffineMap back = inverse(map);
  Pairs places;
  for (const SideShape& side : shape.sides)
  {
    places.add(side.source, nearestOnPolygon(side.target, map.apply(side.source)));
    places.add(nearestOnPolygon(side.source, back.apply(side.target)), side.target);
  }
  return places;
}

AffineMap fitAffine(const SweepShape& shape, const Pairs& pairs)
{
  return fitAffineMap(pairs.from, pairs.to, areaVector(shape.sides.front().source),
    areaVector(shape.sides.front().target));
}

AffineMap fitTranslation(const SweepShape&, const Pairs& pairs)
{
  const Eigen::RowVector3d center = pairs.from.colwise().mean();
  return { Eigen::Matrix3d::Identity(), center, center + (pairs.to - pairs.from).colwise().mean() };
}

/// A translation where it fits as well as another affine map.
AffineMap fitNodes(const SweepShape& shape, const Pairs& pairs)
{
  const AffineMap affine = fitAffine(shape, pairs);
  const AffineMap translation = fitTranslation(shape, pairs);
  const auto residual = [&](const AffineMap& map) {
    return (map.apply(pairs.from) - pairs.to).rowwise().norm().maxCoeff();
  };
  return residual(translation) <= std::max(2.0 * residual(affine), Exact * shape.size) ? translation
                                                                                       : affine;
}

/**
 * Fits a map to the pairs that it makes, until it stays where it is.
 *
 * @param pair makes pairs of a map, or none. @param fit makes a map of pairs.
 * @return nothing where there are no pairs or the map degenerates.
 */
template <typename Pair, typename Fit>
std::optional<AffineMap> refine(
  const SweepShape& shape, AffineMap map, const Pair& pair, const Fit& fit)
{
  const Points& loop = shape.sides.front().source;
  for (int round = 0; round < GreatestRounds; ++round)
  {
    if (!isInvertible(map))
    {
      return std::nullopt;
    }
    const std::optional<Pairs> pairs = pair(shape, map);
    if (!pairs)
    {
      return std::nullopt;
    }
    const AffineMap next = fit(shape, *pairs);
    const double change = (next.apply(loop) - map.apply(loop)).rowwise().norm().maxCoeff();
    map = next;
    if (!(change > Converged * shape.size))
    {
      break;
    }
  }
  return map;
}

using Axes = Eigen::Matrix<double, 3, 2>;

/// The map without a rotation of its own that takes centre, normal and moments to the target's.
AffineMap transport(const SweepShape& shape)
{
  const Eigen::Vector3d from = shape.sourceMoments.areaVector.normalized().transpose();
  const Eigen::Vector3d to = -shape.targetMoments.areaVector.normalized().transpose();
  Axes axes;
  axes.col(0) = from.unitOrthogonal();
  axes.col(1) = from.cross(axes.col(0));
  const Axes turned = leastRotation(from, to) * axes;
  const Eigen::Matrix2d source = axes.transpose() * shape.sourceMoments.covariance * axes;
  const Eigen::Matrix2d target = turned.transpose() * shape.targetMoments.covariance * turned;
  const Eigen::Matrix2d half = symmetricRoot(source);
  const Eigen::Matrix2d stretch =
    half.inverse() * symmetricRoot(half * target * half) * half.inverse();
  AffineMap map;
  map.sourceCenter = shape.sourceMoments.center;
  map.targetCenter = shape.targetMoments.center;
  map.linear = turned * stretch * axes.transpose() +
    std::sqrt(std::max(0.0, stretch.determinant())) * to * from.transpose();
  return map;
}

/// How far straight lines from the outer source loop to its image stay off the outer side.
class RuledDistance
{
public:
  explicit RuledDistance(const SweepShape& shape)
    : Source(shape.sides.front().source)
    , Search(shape.sides.front().surface.points, shape.sides.front().surface.triangles)
  {
  }

  /// Mean over the loop's nodes, in the points' unit. Where the side is flat, as the end of a
  /// tube's wall, lines stay on it however they turn: the shorter ones are nearer.
  /// @param limit what is greater need not be known: infinity is returned then.
  double operator()(
    const AffineMap& map, double limit = std::numeric_limits<double>::infinity()) const
  {
    constexpr Index Most = 100;
    constexpr std::array<double, 3> Shares = { 0.25, 0.5, 0.75 };
    std::array<Index, Shares.size()> near;
    near.fill(-1);
    const Points image = map.apply(this->Source);
    const Index n = image.rows();
    const Index step = std::max<Index>(1, n / Most);
    const Index nodes = (n - 1) / step + 1;
    const auto count = static_cast<double>(Shares.size()) * static_cast<double>(nodes);
    double sum = 0.0;
    for (Index i = 0; i < n; i += step)
    {
      for (std::size_t k = 0; k < Shares.size(); ++k)
      {
        const Eigen::RowVector3d place =
          (1.0 - Shares[k]) * this->Source.row(i) + Shares[k] * image.row(i);
        const TrianglePoint found = this->Search.closest(place, near[k]);
        near[k] = found.triangle;
        sum += found.distance;
      }
      if (sum / count > limit)
      {
        return std::numeric_limits<double>::infinity();
      }
    }
    return sum / count + ShareOfLength * (image - this->Source).rowwise().norm().mean();
  }

private:
  const Points& Source;
  TriangleSearch Search;
};

struct RankedMap
{
  double distance;
  AffineMap map;
};

/// Maps that turn the outer loop by a fraction of its length, those that keep nearest to the outer
/// side first.
std::vector<RankedMap> turnedMaps(const SweepShape& shape, const RuledDistance& distance)
{
  constexpr Index Shifts = 64;
  constexpr Index Samples = 64;
  constexpr std::size_t Kept = 4;
  const ClosedPolygon source(shape.sides.front().source);
  const ClosedPolygon target(shape.sides.front().target);
  Points from(Samples, 3);
  Points to(Samples, 3);
  std::vector<RankedMap> maps;
  for (Index shift = 0; shift < Shifts; ++shift)
  {
    for (Index i = 0; i < Samples; ++i)
    {
      const double place = static_cast<double>(i) / Samples;
      from.row(i) = source.at(place);
      to.row(i) = target.at(place + static_cast<double>(shift) / Shifts);
    }
    const AffineMap map = fitAffineMap(from, to, areaVector(from), areaVector(to));
    const double limit =
      maps.size() < Kept ? std::numeric_limits<double>::infinity() : maps.back().distance;
    const RankedMap ranked{ distance(map, limit), map };
    maps.insert(std::upper_bound(maps.begin(), maps.end(), ranked,
                  [](const RankedMap& a, const RankedMap& b) { return a.distance < b.distance; }),
      ranked);
    maps.resize(std::min(Kept, maps.size()));
  }
  return maps;
}

/// The map of the outer loop's nodes to those of the target, each `turn` nodes further on.
AffineMap turnedByNodes(const SweepShape& shape, const AffineMap& map, Index turn)
{
  const SideShape& outer = shape.sides.front();
  Index first = 0;
  (outer.target.rowwise() - map.apply(outer.source).row(0))
    .rowwise()
    .squaredNorm()
    .minCoeff(&first);
  const Points turned = rotated(outer.target, first + turn);
  return fitAffineMap(outer.source, turned, areaVector(outer.source), areaVector(turned));
}

/// Where loops have as many nodes: the map of nodes to nodes that keeps nearest to the outer side.
std::optional<AffineMap> bestNodeMap(
  const SweepShape& shape, const std::vector<RankedMap>& guesses, const RuledDistance& distance)
{
  const SideShape& outer = shape.sides.front();
  if (outer.source.rows() != outer.target.rows())
  {
    return std::nullopt;
  }
  std::optional<RankedMap> best;
  for (const RankedMap& guess : guesses)
  {
    AffineMap map = turnedByNodes(shape, guess.map, 0);
    double own = distance(map);
    for (bool moved = true; moved;)
    {
      moved = false;
      for (const Index turn : { -1, 1 })
      {
        const AffineMap next = turnedByNodes(shape, map, turn);
        const double nextDistance = distance(next, own);
        if (nextDistance < own)
        {
          map = next;
          own = nextDistance;
          moved = true;
        }
      }
    }
    if (!best || own < best->distance)
    {
      best = RankedMap{ own, map };
    }
  }
  return refine(shape, best->map, matchingPairs, fitNodes);
}

std::optional<AffineSweep> checked(const SweepShape& shape, const std::optional<AffineMap>& map)
{
  if (!map || !isInvertible(*map) || !isRuledImage(shape, *map))
  {
    return std::nullopt;
  }
  return AffineSweep{ *map, map->linear == Eigen::Matrix3d::Identity() };
}

std::optional<AffineSweep> sweepByNodes(const SweepShape& shape, const AffineMap& guess)
{
  return checked(shape, refine(shape, guess, matchingPairs, fitNodes));
}

std::optional<AffineSweep> sweepByPlaces(const SweepShape& shape, const AffineMap& guess)
{
  const std::optional<AffineMap> map = refine(shape, guess, nearestPairs, fitAffine);
  if (!map)
  {
    return std::nullopt;
  }
  const std::optional<AffineSweep> exact = sweepByNodes(shape, *map);
  return exact ? exact : checked(shape, map);
}

std::optional<AffineSweep> translationNear(const SweepShape& shape, AffineMap guess)
{
  guess.linear.setIdentity();
  return checked(shape, refine(shape, guess, nearestPairs, fitTranslation));
}
}

std::optional<AffineSweep> findAffineSweep(const SolidSurface& solid, const SweepTopology& topology)
{
  const SweepShape shape = sweepShape(solid, topology);
  const AffineMap guess = transport(shape);
  std::optional<AffineSweep> byNodes = sweepByNodes(shape, guess);
  if (byNodes && byNodes->isTranslation)
  {
    return byNodes;
  }
  std::optional<AffineSweep> translation = byNodes ? std::nullopt : translationNear(shape, guess);
  if (translation)
  {
    return translation;
  }
  const RuledDistance distance(shape);
  const std::vector<RankedMap> turned = turnedMaps(shape, distance);
  if (auto found = checked(shape, bestNodeMap(shape, turned, distance)))
  {
    return found;
  }
  if (byNodes)
  {
    return byNodes;
  }
  // Nearest places would let a circle turn; the guess does not.
  if (auto found = checked(shape, guess))
  {
    return found;
  }
  for (const RankedMap& candidate : turned)
  {
    if (auto found = sweepByPlaces(shape, candidate.map))
    {
      return found;
    }
  }
  return std::nullopt;
}
}
