// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/QuadMatch.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace TestQuadMatch
{
using hexsweep::Index;
using hexsweep::Quads;

/// n x n quads, points row by row.
Quads grid(Index n)
{
  Quads quads(n * n, 4);
  for (Index k = 0; k < n; ++k)
  {
    for (Index j = 0; j < n; ++j)
    {
      const Index a = k * (n + 1) + j;
      quads.row(k * n + j) << a, a + 1, a + n + 2, a + n + 1;
    }
  }
  return quads;
}

std::vector<Index> unknown(Index n, const std::vector<std::pair<Index, Index>>& known)
{
  std::vector<Index> points(static_cast<std::size_t>((n + 1) * (n + 1)), -1);
  for (const auto& [point, image] : known)
  {
    points[static_cast<std::size_t>(point)] = image;
  }
  return points;
}

TEST(QuadMatch, OneEdgeOfTheRimDecidesAboutAllPoints)
{
  // The target is the grid with its points counted from the end and its quads mirrored.
  const Quads source = grid(3);
  Quads target = source;
  for (Index q = 0; q < target.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      target(q, c) = 115 - source(source.rows() - 1 - q, (4 - c) % 4);
    }
  }
  const auto found = hexsweep::matchQuads(source, target, unknown(3, { { 0, 115 }, { 1, 114 } }));
  ASSERT_TRUE(found.has_value());
  for (std::size_t i = 0; i < found->size(); ++i)
  {
    EXPECT_EQ((*found)[i], 115 - static_cast<Index>(i));
  }
}

TEST(QuadMatch, OtherMeshesDoNotMatch)
{
  const Quads source = grid(3);
  EXPECT_FALSE(hexsweep::matchQuads(source, grid(2), unknown(3, { { 0, 0 }, { 1, 1 } })));
  // As many quads, in one row.
  Quads row(9, 4);
  for (Index j = 0; j < 9; ++j)
  {
    row.row(j) << j, j + 1, j + 11, j + 10;
  }
  EXPECT_FALSE(hexsweep::matchQuads(source, row, unknown(3, { { 0, 0 }, { 1, 1 } })));
  // What is known of another point contradicts.
  EXPECT_FALSE(
    hexsweep::matchQuads(source, source, unknown(3, { { 0, 0 }, { 1, 1 }, { 15, 12 } })));
}
}
