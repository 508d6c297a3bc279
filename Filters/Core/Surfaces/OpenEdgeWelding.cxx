// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/OpenEdgeWelding.h"

#include "Core/Common/DisjointSets.h"
#include "Core/Geometry/PointGrid.h"
#include "Core/Surfaces/FaceSides.h"
#include "Core/Surfaces/NodeTolerance.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace hexsweep
{
namespace
{
/// Finds points by their coordinates: an open-addressing hash table of ids.
class ExactPoints
{
public:
  ExactPoints(const PointsRef& points, std::size_t count)
    : Positions(points)
  {
    std::size_t size = 16;
    while (size < 2 * count)
    {
      size *= 2;
    }
    this->Slots.assign(size, -1);
  }

  /// The first point that was asked for with the coordinates of this one.
  Index first(Index id)
  {
    const std::size_t mask = this->Slots.size() - 1;
    std::size_t slot = this->hash(id) & mask;
    while (
      this->Slots[slot] >= 0 && this->Positions.row(this->Slots[slot]) != this->Positions.row(id))
    {
      slot = (slot + 1) & mask;
    }
    if (this->Slots[slot] < 0)
    {
      this->Slots[slot] = id;
    }
    return this->Slots[slot];
  }

private:
  std::size_t hash(Index id) const
  {
    std::uint64_t mixed = 0;
    for (int c = 0; c < 3; ++c)
    {
      const double x = this->Positions(id, c) + 0.0; // -0 and 0 are equal
      std::uint64_t bits = 0;
      std::memcpy(&bits, &x, sizeof(bits));
      // Multiplication spreads bits upwards, the shift brings them back down.
      mixed = (mixed ^ bits) * 0x9e3779b97f4a7c15ULL;
      mixed ^= mixed >> 32;
    }
    return static_cast<std::size_t>(mixed);
  }

  PointsRef Positions;
  std::vector<Index> Slots;
};

void joinEqualPoints(const PointsRef& points, const std::vector<Index>& ids, DisjointSets& joined)
{
  ExactPoints table(points, ids.size());
  for (const Index id : ids)
  {
    joined.join(id, table.first(id));
  }
}

void joinEndsOfEmptyEdges(
  const PointsRef& points, const TrianglesRef& triangles, DisjointSets& joined)
{
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      const Index a = triangles(t, c);
      const Index b = triangles(t, (c + 1) % 3);
      if (a != b && points.row(a) == points.row(b))
      {
        joined.join(a, b);
      }
    }
  }
}

/// Length of the shortest edge at each point, edges without length left out.
std::vector<double> shortestEdges(const PointsRef& points, const std::vector<FaceSide>& sides)
{
  std::vector<double> shortest(
    static_cast<std::size_t>(points.rows()), std::numeric_limits<double>::max());
  for (const FaceSide& side : sides)
  {
    const double length = (points.row(side.low) - points.row(side.high)).norm();
    if (length > 0.0)
    {
      double& low = shortest[static_cast<std::size_t>(side.low)];
      double& high = shortest[static_cast<std::size_t>(side.high)];
      low = std::min(low, length);
      high = std::min(high, length);
    }
  }
  return shortest;
}

void joinNearPoints(const PointsRef& points, const std::vector<FaceSide>& sides,
  const std::vector<Index>& ids, double matchTolerance, DisjointSets& joined)
{
  const std::vector<double> edges = shortestEdges(points, sides);
  const double roundingError = singlePrecisionError(points);
  const auto radiusOf = [&](Index id) {
    const double edge = edges[static_cast<std::size_t>(id)];
    return edge < std::numeric_limits<double>::max()
      ? coincidenceDistance(matchTolerance, edge, roundingError)
      : 0.0;
  };
  double largest = 0.0;
  for (const Index id : ids)
  {
    largest = std::max(largest, radiusOf(id));
  }
  const PointGrid grid(points, ids, largest);
  for (const Index id : ids)
  {
    grid.forEachNear(
      points.row(id), radiusOf(id), [&](Index other, double) { joined.join(id, other); });
  }
}

Triangles renumbered(const TrianglesRef& triangles, DisjointSets& joined)
{
  Triangles result = triangles;
  for (Index i = 0; i < result.size(); ++i)
  {
    result.data()[i] = joined.find(result.data()[i]);
  }
  return result;
}
}

std::vector<Index> weldOpenEdges(
  const PointsRef& points, const TrianglesRef& triangles, double matchTolerance)
{
  DisjointSets joined(points.rows());
  joinEndsOfEmptyEdges(points, triangles, joined);
  std::vector<Index> open = boundaryPoints(sortedSides(triangles, points.rows()));
  if (!open.empty())
  {
    joinEqualPoints(points, open, joined);
    const std::vector<FaceSide> sides = sortedSides(renumbered(triangles, joined), points.rows());
    open = boundaryPoints(sides);
    if (!open.empty())
    {
      joinNearPoints(points, sides, open, matchTolerance, joined);
    }
  }
  std::vector<Index> welded(static_cast<std::size_t>(points.rows()));
  for (Index p = 0; p < points.rows(); ++p)
  {
    welded[static_cast<std::size_t>(p)] = joined.find(p);
  }
  return welded;
}
}
