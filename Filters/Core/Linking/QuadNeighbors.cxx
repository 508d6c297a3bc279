// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/QuadNeighbors.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"

#include <algorithm>
#include <string>

namespace hexsweep
{
QuadNeighbors::QuadNeighbors(const PointsRef& points, const Quads& quads)
  : Sides(sortedSides(quads, points.rows()))
{
  forEachEdge(this->Sides, [&](std::size_t first, std::size_t last) {
    const FaceSide& side = this->Sides[first];
    if (side.low == side.high)
    {
      throw InvalidInput("Quad " + std::to_string(side.face) +
        " of the linking sides has an edge of no length at " + describe(points.row(side.low)) +
        ". Remove the collapsed quads.");
    }
    if (last - first > 2)
    {
      throw InvalidInput(std::to_string(last - first) +
        " quads of the linking sides meet at the edge from " + describe(points.row(side.low)) +
        " to " + describe(points.row(side.high)) +
        "; at most two may. Remove duplicate cells, and cells that are not on a linking side.");
    }
  });
}

std::pair<const FaceSide*, const FaceSide*> QuadNeighbors::edge(Index a, Index b) const
{
  const auto ends = std::minmax(a, b);
  const auto before = [](const FaceSide& side, const std::pair<Index, Index>& key) {
    return std::make_pair(side.low, side.high) < key;
  };
  const auto first = std::lower_bound(
    this->Sides.begin(), this->Sides.end(), std::make_pair(ends.first, ends.second), before);
  auto last = first;
  while (last != this->Sides.end() && last->low == ends.first && last->high == ends.second)
  {
    ++last;
  }
  const FaceSide* base = this->Sides.data();
  return { base + (first - this->Sides.begin()), base + (last - this->Sides.begin()) };
}
}
