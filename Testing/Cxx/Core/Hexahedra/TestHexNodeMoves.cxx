// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexNodeMoves.h"

#include "Support/HexBlocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace TestHexNodeMoves
{
using hexsweep::HexLoss;
using hexsweep::HexNodeMoves;
using test::Index;

constexpr HexLoss Losses[] = { {}, { 7.0, 0.2 }, { 40.0, 0.9 } };

TEST(HexNodeMoves, LossesMatchDifferencesAndFall)
{
  constexpr double H = 1e-5;
  for (const HexLoss& loss : Losses)
  {
    for (double x = -0.95; x < 0.96; x += 0.1)
    {
      const HexLoss::Place at = loss.at(x);
      EXPECT_LT(at.slope, 0.0);
      const double slope = (loss.at(x + H).value - loss.at(x - H).value) / (2.0 * H);
      EXPECT_NEAR(at.slope, slope, 1e-6 * (1.0 + std::abs(slope)));
      const double curvature = (loss.at(x + H).slope - loss.at(x - H).slope) / (2.0 * H);
      EXPECT_NEAR(at.curvature, curvature, 1e-5 * (1.0 + curvature));
    }
  }
}

TEST(HexNodeMoves, GroupsShareNoHexAndHoldAllFreeNodes)
{
  const test::HexBlock block = test::makeBlock(5);
  const HexNodeMoves moves(block.points, block.hexes, block.fixed, {}, {});
  std::size_t nodes = 0;
  for (const std::vector<Index>& group : moves.groups())
  {
    nodes += group.size();
    std::vector<int> visits(static_cast<std::size_t>(block.hexes.rows()), 0);
    for (const Index node : group)
    {
      EXPECT_FALSE(block.fixed[static_cast<std::size_t>(node)]);
      for (Index h = 0; h < block.hexes.rows(); ++h)
      {
        visits[static_cast<std::size_t>(h)] += (block.hexes.row(h).array() == node).any();
      }
    }
    EXPECT_LE(*std::max_element(visits.begin(), visits.end()), 1);
  }
  EXPECT_EQ(nodes, 64u);
}

TEST(HexNodeMoves, NodesOfGoodHexesAreInNoGroup)
{
  const test::HexBlock block = test::makeBlock(6);
  test::Points points = block.points;
  const Index shifted = 3 * 49 + 2 * 7 + 2; // inside
  points(shifted, 0) += 0.3;
  const HexNodeMoves moves(
    points, block.hexes, block.fixed, hexsweep::hexVerdicts(points, block.hexes), 1.0 - 1e-9, {});
  std::vector<bool> grouped(block.fixed.size(), false);
  for (const std::vector<Index>& group : moves.groups())
  {
    for (const Index node : group)
    {
      grouped[static_cast<std::size_t>(node)] = true;
    }
  }
  for (Index i = 0; i < points.rows(); ++i)
  {
    // Those that share a cube with it.
    const bool near = (block.points.row(i) - block.points.row(shifted)).cwiseAbs().maxCoeff() < 1.5;
    EXPECT_EQ(
      grouped[static_cast<std::size_t>(i)], near && !block.fixed[static_cast<std::size_t>(i)])
      << i;
  }
}

TEST(HexNodeMoves, AStepLowersTheSumAndKeepsTheFloor)
{
  const test::HexBlock block = test::makeBlock(3);
  int moved = 0;
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    const test::Points start = test::shaken(block, 0.45, seed);
    HexNodeMoves moves(start, block.hexes, block.fixed, {}, {});
    for (const std::vector<Index>& group : moves.groups())
    {
      for (const Index node : group)
      {
        const double least = moves.leastAt(node);
        const HexNodeMoves::Step step = moves.move(node, {}, least);
        EXPECT_EQ(step.moved, step.gain > 0.0);
        EXPECT_GE(moves.leastAt(node), least);
        moved += step.moved;
      }
    }
    // What it keeps of the qualities is what the points have.
    const std::vector<hexsweep::HexQuality> kept = moves.qualities();
    const auto anew = hexsweep::hexQualities(moves.take(), block.hexes);
    for (std::size_t h = 0; h < kept.size(); ++h)
    {
      EXPECT_EQ(kept[h].scaledJacobian, anew[h].scaledJacobian);
      EXPECT_EQ(kept[h].validity, anew[h].validity);
    }
  }
  EXPECT_GT(moved, 20);
}
}
