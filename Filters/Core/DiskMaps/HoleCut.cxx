// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/HoleCut.h"

#include "Core/Common/Errors.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace hexsweep
{
namespace
{
/// Vertex ids that an edge joins to each vertex, in compressed rows; some come twice.
struct Adjacency
{
  std::vector<Index> begin;
  std::vector<Index> neighbors;
};

Adjacency adjacency(const TrianglesRef& triangles, Index n)
{
  Adjacency result;
  result.begin.assign(static_cast<std::size_t>(n) + 1, 0);
  for (Index k = 0; k < triangles.size(); ++k)
  {
    result.begin[static_cast<std::size_t>(triangles.data()[k]) + 1] += 2;
  }
  std::partial_sum(result.begin.begin(), result.begin.end(), result.begin.begin());
  std::vector<Index> next = result.begin;
  result.neighbors.resize(static_cast<std::size_t>(result.begin.back()));
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      for (const Index other : { (c + 1) % 3, (c + 2) % 3 })
      {
        Index& place = next[static_cast<std::size_t>(triangles(t, c))];
        result.neighbors[static_cast<std::size_t>(place++)] = triangles(t, other);
      }
    }
  }
  return result;
}
}

std::vector<Index> shortestCut(
  const TrianglesRef& triangles, Index numberOfPoints, const Loop& from, const Loop& to)
{
  const Adjacency edges = adjacency(triangles, numberOfPoints);
  constexpr Index Unseen = -2;
  constexpr Index Start = -1;
  std::vector<Index> previous(static_cast<std::size_t>(numberOfPoints), Unseen);
  std::vector<bool> isEnd(static_cast<std::size_t>(numberOfPoints), false);
  for (const Index v : to)
  {
    isEnd[static_cast<std::size_t>(v)] = true;
  }
  std::vector<Index> queue = from;
  std::sort(queue.begin(), queue.end());
  for (const Index v : queue)
  {
    previous[static_cast<std::size_t>(v)] = Start;
  }
  for (std::size_t q = 0; q < queue.size(); ++q)
  {
    const Index v = queue[q];
    if (isEnd[static_cast<std::size_t>(v)])
    {
      std::vector<Index> cut;
      for (Index w = v; w != Start; w = previous[static_cast<std::size_t>(w)])
      {
        cut.push_back(w);
      }
      std::reverse(cut.begin(), cut.end());
      return cut;
    }
    for (Index k = edges.begin[static_cast<std::size_t>(v)];
         k < edges.begin[static_cast<std::size_t>(v) + 1]; ++k)
    {
      const Index w = edges.neighbors[static_cast<std::size_t>(k)];
      if (previous[static_cast<std::size_t>(w)] == Unseen)
      {
        previous[static_cast<std::size_t>(w)] = v;
        queue.push_back(w);
      }
    }
  }
  throw InvalidInput("no path of edges leads from one loop to the other: the cap is in pieces. "
                     "Sweep each piece by itself.");
}

Corners leftOfCut(const TrianglesRef& triangles, const std::vector<Index>& cut)
{
  // The triangle, and its corner, at a vertex of the cut that follows or precedes an edge there
  // counter-clockwise.
  using Corner = std::pair<Index, Index>;
  std::map<std::pair<Index, Index>, Corner> after;
  std::map<std::pair<Index, Index>, Corner> before;
  std::vector<Index> sorted = cut;
  std::sort(sorted.begin(), sorted.end());
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index v = triangles(t, c);
      if (std::binary_search(sorted.begin(), sorted.end(), v))
      {
        after[{ v, triangles(t, (c + 1) % 3) }] = { t, c };
        before[{ v, triangles(t, (c + 2) % 3) }] = { t, c };
      }
    }
  }

  Corners left = Corners::Constant(triangles.rows(), 3, false);
  for (std::size_t k = 0; k < cut.size(); ++k)
  {
    // Left lies counter-clockwise of the edge ahead; at the last vertex, where there is none,
    // clockwise of the edge behind.
    const Index v = cut[k];
    const bool ahead = k + 1 < cut.size();
    const auto& turn = ahead ? after : before;
    const Index stop = k > 0 && ahead ? cut[k - 1] : -1;
    Index w = ahead ? cut[k + 1] : cut[k - 1];
    while (w != stop)
    {
      const auto found = turn.find({ v, w });
      if (found == turn.end())
      {
        break; // the loop is reached
      }
      const auto [t, c] = found->second;
      left(t, c) = true;
      w = triangles(t, (c + (ahead ? 2 : 1)) % 3);
    }
  }
  return left;
}
}
