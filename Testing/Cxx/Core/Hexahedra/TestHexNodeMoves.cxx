// SPDX-License-Identifier: BSD-3-Clause
// Sums and slopes of single nodes against Verdict's definition and against differences.
#include "Core/Hexahedra/HexNodeMoves.h"

#include "Core/Hexahedra/HexCorner.h"
#include "Support/HexBlocks.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using hexsweep::HexLoss;
using hexsweep::HexNodeMoves;
using hexsweep::HexNodeSum;
using test::Index;

constexpr HexLoss Losses[] = { {}, { 7.0, 0.2 }, { 40.0, 0.9 } };

/// The loss over the corners that have `moving` as their node or at the end of an edge.
double plainSum(const hexsweep::HexCorners& corners, int moving, const HexLoss& loss)
{
  double sum = 0.0;
  for (int c = 0; c < 8; ++c)
  {
    const int* to = hexsweep::HexCornerNeighbors[c];
    if (c == moving || std::find(to, to + 3, moving) != to + 3)
    {
      const auto place = [&](int i) -> Eigen::RowVector3d { return corners.row(i); };
      sum += loss.at(hexsweep::hexFrame(place, c).scaledDeterminant()).value;
    }
  }
  return sum;
}

hexsweep::HexCorners shakenCube(unsigned seed)
{
  const test::HexBlock block = test::makeBlock(1);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> shift(-0.6, 0.6);
  hexsweep::HexCorners corners;
  for (int i = 0; i < 8; ++i)
  {
    corners.row(i) = block.points.row(block.hexes(0, i)) +
      Eigen::RowVector3d(shift(generator), shift(generator), shift(generator));
  }
  return corners;
}
}

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

TEST(HexNodeMoves, SumsMatchTheDefinitionAndGradientsDifferences)
{
  constexpr double H = 1e-6;
  for (unsigned seed = 1; seed <= 30; ++seed)
  {
    const hexsweep::HexCorners corners = shakenCube(seed);
    const int moving = static_cast<int>(seed % 8);
    for (const HexLoss& loss : Losses)
    {
      HexNodeSum sum;
      sum.add(corners, moving, loss);
      const double value = plainSum(corners, moving, loss);
      EXPECT_NEAR(sum.value, value, 1e-11 * value);
      EXPECT_NEAR(HexNodeSum::valueOf(corners, moving, loss), value, 1e-11 * value);
      for (int axis = 0; axis < 3; ++axis)
      {
        hexsweep::HexCorners before = corners;
        hexsweep::HexCorners after = corners;
        before(moving, axis) -= H;
        after(moving, axis) += H;
        const double slope =
          (plainSum(after, moving, loss) - plainSum(before, moving, loss)) / (2.0 * H);
        EXPECT_NEAR(sum.gradient[axis], slope, 1e-5 * (1.0 + std::abs(slope) + value));
      }
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(sum.curvature);
      EXPECT_GT(eigen.eigenvalues().minCoeff(), -1e-10 * eigen.eigenvalues().maxCoeff());
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
