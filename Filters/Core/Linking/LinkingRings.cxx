// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/LinkingRings.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/PointGrid.h"
#include "Core/Linking/QuadNeighbors.h"
#include "Core/Linking/RingWalk.h"
#include "Core/Surfaces/NodeTolerance.h"
#include "Core/Surfaces/SeamWelding.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr Index None = -1;

/// The first ring of a loop, and how far its nodes are from those of the loop.
struct FirstRing
{
  Loop nodes;
  double maximumDistance = 0.0;
  Index snapped = 0;
};

/// Linking node of each loop node.
FirstRing matchLoop(const PointsRef& sourcePoints, const Loop& loop, std::size_t loopNumber,
  const PointsRef& linkingPoints, const std::vector<Index>& candidates, const PointGrid& grid,
  double matchTolerance, double roundingError)
{
  const std::vector<double> edgeLength = loopEdgeLengths(sourcePoints, loop);
  FirstRing ring;
  ring.nodes.assign(loop.size(), None);
  for (std::size_t j = 0; j < loop.size(); ++j)
  {
    const Eigen::RowVector3d place = sourcePoints.row(loop[j]);
    const double radius = coincidenceDistance(matchTolerance, edgeLength[j], roundingError);
    double nearest = std::numeric_limits<double>::max();
    grid.forEachNear(place, radius, [&](Index id, double distance) {
      if (distance < nearest || (distance == nearest && id < ring.nodes[j]))
      {
        nearest = distance;
        ring.nodes[j] = id;
      }
    });
    if (ring.nodes[j] == None)
    {
      for (const Index id : candidates)
      {
        nearest = std::min(nearest, (linkingPoints.row(id) - place).norm());
      }
      throw InvalidInput("the linking sides have no boundary node at node " + std::to_string(j) +
        " of loop " + std::to_string(loopNumber) + " of the source quads (point " +
        std::to_string(loop[j]) + ", at " + describe(place) + "): the nearest one is " +
        describe(nearest) + " away, the tolerance is " + describe(radius) +
        ". The first ring of the linking sides must have the nodes of the source loop; check that "
        "both belong to the same model, or raise MatchTolerance.");
    }
    ring.maximumDistance = std::max(ring.maximumDistance, nearest);
    ring.snapped += nearest > 0.0 ? 1 : 0;
  }
  return ring;
}

void checkSameLayers(const RingStack& rings)
{
  for (std::size_t l = 1; l < rings.tables.size(); ++l)
  {
    if (rings.tables[l].rows() != rings.tables[0].rows())
    {
      throw InvalidInput("the linking sides have " + std::to_string(rings.numberOfLayers()) +
        " layers at loop 0 but " + std::to_string(rings.tables[l].rows() - 1) + " at loop " +
        std::to_string(l) + ". Give all loops the same number of layers.");
    }
  }
}

/// For each side whether its first quad runs against the ring, see RingStack::turned.
std::vector<bool> turnedSides(const RingStack& rings, const Quads& quads)
{
  struct Place
  {
    std::size_t side;
    Index ring;
    Index column;
  };
  std::vector<Place> places(static_cast<std::size_t>(rings.points.rows()));
  for (std::size_t l = 0; l < rings.tables.size(); ++l)
  {
    const RingTable& table = rings.tables[l];
    for (Index k = 0; k < table.rows(); ++k)
    {
      for (Index j = 0; j < table.cols(); ++j)
      {
        places[static_cast<std::size_t>(table(k, j))] = { l, k, j };
      }
    }
  }
  const auto placeOf = [&](Index q, Index c) -> const Place& {
    return places[static_cast<std::size_t>(quads(q, c % 4))];
  };
  std::vector<bool> turned(rings.tables.size(), false);
  std::vector<bool> seen(rings.tables.size(), false);
  for (Index q = 0; q < quads.rows(); ++q)
  {
    const std::size_t side = placeOf(q, 0).side;
    for (Index c = 0; !seen[side] && c < 4; ++c)
    {
      const Place& from = placeOf(q, c);
      const Place& to = placeOf(q, c + 1);
      if (from.ring == to.ring && placeOf(q, c + 2).ring > from.ring)
      {
        turned[side] = to.column != (from.column + 1) % rings.tables[side].cols();
        seen[side] = true;
      }
    }
  }
  return turned;
}

/// @param quads with welded seams.
RingStack walkFrom(const PointsRef& points, const Quads& quads, const QuadNeighbors& neighbors,
  const std::vector<Loop>& firstRings)
{
  RingStack rings;
  rings.points = points;
  RingWalk walk(points, quads, neighbors);
  for (std::size_t l = 0; l < firstRings.size(); ++l)
  {
    rings.tables.push_back(walk.walk(firstRings[l], l));
  }
  checkSameLayers(rings);
  walk.checkAllSeen();
  rings.turned = turnedSides(rings, quads);
  return rings;
}
}

RingStack traceLinkingRings(const PointsRef& sourcePoints, const std::vector<Loop>& sourceLoops,
  const PointsRef& linkingPoints, const QuadsRef& linkingQuads, double matchTolerance)
{
  if (!(matchTolerance >= 0.0 && matchTolerance < 0.5))
  {
    throw InvalidInput("MatchTolerance must lie in [0, 0.5); it is relative to the local edge "
                       "length.");
  }
  const double roundingError =
    std::max(singlePrecisionError(sourcePoints), singlePrecisionError(linkingPoints));
  const Quads quads = weldLinkingSeams(linkingPoints, linkingQuads, matchTolerance);
  const QuadNeighbors neighbors(linkingPoints, quads);

  double largestRadius = 0.0;
  for (const Loop& loop : sourceLoops)
  {
    for (const double edge : loopEdgeLengths(sourcePoints, loop))
    {
      largestRadius =
        std::max(largestRadius, coincidenceDistance(matchTolerance, edge, roundingError));
    }
  }
  const std::vector<Index> candidates = neighbors.boundary();
  const PointGrid grid(linkingPoints, candidates, largestRadius);

  std::vector<Loop> firstRings;
  double maximumDistance = 0.0;
  Index snapped = 0;
  for (std::size_t l = 0; l < sourceLoops.size(); ++l)
  {
    FirstRing first = matchLoop(sourcePoints, sourceLoops[l], l, linkingPoints, candidates, grid,
      matchTolerance, roundingError);
    firstRings.push_back(std::move(first.nodes));
    maximumDistance = std::max(maximumDistance, first.maximumDistance);
    snapped += first.snapped;
  }
  RingStack rings = walkFrom(linkingPoints, quads, neighbors, firstRings);
  rings.loops = sourceLoops;
  rings.maximumMatchDistance = maximumDistance;
  rings.snapped = snapped;
  return rings;
}

RingStack walkLinkingRings(
  const PointsRef& linkingPoints, const Quads& welded, const std::vector<Loop>& firstRings)
{
  RingStack rings =
    walkFrom(linkingPoints, welded, QuadNeighbors(linkingPoints, welded), firstRings);
  rings.loops = firstRings;
  return rings;
}

TargetMatch matchTargetLoops(
  const PointsRef& targetPoints, const RingStack& rings, double matchTolerance)
{
  const double roundingError =
    std::max(singlePrecisionError(targetPoints), singlePrecisionError(rings.points));
  TargetMatch match;
  Index apart = 0;
  double worst = 0.0;
  std::string where;
  for (std::size_t l = 0; l < rings.loops.size(); ++l)
  {
    const Loop& loop = rings.loops[l];
    const Points ring = ringPoints(rings, l, rings.numberOfLayers());
    const std::vector<double> edgeLength = loopEdgeLengths(targetPoints, loop);
    for (std::size_t j = 0; j < loop.size(); ++j)
    {
      const Eigen::RowVector3d place = targetPoints.row(loop[j]);
      const double distance = (ring.row(static_cast<Index>(j)) - place).norm();
      match.maximumDistance = std::max(match.maximumDistance, distance);
      match.snapped += distance > 0.0 ? 1 : 0;
      if (!(distance <= coincidenceDistance(matchTolerance, edgeLength[j], roundingError)))
      {
        ++apart;
        if (!(distance <= worst))
        {
          worst = distance;
          where = "point " + std::to_string(loop[j]) + " (loop " + std::to_string(l) +
            ") of the target quads at " + describe(place) + " is " + describe(distance) +
            " away from its linking node at " + describe(ring.row(static_cast<Index>(j)));
        }
      }
    }
  }
  if (apart > 0)
  {
    throw InvalidInput("the last ring of the linking sides does not lie on the boundary of the "
                       "target quads: " +
      std::to_string(apart) + " nodes differ; the worst: " + where +
      ". Target quads must have the point order of the source quads and the boundary nodes of the "
      "last ring; check that they belong to the same model, or raise MatchTolerance.");
  }
  return match;
}
}
