// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/SideCut.h"

#include "Core/Common/DisjointSets.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
using Edges = std::set<std::pair<Index, Index>>; // the lower point first

Edges edgesOf(const std::vector<std::vector<Index>>& paths)
{
  Edges edges;
  for (const std::vector<Index>& path : paths)
  {
    for (std::size_t k = 1; k < path.size(); ++k)
    {
      edges.emplace(std::minmax(path[k - 1], path[k]));
    }
  }
  return edges;
}

/// Corners (3 t + c) of the triangles that have an edge of the path on their own way round.
std::vector<Index> cornersLeftOf(const std::vector<Index>& path, const Triangles& triangles)
{
  std::map<Index, Index> next;
  for (std::size_t k = 1; k < path.size(); ++k)
  {
    next[path[k - 1]] = path[k];
  }
  std::vector<Index> corners;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const auto following = next.find(triangles(t, c));
      if (following != next.end() && following->second == triangles(t, (c + 1) % 3))
      {
        corners.push_back(3 * t + c);
        corners.push_back(3 * t + (c + 1) % 3);
      }
    }
  }
  return corners;
}

/// Corners are one point where their triangles share an edge that is not cut.
DisjointSets joinCorners(const Triangles& triangles, const Edges& cut)
{
  const Triangles across = triangleNeighbors(triangles);
  DisjointSets sets(triangles.size());
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index a = triangles(t, c);
      const Index b = triangles(t, (c + 1) % 3);
      const Index neighbor = across(t, c);
      if (neighbor < t || cut.count(std::minmax(a, b)) > 0)
      {
        continue;
      }
      for (Index d = 0; d < 3; ++d)
      {
        if (triangles(neighbor, d) == b && triangles(neighbor, (d + 1) % 3) == a)
        {
          sets.join(3 * t + c, 3 * neighbor + (d + 1) % 3);
          sets.join(3 * t + (c + 1) % 3, 3 * neighbor + d);
        }
      }
    }
  }
  return sets;
}
}

CutTube cutTube(const TriangleMesh& tube, const std::vector<std::vector<Index>>& paths)
{
  DisjointSets sets = joinCorners(tube.triangles, edgesOf(paths));
  const Index corners = tube.triangles.size();
  CutTube result;
  result.mesh.triangles.resize(tube.triangles.rows(), 3);
  std::vector<Index> number(at(corners), -1);
  for (Index corner = 0; corner < corners; ++corner)
  {
    Index& id = number[at(sets.find(corner))];
    if (id < 0)
    {
      id = static_cast<Index>(result.original.size());
      result.original.push_back(tube.triangles(corner / 3, corner % 3));
    }
    result.mesh.triangles(corner / 3, corner % 3) = id;
  }
  result.onLeft.assign(result.original.size(), false);
  for (const Index corner : cornersLeftOf(paths.front(), tube.triangles))
  {
    result.onLeft[at(result.mesh.triangles(corner / 3, corner % 3))] = true;
  }
  result.mesh.points.resize(static_cast<Index>(result.original.size()), 3);
  for (std::size_t i = 0; i < result.original.size(); ++i)
  {
    result.mesh.points.row(static_cast<Index>(i)) = tube.points.row(result.original[i]);
  }
  return result;
}
}
