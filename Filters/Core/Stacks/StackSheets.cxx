// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/StackSheets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <set>

namespace hexsweep
{
namespace
{
constexpr double Slope = 0.25;
constexpr double Share = 0.7; // of an even part of the room between caps
constexpr int MostSweeps = 400;
constexpr double OverRelaxation = 1.7;
constexpr double Settled = 1e-7; // of the range of heights

/// Entries of all nodes one after the other.
struct SheetGraph
{
  std::vector<std::size_t> first;               ///< entry of each node, and one past the last
  std::vector<std::vector<std::size_t>> beside; ///< entries of one level on neighbouring nodes
  std::vector<double> gain;                     ///< length along the mesh from the nearest cap
};

std::vector<std::set<Index>> nodeRegions(const StackPlane& plane)
{
  std::vector<std::set<Index>> result(static_cast<std::size_t>(plane.mesh.points.rows()));
  for (Index q = 0; q < plane.mesh.quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      result[static_cast<std::size_t>(plane.mesh.quads(q, c))].insert(
        plane.regionOf[static_cast<std::size_t>(q)]);
    }
  }
  return result;
}

/// Whether each region has each level.
std::vector<std::vector<bool>> regionLevels(const StackLevels& levels)
{
  std::vector<std::vector<bool>> result;
  for (const auto& intervals : levels.intervals)
  {
    std::vector<bool> has(static_cast<std::size_t>(levels.count), false);
    for (const auto& interval : intervals)
    {
      for (const Index level : interval)
      {
        has[static_cast<std::size_t>(level)] = true;
      }
    }
    result.push_back(std::move(has));
  }
  return result;
}

StackSheets capNodes(const StackPlane& plane, const StackArrangement& arrangement,
  const StackLevels& levels, const CapHeights& heights)
{
  StackSheets sheets(static_cast<std::size_t>(plane.mesh.points.rows()));
  const std::vector<std::set<Index>> regions = nodeRegions(plane);
  for (std::size_t i = 0; i < sheets.size(); ++i)
  {
    const Eigen::RowVector2d place = plane.mesh.points.row(static_cast<Index>(i)).head<2>();
    std::map<Index, std::pair<double, int>> fixed;
    std::set<Index> all;
    std::set<std::size_t> asked;
    for (const Index region : regions[i])
    {
      const auto r = static_cast<std::size_t>(region);
      for (std::size_t k = 0; k < arrangement.stacks[r].size(); ++k)
      {
        if (asked.insert(arrangement.stacks[r][k]).second)
        {
          auto& sum = fixed[levels.ofCaps[r][k]];
          sum.first += heights.exact(arrangement.stacks[r][k], place);
          ++sum.second;
        }
      }
      for (const auto& interval : levels.intervals[r])
      {
        all.insert(interval.begin(), interval.end());
      }
    }
    for (const Index level : all)
    {
      const auto known = fixed.find(level);
      const bool isFixed = known != fixed.end();
      sheets[i].push_back({ level,
        isFixed ? known->second.first / known->second.second
                : std::numeric_limits<double>::quiet_NaN(),
        isFixed });
    }
  }
  return sheets;
}

SheetGraph graphOf(const StackPlane& plane, const StackLevels& levels, const StackSheets& sheets)
{
  SheetGraph graph;
  graph.first.push_back(0);
  for (const auto& node : sheets)
  {
    graph.first.push_back(graph.first.back() + node.size());
  }
  graph.beside.resize(graph.first.back());
  const std::vector<std::vector<bool>> has = regionLevels(levels);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (Index q = 0; q < plane.mesh.quads.rows(); ++q)
  {
    const auto region = static_cast<std::size_t>(plane.regionOf[static_cast<std::size_t>(q)]);
    for (Index c = 0; c < 4; ++c)
    {
      const auto i = static_cast<std::size_t>(plane.mesh.quads(q, c));
      const auto j = static_cast<std::size_t>(plane.mesh.quads(q, (c + 1) % 4));
      std::size_t b = 0;
      for (std::size_t a = 0; a < sheets[i].size(); ++a)
      {
        while (b < sheets[j].size() && sheets[j][b].level < sheets[i][a].level)
        {
          ++b;
        }
        if (b < sheets[j].size() && sheets[j][b].level == sheets[i][a].level &&
          has[region][static_cast<std::size_t>(sheets[i][a].level)])
        {
          pairs.push_back(std::minmax(graph.first[i] + a, graph.first[j] + b));
        }
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  for (const auto& [a, b] : pairs)
  {
    graph.beside[a].push_back(b);
    graph.beside[b].push_back(a);
  }
  return graph;
}

/// The same as one list.
std::vector<SheetNode> flattened(const StackSheets& sheets)
{
  std::vector<SheetNode> all;
  for (const auto& node : sheets)
  {
    all.insert(all.end(), node.begin(), node.end());
  }
  return all;
}

std::vector<std::size_t> nodesOfEntries(const SheetGraph& graph)
{
  std::vector<std::size_t> nodes;
  for (std::size_t i = 0; i + 1 < graph.first.size(); ++i)
  {
    nodes.insert(nodes.end(), graph.first[i + 1] - graph.first[i], i);
  }
  return nodes;
}

/// Ways from the caps along each level, and the heights of the nearest caps to begin with.
void spreadFromCaps(const StackPlane& plane, SheetGraph& graph, std::vector<SheetNode>& entries)
{
  const std::vector<std::size_t> nodeOf = nodesOfEntries(graph);
  graph.gain.assign(entries.size(), std::numeric_limits<double>::infinity());
  using Open = std::pair<double, std::size_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  for (std::size_t e = 0; e < entries.size(); ++e)
  {
    if (entries[e].fixed)
    {
      graph.gain[e] = 0.0;
      open.emplace(0.0, e);
    }
  }
  while (!open.empty())
  {
    const auto [gain, e] = open.top();
    open.pop();
    if (gain > graph.gain[e])
    {
      continue;
    }
    for (const std::size_t other : graph.beside[e])
    {
      const double next = gain +
        (plane.mesh.points.row(static_cast<Index>(nodeOf[e])) -
          plane.mesh.points.row(static_cast<Index>(nodeOf[other])))
          .norm();
      if (next < graph.gain[other])
      {
        graph.gain[other] = next;
        entries[other].height = entries[e].height;
        open.emplace(next, other);
      }
    }
  }
}

/// One an entry: of the room between the caps round it.
std::vector<double> sharesOf(const SheetGraph& graph, const std::vector<SheetNode>& entries)
{
  std::vector<double> share(entries.size(), 0.0);
  for (std::size_t i = 0; i + 1 < graph.first.size(); ++i)
  {
    std::size_t low = graph.first[i];
    for (std::size_t e = low + 1; e < graph.first[i + 1]; ++e)
    {
      if (entries[e].fixed)
      {
        const double room = std::max(0.0, entries[e].height - entries[low].height);
        for (std::size_t k = low + 1; k < e; ++k)
        {
          share[k] = Share * room / static_cast<double>(e - low);
        }
        low = e;
      }
    }
  }
  return share;
}

/// Keeps the levels over a node apart: first from below, then from above, where caps end it.
void keepApart(const std::vector<double>& off, std::size_t begin, std::size_t end,
  std::vector<SheetNode>& entries)
{
  for (std::size_t e = begin + 1; e < end; ++e)
  {
    if (!entries[e].fixed)
    {
      entries[e].height = std::max(entries[e].height, entries[e - 1].height + off[e - 1]);
    }
  }
  for (std::size_t e = end - 1; e > begin; --e)
  {
    if (!entries[e - 1].fixed)
    {
      entries[e - 1].height = std::min(entries[e - 1].height, entries[e].height - off[e - 1]);
    }
  }
}

/// Least distances of each entry from the next one of its node.
std::vector<double> leastDistances(
  const SheetGraph& graph, const std::vector<SheetNode>& entries, double gap)
{
  const std::vector<double> share = sharesOf(graph, entries);
  const auto own = [&](std::size_t e) {
    return entries[e].fixed ? 0.0 : std::min({ share[e], gap, Slope * graph.gain[e] });
  };
  std::vector<double> off(entries.size(), 0.0);
  for (std::size_t i = 0; i + 1 < graph.first.size(); ++i)
  {
    for (std::size_t e = graph.first[i]; e + 1 < graph.first[i + 1]; ++e)
    {
      off[e] = std::max(own(e), own(e + 1));
    }
  }
  return off;
}

/// Gauss and Seidel's rounds, each node's levels kept apart.
void settle(const SheetGraph& graph, double gap, std::vector<SheetNode>& entries)
{
  const std::vector<double> off = leastDistances(graph, entries, gap);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const SheetNode& entry : entries)
  {
    low = entry.fixed ? std::min(low, entry.height) : low;
    high = entry.fixed ? std::max(high, entry.height) : high;
  }
  std::vector<double> before;
  for (int sweep = 0; sweep < MostSweeps; ++sweep)
  {
    double change = 0.0;
    for (std::size_t i = 0; i + 1 < graph.first.size(); ++i)
    {
      const std::size_t begin = graph.first[i];
      const std::size_t end = graph.first[i + 1];
      before.clear();
      for (std::size_t e = begin; e < end; ++e)
      {
        before.push_back(entries[e].height);
        if (entries[e].fixed || graph.beside[e].empty())
        {
          continue;
        }
        double mean = 0.0;
        for (const std::size_t other : graph.beside[e])
        {
          mean += entries[other].height;
        }
        mean /= static_cast<double>(graph.beside[e].size());
        entries[e].height += OverRelaxation * (mean - entries[e].height);
      }
      keepApart(off, begin, end, entries);
      for (std::size_t e = begin; e < end; ++e)
      {
        change = std::max(change, std::abs(entries[e].height - before[e - begin]));
      }
    }
    if (!(change > Settled * (high - low)))
    {
      break;
    }
  }
}
}

StackSheets placeSheets(const StackPlane& plane, const StackArrangement& arrangement,
  const StackLevels& levels, const CapHeights& heights, double gap)
{
  StackSheets sheets = capNodes(plane, arrangement, levels, heights);
  SheetGraph graph = graphOf(plane, levels, sheets);
  std::vector<SheetNode> entries = flattened(sheets);
  spreadFromCaps(plane, graph, entries);
  settle(graph, gap, entries);
  std::size_t e = 0;
  for (auto& node : sheets)
  {
    for (SheetNode& entry : node)
    {
      entry = entries[e++];
    }
  }
  return sheets;
}
}
