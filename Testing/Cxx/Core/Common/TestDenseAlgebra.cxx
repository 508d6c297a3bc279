// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Common/DenseAlgebra.h"

#include "Support/DenseTruth.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

namespace TestDenseAlgebra
{
using namespace hexsweep;

Eigen::Vector3d randomDirection(std::mt19937& generator)
{
  std::normal_distribution<double> normal;
  return { normal(generator), normal(generator), normal(generator) };
}

TEST(DenseAlgebra, LeastRotationTakesOneDirectionToTheOther)
{
  std::mt19937 generator(1);
  for (int trial = 0; trial < 200; ++trial)
  {
    const Eigen::Vector3d from = randomDirection(generator);
    // Every second pair is nearly opposite, down to what the cosine cannot tell.
    const Eigen::Vector3d to = trial % 2 == 0
      ? randomDirection(generator)
      : Eigen::Vector3d(-2.0 * from + std::pow(10.0, -trial / 20.0) * randomDirection(generator));
    const Eigen::Matrix3d rotation = leastRotation(from, to);
    constexpr double tolerance = 1e-14;
    EXPECT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), tolerance);
    EXPECT_LT((rotation * from.normalized() - to.normalized()).norm(), tolerance);
    EXPECT_NEAR(rotation.determinant(), 1.0, tolerance);
    // Its angle is the one between the directions: Eigen's, by their tangent.
    const double angle = std::atan2(
      from.normalized().cross(to.normalized()).norm(), from.normalized().dot(to.normalized()));
    EXPECT_NEAR(rotation.trace(), 1.0 + 2.0 * std::cos(angle), tolerance);
  }
}

TEST(DenseAlgebra, OppositeDirectionsAreHalfATurnApart)
{
  for (const Eigen::Vector3d& from : { Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, 1e-200),
         Eigen::Vector3d(1e100, 2e100, -1e100) })
  {
    const Eigen::Matrix3d rotation = leastRotation(from, -from);
    EXPECT_LT((rotation * from.normalized() + from.normalized()).norm(), 1e-15);
    EXPECT_NEAR(rotation.trace(), -1.0, 1e-15);
    EXPECT_NEAR(rotation.determinant(), 1.0, 1e-14);
  }
}

TEST(DenseAlgebra, WhatHasNoDirectionIsNotTurned)
{
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  for (const auto& [from, to] : { std::pair(none, none), std::pair(none, Eigen::Vector3d(1, 2, 3)),
         std::pair(Eigen::Vector3d(1, 2, 3), none) })
  {
    EXPECT_EQ(leastRotation(from, to), Eigen::Matrix3d::Identity().eval());
  }
}

TEST(DenseAlgebra, RootTimesItselfIsTheMatrix)
{
  std::mt19937 generator(2);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 100; ++trial)
  {
    Eigen::Matrix2d factor;
    factor << normal(generator), normal(generator), normal(generator), 1e-3 * normal(generator);
    const Eigen::Matrix2d matrix = factor * factor.transpose();
    const Eigen::Matrix2d root = symmetricRoot(matrix);
    EXPECT_EQ(root(0, 1), root(1, 0));
    EXPECT_GT(root.trace(), 0.0);
    EXPECT_GT(root.determinant(), 0.0);
    EXPECT_LT((root * root - matrix).norm(), 1e-14 * matrix.norm());
  }
}

TEST(DenseAlgebra, LeastSquaresAreThoseOfQRAndShortWhereSeveralFit)
{
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  const auto random = [&](Eigen::Index rows, Eigen::Index columns) {
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(generator); }).eval();
  };
  const Eigen::MatrixXd right = random(9, 2);
  const Eigen::MatrixXd full = random(9, 3);
  EXPECT_LT((leastSquares(full, right) - test::leastSquaresSolution(full, right)).norm(), 1e-13);
  // The third column is the first: the share of both is the same.
  Eigen::MatrixXd twice = full;
  twice.col(2) = twice.col(0);
  const Eigen::MatrixXd found = leastSquares(twice, right);
  const Eigen::MatrixXd alone = test::leastSquaresSolution(full.leftCols(2), right);
  EXPECT_LT((found.row(0) - 0.5 * alone.row(0)).norm(), 1e-13);
  EXPECT_LT((found.row(2) - 0.5 * alone.row(0)).norm(), 1e-13);
  EXPECT_LT((found.row(1) - alone.row(1)).norm(), 1e-13);
}

TEST(DenseAlgebra, PrincipalAxesAreThoseThatMadeTheMatrix)
{
  const Eigen::Matrix3d axes =
    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const Eigen::Vector3d values(-1.0, 0.5, 3.0);
  const PrincipalAxes found = principalAxes(axes * values.asDiagonal() * axes.transpose());
  EXPECT_LT((found.values - values).norm(), 1e-14);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(std::abs(found.axes.col(i).dot(axes.col(i))), 1.0, 1e-14);
  }
}
}
