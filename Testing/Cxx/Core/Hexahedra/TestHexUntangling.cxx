// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexUntangling.h"

#include "Core/Common/Errors.h"
#include "Core/Hexahedra/FixedCorners.h"
#include "Support/HexBlocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace TestHexUntangling
{
using hexsweep::HexBoxes;
using hexsweep::HexDescent;
using hexsweep::HexSamples;
using hexsweep::UntangledHexes;
using test::HexBlock;
using test::Index;
using test::Points;

HexBoxes cubes(const HexBlock& block)
{
  return HexBoxes::Ones(block.hexes.rows(), 3);
}

std::vector<bool> opposite(std::vector<bool> flags)
{
  flags.flip();
  return flags;
}

TEST(HexDescent, FindsTheCubesAgain)
{
  // The undisturbed block is the minimum: every Jacobian is the identity.
  const HexBlock block = test::makeBlock(3);
  const HexDescent descent(block.hexes, cubes(block), opposite(block.fixed));
  for (const HexSamples samples : { HexSamples::Corners, HexSamples::Lattice })
  {
    Points points = test::shaken(block, 0.3, 5);
    const HexDescent::Result result = descent.descend(points, samples, 1e-3, 60, 0.0);
    EXPECT_LT((result.points - block.points).norm(), 1e-6);
    // Sum over the samples of 1, which is the energy of a rotation.
    EXPECT_NEAR(result.after, 27.0 * (samples == HexSamples::Corners ? 8 : 27), 1e-3);
    EXPECT_NEAR(result.leastDeterminant, 1.0, 1e-5);
    EXPECT_GT(result.before, result.after);
  }
}

TEST(HexDescent, BoxesSetTheScale)
{
  HexBlock block = test::makeBlock(3);
  block.points.col(1) *= 1e-3;
  block.points *= 1e6;
  HexBoxes boxes = cubes(block) * 1e6;
  boxes.col(1) *= 1e-3;
  const HexDescent descent(block.hexes, boxes, opposite(block.fixed));
  Points points = block.points;
  for (Index i = 0; i < points.rows(); ++i)
  {
    if (!block.fixed[static_cast<std::size_t>(i)])
    {
      points.row(i) += Eigen::RowVector3d(1e5, -2e2, 3e5);
    }
  }
  const Points result = descent.descend(points, HexSamples::Corners, 1e-3, 60, 0.0).points;
  EXPECT_LT((result - block.points).norm(), 1e-6 * 1e6);
  EXPECT_LT((result - block.points).col(1).norm(), 1e-6 * 1e3);
}

TEST(HexUntangling, MendsABlockShakenInside)
{
  const HexBlock block = test::makeBlock(6);
  for (const unsigned seed : { 1u, 2u, 3u })
  {
    const Points start = test::shaken(block, 0.9, seed);
    const auto before = test::judge(start, block.hexes);
    ASSERT_GT(before.inverted, 50);
    const UntangledHexes result =
      hexsweep::untangleHexes(start, block.hexes, cubes(block), block.fixed);
    EXPECT_EQ(result.before, before.notCertified);
    EXPECT_EQ(result.after, 0);
    EXPECT_EQ(test::judge(result.points, block.hexes).notCertified, 0);
    for (Index i = 0; i < start.rows(); ++i)
    {
      if (block.fixed[static_cast<std::size_t>(i)])
      {
        ASSERT_EQ(result.points.row(i), start.row(i));
      }
    }
  }
}

TEST(HexUntangling, LeavesWhatIsFarAway)
{
  const HexBlock block = test::makeBlock(12);
  Points start = block.points;
  const Index middle = (6 * 13 + 6) * 13 + 6;
  start(middle, 0) += 1.4; // beyond its neighbour
  const UntangledHexes result =
    hexsweep::untangleHexes(start, block.hexes, cubes(block), block.fixed);
  EXPECT_EQ(result.after, 0);
  EXPECT_EQ(result.patches, 1);
  for (Index i = 0; i < start.rows(); ++i)
  {
    // Eight bad cubes and three rings: five edges from the node.
    if ((block.points.row(i) - block.points.row(middle)).cwiseAbs().maxCoeff() > 4.5)
    {
      ASSERT_EQ(result.points.row(i), start.row(i));
    }
  }
}

TEST(HexUntangling, MendsWhatIsPositiveAtItsCornersOnly)
{
  // Johnen, Weill, Remacle 2017 warn of such: positive corners, negative inside. Found by search
  // here: the cube of a block of three, its eight nodes free.
  const HexBlock block = test::makeBlock(3);
  const Index center = (1 * 3 + 1) * 3 + 1;
  for (unsigned seed = 0; seed < 100000; ++seed)
  {
    const Points start = test::shaken(block, 0.55, seed);
    const auto qualities = hexsweep::hexQualities(start, block.hexes);
    const auto others = std::count_if(qualities.begin(), qualities.end(),
      [](const auto& quality) { return quality.validity == hexsweep::Validity::InvertedCorner; });
    if (others > 0 ||
      qualities[static_cast<std::size_t>(center)].validity != hexsweep::Validity::InvertedInside)
    {
      continue;
    }
    const UntangledHexes result =
      hexsweep::untangleHexes(start, block.hexes, cubes(block), block.fixed);
    EXPECT_GT(result.before, 0);
    EXPECT_EQ(test::judge(result.points, block.hexes).notCertified, 0);
    return;
  }
  FAIL() << "no such cube among the samples";
}

TEST(HexUntangling, SaysWhatFixedNodesForbidAndMendsTheRest)
{
  HexBlock block = test::makeBlock(5);
  // A corner of the block that is pushed through: all four of its nodes are fixed.
  block.points.row(0) << 1.5, 1.5, 1.5;
  Points start = test::shaken(block, 0.0, 1);
  const Index node = (3 * 6 + 3) * 6 + 3;
  start(node, 0) += 1.4;
  const auto fixed = hexsweep::fixedCorners(start, block.hexes, block.fixed);
  ASSERT_EQ(fixed.conflicts.size(), 1u);
  EXPECT_EQ(fixed.conflicts[0].hex, 0);
  EXPECT_EQ(fixed.conflicts[0].cause, hexsweep::ConflictCause::Corner);
  EXPECT_LT(fixed.floor, 0.0);
  const UntangledHexes result =
    hexsweep::untangleHexes(start, block.hexes, cubes(block), block.fixed);
  EXPECT_EQ(result.after, 1);
  const auto qualities = hexsweep::hexQualities(result.points, block.hexes);
  for (std::size_t h = 1; h < qualities.size(); ++h)
  {
    EXPECT_EQ(qualities[h].validity, hexsweep::Validity::Certified) << h;
  }
}

TEST(HexUntangling, FixedCornersOfAGoodBlock)
{
  const HexBlock block = test::makeBlock(3);
  const auto fixed = hexsweep::fixedCorners(block.points, block.hexes, block.fixed);
  EXPECT_DOUBLE_EQ(fixed.floor, 1.0);
  EXPECT_TRUE(fixed.conflicts.empty());
  // A corner of the block turned: the floor is its scaled Jacobian.
  Points points = block.points;
  points.row(0) << 0.5, 0.0, 0.0;
  const double expected = 1.0 / (std::hypot(0.5, 1.0) * std::hypot(0.5, 1.0));
  EXPECT_NEAR(hexsweep::fixedCorners(points, block.hexes, block.fixed).floor, expected, 1e-12);
}

TEST(HexUntangling, SpendsNoMoreThanItsBudget)
{
  // Far beyond repair within a few steps: nodes thrown over several cubes.
  const HexBlock block = test::makeBlock(6);
  const Index count = block.hexes.rows();
  const Points start = test::shaken(block, 5.0, 1);
  const UntangledHexes result =
    hexsweep::untangleHexes(start, block.hexes, cubes(block), block.fixed);
  ASSERT_GT(result.before, count / 2);
  // Every halving earns the budget once more.
  const double extensions = std::log(static_cast<double>(result.before) /
                              std::max(1.0, static_cast<double>(result.after))) /
    std::log(2.0);
  EXPECT_GT(result.work, 0.0);
  EXPECT_LE(result.work, (1.0 + extensions) * hexsweep::untanglingBudget(count));
  EXPECT_LE(result.after, result.before);
}

TEST(HexUntangling, CanBeAborted)
{
  const HexBlock block = test::makeBlock(6);
  EXPECT_THROW(hexsweep::untangleHexes(test::shaken(block, 0.9, 1), block.hexes, cubes(block),
                 block.fixed, {}, [](double) { return false; }),
    hexsweep::Aborted);
}
}
