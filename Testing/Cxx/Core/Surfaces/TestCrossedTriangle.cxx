// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/CrossedTriangle.h"

#include "Support/CapMeshes.h"

#include <set>

namespace TestCrossedTriangle
{
using hexsweep::Index;
using hexsweep::PieceIds;
using hexsweep::Points;

/// Edges that cross a triangle: around[c] cut off corner c, `from` start in the corner `source`.
struct Strands
{
  Index around[3];
  std::size_t source;
  Index from;
};

/// A triangle with evenly spaced points on its sides, and the edges that join them.
struct Crossed
{
  Points points;
  std::array<std::vector<Index>, 3> sides;
  std::set<std::pair<Index, Index>> edges;
};

Crossed crossed(const Strands& strands)
{
  Crossed result;
  result.points.resize(3, 3);
  result.points << 0, 0, 0, 3, 0, 0, 1, 2, 0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const std::size_t next = (c + 1) % 3;
    const bool opposite = (c + 2) % 3 == strands.source;
    const Index n = strands.around[c] + (opposite ? strands.from : 0) + strands.around[next];
    for (Index k = 1; k <= n; ++k)
    {
      const double t = static_cast<double>(k) / static_cast<double>(n + 1);
      const Index id = result.points.rows();
      result.points.conservativeResize(id + 1, 3);
      result.points.row(id) = (1.0 - t) * result.points.row(static_cast<Index>(c)) +
        t * result.points.row(static_cast<Index>(next));
      result.sides[c].push_back(id);
    }
  }
  for (std::size_t c = 0; c < 3; ++c)
  {
    for (std::size_t k = 0; k < static_cast<std::size_t>(strands.around[c]); ++k)
    {
      result.edges.insert(std::minmax(result.sides[c][k],
        *(result.sides[(c + 2) % 3].rbegin() + static_cast<std::ptrdiff_t>(k))));
    }
  }
  const std::size_t a = (strands.source + 1) % 3;
  for (Index k = 0; k < strands.from; ++k)
  {
    result.edges.emplace(static_cast<Index>(strands.source),
      result.sides[a][static_cast<std::size_t>(strands.around[a] + k)]);
  }
  return result;
}

TEST(CrossedTriangle, PiecesCoverItUprightAndHaveAllCrossingEdges)
{
  std::mt19937 generator(7);
  for (int trial = 0; trial < 200; ++trial)
  {
    const auto random = [&](unsigned n) { return static_cast<Index>(generator() % n); };
    Strands strands{ { random(4), random(4), random(4) }, static_cast<std::size_t>(random(3)),
      random(4) };
    if (strands.from > 0)
    {
      strands.around[strands.source] = 0; // such an edge would cross those that start there
    }
    const Crossed triangle = crossed(strands);
    const auto pieces =
      hexsweep::crossedTrianglePieces({ 0, 1, 2 }, triangle.sides, triangle.points);
    // Every point is a corner of the polygon that is triangulated.
    ASSERT_EQ(static_cast<Index>(pieces.size()), triangle.points.rows() - 2);
    double area = 0.0;
    std::set<std::pair<Index, Index>> found;
    for (const PieceIds& piece : pieces)
    {
      const Eigen::RowVector3d p = triangle.points.row(piece[0]);
      const Eigen::RowVector3d u = triangle.points.row(piece[1]) - p;
      const Eigen::RowVector3d v = triangle.points.row(piece[2]) - p;
      EXPECT_GT(u.cross(v).z(), 1e-3);
      area += 0.5 * u.cross(v).z();
      for (std::size_t c = 0; c < 3; ++c)
      {
        found.insert(std::minmax(piece[c], piece[(c + 1) % 3]));
      }
    }
    EXPECT_NEAR(area, 3.0, 1e-12);
    for (const auto& edge : triangle.edges)
    {
      EXPECT_TRUE(found.count(edge)) << edge.first << " to " << edge.second;
    }
  }
}
}
