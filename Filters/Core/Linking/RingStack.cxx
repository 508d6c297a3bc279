// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/RingStack.h"

#include <utility>

namespace hexsweep
{
Points ringPoints(const RingStack& rings, std::size_t loop, Index ring)
{
  const RingTable& table = rings.tables.at(loop);
  Points points(table.cols(), 3);
  for (Index j = 0; j < table.cols(); ++j)
  {
    points.row(j) = rings.points.row(table(ring, j));
  }
  return points;
}

RingStack stackRings(Points points, std::vector<Loop> loops, Index layers)
{
  RingStack rings;
  Index next = 0;
  for (const Loop& loop : loops)
  {
    RingTable table(layers + 1, static_cast<Index>(loop.size()));
    for (Index i = 0; i < table.size(); ++i)
    {
      table.data()[i] = next++;
    }
    rings.tables.push_back(std::move(table));
  }
  rings.turned.assign(loops.size(), false);
  rings.points = std::move(points);
  rings.loops = std::move(loops);
  return rings;
}
}
