// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/DegenerateTriangles.h"

#include "Core/Surfaces/TriangleAngles.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
using EdgeKey = std::pair<Index, Index>;

class DegenerateFlips
{
public:
  explicit DegenerateFlips(SolidSurface& solid)
    : Solid(solid)
  {
    for (Index t = 0; t < solid.triangles.rows(); ++t)
    {
      if (!hasWeights(solid.points, solid.triangles.row(t)))
      {
        this->Degenerate.insert(t);
      }
    }
    for (Index t = 0; t < (this->Degenerate.empty() ? 0 : solid.triangles.rows()); ++t)
    {
      this->link(t);
    }
  }

  Index flipAll()
  {
    Index flipped = 0;
    // Where several lie on each other, one that has been flipped makes way for the next.
    for (bool any = true; any;)
    {
      any = false;
      const std::set<Index> left = this->Degenerate;
      for (const Index t : left)
      {
        if (this->flip(t))
        {
          this->Degenerate.erase(t);
          any = true;
          ++flipped;
        }
      }
    }
    return flipped;
  }

private:
  static EdgeKey key(Index a, Index b) { return std::minmax(a, b); }

  void link(Index t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      this->TrianglesAt[key(this->corner(t, c), this->corner(t, c + 1))].push_back(t);
    }
  }

  void unlink(Index t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      std::vector<Index>& rows = this->TrianglesAt[key(this->corner(t, c), this->corner(t, c + 1))];
      rows.erase(std::find(rows.begin(), rows.end(), t));
    }
  }

  Index corner(Index t, Index c) const { return this->Solid.triangles(t, c % 3); }

  bool hasArea(Index a, Index b, Index c) const
  {
    return hasWeights(this->Solid.points, Eigen::Matrix<Index, 1, 3>(a, b, c));
  }

  double edgeLength(Index t, Index c) const
  {
    return (
      this->Solid.points.row(this->corner(t, c)) - this->Solid.points.row(this->corner(t, c + 1)))
      .norm();
  }

  bool flip(Index t)
  {
    Index longest = 0;
    for (Index c = 1; c < 3; ++c)
    {
      longest = this->edgeLength(t, c) > this->edgeLength(t, longest) ? c : longest;
    }
    const Index middle = this->corner(t, longest + 2);
    const std::vector<Index>& sides =
      this->TrianglesAt[key(this->corner(t, longest), this->corner(t, longest + 1))];
    if (sides.size() != 2)
    {
      return false;
    }
    const Index beyond = sides[0] == t ? sides[1] : sides[0];
    Index c = 0;
    while (this->corner(beyond, c) == this->corner(t, longest) ||
      this->corner(beyond, c) == this->corner(t, longest + 1))
    {
      ++c;
    }
    const Index far = this->corner(beyond, c);
    const Index from = this->corner(beyond, c + 1);
    const Index to = this->corner(beyond, c + 2);
    const auto edge = this->TrianglesAt.find(key(middle, far));
    if (far == middle || (edge != this->TrianglesAt.end() && !edge->second.empty()) ||
      !this->hasArea(far, from, middle) || !this->hasArea(far, middle, to))
    {
      return false;
    }
    this->unlink(t);
    this->unlink(beyond);
    this->Solid.triangles.row(beyond) << far, from, middle;
    this->Solid.triangles.row(t) << far, middle, to;
    this->link(t);
    this->link(beyond);
    this->giveTo(t, beyond, this->Solid.triangleRows);
    this->giveTo(t, beyond, this->Solid.cellIds);
    this->giveTo(t, beyond, this->Solid.faceIds);
    return true;
  }

  static void giveTo(Index t, Index beyond, std::vector<Index>& ids)
  {
    if (!ids.empty())
    {
      ids[static_cast<std::size_t>(t)] = ids[static_cast<std::size_t>(beyond)];
    }
  }

  SolidSurface& Solid;
  std::set<Index> Degenerate;
  std::map<EdgeKey, std::vector<Index>> TrianglesAt;
};
}

Index flipDegenerateTriangles(SolidSurface& solid)
{
  return DegenerateFlips(solid).flipAll();
}
}
