// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Common/CellPatches.h"
#include "Support/HexBlocks.h"

#include <gtest/gtest.h>

namespace TestCellPatches
{
using hexsweep::CellPatch;
using hexsweep::cellPatches;
using hexsweep::CellsAtNodes;
using test::HexBlock;
using test::Index;

// Cube (i, j, k) of a block of n.
Index cube(Index n, Index i, Index j, Index k)
{
  return (k * n + j) * n + i;
}

TEST(CellPatches, HexesAtEachNode)
{
  const HexBlock block = test::makeBlock(3);
  const CellsAtNodes atNodes(block.hexes, block.points.rows());
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

TEST(CellPatches, RingsAreBoxesOfCubes)
{
  const Index n = 9;
  const HexBlock block = test::makeBlock(n);
  const CellsAtNodes atNodes(block.hexes, block.points.rows());
  for (const int rings : { 0, 1, 2, 3 })
  {
    const auto patches =
      cellPatches(block.hexes, atNodes, { cube(n, 4, 4, 4) }, rings, block.fixed);
    ASSERT_EQ(patches.size(), 1u);
    const CellPatch& patch = patches[0];
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
        ASSERT_EQ(patch.nodes[static_cast<std::size_t>(patch.corners(static_cast<Index>(c), i))],
          block.hexes(patch.cells[c], i));
      }
    }
  }
}

TEST(CellPatches, PiecesThatTouchAreOne)
{
  const Index n = 9;
  const HexBlock block = test::makeBlock(n);
  const CellsAtNodes atNodes(block.hexes, block.points.rows());
  const std::vector<Index> cells{ cube(n, 1, 4, 4), cube(n, 7, 4, 4) };
  EXPECT_EQ(cellPatches(block.hexes, atNodes, cells, 1, block.fixed).size(), 2u);
  EXPECT_EQ(cellPatches(block.hexes, atNodes, cells, 3, block.fixed).size(), 1u);
  // Fixed nodes stay fixed, also where all of their hexahedra are in the piece.
  for (const CellPatch& patch : cellPatches(block.hexes, atNodes, cells, 3, block.fixed))
  {
    for (std::size_t i = 0; i < patch.nodes.size(); ++i)
    {
      EXPECT_FALSE(patch.free[i] && block.fixed[static_cast<std::size_t>(patch.nodes[i])]);
    }
  }
}

// Quads of a row, two to a side of the middle one.
TEST(CellPatches, QuadsAreCellsAsWell)
{
  const Index n = 9;
  hexsweep::Quads quads(n, 4);
  for (Index q = 0; q < n; ++q)
  {
    quads.row(q) << 2 * q, 2 * q + 2, 2 * q + 3, 2 * q + 1;
  }
  const std::vector<bool> fixed(20, false);
  const CellsAtNodes atNodes(quads, 20);
  const auto patches = cellPatches(quads, atNodes, { 4 }, 2, fixed);
  ASSERT_EQ(patches.size(), 1u);
  EXPECT_EQ(patches[0].cells, (std::vector<Index>{ 2, 3, 4, 5, 6 }));
  EXPECT_EQ(patches[0].corners.cols(), 4);
  EXPECT_EQ(std::count(patches[0].free.begin(), patches[0].free.end(), true), 8);
  for (std::size_t c = 0; c < patches[0].cells.size(); ++c)
  {
    for (Index i = 0; i < 4; ++i)
    {
      const Index local = patches[0].corners(static_cast<Index>(c), i);
      EXPECT_EQ(patches[0].nodes[static_cast<std::size_t>(local)], quads(patches[0].cells[c], i));
    }
  }
}
}
