// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/StackColumns.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
namespace
{
/// Between two levels: more are more than there is memory for, and must not overflow before that is
/// told.
constexpr double MostLayers = 1e15;

/// Place of a level among those over a node.
Index entryOf(const std::vector<SheetNode>& node, Index level)
{
  const auto place = std::lower_bound(node.begin(), node.end(), level,
    [](const SheetNode& entry, Index wanted) { return entry.level < wanted; });
  return place - node.begin();
}

/// Quad across the edge from corner c of quad q to the next, -1: none.
Quads quadsBeside(const QuadsRef& quads)
{
  struct Side
  {
    std::pair<Index, Index> ends;
    Index quad;
    Index corner;
  };
  std::vector<Side> sides;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      sides.push_back({ std::minmax<Index>(quads(q, c), quads(q, (c + 1) % 4)), q, c });
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.quad < b.quad;
  });
  Quads beside = Quads::Constant(quads.rows(), 4, -1);
  for (std::size_t s = 1; s < sides.size(); ++s)
  {
    if (sides[s].ends == sides[s - 1].ends)
    {
      beside(sides[s].quad, sides[s].corner) = sides[s - 1].quad;
      beside(sides[s - 1].quad, sides[s - 1].corner) = sides[s].quad;
    }
  }
  return beside;
}

bool hasGap(const std::vector<std::vector<Index>>& intervals, Index low, Index high)
{
  for (const std::vector<Index>& interval : intervals)
  {
    const auto place = std::lower_bound(interval.begin(), interval.end(), low);
    if (place != interval.end() && *place == low && place + 1 != interval.end())
    {
      return *(place + 1) == high;
    }
  }
  return false;
}

class ColumnMaker
{
public:
  ColumnMaker(const StackPlane& plane, const StackArrangement& arrangement,
    const StackLevels& levels, const StackSheets& sheets, const LayerCounts& layers)
    : Plane(plane)
    , Arrangement(arrangement)
    , Levels(levels)
    , Sheets(sheets)
    , Layers(layers)
    , Beside(quadsBeside(plane.mesh.quads))
    , OnLevel(sheets.size())
    , Between(sheets.size())
  {
    for (std::size_t i = 0; i < sheets.size(); ++i)
    {
      this->OnLevel[i].assign(sheets[i].size(), -1);
    }
  }

  StackColumns make()
  {
    std::vector<std::array<Index, 8>> hexes;
    for (Index q = 0; q < this->Plane.mesh.quads.rows(); ++q)
    {
      const auto region =
        static_cast<std::size_t>(this->Plane.regionOf[static_cast<std::size_t>(q)]);
      Index layer = 0;
      for (std::size_t k = 0; k < this->Levels.intervals[region].size(); ++k)
      {
        this->fill(q, this->Levels.intervals[region][k],
          { this->Arrangement.stacks[region][2 * k], this->Arrangement.stacks[region][2 * k + 1] },
          layer, hexes);
      }
    }
    this->Result.hexes.resize(static_cast<Index>(hexes.size()), 8);
    for (std::size_t h = 0; h < hexes.size(); ++h)
    {
      for (std::size_t c = 0; c < 8; ++c)
      {
        this->Result.hexes(static_cast<Index>(h), static_cast<Index>(c)) = hexes[h][c];
      }
    }
    return std::move(this->Result);
  }

private:
  /// One interval of material over one quad.
  void fill(Index q, const std::vector<Index>& interval,
    const std::pair<std::size_t, std::size_t>& caps, Index& layer,
    std::vector<std::array<Index, 8>>& hexes)
  {
    for (std::size_t g = 0; g + 1 < interval.size(); ++g)
    {
      const Index low = interval[g];
      const Index high = interval[g + 1];
      const Index count = this->Layers.at({ low, high });
      std::array<bool, 4> isOpen{};
      for (Index c = 0; c < 4; ++c)
      {
        const Index other = this->Beside(q, c);
        isOpen[static_cast<std::size_t>(c)] = other < 0 ||
          !hasGap(this->Levels.intervals[static_cast<std::size_t>(
                    this->Plane.regionOf[static_cast<std::size_t>(other)])],
            low, high);
      }
      for (Index k = 0; k < count; ++k)
      {
        const Index h = static_cast<Index>(hexes.size());
        std::array<Index, 8> hex{};
        for (Index c = 0; c < 4; ++c)
        {
          const Index i = this->Plane.mesh.quads(q, c);
          hex[static_cast<std::size_t>(c)] = this->node(i, low, high, k, count);
          hex[static_cast<std::size_t>(c) + 4] = this->node(i, low, high, k + 1, count);
        }
        hexes.push_back(hex);
        this->Result.quadOf.push_back(q);
        this->Result.layerOf.push_back(layer++);
        this->close(h, hex, isOpen, g == 0 && k == 0 ? static_cast<Index>(caps.first) : -1,
          g + 2 == interval.size() && k + 1 == count ? static_cast<Index>(caps.second) : -1);
      }
    }
  }

  /// The outer quads of a hexahedron. @param bottom, top caps, or -1.
  void close(Index h, const std::array<Index, 8>& hex, const std::array<bool, 4>& isOpen,
    Index bottom, Index top)
  {
    if (bottom >= 0)
    {
      this->Result.boundary.push_back({ { hex[0], hex[3], hex[2], hex[1] }, h, 4, bottom });
    }
    if (top >= 0)
    {
      this->Result.boundary.push_back({ { hex[4], hex[5], hex[6], hex[7] }, h, 5, top });
    }
    for (std::size_t c = 0; c < 4; ++c)
    {
      if (isOpen[c])
      {
        const std::size_t d = (c + 1) % 4;
        this->Result.boundary.push_back(
          { { hex[c], hex[d], hex[d + 4], hex[c + 4] }, h, static_cast<int>(c), -1 });
      }
    }
  }

  Index node(Index i, Index low, Index high, Index k, Index count)
  {
    const auto at = static_cast<std::size_t>(i);
    if (k == 0 || k == count)
    {
      const Index entry = entryOf(this->Sheets[at], k == 0 ? low : high);
      Index& known = this->OnLevel[at][static_cast<std::size_t>(entry)];
      if (known < 0)
      {
        known = static_cast<Index>(this->Result.nodes.size());
        this->Result.nodes.push_back({ i, entry, entry, 0.0 });
      }
      return known;
    }
    const auto added = this->Between[at].emplace(
      std::pair{ low, high }, static_cast<Index>(this->Result.nodes.size()));
    if (added.second)
    {
      for (Index j = 1; j < count; ++j)
      {
        this->Result.nodes.push_back({ i, entryOf(this->Sheets[at], low),
          entryOf(this->Sheets[at], high), static_cast<double>(j) / static_cast<double>(count) });
      }
    }
    return added.first->second + k - 1;
  }

  const StackPlane& Plane;
  const StackArrangement& Arrangement;
  const StackLevels& Levels;
  const StackSheets& Sheets;
  const LayerCounts& Layers;
  Quads Beside;
  std::vector<std::vector<Index>> OnLevel;
  std::vector<std::map<std::pair<Index, Index>, Index>> Between;
  StackColumns Result;
};

/// Mean distances between levels that follow each other.
std::map<std::pair<Index, Index>, double> meanGaps(
  const StackPlane& plane, const StackLevels& levels, const StackSheets& sheets)
{
  std::map<std::pair<Index, Index>, std::pair<double, double>> sums;
  for (Index q = 0; q < plane.mesh.quads.rows(); ++q)
  {
    const auto region = static_cast<std::size_t>(plane.regionOf[static_cast<std::size_t>(q)]);
    for (const std::vector<Index>& interval : levels.intervals[region])
    {
      for (std::size_t g = 0; g + 1 < interval.size(); ++g)
      {
        auto& sum = sums[{ interval[g], interval[g + 1] }];
        for (Index c = 0; c < 4; ++c)
        {
          const auto& node = sheets[static_cast<std::size_t>(plane.mesh.quads(q, c))];
          sum.first += node[static_cast<std::size_t>(entryOf(node, interval[g + 1]))].height -
            node[static_cast<std::size_t>(entryOf(node, interval[g]))].height;
          sum.second += 1.0;
        }
      }
    }
  }
  std::map<std::pair<Index, Index>, double> result;
  for (const auto& [gap, sum] : sums)
  {
    result[gap] = sum.first / sum.second;
  }
  return result;
}
}

LayerCounts countLayers(const StackPlane& plane, const StackLevels& levels,
  const StackSheets& sheets, double layerSize, Index layers)
{
  const auto gaps = meanGaps(plane, levels, sheets);
  if (layers > 0)
  {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const auto& node : sheets)
    {
      for (const SheetNode& entry : node)
      {
        low = std::min(low, entry.height);
        high = std::max(high, entry.height);
      }
    }
    layerSize = (high - low) / static_cast<double>(layers);
  }
  LayerCounts result;
  for (const auto& [gap, height] : gaps)
  {
    result[gap] = std::max<Index>(1, std::llround(std::min(height / layerSize, MostLayers)));
  }
  return result;
}

double countHexes(const StackPlane& plane, const StackLevels& levels, const LayerCounts& layers)
{
  double hexes = 0.0;
  for (const Index region : plane.regionOf)
  {
    for (const std::vector<Index>& interval : levels.intervals[static_cast<std::size_t>(region)])
    {
      for (std::size_t g = 0; g + 1 < interval.size(); ++g)
      {
        hexes += static_cast<double>(layers.at({ interval[g], interval[g + 1] }));
      }
    }
  }
  return hexes;
}

StackColumns makeColumns(const StackPlane& plane, const StackArrangement& arrangement,
  const StackLevels& levels, const StackSheets& sheets, const LayerCounts& layers)
{
  return ColumnMaker(plane, arrangement, levels, sheets, layers).make();
}

Points columnPoints(const StackPlane& plane, const StackSheets& sheets, const StackColumns& columns)
{
  Points points(static_cast<Index>(columns.nodes.size()), 3);
  for (Index p = 0; p < points.rows(); ++p)
  {
    const ColumnNode& node = columns.nodes[static_cast<std::size_t>(p)];
    const auto& column = sheets[static_cast<std::size_t>(node.node)];
    const double low = column[static_cast<std::size_t>(node.below)].height;
    const double high = column[static_cast<std::size_t>(node.above)].height;
    points.row(p).head<2>() = plane.mesh.points.row(node.node).head<2>();
    points(p, 2) = low + node.fraction * (high - low);
  }
  return points;
}
}
