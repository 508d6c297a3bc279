// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/TriangleEdges.h"

#include <algorithm>
#include <utility>

namespace hexsweep
{
TriangleEdges triangleEdges(const TrianglesRef& triangles)
{
  const auto edgeOf = [&](Index t, int c) {
    return std::minmax({ triangles(t, (c + 1) % 3), triangles(t, (c + 2) % 3) });
  };
  std::vector<std::pair<Index, Index>> all;
  all.reserve(static_cast<std::size_t>(triangles.size()));
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      all.push_back(edgeOf(t, c));
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());

  TriangleEdges edges;
  edges.ends.resize(static_cast<Index>(all.size()), 2);
  for (std::size_t e = 0; e < all.size(); ++e)
  {
    edges.ends.row(static_cast<Index>(e)) << all[e].first, all[e].second;
  }
  edges.opposite.resize(triangles.rows(), 3);
  edges.direction.resize(triangles.rows(), 3);
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      const std::pair<Index, Index> edge = edgeOf(t, c);
      edges.opposite(t, c) = std::lower_bound(all.begin(), all.end(), edge) - all.begin();
      edges.direction(t, c) = triangles(t, (c + 1) % 3) == edge.first ? 1.0 : -1.0;
    }
  }
  return edges;
}
}
