// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SeamWelding.h"

#include "Core/Common/DisjointSets.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/CoordinateRange.h"
#include "Core/Geometry/PointGrid.h"
#include "Core/Surfaces/FaceSides.h"
#include "Core/Surfaces/NodeTolerance.h"

#include <algorithm>
#include <limits>
#include <string>

namespace hexsweep
{
namespace
{
/// Length of the shortest quad edge at each point.
std::vector<double> shortestQuadEdges(const PointsRef& points, const std::vector<FaceSide>& sides)
{
  std::vector<double> shortest(
    static_cast<std::size_t>(points.rows()), std::numeric_limits<double>::max());
  for (const FaceSide& side : sides)
  {
    const double length = (points.row(side.low) - points.row(side.high)).norm();
    shortest[side.low] = std::min(shortest[side.low], length);
    shortest[side.high] = std::min(shortest[side.high], length);
  }
  return shortest;
}

void checkQuads(const PointsRef& points, const QuadsRef& quads)
{
  if (quads.rows() == 0)
  {
    throw InvalidInput("the linking sides have no quads. Mesh them with structured quads first.");
  }
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (int c = 0; c < 4; ++c)
    {
      const Index id = quads(q, c);
      if (id < 0 || id >= points.rows())
      {
        throw InvalidInput("Quad " + std::to_string(q) +
          " of the linking sides names a point that does not exist (" + std::to_string(id) + ").");
      }
    }
  }
  checkCoordinates(points, quads, "linking sides");
}

/// Joins patches that repeat the points of their common seam: point id -> smallest id there.
std::vector<Index> weldSeams(
  const PointsRef& points, const QuadsRef& quads, double matchTolerance, double roundingError)
{
  DisjointSets joined(points.rows());
  const std::vector<FaceSide> sides = sortedSides(quads, points.rows());
  const std::vector<Index> candidates = boundaryPoints(sides);
  const std::vector<double> edgeLength = shortestQuadEdges(points, sides);
  const auto radiusOf = [&](Index id) {
    return coincidenceDistance(matchTolerance, edgeLength[id], roundingError);
  };

  double largestRadius = 0.0;
  for (const Index id : candidates)
  {
    largestRadius = std::max(largestRadius, radiusOf(id));
  }
  const PointGrid grid(points, candidates, largestRadius);
  for (const Index id : candidates)
  {
    grid.forEachNear(
      points.row(id), radiusOf(id), [&](Index other, double) { joined.join(id, other); });
  }
  std::vector<Index> welded;
  for (Index i = 0; i < points.rows(); ++i)
  {
    welded.push_back(joined.find(i));
  }
  return welded;
}
}

Quads weldLinkingSeams(
  const PointsRef& linkingPoints, const QuadsRef& linkingQuads, double matchTolerance)
{
  checkQuads(linkingPoints, linkingQuads);
  const std::vector<Index> welded =
    weldSeams(linkingPoints, linkingQuads, matchTolerance, singlePrecisionError(linkingPoints));
  Quads quads = linkingQuads;
  for (Index i = 0; i < quads.size(); ++i)
  {
    quads.data()[i] = welded[quads.data()[i]];
  }
  return quads;
}
}
