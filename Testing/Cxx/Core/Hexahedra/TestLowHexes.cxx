// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/LowHexes.h"

#include "Core/Common/Errors.h"
#include "Core/Hexahedra/HexMinimum.h"
#include "Core/Hexahedra/HexUntangling.h"
#include "Support/HexBlocks.h"

#include <gtest/gtest.h>

namespace TestLowHexes
{
using hexsweep::RaisedLowHexes;
using hexsweep::raiseLowHexes;
using test::HexBlock;
using test::Index;
using test::Points;

/// A block shorn by an inner layer: nodes of the middle plane are moved along it, all the same way.
/// All of them have to move back together.
Points shorn(const HexBlock& block, Index n, double amount)
{
  Points points = block.points;
  for (Index i = 0; i < points.rows(); ++i)
  {
    if (!block.fixed[static_cast<std::size_t>(i)] && 2.0 * points(i, 2) == static_cast<double>(n))
    {
      points(i, 0) += amount;
      points(i, 1) += amount;
    }
  }
  return points;
}

TEST(LowHexes, NodesThatWereMovedTogetherMoveBackTogether)
{
  for (const double amount : { 0.7, 0.8, 0.9 })
  {
    const HexBlock block = test::makeBlock(4);
    const Points start = shorn(block, 4, amount);
    ASSERT_LT(test::judge(start, block.hexes).minScaledJacobian, 0.35);
    const RaisedLowHexes raised = raiseLowHexes(start, block.hexes, block.fixed, 0.7);
    EXPECT_EQ(raised.before, test::judge(start, block.hexes).minScaledJacobian);
    EXPECT_EQ(raised.after, test::judge(raised.points, block.hexes).minScaledJacobian);
    EXPECT_GE(raised.after, 0.7) << amount;
    EXPECT_LE(raised.work, 0.15 * hexsweep::untanglingBudget(block.hexes.rows()));
    for (Index i = 0; i < start.rows(); ++i)
    {
      if (block.fixed[static_cast<std::size_t>(i)])
      {
        ASSERT_EQ(raised.points.row(i), start.row(i));
      }
    }
  }
}

TEST(LowHexes, NeitherTheMinimumNorTheNumberOfCertifiedHexesFalls)
{
  for (const unsigned seed : { 1u, 2u, 3u, 4u })
  {
    for (const double amount : { 0.3, 0.5, 0.7 })
    {
      const HexBlock block = test::makeBlock(5);
      const Points start = test::shaken(block, amount, seed);
      const auto before = test::judge(start, block.hexes);
      const auto after =
        test::judge(raiseLowHexes(start, block.hexes, block.fixed, 0.9).points, block.hexes);
      EXPECT_GE(after.minScaledJacobian, before.minScaledJacobian);
      EXPECT_LE(after.notCertified, before.notCertified);
    }
  }
}

TEST(LowHexes, WhatIsGoodEnoughStays)
{
  const HexBlock block = test::makeBlock(4);
  const Points start = test::shaken(block, 0.2, 2);
  const double least = test::judge(start, block.hexes).minScaledJacobian;
  for (const double wanted : { least, 0.0, -1.0 })
  {
    const RaisedLowHexes raised = raiseLowHexes(start, block.hexes, block.fixed, wanted);
    EXPECT_EQ(raised.points, start);
    EXPECT_EQ(raised.patches, 0);
  }
}

TEST(LowHexes, SizeDoesNotMatter)
{
  const HexBlock block = test::makeBlock(5);
  const Points start = test::shaken(block, 0.5, 7);
  const Points points = raiseLowHexes(start, block.hexes, block.fixed, 0.6).points;
  EXPECT_NE(points, start);
  const double size = std::ldexp(1.0, -30);
  EXPECT_EQ(raiseLowHexes(size * start, block.hexes, block.fixed, 0.6).points, size * points);
}

TEST(LowHexes, CanBeAborted)
{
  const HexBlock block = test::makeBlock(5);
  EXPECT_THROW(raiseLowHexes(test::shaken(block, 0.5, 7), block.hexes, block.fixed, 0.6, {},
                 [](double) { return false; }),
    hexsweep::Aborted);
}
}
