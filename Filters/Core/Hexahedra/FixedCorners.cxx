// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/FixedCorners.h"

#include "Core/Hexahedra/HalfSpace.h"
#include "Core/Hexahedra/HexCertificate.h"
#include "Core/Hexahedra/HexCorner.h"

#include <algorithm>
#include <tuple>

namespace hexsweep
{
namespace
{
/// A corner of a hexahedron that only the free end of one edge can change.
struct HalfFixedCorner
{
  Index node; ///< fixed
  Index free; ///< the end of the edge
  Index hex;
  Eigen::RowVector3d normal; ///< of the two fixed edges; its product with the free one counts
};

/// Zero where the vectors are parallel but for rounding.
Eigen::RowVector3d normalOf(const Eigen::RowVector3d& u, const Eigen::RowVector3d& v)
{
  constexpr double Rounding = 1e-14;
  const Eigen::RowVector3d sine = u.stableNormalized().cross(v.stableNormalized());
  return sine.norm() > Rounding ? Eigen::RowVector3d(u.cross(v)) : Eigen::RowVector3d::Zero();
}

class Search
{
public:
  Search(const PointsRef& points, const HexesRef& hexes, const std::vector<bool>& fixed)
    : Places(points)
    , Cells(hexes)
    , Fixed(fixed)
  {
  }

  /// Looks at the hexahedra [begin, end).
  void look(Index begin, Index end)
  {
    for (Index h = begin; h < end; ++h)
    {
      int fixedNodes = 0;
      for (int c = 0; c < 8; ++c)
      {
        fixedNodes += this->isFixed(h, c);
      }
      for (int c = 0; c < 8 && fixedNodes > 1; ++c)
      {
        if (this->isFixed(h, c))
        {
          this->lookAt(h, c);
        }
      }
      if (fixedNodes == 8)
      {
        this->certify(h);
      }
    }
  }

  /// Takes over what was found in the hexahedra that follow.
  void append(const Search& next)
  {
    this->Found.floor = std::min(this->Found.floor, next.Found.floor);
    this->Found.conflicts.insert(
      this->Found.conflicts.end(), next.Found.conflicts.begin(), next.Found.conflicts.end());
    this->HalfFixed.insert(this->HalfFixed.end(), next.HalfFixed.begin(), next.HalfFixed.end());
  }

  FixedCorners finish() &&
  {
    this->lookForFolds();
    return std::move(*this).result();
  }

private:
  bool isFixed(Index h, int c) const
  {
    return this->Fixed[static_cast<std::size_t>(this->Cells(h, c))];
  }

  void add(Index h, int c, ConflictCause cause)
  {
    this->Found.conflicts.push_back({ h, this->Cells(h, c), cause });
  }

  void lookAt(Index h, int c)
  {
    const HexFrame frame = hexFrame([&](int i) { return this->Places.row(this->Cells(h, i)); }, c);
    const Eigen::RowVector3d* arms[3] = { &frame.u, &frame.v, &frame.w };
    int freeArms = 0;
    int free = 0;
    for (int e = 0; e < 3; ++e)
    {
      if (!this->isFixed(h, HexCornerNeighbors[c][e]))
      {
        ++freeArms;
        free = e;
      }
      else if (arms[e]->isZero(0.0))
      {
        this->add(h, c, ConflictCause::Edge);
      }
    }
    if (freeArms == 0)
    {
      const double quality = frame.scaledDeterminant();
      this->Found.floor = std::min(this->Found.floor, quality);
      if (!(quality > 0.0))
      {
        this->add(h, c, ConflictCause::Corner);
      }
    }
    else if (freeArms == 1)
    {
      this->HalfFixed.push_back({ this->Cells(h, c), this->Cells(h, HexCornerNeighbors[c][free]), h,
        normalOf(*arms[(free + 1) % 3], *arms[(free + 2) % 3]) });
    }
  }

  void certify(Index h)
  {
    HexCorners corners;
    for (int c = 0; c < 8; ++c)
    {
      corners.row(c) = this->Places.row(this->Cells(h, c));
    }
    if (certifyHex(corners).validity != Validity::Certified)
    {
      this->add(h, 0, ConflictCause::Inside);
    }
  }

  void lookForFolds()
  {
    std::vector<HalfFixedCorner>& corners = this->HalfFixed;
    const auto edge = [](const HalfFixedCorner& c) { return std::tie(c.node, c.free); };
    std::sort(
      corners.begin(), corners.end(), [](const HalfFixedCorner& a, const HalfFixedCorner& b) {
        return std::tie(a.node, a.free, a.hex) < std::tie(b.node, b.free, b.hex);
      });
    for (auto begin = corners.begin(); begin != corners.end();)
    {
      const auto end = std::find_if(
        begin, corners.end(), [&](const HalfFixedCorner& c) { return edge(c) != edge(*begin); });
      Points normals(end - begin, 3);
      for (auto c = begin; c != end; ++c)
      {
        normals.row(c - begin) = c->normal;
      }
      // Round an inner node of a plane cap the sum, with its sign, does not depend on the node.
      const std::vector<bool> upright = largestHalfSpace(normals, normals.colwise().sum());
      for (auto c = begin; c != end; ++c)
      {
        if (!upright[static_cast<std::size_t>(c - begin)])
        {
          this->Found.conflicts.push_back({ c->hex, c->node, ConflictCause::Fold });
        }
      }
      begin = end;
    }
  }

  FixedCorners result() &&
  {
    std::vector<Conflict>& all = this->Found.conflicts;
    // An edge without length is the cause of all else that is wrong there.
    const auto rank = [](ConflictCause cause) { return cause == ConflictCause::Edge ? 0 : 1; };
    std::stable_sort(all.begin(), all.end(), [&](const Conflict& a, const Conflict& b) {
      return std::make_pair(a.hex, rank(a.cause)) < std::make_pair(b.hex, rank(b.cause));
    });
    const auto sameHex = [](const Conflict& a, const Conflict& b) { return a.hex == b.hex; };
    all.erase(std::unique(all.begin(), all.end(), sameHex), all.end());
    if (!all.empty())
    {
      this->Found.floor = std::min(this->Found.floor, 0.0);
    }
    return std::move(this->Found);
  }

  PointsRef Places;
  HexesRef Cells;
  const std::vector<bool>& Fixed;
  FixedCorners Found;
  std::vector<HalfFixedCorner> HalfFixed;
};
}

bool FixedCorners::forbids(Index hex) const
{
  const auto found = std::lower_bound(this->conflicts.begin(), this->conflicts.end(), hex,
    [](const Conflict& conflict, Index h) { return conflict.hex < h; });
  return found != this->conflicts.end() && found->hex == hex;
}

FixedCorners fixedCorners(const PointsRef& points, const HexesRef& hexes,
  const std::vector<bool>& fixed, const ParallelFor& parallelFor)
{
  constexpr Index HexesAPiece = Index{ 1 } << 15;
  std::vector<Search> pieces(
    static_cast<std::size_t>((hexes.rows() + HexesAPiece - 1) / HexesAPiece),
    Search(points, hexes, fixed));
  forPieces(parallelFor, hexes.rows(), HexesAPiece, [&](Index begin, Index end) {
    pieces[static_cast<std::size_t>(begin / HexesAPiece)].look(begin, end);
  });
  Search all(points, hexes, fixed);
  for (const Search& piece : pieces)
  {
    all.append(piece);
  }
  return std::move(all).finish();
}
}
