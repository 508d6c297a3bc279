// SPDX-License-Identifier: BSD-3-Clause
// What the fixed nodes of hexahedra decide alone.
#include "Core/Hexahedra/FixedCorners.h"

#include "Core/Hexahedra/HexUntangling.h"
#include "Support/HexBlocks.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace TestFixedCorners
{
using hexsweep::Conflict;
using hexsweep::ConflictCause;
using hexsweep::FixedCorners;
using hexsweep::HexBoxes;
using hexsweep::Validity;
using test::HexBlock;
using test::Index;
using test::Points;

constexpr Index N = 4;

Index node(Index i, Index j, Index k)
{
  return (k * (N + 1) + j) * (N + 1) + i;
}

FixedCorners conflictsOf(const HexBlock& block)
{
  return hexsweep::fixedCorners(block.points, block.hexes, block.fixed);
}

std::vector<Index> hexesOf(const FixedCorners& fixed)
{
  std::vector<Index> hexes;
  for (const Conflict& conflict : fixed.conflicts)
  {
    hexes.push_back(conflict.hex);
  }
  return hexes;
}

std::set<Index> notCertified(const Points& points, const hexsweep::Hexes& hexes)
{
  std::set<Index> bad;
  const auto qualities = hexsweep::hexQualities(points, hexes);
  for (std::size_t h = 0; h < qualities.size(); ++h)
  {
    if (qualities[h].validity != Validity::Certified)
    {
      bad.insert(static_cast<Index>(h));
    }
  }
  return bad;
}

/// A node of the bottom drawn over its neighbour: the quads beyond turn over.
HexBlock foldedBlock()
{
  HexBlock block = test::makeBlock(N);
  block.points.row(node(2, 2, 0)) << 3.3, 2.2, 0.0;
  return block;
}

HexBoxes cubes(const HexBlock& block)
{
  return HexBoxes::Ones(block.hexes.rows(), 3);
}

TEST(FixedCornersOfHexes, AFoldInAPlaneCapIsAConflict)
{
  const HexBlock block = foldedBlock();
  const FixedCorners fixed = conflictsOf(block);
  ASSERT_FALSE(fixed.conflicts.empty());
  EXPECT_LE(fixed.floor, 0.0);
  for (const Conflict& conflict : fixed.conflicts)
  {
    EXPECT_EQ(conflict.cause, ConflictCause::Fold);
    // The quads that turned over are those beyond the node, under the hexahedra of the bottom.
    EXPECT_TRUE(conflict.hex == 1 * N + 2 || conflict.hex == 2 * N + 2) << conflict.hex;
    EXPECT_TRUE(fixed.forbids(conflict.hex));
  }
  EXPECT_FALSE(fixed.forbids(0));
  // No place of the node above cures all of them.
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    const Points points = test::shaken(block, 2.0, seed);
    const auto bad = notCertified(points, block.hexes);
    EXPECT_TRUE(std::any_of(bad.begin(), bad.end(), [](Index h) { return h < N * N; }));
  }
}

TEST(FixedCornersOfHexes, UntanglingMendsWhatTheFoldLeaves)
{
  const HexBlock block = foldedBlock();
  const FixedCorners fixed = conflictsOf(block);
  const auto result =
    hexsweep::untangleHexes(test::shaken(block, 0.5, 1), block.hexes, cubes(block), block.fixed);
  for (const Index h : notCertified(result.points, block.hexes))
  {
    EXPECT_TRUE(fixed.forbids(h)) << h;
  }
  EXPECT_GT(result.before, result.after);
}

TEST(FixedCornersOfHexes, SteepCapsAreNoConflict)
{
  // A spike and a dent in the bottom, both nearly as deep as the block: all faces of the spike
  // look outwards, and the node above may well stand over it.
  for (const double height : { 3.0, -50.0 })
  {
    HexBlock block = test::makeBlock(N);
    block.points(node(2, 2, 0), 2) = height;
    EXPECT_TRUE(conflictsOf(block).conflicts.empty());
    EXPECT_DOUBLE_EQ(conflictsOf(block).floor, 1.0);
  }
}

TEST(FixedCornersOfHexes, ColumnsThatRunBackAndEdgesWithoutLength)
{
  // Side x = 0: the ring of layer 2 below that of layer 1.
  HexBlock back = test::makeBlock(N);
  back.points(node(0, 2, 2), 2) = 0.4;
  const FixedCorners fixed = conflictsOf(back);
  ASSERT_FALSE(fixed.conflicts.empty());
  for (const Conflict& conflict : fixed.conflicts)
  {
    EXPECT_EQ(conflict.cause, ConflictCause::Fold);
    EXPECT_EQ(conflict.hex % N, 0); // at that side
  }

  HexBlock collapsed = test::makeBlock(N);
  collapsed.points.row(node(0, 2, 2)) = collapsed.points.row(node(0, 2, 1));
  const FixedCorners lost = conflictsOf(collapsed);
  // The two hexahedra on either side of the column, in layer 1.
  const std::vector<Index> expected{ (1 * N + 1) * N, (1 * N + 2) * N };
  std::vector<Index> edges;
  for (const Conflict& conflict : lost.conflicts)
  {
    if (conflict.cause == ConflictCause::Edge)
    {
      edges.push_back(conflict.hex);
    }
  }
  EXPECT_EQ(edges, expected);
  // Degenerate, wherever the inner nodes are.
  const auto qualities = hexsweep::hexQualities(test::shaken(collapsed, 0.2, 1), collapsed.hexes);
  for (const Index h : expected)
  {
    EXPECT_EQ(qualities[static_cast<std::size_t>(h)].validity, Validity::Degenerate);
  }
}

TEST(FixedCornersOfHexes, AHexWithoutFreeNodesIsCertified)
{
  // One cube, all nodes fixed, shaken until it is positive at its corners only.
  HexBlock block = test::makeBlock(1);
  const Points cube = block.points;
  const std::vector<bool> none(8, false);
  Index inside = 0;
  Index valid = 0;
  for (unsigned seed = 0; seed < 20000 && (inside < 5 || valid < 5); ++seed)
  {
    HexBlock loose = block;
    loose.fixed = none;
    block.points = test::shaken(loose, 0.55, seed);
    const Validity validity = hexsweep::hexQualities(block.points, block.hexes)[0].validity;
    if (validity == Validity::InvertedInside)
    {
      ++inside;
      ASSERT_EQ(hexesOf(conflictsOf(block)), std::vector<Index>{ 0 });
      EXPECT_EQ(conflictsOf(block).conflicts[0].cause, ConflictCause::Inside);
    }
    else if (validity == Validity::Certified)
    {
      ++valid;
      EXPECT_TRUE(conflictsOf(block).conflicts.empty());
      EXPECT_GT(conflictsOf(block).floor, 0.0);
    }
    block.points = cube;
  }
  EXPECT_EQ(inside, 5);
  EXPECT_GE(valid, 5);
}

TEST(FixedCornersOfHexes, TheSameAtAnySizeAndWhereverTheyAre)
{
  const HexBlock block = foldedBlock();
  const auto expected = hexesOf(conflictsOf(block));
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 0.5).normalized()).toRotationMatrix();
  for (const double scale : { 1e-6, 1e6 })
  {
    HexBlock placed = block;
    placed.points = scale * block.points * turn.transpose();
    placed.points.rowwise() += 10.0 * scale * Eigen::RowVector3d(1, -2, 3);
    EXPECT_EQ(hexesOf(conflictsOf(placed)), expected);
  }
}

TEST(FixedCornersOfHexes, TheOrderOfTheWorkDoesNotMatter)
{
  // More than one piece of work; folds at the nodes that were drawn over others.
  HexBlock block = test::makeBlock(36);
  for (Index i = 0; i < block.points.rows(); i += 7)
  {
    if (block.fixed[static_cast<std::size_t>(i)])
    {
      block.points.row(i) += Eigen::RowVector3d(1.3, 0.8, -0.7);
    }
  }
  Index most = 0;
  const auto backwards = [&](Index count, const std::function<void(Index)>& call) {
    most = std::max(most, count);
    for (Index i = count - 1; i >= 0; --i)
    {
      call(i);
    }
  };
  const FixedCorners alone = conflictsOf(block);
  const FixedCorners shared =
    hexsweep::fixedCorners(block.points, block.hexes, block.fixed, backwards);
  EXPECT_GT(most, 1);
  EXPECT_GT(alone.conflicts.size(), 50u);
  EXPECT_EQ(alone.floor, shared.floor);
  ASSERT_EQ(hexesOf(alone), hexesOf(shared));
  for (std::size_t i = 0; i < alone.conflicts.size(); ++i)
  {
    EXPECT_EQ(alone.conflicts[i].node, shared.conflicts[i].node);
    EXPECT_EQ(alone.conflicts[i].cause, shared.conflicts[i].cause);
  }
}
}
