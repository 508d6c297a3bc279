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

void checkSameLayers(const LinkingRings& rings)
{
  for (std::size_t l = 1; l < rings.loops.size(); ++l)
  {
    if (rings.loops[l].rows() != rings.loops[0].rows())
    {
      throw InvalidInput("the linking sides have " + std::to_string(rings.numberOfLayers()) +
        " layers at loop 0 but " + std::to_string(rings.loops[l].rows() - 1) + " at loop " +
        std::to_string(l) + ". Give all loops the same number of layers.");
    }
  }
}
}

LinkingRings traceLinkingRings(const PointsRef& sourcePoints, const std::vector<Loop>& sourceLoops,
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

  LinkingRings rings;
  RingWalk walk(linkingPoints, quads, neighbors);
  for (std::size_t l = 0; l < sourceLoops.size(); ++l)
  {
    const FirstRing first = matchLoop(sourcePoints, sourceLoops[l], l, linkingPoints, candidates,
      grid, matchTolerance, roundingError);
    rings.loops.push_back(walk.walk(first.nodes, l));
    rings.maximumMatchDistance = std::max(rings.maximumMatchDistance, first.maximumDistance);
    rings.snapped += first.snapped;
  }
  checkSameLayers(rings);
  walk.checkAllSeen();
  return rings;
}

Points ringPoints(
  const LinkingRings& rings, const PointsRef& linkingPoints, std::size_t loop, Index ring)
{
  const RingTable& table = rings.loops.at(loop);
  Points points(table.cols(), 3);
  for (Index j = 0; j < table.cols(); ++j)
  {
    points.row(j) = linkingPoints.row(table(ring, j));
  }
  return points;
}

TargetMatch matchTargetLoops(const PointsRef& targetPoints, const std::vector<Loop>& sourceLoops,
  const LinkingRings& rings, const PointsRef& linkingPoints, double matchTolerance)
{
  const double roundingError =
    std::max(singlePrecisionError(targetPoints), singlePrecisionError(linkingPoints));
  TargetMatch match;
  Index apart = 0;
  double worst = 0.0;
  std::string where;
  for (std::size_t l = 0; l < sourceLoops.size(); ++l)
  {
    const Loop& loop = sourceLoops[l];
    const Points ring = ringPoints(rings, linkingPoints, l, rings.numberOfLayers());
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
