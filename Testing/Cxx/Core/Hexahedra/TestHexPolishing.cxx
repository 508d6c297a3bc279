// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexPolishing.h"

#include "Core/Common/Errors.h"
#include "Support/HexBlocks.h"

#include <gtest/gtest.h>

namespace TestHexPolishing
{
using hexsweep::polishHexes;
using test::HexBlock;
using test::Index;
using test::Points;

/// The calls in another order, as threads might make them.
void backwards(Index count, const std::function<void(Index)>& call)
{
  for (Index i = count - 1; i >= 0; --i)
  {
    call(i);
  }
}

TEST(HexPolishing, RaisesTheMeanAndKeepsTheMinimum)
{
  const HexBlock block = test::makeBlock(6);
  for (const unsigned seed : { 1u, 2u, 3u })
  {
    for (const double amount : { 0.2, 0.35, 0.5 })
    {
      const Points start = test::shaken(block, amount, seed);
      const auto before = hexsweep::hexQualities(start, block.hexes);
      const Points points = polishHexes(start, block.hexes, block.fixed, 4).points;
      const auto after = hexsweep::hexQualities(points, block.hexes);
      const auto was = hexsweep::summarize(before);
      const auto is = hexsweep::summarize(after);
      EXPECT_GT(is.meanScaledJacobian, was.meanScaledJacobian + 0.05);
      EXPECT_GE(is.minScaledJacobian, was.minScaledJacobian);
      for (std::size_t h = 0; h < before.size(); ++h)
      {
        if (before[h].validity == hexsweep::Validity::Certified)
        {
          ASSERT_EQ(after[h].validity, hexsweep::Validity::Certified);
        }
      }
      for (Index i = 0; i < points.rows(); ++i)
      {
        if (block.fixed[static_cast<std::size_t>(i)])
        {
          ASSERT_EQ(points.row(i), start.row(i));
        }
      }
    }
  }
}

TEST(HexPolishing, FindsTheCubesAgain)
{
  const HexBlock block = test::makeBlock(5);
  const Points start = test::shaken(block, 0.3, 7);
  const Points points = polishHexes(start, block.hexes, block.fixed, 60).points;
  // Nodes of cubes better than 0.95 stay.
  EXPECT_GT(test::judge(points, block.hexes).minScaledJacobian, 0.94);
}

TEST(HexPolishing, SizeDoesNotMatterNorDoesTheOrderOfTheWork)
{
  const HexBlock block = test::makeBlock(18);
  const Points start = test::shaken(block, 0.4, 4);
  const Points points = polishHexes(start, block.hexes, block.fixed, 3).points;
  Index mostCalls = 0;
  const auto counted = [&mostCalls](Index count, const std::function<void(Index)>& call) {
    mostCalls = std::max(mostCalls, count);
    backwards(count, call);
  };
  EXPECT_EQ(polishHexes(start, block.hexes, block.fixed, 3, counted).points, points);
  EXPECT_GT(mostCalls, 1);
  for (const double scale : { 1.0 / 1048576.0, 1048576.0 })
  {
    const Points scaled = polishHexes(Points(scale * start), block.hexes, block.fixed, 3).points;
    EXPECT_LT((scaled / scale - points).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(HexPolishing, GoodHexesStayAsTheyAre)
{
  const HexBlock block = test::makeBlock(4);
  const auto result = polishHexes(block.points, block.hexes, block.fixed, 5);
  EXPECT_EQ(result.points, block.points);
  EXPECT_EQ(result.movedNodes, 0);
}

TEST(HexPolishing, StopsWhereNoNodeGains)
{
  const HexBlock block = test::makeBlock(5);
  const Points start = test::shaken(block, 0.3, 7);
  Index calls = 0;
  const auto counted = [&calls](Index count, const std::function<void(Index)>& call) {
    ++calls;
    backwards(count, call);
  };
  const auto few = polishHexes(start, block.hexes, block.fixed, 60, counted);
  const Index needed = calls;
  calls = 0;
  const auto many = polishHexes(start, block.hexes, block.fixed, 100000, counted);
  EXPECT_EQ(few.points, many.points);
  EXPECT_EQ(few.movedNodes, many.movedNodes);
  EXPECT_EQ(calls, needed);
}

TEST(HexPolishing, CanBeAborted)
{
  const HexBlock block = test::makeBlock(4);
  EXPECT_THROW(
    polishHexes(block.points, block.hexes, block.fixed, 5, {}, [](double) { return false; }),
    hexsweep::Aborted);
}
}
