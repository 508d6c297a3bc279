// SPDX-License-Identifier: BSD-3-Clause
#include "SideFeatures.h"

#include "SurfaceTopology.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace hexsweep
{
namespace
{
using Neighbors = std::vector<std::vector<Index>>;

/// Ends of the inner edges between triangles of different faces.
Neighbors faceBorders(const TriangleMesh& surface, const std::vector<Index>& faceIds)
{
  Neighbors neighbors(static_cast<std::size_t>(surface.points.rows()));
  const Triangles across = triangleNeighbors(surface.triangles);
  for (Index t = 0; t < across.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      if (across(t, c) > t &&
        faceIds[static_cast<std::size_t>(t)] != faceIds[static_cast<std::size_t>(across(t, c))])
      {
        const Index a = surface.triangles(t, c);
        const Index b = surface.triangles(t, (c + 1) % 3);
        neighbors[static_cast<std::size_t>(a)].push_back(b);
        neighbors[static_cast<std::size_t>(b)].push_back(a);
      }
    }
  }
  return neighbors;
}

enum class Place : char
{
  Inside,
  Source,
  Target
};

std::vector<Place> placesOf(Index n, const Loop& sourceLoop, const Loop& targetLoop)
{
  std::vector<Place> places(static_cast<std::size_t>(n), Place::Inside);
  for (const Index i : sourceLoop)
  {
    places[static_cast<std::size_t>(i)] = Place::Source;
  }
  for (const Index i : targetLoop)
  {
    places[static_cast<std::size_t>(i)] = Place::Target;
  }
  return places;
}

/// The next point that continues a -> b most directly, or -1.
Index straightest(const PointsRef& points, Index a, Index b, const std::vector<Index>& choices)
{
  const Eigen::RowVector3d direction = (points.row(b) - points.row(a)).normalized();
  Index best = -1;
  double most = -std::numeric_limits<double>::infinity();
  for (const Index c : choices)
  {
    const double cosine = direction.dot((points.row(c) - points.row(b)).normalized());
    if (c != a && cosine > most)
    {
      most = cosine;
      best = c;
    }
  }
  return best;
}
}

std::vector<std::vector<Index>> crossingFeatures(const TriangleMesh& surface,
  const std::vector<Index>& faceIds, const Loop& sourceLoop, const Loop& targetLoop)
{
  const Neighbors borders = faceBorders(surface, faceIds);
  const std::vector<Place> places = placesOf(surface.points.rows(), sourceLoop, targetLoop);
  std::vector<bool> taken(places.size(), false);
  std::vector<std::vector<Index>> paths;
  for (const Index start : sourceLoop)
  {
    for (const Index second : borders[static_cast<std::size_t>(start)])
    {
      std::vector<Index> path = { start };
      std::vector<Index> visited = { start };
      bool blocked = taken[static_cast<std::size_t>(start)];
      Index last = start;
      Index next = second;
      while (!blocked && next >= 0)
      {
        const std::size_t at = static_cast<std::size_t>(next);
        blocked = taken[at] || places[at] == Place::Source;
        taken[at] = true;
        visited.push_back(next);
        path.push_back(next);
        if (blocked || places[at] == Place::Target)
        {
          break;
        }
        const Index following = straightest(surface.points, last, next, borders[at]);
        last = next;
        next = following;
      }
      if (!blocked && places[static_cast<std::size_t>(path.back())] == Place::Target)
      {
        taken[static_cast<std::size_t>(start)] = true;
        paths.push_back(std::move(path));
      }
      else if (!visited.empty())
      {
        // What was walked over in vain is free again; a point that another path holds stays so.
        const std::size_t own = visited.size() - (blocked && visited.size() > 1 ? 1 : 0);
        for (std::size_t i = 1; i < own; ++i)
        {
          taken[static_cast<std::size_t>(visited[i])] = false;
        }
      }
    }
  }
  return paths;
}

std::vector<Index> shortestCrossing(
  const TriangleMesh& surface, const Loop& sourceLoop, const Loop& targetLoop)
{
  const std::size_t n = static_cast<std::size_t>(surface.points.rows());
  Neighbors neighbors(n);
  for (Index t = 0; t < surface.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index a = surface.triangles(t, c);
      const Index b = surface.triangles(t, (c + 1) % 3);
      neighbors[static_cast<std::size_t>(a)].push_back(b);
      neighbors[static_cast<std::size_t>(b)].push_back(a);
    }
  }
  const std::vector<Place> places = placesOf(surface.points.rows(), sourceLoop, targetLoop);
  std::vector<double> distance(n, std::numeric_limits<double>::infinity());
  std::vector<Index> before(n, -1);
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (const Index i : sourceLoop)
  {
    distance[static_cast<std::size_t>(i)] = 0.0;
    open.emplace(0.0, i);
  }
  while (!open.empty())
  {
    const auto [reached, i] = open.top();
    open.pop();
    if (places[static_cast<std::size_t>(i)] == Place::Target)
    {
      std::vector<Index> path;
      for (Index p = i; p >= 0; p = before[static_cast<std::size_t>(p)])
      {
        path.push_back(p);
      }
      std::reverse(path.begin(), path.end());
      return path;
    }
    if (reached > distance[static_cast<std::size_t>(i)])
    {
      continue;
    }
    for (const Index j : neighbors[static_cast<std::size_t>(i)])
    {
      const double length = reached + (surface.points.row(j) - surface.points.row(i)).norm();
      if (length < distance[static_cast<std::size_t>(j)])
      {
        distance[static_cast<std::size_t>(j)] = length;
        before[static_cast<std::size_t>(j)] = i;
        open.emplace(length, j);
      }
    }
  }
  return {};
}
}
