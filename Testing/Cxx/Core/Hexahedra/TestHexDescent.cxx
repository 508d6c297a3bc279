// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexDescent.h"

#include "Core/Geometry/FoldoverFreeEnergy.h"
#include "Core/Hexahedra/HexCorner.h"
#include "Support/HexBlocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace TestHexDescent
{
using test::Index;
using test::Points;

constexpr double VolumeWeight = 1.0 / 128.0;

/// The sum over the corners, in boxes of edge 1, and its least determinant.
struct CornerSum
{
  double value = 0.0;
  double leastDeterminant = 1e300;
};

CornerSum cornerSum(const Points& points, const hexsweep::Hexes& hexes, double epsilon)
{
  CornerSum sum;
  for (Index h = 0; h < hexes.rows(); ++h)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      const auto place = [&](int i) -> Eigen::RowVector3d { return points.row(hexes(h, i)); };
      const hexsweep::HexFrame frame = hexsweep::hexFrame(place, corner);
      Eigen::Matrix3d jacobian;
      jacobian << frame.u.transpose(), frame.v.transpose(), frame.w.transpose();
      sum.value += hexsweep::distortion<3>(jacobian, epsilon, VolumeWeight).value;
      sum.leastDeterminant = std::min(sum.leastDeterminant, frame.determinant());
    }
  }
  return sum;
}

/// Eight cubes of a bent block whose only free node is the one in the middle, far from there.
struct OneFreeNode
{
  test::HexBlock block = test::makeBlock(2);
  Points start;
  static constexpr Index Free = 13;

  explicit OneFreeNode(const Eigen::RowVector3d& place)
  {
    std::mt19937 generator(4);
    std::uniform_real_distribution<double> shift(-0.1, 0.1);
    this->start = this->block.points;
    for (Index i = 0; i < this->start.size(); ++i)
    {
      this->start.data()[i] += shift(generator);
    }
    this->start.row(Free) = place;
  }

  hexsweep::HexDescent::Result descend(double epsilon) const
  {
    std::vector<bool> free = this->block.fixed;
    free.flip();
    const hexsweep::HexBoxes boxes = hexsweep::HexBoxes::Ones(this->block.hexes.rows(), 3);
    const hexsweep::HexDescent descent(this->block.hexes, boxes, free);
    return descent.descend(this->start, hexsweep::HexSamples::Corners, epsilon, 100, 1e-15);
  }
};

TEST(HexDescent, EndsWhereDifferencesOfTheSumVanish)
{
  const double epsilon = 0.1;
  // In the middle of the block, near a side, and outside: inverted.
  for (const Eigen::RowVector3d& place : { Eigen::RowVector3d(1.2, 0.9, 1.1),
         Eigen::RowVector3d(1.7, 0.5, 0.6), Eigen::RowVector3d(2.6, 1.1, 0.8) })
  {
    const OneFreeNode model(place);
    const auto result = model.descend(epsilon);
    const CornerSum before = cornerSum(model.start, model.block.hexes, epsilon);
    const CornerSum after = cornerSum(result.points, model.block.hexes, epsilon);
    EXPECT_NEAR(result.before, before.value, 1e-12 * before.value);
    EXPECT_NEAR(result.after, after.value, 1e-12 * after.value);
    EXPECT_NEAR(result.leastDeterminant, after.leastDeterminant, 1e-12);
    EXPECT_GT(after.leastDeterminant, 0.0);
    for (Index i = 0; i < model.start.rows(); ++i)
    {
      EXPECT_TRUE(i == OneFreeNode::Free || result.points.row(i) == model.start.row(i)) << i;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const double h = 1e-4;
      Points moved = result.points;
      moved(OneFreeNode::Free, axis) += h;
      const double up = cornerSum(moved, model.block.hexes, epsilon).value;
      moved(OneFreeNode::Free, axis) -= 2.0 * h;
      const double down = cornerSum(moved, model.block.hexes, epsilon).value;
      const double slope = (up - down) / (2.0 * h);
      const double curvature = (up - 2.0 * after.value + down) / (h * h);
      EXPECT_GT(curvature, 0.0);
      EXPECT_LT(std::abs(slope / curvature), 1e-5); // about the distance to the minimum
    }
  }
}

TEST(HexDescent, FindsTheSamePlaceFromEverywhere)
{
  const Points first = OneFreeNode({ 1.2, 0.9, 1.1 }).descend(0.1).points;
  const Points second = OneFreeNode({ 0.4, 1.5, 1.6 }).descend(0.1).points;
  EXPECT_LT((first - second).norm(), 1e-5);
}

TEST(HexDescent, WithoutFreeNodesNothingMoves)
{
  const test::HexBlock block = test::makeBlock(1);
  const hexsweep::HexDescent descent(
    block.hexes, hexsweep::HexBoxes::Ones(1, 3), std::vector<bool>(8, false));
  EXPECT_FALSE(descent.hasFreeNodes());
}
}
