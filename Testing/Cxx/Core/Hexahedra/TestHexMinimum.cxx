// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexMinimum.h"

#include "Core/Common/Errors.h"
#include "Core/Hexahedra/FixedCorners.h"
#include "Core/Hexahedra/HexCorner.h"
#include "Support/HexBlocks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace TestHexMinimum
{
using hexsweep::Certificates;
using hexsweep::RaisedMinimum;
using hexsweep::raiseMinimum;
using test::HexBlock;
using test::Index;
using test::Points;

/// A block whose upper and lower sides run into the others nearly without an edge, as a rounded
/// body's do: corners between them are flat.
HexBlock roundedBlock(Index n, double roundness)
{
  HexBlock block = test::makeBlock(n);
  for (Index i = 0; i < block.points.rows(); ++i)
  {
    const Eigen::Array3d u = 2.0 * block.points.row(i).transpose().array() / double(n) - 1.0;
    const Eigen::Array3d s = roundness * u.square();
    block.points.row(i) << u[0] * std::sqrt(1 - s[1] / 2 - s[2] / 2 + s[1] * s[2] / 3),
      u[1] * std::sqrt(1 - s[2] / 2 - s[0] / 2 + s[2] * s[0] / 3),
      u[2] * std::sqrt(1 - s[0] / 2 - s[1] / 2 + s[0] * s[1] / 3);
  }
  return block;
}

TEST(HexMinimum, RaisesItToWhatIsWanted)
{
  for (const unsigned seed : { 1u, 2u, 3u })
  {
    const HexBlock block = test::makeBlock(6);
    const Points start = test::shaken(block, 0.3, seed);
    const auto before = hexsweep::hexQualities(start, block.hexes);
    ASSERT_LT(hexsweep::summarize(before).minScaledJacobian, 0.3);
    const RaisedMinimum raised = raiseMinimum(start, block.hexes, block.fixed, 0.6);
    const auto after = hexsweep::hexQualities(raised.points, block.hexes);
    EXPECT_GE(hexsweep::summarize(after).minScaledJacobian, 0.6);
    EXPECT_EQ(raised.after, 0);
    Index below = 0;
    for (std::size_t h = 0; h < before.size(); ++h)
    {
      below += before[h].scaledJacobian < 0.6;
      EXPECT_EQ(after[h].validity, hexsweep::Validity::Certified);
    }
    EXPECT_EQ(raised.before, below);
    for (Index i = 0; i < start.rows(); ++i)
    {
      if (block.fixed[static_cast<std::size_t>(i)])
      {
        ASSERT_EQ(raised.points.row(i), start.row(i));
      }
    }
  }
}

// No mesh is better than its fixed corners, and here there is one that reaches them: the block.
TEST(HexMinimum, ReachesTheFloorOfARoundedBlock)
{
  const HexBlock block = roundedBlock(8, 0.85);
  const double floor = hexsweep::fixedCorners(block.points, block.hexes, block.fixed).floor;
  EXPECT_LT(floor, 0.3);
  EXPECT_GE(test::judge(block.points, block.hexes).minScaledJacobian, floor * (1.0 - 1e-12));
  for (const unsigned seed : { 4u, 5u, 6u })
  {
    const Points start = test::shaken(block, 0.05, seed);
    ASSERT_LT(test::judge(start, block.hexes).minScaledJacobian, 0.5 * floor);
    const Points points =
      raiseMinimum(start, block.hexes, block.fixed, floor * (1.0 - 1e-12), Certificates::MayGo)
        .points;
    EXPECT_GE(test::judge(points, block.hexes).minScaledJacobian, floor * (1.0 - 1e-12)) << seed;
  }
}

TEST(HexMinimum, NeverLowersItAndLosesNoCertificate)
{
  const HexBlock block = test::makeBlock(5);
  for (const double amount : { 0.3, 0.5, 0.7 })
  {
    const Points start = test::shaken(block, amount, 9);
    const auto before = hexsweep::hexQualities(start, block.hexes);
    const Points points = raiseMinimum(start, block.hexes, block.fixed, 0.999).points;
    const auto after = hexsweep::hexQualities(points, block.hexes);
    EXPECT_GE(
      hexsweep::summarize(after).minScaledJacobian, hexsweep::summarize(before).minScaledJacobian);
    for (std::size_t h = 0; h < before.size(); ++h)
    {
      if (before[h].validity == hexsweep::Validity::Certified)
      {
        EXPECT_EQ(after[h].validity, hexsweep::Validity::Certified);
      }
    }
  }
}

TEST(HexMinimum, WhatIsGoodEnoughStays)
{
  const HexBlock block = test::makeBlock(4);
  const Points start = test::shaken(block, 0.2, 2);
  const double least = test::judge(start, block.hexes).minScaledJacobian;
  for (const double wanted : { least, 0.0, -1.0 })
  {
    const RaisedMinimum raised = raiseMinimum(start, block.hexes, block.fixed, wanted);
    EXPECT_EQ(raised.points, start);
    EXPECT_EQ(raised.rounds, 0);
  }
}

TEST(HexMinimum, SizeDoesNotMatterNorDoesTheOrderOfTheWork)
{
  const HexBlock block = test::makeBlock(14);
  const Points start = test::shaken(block, 0.4, 4);
  const Points points = raiseMinimum(start, block.hexes, block.fixed, 0.6).points;
  Index mostCalls = 0;
  const auto backwards = [&](Index count, const std::function<void(Index)>& call) {
    mostCalls = std::max(mostCalls, count);
    for (Index i = count - 1; i >= 0; --i)
    {
      call(i);
    }
  };
  EXPECT_EQ(
    raiseMinimum(start, block.hexes, block.fixed, 0.6, Certificates::Stay, backwards).points,
    points);
  EXPECT_GT(mostCalls, 1);
  for (const double scale : { 1.0 / 1048576.0, 1048576.0 })
  {
    const Points scaled = raiseMinimum(Points(scale * start), block.hexes, block.fixed, 0.6).points;
    EXPECT_LT((scaled / scale - points).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(HexMinimum, EdgesDoNotShrinkToNothing)
{
  // The middles of bottom and top are turned against each other, and stay: hexahedra are low for
  // the turn of their edges, and would be better the shorter these are.
  for (const double turn : { 0.9, 1.5 })
  {
    const Index n = 4;
    const HexBlock block = test::makeBlock(n);
    Points start = block.points;
    for (Index i = 0; i < start.rows(); ++i)
    {
      const bool isTop = start(i, 2) == static_cast<double>(n);
      if (isTop || start(i, 2) == 0.0)
      {
        const Eigen::Vector2d out = start.row(i).head<2>().transpose().array() - 0.5 * n;
        const double inside = 1.0 - out.cwiseAbs().maxCoeff() / (0.5 * n);
        start.row(i).head<2>() =
          (Eigen::Rotation2Dd((isTop ? -2.0 : 2.0) * turn * inside) * out).transpose().array() +
          0.5 * n;
      }
    }
    const Points raised =
      raiseMinimum(start, block.hexes, block.fixed, 0.9, Certificates::MayGo).points;
    for (Index h = 0; h < block.hexes.rows(); ++h)
    {
      for (int c = 0; c < 8; ++c)
      {
        for (const int next : hexsweep::HexCornerNeighbors[c])
        {
          const Index a = block.hexes(h, c);
          const Index b = block.hexes(h, next);
          EXPECT_GE((raised.row(b) - raised.row(a)).norm(),
            0.1 * (1.0 - 1e-12) * (start.row(b) - start.row(a)).norm());
        }
      }
    }
  }
}

TEST(HexMinimum, CanBeAborted)
{
  const HexBlock block = test::makeBlock(4);
  const Points start = test::shaken(block, 0.4, 1);
  EXPECT_THROW(raiseMinimum(start, block.hexes, block.fixed, 0.9, Certificates::Stay, {},
                 [](double) { return false; }),
    hexsweep::Aborted);
}
}
