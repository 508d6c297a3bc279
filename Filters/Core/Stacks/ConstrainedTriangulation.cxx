// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/ConstrainedTriangulation.h"

#include "Core/Stacks/DelaunayCells.h"

#include <algorithm>

namespace hexsweep
{
namespace
{
/// -1 where the way to the frame crosses no edge; else numbers from 0 on.
std::vector<Index> regionsOf(const std::vector<DelaunayCell>& cells, Index points, Index& count)
{
  std::vector<Index> region(cells.size(), -2);
  const auto flood = [&](std::size_t start, Index number) {
    std::vector<std::size_t> open(1, start);
    region[start] = number;
    while (!open.empty())
    {
      const std::size_t t = open.back();
      open.pop_back();
      for (std::size_t c = 0; c < 3; ++c)
      {
        const Index u = cells[t].across[c];
        if (u >= 0 && !cells[t].isEdge[c] && region[static_cast<std::size_t>(u)] == -2)
        {
          region[static_cast<std::size_t>(u)] = number;
          open.push_back(static_cast<std::size_t>(u));
        }
      }
    }
  };
  for (std::size_t t = 0; t < cells.size(); ++t)
  {
    const auto& corner = cells[t].corner;
    if (region[t] == -2 && *std::max_element(corner.begin(), corner.end()) >= points)
    {
      flood(t, -1);
    }
  }
  count = 0;
  for (std::size_t t = 0; t < cells.size(); ++t)
  {
    if (region[t] == -2)
    {
      flood(t, count++);
    }
  }
  return region;
}
}

ConstrainedTriangles triangulateGraph(const PlaneGraph& graph)
{
  ConstrainedTriangles result;
  if (graph.edges.empty())
  {
    return result;
  }
  const std::vector<DelaunayCell> cells = delaunayCells(graph);
  const std::vector<Index> region = regionsOf(cells, graph.points.rows(), result.regions);
  std::vector<Index> number(cells.size(), -1);
  Index count = 0;
  for (std::size_t t = 0; t < cells.size(); ++t)
  {
    number[t] = region[t] >= 0 ? count++ : -1;
  }
  result.triangles.resize(count, 3);
  result.neighbors.resize(count, 3);
  for (std::size_t t = 0; t < cells.size(); ++t)
  {
    if (number[t] < 0)
    {
      continue;
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
      const Index u = cells[t].across[c];
      result.triangles(number[t], static_cast<Index>(c)) = cells[t].corner[c];
      result.neighbors(number[t], static_cast<Index>(c)) =
        u < 0 ? -1 : number[static_cast<std::size_t>(u)];
    }
    result.isEdge.push_back(cells[t].isEdge);
    result.regionOf.push_back(region[t]);
  }
  return result;
}
}
