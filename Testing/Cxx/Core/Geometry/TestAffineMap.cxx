// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/AffineMap.h"

#include "Core/Common/Errors.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace TestAffineMap
{
using Eigen::Matrix3d;
using Eigen::RowVector3d;
using hexsweep::AffineMap;
using hexsweep::Index;
using hexsweep::Points;

/// A closed curve: an ellipse whose height waves with the given amplitude.
Points makeLoop(double wave, Index n = 40)
{
  Points loop(n, 3);
  for (Index i = 0; i < n; ++i)
  {
    const double a = 2 * std::acos(-1.0) * static_cast<double>(i) / static_cast<double>(n);
    loop.row(i) << 1.5 * std::cos(a) + 0.2 * std::cos(2 * a), std::sin(a), wave * std::sin(3 * a);
  }
  return loop;
}

Points transformed(const Points& points, const Matrix3d& linear, const RowVector3d& shift)
{
  return (points * linear.transpose()).rowwise() + shift;
}

AffineMap fit(const Points& source, const Points& target)
{
  return hexsweep::fitAffineMap(
    source, target, hexsweep::areaVector(source), hexsweep::areaVector(target));
}

Matrix3d rotation(double angle, const Eigen::Vector3d& axis)
{
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

Matrix3d someMatrix()
{
  Matrix3d matrix;
  matrix << 1.2, 0.3, -0.4, 0.1, 0.8, 0.5, -0.6, 0.2, 1.7;
  return matrix;
}

TEST(AreaVector, EqualsClosedForms)
{
  Points square(4, 3);
  square << 0, 0, 5, 2, 0, 5, 2, 3, 5, 0, 3, 5;
  EXPECT_NEAR((hexsweep::areaVector(square) - RowVector3d(0, 0, 6)).norm(), 0.0, 1e-14);
  // Lifting nodes off the plane adds area to the sides only: the projection's area stays.
  square(2, 2) = 7;
  EXPECT_NEAR(hexsweep::areaVector(square)[2], 6.0, 1e-14);
}

TEST(AffineMap, SpatialLoopsReproduceAnyAffineMap)
{
  const RowVector3d shift(3, -1, 2);
  const Points source = makeLoop(0.3);
  const AffineMap map = fit(source, transformed(source, someMatrix(), shift));
  EXPECT_LT((map.linear - someMatrix()).norm(), 1e-12);
  Points elsewhere(1, 3);
  elsewhere << 4, 5, -6;
  EXPECT_LT((map.apply(elsewhere) - transformed(elsewhere, someMatrix(), shift)).norm(), 1e-11);
}

TEST(AffineMap, HardlySpatialLoopsReproduceAnyAffineMap)
{
  const Points source = makeLoop(0.12);
  const AffineMap map = fit(source, transformed(source, someMatrix(), RowVector3d(3, -1, 2)));
  EXPECT_LT((map.linear - someMatrix()).norm(), 1e-10);
}

TEST(AffineMap, PlanarLoopsReproduceSimilarityInSpace)
{
  for (const double scale : { 1e-6, 0.4, 1.0, 1e6 })
  {
    const Matrix3d linear = scale * rotation(2.1, Eigen::Vector3d(1, 2, -0.5));
    const Points source = makeLoop(0.0) * rotation(0.7, Eigen::Vector3d(1, 1, 0)).transpose();
    const AffineMap map = fit(source, transformed(source, linear, scale * RowVector3d(3, -1, 2)));
    EXPECT_LT((map.linear - linear).norm(), 1e-12 * scale) << scale;
  }
}

TEST(AffineMap, PlanarLoopsReproduceAffineMapsOfTheirPlane)
{
  const Points source = makeLoop(0.0);
  const Points target = transformed(source, someMatrix(), RowVector3d(3, -1, 2));
  const AffineMap map = fit(source, target);
  EXPECT_LT((map.apply(source) - target).norm(), 1e-12);
  EXPECT_LT((map.linear.leftCols<2>() - someMatrix().leftCols<2>()).norm(), 1e-12);
  // Normal to normal, scaled by the root of the area ratio.
  const Eigen::Vector3d a = someMatrix().col(0);
  const Eigen::Vector3d b = someMatrix().col(1);
  const Eigen::Vector3d normal = a.cross(b);
  EXPECT_LT((map.linear.col(2) - normal / std::sqrt(normal.norm())).norm(), 1e-12);
}

TEST(AffineMap, AnySizeAnywhere)
{
  const Matrix3d linear = 1.3 * rotation(0.8, Eigen::Vector3d(1, 2, 3));
  for (const double wave : { 0.0, 0.3 })
  {
    for (const double scale : { 1e-6, 1e6 })
    {
      const RowVector3d far = 1e6 * scale * RowVector3d(1, -2, 3);
      const Points source = (scale * makeLoop(wave)).rowwise() + far;
      const Points target = transformed(scale * makeLoop(wave), linear, -2 * far);
      // Coordinates keep ten digits of the size there.
      EXPECT_LT((fit(source, target).linear - linear).norm(), 1e-7) << wave << ' ' << scale;
    }
  }
}

TEST(AffineMap, NoiseOfNearlyPlanarLoopsIsNotBlownUp)
{
  std::mt19937 generator(5);
  std::normal_distribution<double> gauss;
  for (const double sourceNoise : { 1e-12, 1e-7, 1e-3 })
  {
    for (const double targetNoise : { 1e-7, 1e-3, 0.05 })
    {
      Points source = makeLoop(0.0);
      Points target = makeLoop(0.0);
      for (Index i = 0; i < source.rows(); ++i)
      {
        source(i, 2) += sourceNoise * gauss(generator);
        target(i, 2) += targetNoise * gauss(generator);
      }
      const AffineMap map = fit(source, target);
      EXPECT_LT((map.linear - Matrix3d::Identity()).norm(), 0.2)
        << sourceNoise << ' ' << targetNoise;
    }
  }
}

TEST(AffineMap, LoopWithoutVectorArea)
{
  // A figure that bounds equal areas of opposite sign has no normal of its own.
  Points source(60, 3);
  for (Index i = 0; i < source.rows(); ++i)
  {
    const double a = 2 * std::acos(-1.0) * static_cast<double>(i) / 60.0;
    source.row(i) << std::sin(a), std::sin(2 * a), 0.4 * std::cos(3 * a);
  }
  ASSERT_LT(hexsweep::areaVector(source).norm(), 1e-12);
  const AffineMap map = fit(source, transformed(source, someMatrix(), RowVector3d(1, 2, 3)));
  EXPECT_LT((map.linear - someMatrix()).norm(), 1e-12);
}

TEST(AffineMap, LeastSquaresIsOptimal)
{
  // A spatial loop and an exact map leave no room; a bent target does. No small change of the
  // in-plane columns may lower the residual.
  const Points source = makeLoop(0.0);
  Points target = source;
  target.col(0) += 0.2 * source.col(0).cwiseProduct(source.col(1));
  target.col(2) += 0.3 * source.col(0).cwiseAbs2();
  const AffineMap map = fit(source, target);
  const double least = (map.apply(source) - target).squaredNorm();
  for (int r = 0; r < 3; ++r)
  {
    for (int c = 0; c < 3; ++c)
    {
      for (const double step : { -1e-3, 1e-3 })
      {
        AffineMap other = map;
        other.linear(r, c) += step;
        EXPECT_GE((other.apply(source) - target).squaredNorm(), least);
      }
    }
  }
}

TEST(AffineMap, UnusableNodesAreRefused)
{
  EXPECT_THROW(fit(Points::Zero(5, 3), makeLoop(0, 5)), hexsweep::InvalidInput);
  EXPECT_THROW(fit(makeLoop(0, 5), makeLoop(0, 6)), hexsweep::InvalidInput);
}
}
