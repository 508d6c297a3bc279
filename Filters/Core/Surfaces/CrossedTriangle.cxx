// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/CrossedTriangle.h"

#include "Core/Surfaces/TriangleCrossings.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace hexsweep
{
namespace
{
/// The convex polygon's triangles: the fan whose least triangle is greatest.
void appendFan(
  std::vector<PieceIds>& pieces, const std::vector<Index>& polygon, const PointsRef& points)
{
  const std::size_t n = polygon.size();
  std::size_t best = 0;
  double greatest = -1.0;
  for (std::size_t s = 0; n > 3 && s < n; ++s)
  {
    double least = std::numeric_limits<double>::max();
    for (std::size_t k = 1; k + 1 < n; ++k)
    {
      const Eigen::RowVector3d p = points.row(polygon[s]);
      const Eigen::RowVector3d u = points.row(polygon[(s + k) % n]) - p;
      const Eigen::RowVector3d v = points.row(polygon[(s + k + 1) % n]) - p;
      least = std::min(least, u.cross(v).norm());
    }
    if (least > greatest)
    {
      greatest = least;
      best = s;
    }
  }
  for (std::size_t k = 1; k + 1 < n; ++k)
  {
    pieces.push_back({ polygon[best], polygon[(best + k) % n], polygon[(best + k + 1) % n] });
  }
}
}

std::vector<PieceIds> crossedTrianglePieces(const std::array<Index, 3>& corners,
  const std::array<std::vector<Index>, 3>& sides, const PointsRef& points)
{
  std::vector<PieceIds> pieces;
  const auto count = [&](std::size_t c) { return static_cast<Index>(sides[c].size()); };
  const TriangleCrossings inside = triangleCrossings(count(0), count(1), count(2));
  std::array<std::vector<Index>, 3> middle; // of the side before a corner to that after it
  std::size_t source = 3;                   // corner that edges start from
  for (std::size_t c = 0; c < 3; ++c)
  {
    const std::vector<Index>& after = sides[c];
    const std::vector<Index>& before = sides[(c + 2) % 3];
    Index lastAfter = corners[c];
    Index lastBefore = corners[c];
    for (Index k = 0; k < inside.around[c]; ++k)
    {
      const Index p = after[static_cast<std::size_t>(k)];
      const Index q = before[before.size() - 1 - static_cast<std::size_t>(k)];
      appendFan(pieces,
        k == 0 ? std::vector<Index>{ corners[c], p, q }
               : std::vector<Index>{ lastBefore, lastAfter, p, q },
        points);
      lastAfter = p;
      lastBefore = q;
    }
    middle[c] = inside.around[c] == 0 ? std::vector<Index>{ corners[c] }
                                      : std::vector<Index>{ lastBefore, lastAfter };
    if (inside.from[c] > 0)
    {
      source = c;
    }
  }
  if (source == 3)
  {
    std::vector<Index> polygon;
    for (const std::vector<Index>& part : middle)
    {
      polygon.insert(polygon.end(), part.begin(), part.end());
    }
    appendFan(pieces, polygon, points);
    return pieces;
  }
  // A fan about the source: the ends are what is left at the other two corners.
  const std::size_t a = (source + 1) % 3;
  const std::size_t b = (source + 2) % 3;
  std::vector<Index> piece{ corners[source] };
  piece.insert(piece.end(), middle[a].begin(), middle[a].end());
  for (Index k = 0; k < inside.from[source]; ++k)
  {
    const Index p = sides[a][static_cast<std::size_t>(inside.around[a] + k)];
    piece.push_back(p);
    appendFan(pieces, piece, points);
    piece = { corners[source], p };
  }
  piece.insert(piece.end(), middle[b].begin(), middle[b].end());
  appendFan(pieces, piece, points);
  return pieces;
}
}
