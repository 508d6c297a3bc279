// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/SideFeatures.h"

#include "Core/Surfaces/SurfaceTopology.h"

#include <algorithm>
#include <limits>
#include <map>
#include <queue>
#include <tuple>

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

/// The cheapest way along borders from a point of the source loop to the target loop: its length,
/// plus `size` times 1 - cos of each turn. Empty: there is none that avoids taken points.
struct BorderPath
{
  double cost = 0.0;
  std::vector<Index> points;
};

class BorderTracing
{
public:
  BorderTracing(const PointsRef& points, const Neighbors& borders, const std::vector<Place>& places)
    : Coordinates(points)
    , Borders(borders)
    , Places(places)
    , First(borders.size() + 1, 0)
    , Size((points.colwise().maxCoeff() - points.colwise().minCoeff()).norm())
  {
    for (std::size_t i = 0; i < borders.size(); ++i)
    {
      this->First[i + 1] = this->First[i] + borders[i].size();
    }
  }

  /// Dijkstra's algorithm on directed edges, whose ends know where they come from.
  BorderPath from(Index start, const std::vector<bool>& taken) const
  {
    struct Step
    {
      double cost;
      Index from;
      Index to;
      std::size_t edge;
      bool operator>(const Step& other) const
      {
        return std::tie(this->cost, this->edge) > std::tie(other.cost, other.edge);
      }
    };
    std::map<std::size_t, std::size_t> before; // of each edge that is reached
    std::priority_queue<Step, std::vector<Step>, std::greater<>> open;
    std::map<std::size_t, Index> origin;
    std::map<std::size_t, double> reached;
    const auto pushFrom = [&](Index last, Index here, double cost, std::size_t edge) {
      const std::vector<Index>& choices = this->Borders[static_cast<std::size_t>(here)];
      for (std::size_t k = 0; k < choices.size(); ++k)
      {
        const Index next = choices[k];
        const auto at = static_cast<std::size_t>(next);
        const std::size_t own = this->First[static_cast<std::size_t>(here)] + k;
        if (next == last || taken[at] || this->Places[at] == Place::Source)
        {
          continue;
        }
        const Eigen::RowVector3d way = this->Coordinates.row(next) - this->Coordinates.row(here);
        double total = cost + way.norm();
        if (last >= 0)
        {
          const Eigen::RowVector3d came = this->Coordinates.row(here) - this->Coordinates.row(last);
          total += this->Size * (1.0 - came.normalized().dot(way.normalized()));
        }
        const auto known = reached.find(own);
        if (known == reached.end() || total < known->second)
        {
          reached[own] = total;
          before[own] = edge;
          origin[own] = here;
          open.push({ total, here, next, own });
        }
      }
    };
    constexpr std::size_t None = std::numeric_limits<std::size_t>::max();
    pushFrom(-1, start, 0.0, None);
    while (!open.empty())
    {
      const Step step = open.top();
      open.pop();
      if (step.cost > reached[step.edge])
      {
        continue;
      }
      if (this->Places[static_cast<std::size_t>(step.to)] != Place::Target)
      {
        pushFrom(step.from, step.to, step.cost, step.edge);
        continue;
      }
      BorderPath path;
      path.cost = step.cost;
      path.points.push_back(step.to);
      for (std::size_t edge = step.edge; edge != None; edge = before[edge])
      {
        path.points.push_back(origin[edge]);
      }
      std::reverse(path.points.begin(), path.points.end());
      return path;
    }
    return {};
  }

private:
  const PointsRef& Coordinates;
  const Neighbors& Borders;
  const std::vector<Place>& Places;
  std::vector<std::size_t> First; ///< number of the first edge at each point
  double Size;
};

bool meetsItself(std::vector<Index> points)
{
  std::sort(points.begin(), points.end());
  return std::adjacent_find(points.begin(), points.end()) != points.end();
}
}

std::vector<std::vector<Index>> crossingFeatures(const TriangleMesh& surface,
  const std::vector<Index>& faceIds, const Loop& sourceLoop, const Loop& targetLoop)
{
  const Neighbors borders = faceBorders(surface, faceIds);
  const std::vector<Place> places = placesOf(surface.points.rows(), sourceLoop, targetLoop);
  const PointsRef points(surface.points);
  const BorderTracing tracing(points, borders, places);
  std::vector<bool> taken(places.size(), false);
  std::vector<std::pair<double, std::size_t>> order; // cost, place on the source loop
  std::vector<BorderPath> best(sourceLoop.size());
  for (std::size_t i = 0; i < sourceLoop.size(); ++i)
  {
    best[i] = tracing.from(sourceLoop[i], taken);
    if (!best[i].points.empty())
    {
      order.emplace_back(best[i].cost, i);
    }
  }
  std::sort(order.begin(), order.end());
  const auto isTaken = [&](Index p) { return taken[static_cast<std::size_t>(p)]; };
  std::vector<std::vector<Index>> paths(sourceLoop.size());
  for (const auto& [cost, i] : order)
  {
    BorderPath& path = best[i];
    if (std::any_of(path.points.begin(), path.points.end(), isTaken))
    {
      path = tracing.from(sourceLoop[i], taken);
    }
    if (meetsItself(path.points))
    {
      continue;
    }
    for (const Index p : path.points)
    {
      taken[static_cast<std::size_t>(p)] = true;
    }
    paths[i] = std::move(path.points);
  }
  paths.erase(std::remove_if(paths.begin(), paths.end(),
                [](const std::vector<Index>& path) { return path.empty(); }),
    paths.end());
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
