// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexPatches.h"
#include "Support/HexBlocks.h"

#include <gtest/gtest.h>

namespace
{
using hexsweep::HexesAtNodes;
using hexsweep::HexPatch;
using hexsweep::hexPatches;
using test::HexBlock;
using test::Index;

// Cube (i, j, k) of a block of n.
Index cube(Index n, Index i, Index j, Index k)
{
  return (k * n + j) * n + i;
}
}

TEST(HexPatches, HexesAtEachNode)
{
  const HexBlock block = test::makeBlock(3);
  const HexesAtNodes atNodes(block.hexes, block.points.rows());
  for (Index i = 0; i < block.points.rows(); ++i)
  {
    std::vector<Index> expected;
    for (Index h = 0; h < block.hexes.rows(); ++h)
    {
      if ((block.hexes.row(h).array() == i).any())
      {
        expected.push_back(h);
      }
    }
    const auto around = atNodes[i];
    EXPECT_EQ(std::vector<Index>(around.begin(), around.end()), expected);
  }
}

TEST(HexPatches, RingsAreBoxesOfCubes)
{
  const Index n = 9;
  const HexBlock block = test::makeBlock(n);
  const HexesAtNodes atNodes(block.hexes, block.points.rows());
  for (const int rings : { 0, 1, 2, 3 })
  {
    const auto patches = hexPatches(block.hexes, atNodes, { cube(n, 4, 4, 4) }, rings, block.fixed);
    ASSERT_EQ(patches.size(), 1u);
    const HexPatch& patch = patches[0];
    const Index side = 2 * rings + 1;
    EXPECT_EQ(static_cast<Index>(patch.cells.size()), side * side * side);
    EXPECT_EQ(static_cast<Index>(patch.nodes.size()), (side + 1) * (side + 1) * (side + 1));
    // All inside is free, and nothing on its surface.
    EXPECT_EQ(
      std::count(patch.free.begin(), patch.free.end(), true), (side - 1) * (side - 1) * (side - 1));
    for (std::size_t c = 0; c < patch.cells.size(); ++c)
    {
      for (int i = 0; i < 8; ++i)
      {
        ASSERT_EQ(patch.nodes[static_cast<std::size_t>(patch.hexes(static_cast<Index>(c), i))],
          block.hexes(patch.cells[c], i));
      }
    }
  }
}

TEST(HexPatches, PiecesThatTouchAreOne)
{
  const Index n = 9;
  const HexBlock block = test::makeBlock(n);
  const HexesAtNodes atNodes(block.hexes, block.points.rows());
  const std::vector<Index> cells{ cube(n, 1, 4, 4), cube(n, 7, 4, 4) };
  EXPECT_EQ(hexPatches(block.hexes, atNodes, cells, 1, block.fixed).size(), 2u);
  EXPECT_EQ(hexPatches(block.hexes, atNodes, cells, 3, block.fixed).size(), 1u);
  // Fixed nodes stay fixed, also where all of their hexahedra are in the piece.
  for (const HexPatch& patch : hexPatches(block.hexes, atNodes, cells, 3, block.fixed))
  {
    for (std::size_t i = 0; i < patch.nodes.size(); ++i)
    {
      EXPECT_FALSE(patch.free[i] && block.fixed[static_cast<std::size_t>(patch.nodes[i])]);
    }
  }
}
