// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/LoopCorrespondence.h"

#include "Core/Common/Constants.h"
#include "Core/Linking/CornerMatching.h"

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
/// Leaving corners over must pay: cost relative to arc length alone.
constexpr double ClearlyBetter = 0.8;
/// Corners may cost this many times as much as arc length before the best fit takes the motion out.
constexpr double StillNear = 2.5;
/// Where both loops have as many corners, those may fit this much worse than arc length: loops that
/// bend on their way (a C that opens) cost something in any case, and corners are what one sees.
constexpr double CornersCount = 1.5;
/// A runner-up that costs less than this many times the best one makes the choice a guess.
constexpr double NearlyAsGood = 1.5;

/// A correspondence that was looked at: its mean shift of places and its cost.
struct Candidate
{
  double shift;
  double cost;
};

/// Starts that put the first source node on a target node, and source nodes on target corners.
std::vector<double> startsToTry(const ClosedPolygon& source, const ClosedPolygon& target)
{
  constexpr Index MostOfOneKind = 1024;
  std::vector<double> result;
  for (Index v = 0; v < target.nodes().rows(); ++v)
  {
    result.push_back(target.fraction(v));
  }
  const Index nodes = source.nodes().rows();
  std::vector<Index> corners = loopCorners(target);
  if (corners.empty() || static_cast<Index>(corners.size()) * nodes > MostOfOneKind)
  {
    corners.assign(1, 0);
  }
  for (const Index corner : corners)
  {
    for (Index j = 0; j < nodes; ++j)
    {
      const double start = target.fraction(corner) - source.fraction(j);
      result.push_back(start - std::floor(start));
    }
  }
  return result;
}

/// The best of the others that is lower than its neighbours and no neighbour of the chosen one.
LoopCorrespondence withRunnerUp(
  LoopCorrespondence result, double chosen, std::vector<Candidate> others)
{
  // A shift by less than an edge or so of a smooth loop is the same correspondence.
  const double edges = result.matchedCorners > 0 ? 0.9 : 1.5;
  const double near = edges / static_cast<double>(result.places.size());
  const auto turn = [](double from, double to) { return std::remainder(to - from, 1.0); };
  std::sort(others.begin(), others.end(), [](const Candidate& a, const Candidate& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.shift < b.shift;
  });
  result.runnerUpCost = Infinity;
  for (auto candidate = others.begin(); candidate != others.end(); ++candidate)
  {
    const auto isBetterNeighbor = [&](const Candidate& other) {
      return std::abs(turn(other.shift, candidate->shift)) <= near &&
        other.cost < candidate->cost - SameLoopCost;
    };
    if (std::abs(turn(chosen, candidate->shift)) > near &&
      std::none_of(others.begin(), candidate, isBetterNeighbor))
    {
      result.runnerUpCost = candidate->cost;
      result.runnerUpTurn = turn(chosen, candidate->shift);
      return result;
    }
  }
  return result;
}
}

bool LoopCorrespondence::isGuess() const
{
  return this->runnerUpCost <= NearlyAsGood * this->cost;
}

LoopCorrespondence correspondLoops(
  const ClosedPolygon& source, const ClosedPolygon& target, const Eigen::Matrix3d& linear)
{
  const LoopFit fit(source, target, linear);
  LoopAnchors best;
  double cost = Infinity;
  Index corners = 0;
  std::vector<Candidate> starts;
  for (const double start : startsToTry(source, target))
  {
    starts.push_back({ start, fit.straightCost(start) });
    if (starts.back().cost < cost - SameLoopCost)
    {
      cost = starts.back().cost;
      best = { { 0.0 }, { start } };
    }
  }

  // Starts and offsets are chosen as the loops lie; whether corners fit better than arc length is
  // judged by shape alone, after the affine map that fits each correspondence best.
  const double shapeCost = fit.alignedCost(best);
  const double straightCost = cost;
  CornerMatch all;
  std::vector<Candidate> offsets;
  for (const CornerMatch& match : matchAllCorners(fit))
  {
    offsets.push_back({ fit.shiftOf(match.anchors), match.cost });
    all = match.cost < all.cost - SameLoopCost ? match : all;
  }
  if (all.cost <= StillNear * straightCost + SameLoopCost &&
    fit.alignedCost(all.anchors) <= CornersCount * shapeCost + SameLoopCost)
  {
    best = all.anchors;
    cost = all.cost;
    corners = static_cast<Index>(best.source.size());
  }
  else
  {
    const CornerMatch some = matchSomeCorners(fit);
    if (some.cost < straightCost - SameLoopCost &&
      fit.alignedCost(some.anchors) < ClearlyBetter * shapeCost - SameLoopCost)
    {
      best = some.anchors;
      cost = some.cost;
      corners = static_cast<Index>(best.source.size());
    }
    offsets = std::move(starts);
  }

  LoopCorrespondence result;
  for (Index i = 0; i < source.nodes().rows(); ++i)
  {
    result.places.push_back(best(source.fraction(i)));
  }
  result.matchedCorners = corners;
  result.cost = cost;
  return withRunnerUp(std::move(result), fit.shiftOf(best), std::move(offsets));
}
}
