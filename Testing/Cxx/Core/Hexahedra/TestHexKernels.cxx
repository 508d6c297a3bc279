// SPDX-License-Identifier: BSD-3-Clause
// Sums and slopes of single nodes against Verdict's definition and against differences, and the
// same bits on every instruction set.
#include "Core/Hexahedra/HexKernels.h"

#include "Core/Hexahedra/HexCorner.h"
#include "Support/DenseTruth.h"
#include "Support/HexBlocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace TestHexKernels
{
using hexsweep::HexCorners;
using hexsweep::HexKernels;
using hexsweep::HexLoss;
using hexsweep::HexNodeSum;
using test::Index;

constexpr HexLoss Losses[] = { {}, { 7.0, 0.2 }, { 40.0, 0.9 } };

/// The loss over the corners that have `moving` as their node or at the end of an edge.
double plainSum(const HexCorners& corners, int moving, const HexLoss& loss)
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

HexCorners shakenCube(unsigned seed)
{
  const test::HexBlock block = test::makeBlock(1);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> shift(-0.6, 0.6);
  HexCorners corners;
  for (int i = 0; i < 8; ++i)
  {
    corners.row(i) = block.points.row(block.hexes(0, i)) +
      Eigen::RowVector3d(shift(generator), shift(generator), shift(generator));
  }
  return corners;
}

std::vector<const HexKernels*> allKernels()
{
  const HexKernels* kernels[2];
  const int count = hexsweep::availableHexKernels(kernels);
  EXPECT_EQ(&hexsweep::hexKernels(), kernels[count - 1]);
  return { kernels, kernels + count };
}

/// Hexahedra round a node, as the kernels take them: the rest of the last batch has no edges.
class Around
{
public:
  Around(const std::vector<HexCorners>& hexes, const std::vector<int>& moving)
    : Hexes(hexes)
    , Batches(static_cast<int>(hexes.size() + hexsweep::HexLanesSize - 1) / hexsweep::HexLanesSize)
  {
    for (std::size_t h = 0; h < hexes.size(); ++h)
    {
      for (const int i : hexsweep::HexCornersFrom[moving[h]])
      {
        this->Corners.push_back(this->Hexes[h].data() + 3 * i);
      }
    }
    this->Corners.resize(
      static_cast<std::size_t>(8 * hexsweep::HexLanesSize * this->Batches), this->Hexes[0].data());
  }
  HexNodeSum sum(const HexKernels& kernels, const HexLoss& loss) const
  {
    return kernels.sum(this->Corners.data(), this->Batches, loss);
  }
  double value(const HexKernels& kernels, const HexLoss& loss) const
  {
    return kernels.value(this->Corners.data(), this->Batches, loss);
  }
  const double* const* corners() const { return this->Corners.data(); }

private:
  std::vector<HexCorners> Hexes;
  int Batches;
  std::vector<const double*> Corners;
};

template <typename Type>
void expectSameBits(const Type& a, const Type& b)
{
  EXPECT_EQ(std::memcmp(&a, &b, sizeof(Type)), 0);
}

TEST(HexKernels, OrdersBeginWithAnyCornerAndStayRightHanded)
{
  const test::HexBlock block = test::makeBlock(1);
  for (int moving = 0; moving < 8; ++moving)
  {
    const auto& order = hexsweep::HexCornersFrom[moving];
    EXPECT_EQ(order[0], moving);
    EXPECT_TRUE(std::is_permutation(order, order + 8, hexsweep::HexCornersFrom[0]));
    HexCorners turned;
    for (int i = 0; i < 8; ++i)
    {
      turned.row(i) = block.points.row(block.hexes(0, order[i]));
    }
    EXPECT_EQ(hexsweep::hexQuality(turned).scaledJacobian, 1.0);
    EXPECT_FALSE(hexsweep::hexQuality(turned).insideOut);
  }
}

TEST(HexKernels, SumsMatchTheDefinitionAndGradientsDifferences)
{
  constexpr double H = 1e-6;
  for (const HexKernels* kernels : allKernels())
  {
    SCOPED_TRACE(kernels->name);
    for (unsigned seed = 1; seed <= 30; ++seed)
    {
      const std::vector<HexCorners> corners{ shakenCube(seed) };
      const int moving = static_cast<int>(seed % 8);
      for (const HexLoss& loss : Losses)
      {
        const HexNodeSum sum = Around(corners, { moving }).sum(*kernels, loss);
        const double value = plainSum(corners[0], moving, loss);
        EXPECT_NEAR(sum.value, value, 1e-11 * value);
        EXPECT_EQ(Around(corners, { moving }).value(*kernels, loss), sum.value);
        for (int axis = 0; axis < 3; ++axis)
        {
          HexCorners before = corners[0];
          HexCorners after = corners[0];
          before(moving, axis) -= H;
          after(moving, axis) += H;
          const double slope =
            (plainSum(after, moving, loss) - plainSum(before, moving, loss)) / (2.0 * H);
          EXPECT_NEAR(sum.gradient[axis], slope, 1e-5 * (1.0 + std::abs(slope) + value));
        }
        const double* c = sum.curvature;
        Eigen::Matrix3d curvature;
        curvature << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
        const Eigen::VectorXd bends = test::eigenvalues(curvature);
        EXPECT_GT(bends.minCoeff(), -1e-10 * bends.maxCoeff());
      }
    }
  }
}

TEST(HexKernels, AnyNumberOfHexesIsTheSumOfEach)
{
  std::vector<HexCorners> hexes;
  std::vector<int> moving;
  for (unsigned n = 1; n <= 21; ++n)
  {
    hexes.push_back(shakenCube(n));
    moving.push_back(static_cast<int>(n % 8));
    for (const HexKernels* kernels : allKernels())
    {
      for (const HexLoss& loss : Losses)
      {
        double value = 0.0;
        for (std::size_t h = 0; h < hexes.size(); ++h)
        {
          value += plainSum(hexes[h], moving[h], loss);
        }
        EXPECT_NEAR(Around(hexes, moving).value(*kernels, loss), value, 1e-11 * value);
      }
    }
  }
}

TEST(HexKernels, CornersWithoutAnEdgeDoNotCount)
{
  HexCorners hex = shakenCube(3);
  hex.row(1) = hex.row(2);
  for (const HexKernels* kernels : allKernels())
  {
    for (const HexLoss& loss : Losses)
    {
      // Of the corners at 0 only 0, 3 and 4 have all their edges.
      const double corner1 = loss.at(0.0).value;
      EXPECT_NEAR(Around({ hex }, { 0 }).value(*kernels, loss), plainSum(hex, 0, loss) - corner1,
        1e-11 * plainSum(hex, 0, loss));
      const HexNodeSum sum = Around({ hex }, { 0 }).sum(*kernels, loss);
      EXPECT_TRUE(std::isfinite(sum.gradient[0] + sum.curvature[0] + sum.curvature[5]));
    }
  }
}

TEST(HexKernels, AllInstructionSetsGiveTheSameBits)
{
  const std::vector<const HexKernels*> kernels = allKernels();
  if (kernels.size() < 2)
  {
    GTEST_SKIP() << "this processor has one set of instructions only";
  }
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    std::vector<HexCorners> hexes;
    std::vector<int> moving;
    for (unsigned h = 0; h < 4 + seed % 7; ++h)
    {
      hexes.push_back(shakenCube(100 * seed + h));
      moving.push_back(static_cast<int>((seed + h) % 8));
    }
    const Around around(hexes, moving);
    for (const HexKernels* other : kernels)
    {
      for (const HexLoss& loss : Losses)
      {
        expectSameBits(around.sum(*other, loss), around.sum(*kernels[0], loss));
        expectSameBits(around.value(*other, loss), around.value(*kernels[0], loss));
      }
      expectSameBits(other->measure(around.corners()), kernels[0]->measure(around.corners()));
    }
  }
}
}
