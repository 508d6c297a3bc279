// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/StackLevels.h"

#include "Core/Common/DisjointSets.h"
#include "Core/Common/Errors.h"
#include "Core/Solids/SolidMessages.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <set>

namespace hexsweep
{
namespace
{
constexpr double SameHeight = 1e-7; // of the whole extent

/// How two caps lie to each other along the border between their regions.
enum class BorderOrder
{
  Below,
  Equal,
  Above,
  Mixed
};

/// The caps of all regions, numbered on.
class CapOrder
{
public:
  CapOrder(const StackArrangement& arrangement, const CapLikeFaces& faces,
    const CapHeights& heights, double slack)
    : Arrangement(arrangement)
    , Faces(faces)
    , Heights(heights)
    , Slack(slack)
    , First(firstOf(arrangement))
    , Sets(this->First.back())
  {
    const Points& points = arrangement.mesh.points;
    this->Tolerance =
      SameHeight * (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
    for (std::size_t r = 0; r < arrangement.stacks.size(); ++r)
    {
      for (std::size_t i = 0; i + 1 < arrangement.stacks[r].size(); ++i)
      {
        this->Relations.emplace(this->number(r, i), this->number(r, i + 1));
      }
    }
    this->compareAcrossBorders();
  }

  void joinFlat(double join)
  {
    std::vector<std::pair<double, Index>> flat;
    for (std::size_t r = 0; r < this->Arrangement.stacks.size(); ++r)
    {
      for (std::size_t i = 0; i < this->Arrangement.stacks[r].size(); ++i)
      {
        const std::size_t face = this->Arrangement.stacks[r][i];
        if (this->Heights.isFlat(face))
        {
          flat.emplace_back(this->Heights.range(face).first, this->number(r, i));
        }
      }
    }
    std::sort(flat.begin(), flat.end());
    for (std::size_t k = 1; k < flat.size(); ++k)
    {
      if (flat[k].first - flat[k - 1].first <= this->Tolerance)
      {
        this->Sets.join(flat[k - 1].second, flat[k].second);
      }
    }
    this->joinNear(flat, join);
  }

  StackLevels levels()
  {
    const std::vector<Index> rank = this->ranks();
    StackLevels result;
    result.count = this->Count;
    for (std::size_t r = 0; r < this->Arrangement.stacks.size(); ++r)
    {
      std::vector<Index> own;
      for (std::size_t i = 0; i < this->Arrangement.stacks[r].size(); ++i)
      {
        own.push_back(rank[static_cast<std::size_t>(this->Sets.find(this->number(r, i)))]);
      }
      result.ofCaps.push_back(own);
      std::vector<std::vector<Index>> intervals;
      for (std::size_t i = 0; i + 1 < own.size(); i += 2)
      {
        intervals.push_back({ own[i], own[i + 1] });
      }
      result.intervals.push_back(std::move(intervals));
    }
    return result;
  }

private:
  static std::vector<Index> firstOf(const StackArrangement& arrangement)
  {
    std::vector<Index> first(1, 0);
    for (const auto& stack : arrangement.stacks)
    {
      first.push_back(first.back() + static_cast<Index>(stack.size()));
    }
    return first;
  }

  Index number(std::size_t region, std::size_t i) const
  {
    return this->First[region] + static_cast<Index>(i);
  }

  void compareAcrossBorders()
  {
    std::map<std::pair<Index, Index>, std::vector<Eigen::RowVector2d>> samples;
    for (const RegionEdge& edge : this->Arrangement.edges)
    {
      if (edge.right >= 0)
      {
        samples[{ edge.left, edge.right }].emplace_back(0.5 *
          (this->Arrangement.mesh.points.row(edge.a) + this->Arrangement.mesh.points.row(edge.b))
            .head<2>());
      }
    }
    for (const auto& [regions, places] : samples)
    {
      const auto r = static_cast<std::size_t>(regions.first);
      const auto s = static_cast<std::size_t>(regions.second);
      for (std::size_t i = 0; i < this->Arrangement.stacks[r].size(); ++i)
      {
        for (std::size_t j = 0; j < this->Arrangement.stacks[s].size(); ++j)
        {
          this->compare(r, i, s, j, places);
        }
      }
    }
  }

  void compare(std::size_t r, std::size_t i, std::size_t s, std::size_t j,
    const std::vector<Eigen::RowVector2d>& places)
  {
    const std::size_t f = this->Arrangement.stacks[r][i];
    const std::size_t g = this->Arrangement.stacks[s][j];
    if (f == g)
    {
      this->Sets.join(this->number(r, i), this->number(s, j));
      return;
    }
    const bool sameKind = this->Faces.faces[f].kind == this->Faces.faces[g].kind;
    switch (this->orderOf(f, g, places))
    {
      case BorderOrder::Below:
        this->Relations.emplace(this->number(r, i), this->number(s, j));
        break;
      case BorderOrder::Above:
        this->Relations.emplace(this->number(s, j), this->number(r, i));
        break;
      case BorderOrder::Equal:
        if (sameKind)
        {
          this->Sets.join(this->number(r, i), this->number(s, j));
        }
        break;
      case BorderOrder::Mixed:
        this->refuse(f, g);
    }
  }

  BorderOrder orderOf(
    std::size_t f, std::size_t g, const std::vector<Eigen::RowVector2d>& places) const
  {
    const double equal =
      this->Tolerance + this->Slack * std::max(this->Heights.slope(f), this->Heights.slope(g));
    bool below = false;
    bool above = false;
    bool same = false;
    for (const Eigen::RowVector2d& place : places)
    {
      const double difference = this->Heights.nearest(g, place) - this->Heights.nearest(f, place);
      below = below || difference > equal;
      above = above || difference < -equal;
      same = same || std::abs(difference) <= equal;
    }
    if (below && above)
    {
      return BorderOrder::Mixed;
    }
    if (same && (below || above))
    {
      // Steep caps meet others within the slack near the ends of a border.
      return BorderOrder::Mixed;
    }
    return below ? BorderOrder::Below : above ? BorderOrder::Above : BorderOrder::Equal;
  }

  [[noreturn]] void refuse(std::size_t f, std::size_t g) const
  {
    throw InvalidInput("caps " +
      listFaces({ std::min(this->Faces.faces[f].id, this->Faces.faces[g].id),
        std::max(this->Faces.faces[f].id, this->Faces.faces[g].id) }) +
      " run out into each other, or one is above the other along a part of their border only: "
      "layers of hexahedra would end there. Cut the part into pieces there, and mesh them "
      "together.");
  }

  /// Joins flat levels that are near, where nothing holds them apart.
  void joinNear(const std::vector<std::pair<double, Index>>& flat, double join)
  {
    std::map<Index, std::set<Index>> pointsOf;
    const Triangles& triangles = this->Arrangement.mesh.triangles;
    std::vector<std::set<Index>> ofRegion(this->Arrangement.stacks.size());
    for (Index t = 0; t < triangles.rows(); ++t)
    {
      for (Index c = 0; c < 3; ++c)
      {
        ofRegion[static_cast<std::size_t>(this->Arrangement.regionOf[static_cast<std::size_t>(t)])]
          .insert(triangles(t, c));
      }
    }
    const std::vector<std::size_t> regionOfCap = this->regionsOfCaps();
    for (const auto& [height, cap] : flat)
    {
      const std::set<Index>& own = ofRegion[regionOfCap[static_cast<std::size_t>(cap)]];
      pointsOf[this->Sets.find(cap)].insert(own.begin(), own.end());
    }
    for (std::size_t k = 1; k < flat.size(); ++k)
    {
      const Index a = this->Sets.find(flat[k - 1].second);
      const Index b = this->Sets.find(flat[k].second);
      if (a == b || flat[k].first - flat[k - 1].first > join)
      {
        continue;
      }
      const std::set<Index>& first = pointsOf[a];
      const std::set<Index>& second = pointsOf[b];
      const bool touch = std::any_of(
        first.begin(), first.end(), [&](Index point) { return second.count(point) > 0; });
      if (!touch && !this->isRelated(a, b))
      {
        std::set<Index> both = first;
        both.insert(second.begin(), second.end());
        this->Sets.join(a, b);
        pointsOf[this->Sets.find(a)] = std::move(both);
      }
    }
  }

  bool isRelated(Index a, Index b)
  {
    for (const auto& [low, high] : this->Relations)
    {
      const Index p = this->Sets.find(low);
      const Index q = this->Sets.find(high);
      if ((p == a && q == b) || (p == b && q == a))
      {
        return true;
      }
    }
    return false;
  }

  std::vector<std::size_t> regionsOfCaps() const
  {
    std::vector<std::size_t> result;
    for (std::size_t r = 0; r < this->Arrangement.stacks.size(); ++r)
    {
      result.insert(result.end(), this->Arrangement.stacks[r].size(), r);
    }
    return result;
  }

  /// Ranks of the sets, by their first members: as the relations ask, else by height.
  std::vector<Index> ranks()
  {
    const Index caps = this->First.back();
    std::map<Index, std::set<Index>> above;
    std::vector<Index> below(static_cast<std::size_t>(caps), 0);
    for (const auto& [low, high] : this->Relations)
    {
      const Index a = this->Sets.find(low);
      const Index b = this->Sets.find(high);
      if (a == b)
      {
        this->refuse(this->faceOfCap(low), this->faceOfCap(high));
      }
      if (above[a].insert(b).second)
      {
        ++below[static_cast<std::size_t>(b)];
      }
    }
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    Index sets = 0;
    for (Index c = 0; c < caps; ++c)
    {
      if (this->Sets.find(c) == c)
      {
        ++sets;
        if (below[static_cast<std::size_t>(c)] == 0)
        {
          open.emplace(this->heightOf(c), c);
        }
      }
    }
    std::vector<Index> rank(static_cast<std::size_t>(caps), -1);
    while (!open.empty())
    {
      const Index c = open.top().second;
      open.pop();
      rank[static_cast<std::size_t>(c)] = this->Count++;
      for (const Index b : above[c])
      {
        if (--below[static_cast<std::size_t>(b)] == 0)
        {
          open.emplace(this->heightOf(b), b);
        }
      }
    }
    if (this->Count < sets)
    {
      throw InvalidInput("the caps wind round each other like stairs: layers of hexahedra would "
                         "come back below themselves. Cut the part into pieces, and mesh them "
                         "together.");
    }
    return rank;
  }

  std::size_t faceOfCap(Index cap) const
  {
    const auto after = std::upper_bound(this->First.begin(), this->First.end(), cap);
    const std::size_t r = static_cast<std::size_t>(after - this->First.begin()) - 1;
    return this->Arrangement.stacks[r][static_cast<std::size_t>(cap - this->First[r])];
  }

  double heightOf(Index cap) const
  {
    const auto [low, high] = this->Heights.range(this->faceOfCap(cap));
    return 0.5 * (low + high);
  }

  const StackArrangement& Arrangement;
  const CapLikeFaces& Faces;
  const CapHeights& Heights;
  double Slack;
  double Tolerance = 0.0;
  std::vector<Index> First; // cap of each region, and one past the last
  DisjointSets Sets;
  std::set<std::pair<Index, Index>> Relations; // lower, upper
  Index Count = 0;
};

/// Puts the levels of one interval that are within another one there. @return whether any was new.
bool lead(const std::vector<Index>& from, std::vector<Index>& to)
{
  bool any = false;
  for (const Index level : from)
  {
    if (level > to.front() && level < to.back())
    {
      const auto place = std::lower_bound(to.begin(), to.end(), level);
      if (*place != level)
      {
        to.insert(place, level);
        any = true;
      }
    }
  }
  return any;
}

bool overlap(const std::vector<Index>& a, const std::vector<Index>& b)
{
  return std::max(a.front(), b.front()) < std::min(a.back(), b.back());
}
}

StackLevels orderLevels(const StackArrangement& arrangement, const CapLikeFaces& faces,
  const CapHeights& heights, double slack, double join)
{
  CapOrder order(arrangement, faces, heights, slack);
  order.joinFlat(join);
  StackLevels result = order.levels();
  std::set<std::pair<Index, Index>> borders;
  for (const RegionEdge& edge : arrangement.edges)
  {
    if (edge.right >= 0)
    {
      borders.emplace(edge.left, edge.right);
    }
  }
  for (bool any = true; any;)
  {
    any = false;
    for (const auto& [r, s] : borders)
    {
      for (std::vector<Index>& first : result.intervals[static_cast<std::size_t>(r)])
      {
        for (std::vector<Index>& second : result.intervals[static_cast<std::size_t>(s)])
        {
          if (overlap(first, second))
          {
            const bool up = lead(first, second);
            const bool down = lead(second, first);
            any = any || up || down;
          }
        }
      }
    }
  }
  return result;
}
}
