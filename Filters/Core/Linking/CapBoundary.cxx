// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/CapBoundary.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/BoundarySearch.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Linking/LinkingRings.h"
#include "Core/Linking/RingParameter.h"
#include "Core/Linking/SweepSections.h"
#include "Core/Surfaces/SeamWelding.h"
#include "Core/Surfaces/SurfaceRefinement.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexsweep
{
namespace
{
/// A ring node further than this from the cap's boundary, in local edges, is no node of it. The
/// sagitta of a chord is less than a fifth of its length for any loop of four nodes or more.
constexpr double FarthestInEdges = 0.25;

double meanDistance(const BoundarySearch& boundary, const Points& ring)
{
  double sum = 0.0;
  for (Index i = 0; i < ring.rows(); ++i)
  {
    sum += boundary.closest(ring.row(i)).distance;
  }
  return sum / static_cast<double>(ring.rows());
}

/// Which loop of a cap a ring lies on and whether it runs the other way.
struct RingOnCap
{
  std::size_t loop;
  bool reversed;
  double distance;
};

RingOnCap findRing(const BoundarySearch& boundary, const std::vector<Loop>& loops,
  const Points& ring, std::size_t ringNumber, const std::string& cap, const std::string& rings)
{
  const Index n = ring.rows();
  std::vector<BoundarySearch::Place> places;
  std::vector<Index> votes(loops.size(), 0);
  double farthest = 0.0;
  for (Index i = 0; i < n; ++i)
  {
    const BoundarySearch::Place place = boundary.closest(ring.row(i));
    const double edge = std::max({ place.edgeLength, (ring.row(i) - ring.row((i + 1) % n)).norm(),
      (ring.row(i) - ring.row((i + n - 1) % n)).norm() });
    if (place.distance > FarthestInEdges * edge)
    {
      throw InvalidInput("a loop of the " + rings + " does not lie on the boundary of the " + cap +
        ": node " + std::to_string(i) + " of loop " + std::to_string(ringNumber) + " at " +
        describe(ring.row(i)) + " is " + describe(place.distance) +
        " away from it. Check that both belong to the same volume.");
    }
    farthest = std::max(farthest, place.distance);
    ++votes[place.loop];
    places.push_back(place);
  }
  const std::size_t loop =
    static_cast<std::size_t>(std::max_element(votes.begin(), votes.end()) - votes.begin());

  const double size = static_cast<double>(loops[loop].size());
  double turns = 0.0;
  double last = -1.0;
  double start = -1.0;
  const auto advance = [&](double position) {
    if (last >= 0.0)
    {
      turns += std::remainder(position - last, size);
    }
    last = position;
  };
  for (const BoundarySearch::Place& place : places)
  {
    if (place.loop == loop)
    {
      start = start < 0.0 ? place.position : start;
      advance(place.position);
    }
  }
  advance(start);
  if (std::abs(std::abs(turns / size) - 1.0) > 0.01)
  {
    throw InvalidInput("loop " + std::to_string(ringNumber) + " of the " + rings + ", through " +
      describe(ring.row(0)) + ", does not run once round a loop of the " + cap +
      ". Check that both belong to the same volume.");
  }
  return { loop, turns < 0.0, farthest };
}

std::vector<RingOnCap> findRings(const PointsRef& points, const std::vector<Loop>& loops,
  const std::vector<const Points*>& rings, const std::string& cap, const std::string& ringsName)
{
  if (loops.size() != rings.size())
  {
    throw InvalidInput("the " + cap + " has " + std::to_string(loops.size()) +
      " boundary loop(s), but the " + ringsName + verb(ringsName, " has ", " have ") +
      std::to_string(rings.size()) + ". Both caps must have the same holes.");
  }
  const BoundarySearch boundary(points, loops);
  std::vector<RingOnCap> found;
  std::vector<bool> taken(loops.size(), false);
  for (std::size_t p = 0; p < rings.size(); ++p)
  {
    found.push_back(findRing(boundary, loops, *rings[p], p, cap, ringsName));
    if (taken[found.back().loop])
    {
      throw InvalidInput("two loops of the " + ringsName + " lie on the same loop of the " + cap +
        ", through " + describe(rings[p]->row(0)) + ". Check that both belong to the same volume.");
    }
    taken[found.back().loop] = true;
  }
  return found;
}

/// The other way round from the same first vertex.
Loop reversedLoop(Loop loop)
{
  std::reverse(loop.begin() + 1, loop.end());
  return loop;
}

/// A cap's own loops in ring order and direction, with the place of each vertex.
struct AttachedLoops
{
  std::vector<Loop> loops;
  std::vector<std::vector<double>> places;
};

AttachedLoops attach(const PointsRef& points, const std::vector<Loop>& capLoops,
  const std::vector<RingOnCap>& found, const std::vector<const Points*>& rings,
  double matchTolerance)
{
  AttachedLoops attached;
  for (std::size_t p = 0; p < rings.size(); ++p)
  {
    const Loop& loop = capLoops[found[p].loop];
    attached.loops.push_back(found[p].reversed ? reversedLoop(loop) : loop);
    attached.places.push_back(
      ringParameters(loopPoints(points, attached.loops.back()), *rings[p], matchTolerance));
  }
  return attached;
}

CapBoundary splitAtUnion(const TriangleMesh& mesh, const AttachedLoops& attached,
  const std::vector<const Points*>& rings, const std::vector<std::vector<double>>& united)
{
  CapBoundary cap;
  std::vector<EdgeSubdivision> subdivisions;
  std::vector<std::pair<std::size_t, std::size_t>> firstInserted; // (ring, united place)
  for (std::size_t p = 0; p < rings.size(); ++p)
  {
    const Index n = rings[p]->rows();
    const Loop& loop = attached.loops[p];
    const std::vector<double>& places = attached.places[p];
    const std::vector<double>& all = united[p];
    cap.loops.emplace_back(all.size(), -1);
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const std::size_t next = (i + 1) % loop.size();
      const std::size_t begin = unitedPlace(all, n, places[i]);
      const std::size_t end = unitedPlace(all, n, places[next]);
      cap.loops[p][begin] = loop[i];
      const double from = all[begin];
      const double span =
        std::fmod(all[end] - from + static_cast<double>(n), static_cast<double>(n));
      EdgeSubdivision subdivision{ loop[i], loop[next], {} };
      for (std::size_t k = (begin + 1) % all.size(); k != end; k = (k + 1) % all.size())
      {
        const double along =
          std::fmod(all[k] - from + static_cast<double>(n), static_cast<double>(n));
        subdivision.fractions.push_back(along / span);
      }
      if (!subdivision.fractions.empty())
      {
        subdivisions.push_back(std::move(subdivision));
        firstInserted.emplace_back(p, (begin + 1) % all.size());
      }
    }
  }
  RefinedSurface refined = refineSurface(mesh, subdivisions, true);
  for (std::size_t s = 0; s < subdivisions.size(); ++s)
  {
    const auto [p, place] = firstInserted[s];
    for (std::size_t k = 0; k < refined.inserted[s].size(); ++k)
    {
      cap.loops[p][(place + k) % united[p].size()] = refined.inserted[s][k];
    }
  }
  cap.mesh = std::move(refined.mesh);
  cap.triangleOrigin = std::move(refined.triangleOrigin);
  return cap;
}

/// Whether the ends of a side, as its quads give them, run against its rings.
bool runsAgainst(const RingStack& rings, std::size_t side, bool fromSecond)
{
  // The two ends of an oriented side run against each other.
  return rings.turned[side] != fromSecond;
}

/// The ends of a side as its quads give them: from the least id on, in the way of the first quad.
LoopPair pairFrom(const RingStack& rings, std::size_t side, bool fromSecond)
{
  const RingTable& table = rings.tables[side];
  const Index n = table.cols();
  const Index begin = fromSecond ? rings.numberOfLayers() : 0;
  const Index end = rings.numberOfLayers() - begin;
  Index column = 0;
  table.row(begin).minCoeff(&column);
  const Index step = runsAgainst(rings, side, fromSecond) ? n - 1 : 1;
  LoopPair pair{ Points(n, 3), Points(n, 3), std::nullopt };
  for (Index j = 0; j < n; ++j, column = (column + step) % n)
  {
    pair.first.row(j) = rings.points.row(table(begin, column));
    pair.second.row(j) = rings.points.row(table(end, column));
  }
  return pair;
}

double farthest(const std::vector<RingOnCap>& found)
{
  double distance = 0.0;
  for (const RingOnCap& ring : found)
  {
    distance = std::max(distance, ring.distance);
  }
  return distance;
}
}

std::vector<LoopPair> outerFirst(std::vector<LoopPair> pairs)
{
  const auto length = [](const LoopPair& pair) {
    return closedLength(pair.first) + closedLength(pair.second);
  };
  const auto outer = std::max_element(pairs.begin(), pairs.end(),
    [&](const LoopPair& a, const LoopPair& b) { return length(a) < length(b); });
  std::rotate(pairs.begin(), outer, outer + 1);
  return pairs;
}

LinkedLoops linkLoops(const RingStack& rings)
{
  const Index last = rings.numberOfLayers();
  std::vector<std::pair<Index, std::size_t>> firstOnes; // least id of a ring at the first cap, side
  std::vector<std::pair<Index, std::size_t>> secondOnes;
  for (std::size_t l = 0; l < rings.tables.size(); ++l)
  {
    firstOnes.emplace_back(rings.tables[l].row(0).minCoeff(), l);
    secondOnes.emplace_back(rings.tables[l].row(last).minCoeff(), l);
  }
  std::sort(firstOnes.begin(), firstOnes.end());
  std::sort(secondOnes.begin(), secondOnes.end());
  LinkedLoops linked;
  linked.swapped = secondOnes < firstOnes;
  const std::optional<SweepSections> sections = sweepSections(rings);
  for (const auto& [id, side] : linked.swapped ? secondOnes : firstOnes)
  {
    linked.pairs.push_back(pairFrom(rings, side, linked.swapped));
  }
  if (sections)
  {
    const bool against = runsAgainst(rings, sections->outer, linked.swapped) != linked.swapped;
    const std::vector<double> own = loopWinding(*sections).own;
    for (std::size_t p = 0; p < linked.pairs.size(); ++p)
    {
      const double turn = own[(linked.swapped ? secondOnes : firstOnes)[p].second];
      linked.pairs[p].turn = against ? -turn : turn;
    }
  }
  linked.pairs = outerFirst(std::move(linked.pairs));
  return linked;
}

LinkedLoops linkLoops(const PointsRef& firstCap, const std::vector<Loop>& firstLoops,
  const PointsRef& secondCap, const std::vector<Loop>& secondLoops, const PointsRef& linkingPoints,
  const QuadsRef& linkingQuads, double matchTolerance)
{
  const Quads quads =
    orientFaces(weldLinkingSeams(linkingPoints, linkingQuads, matchTolerance), "linking sides");
  const SurfaceTopology topology = checkSurface(quads, linkingPoints.rows(), "linking sides");
  const BoundarySearch onFirst(firstCap, firstLoops);
  const BoundarySearch onSecond(secondCap, secondLoops);

  LinkedLoops linked;
  std::vector<Loop> starts;
  for (std::size_t l = 0; l < topology.loops.size(); ++l)
  {
    const Points ring = loopPoints(linkingPoints, topology.loops[l]);
    const bool nearSecond = meanDistance(onSecond, ring) < meanDistance(onFirst, ring);
    if (l == 0)
    {
      linked.swapped = nearSecond;
    }
    if (nearSecond == linked.swapped)
    {
      starts.push_back(topology.loops[l]);
    }
  }
  if (starts.empty() || 2 * starts.size() != topology.loops.size())
  {
    throw InvalidInput("of the " + std::to_string(topology.loops.size()) +
      " boundary loops of the linking sides, " + std::to_string(starts.size()) +
      " lie at one cap and " + std::to_string(topology.loops.size() - starts.size()) +
      " at the other. Check that the linking sides lead from one of the two caps to the other.");
  }
  const RingStack rings = walkLinkingRings(linkingPoints, quads, starts);
  for (std::size_t l = 0; l < starts.size(); ++l)
  {
    linked.pairs.push_back(
      { ringPoints(rings, l, 0), ringPoints(rings, l, rings.numberOfLayers()), std::nullopt });
  }
  if (const std::optional<SweepSections> sections = sweepSections(rings))
  {
    const std::vector<double> own = loopWinding(*sections).own;
    for (std::size_t l = 0; l < starts.size(); ++l)
    {
      linked.pairs[l].turn = own[l];
    }
  }
  linked.pairs = outerFirst(std::move(linked.pairs));
  return linked;
}

CapBoundaries matchCapBoundaries(const Cap& first, const Cap& second,
  const std::vector<LoopPair>& pairs, double matchTolerance, const CapNames& names)
{
  CapBoundaries result;
  result.pairs = pairs;
  std::vector<const Points*> firstRings;
  std::vector<const Points*> secondRings;
  for (const LoopPair& pair : result.pairs)
  {
    firstRings.push_back(&pair.first);
    secondRings.push_back(&pair.second);
  }
  std::vector<RingOnCap> onFirst =
    findRings(first.points(), first.loops(), firstRings, names.first, names.rings);
  // The outer ring, not the way the cap happens to face, says which side is up: the result is the
  // same for both. Linking sides may have given the other rings either direction.
  TriangleMesh upright = first.mesh();
  const bool turnFirst = onFirst.front().reversed;
  if (turnFirst)
  {
    upright.triangles.col(1).swap(upright.triangles.col(2));
  }
  for (std::size_t p = 0; p < onFirst.size(); ++p)
  {
    if (onFirst[p].reversed != turnFirst)
    {
      LoopPair& pair = result.pairs[p];
      pair.first = pair.first.colwise().reverse().eval();
      pair.second = pair.second.colwise().reverse().eval();
      onFirst[p].reversed = turnFirst;
    }
  }
  const std::vector<RingOnCap> onSecond =
    findRings(second.points(), second.loops(), secondRings, names.second, names.rings);
  TriangleMesh turned = second.mesh();
  for (const RingOnCap& ring : onSecond)
  {
    if (ring.reversed != onSecond.front().reversed)
    {
      throw InvalidInput("some of the loops run the other way on the " + names.second +
        " than on the " + names.first +
        ": linked like this, a side is turned inside out. Check that the " + names.rings +
        verb(names.rings, " belongs", " belong") + " to this volume.");
    }
  }
  if (onSecond.front().reversed)
  {
    turned.triangles.col(1).swap(turned.triangles.col(2));
  }

  const AttachedLoops firstAttached =
    attach(first.points(), first.loops(), onFirst, firstRings, matchTolerance);
  const AttachedLoops secondAttached =
    attach(second.points(), second.loops(), onSecond, secondRings, matchTolerance);
  for (std::size_t p = 0; p < pairs.size(); ++p)
  {
    result.united.push_back(uniteParameters(
      pairs[p].first.rows(), { &firstAttached.places[p], &secondAttached.places[p] }));
  }
  result.first = splitAtUnion(upright, firstAttached, firstRings, result.united);
  result.second = splitAtUnion(turned, secondAttached, secondRings, result.united);
  result.first.maximumDistance = farthest(onFirst);
  result.second.maximumDistance = farthest(onSecond);
  return result;
}
}
