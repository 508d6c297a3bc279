// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/QuadLaplacian.h"

#include "Support/SweepMeshes.h"

#include <gtest/gtest.h>

namespace TestQuadLaplacian
{
using hexsweep::Points;
using hexsweep::QuadLaplacian;
using test::Sweep;

/// An irregular planar mesh of area 2 in a tilted plane.
Sweep tiltedCap()
{
  return test::makeSweep(8, 6, false, { 0, 1 }, [](double x, double y, double t) {
    const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    return Eigen::RowVector3d((turn * Eigen::Vector3d(x, y, t)).transpose());
  });
}

Points bulged(const Sweep& sweep)
{
  Points points = sweep.source;
  for (hexsweep::Index i = 0; i < points.rows(); ++i)
  {
    points(i, 2) += 0.4 * std::sin(3 * points(i, 0)) * points(i, 1);
  }
  return points;
}

TEST(QuadLaplacian, EnergyOfALinearFunctionIsItsGradientSquaredTimesTheArea)
{
  const Sweep sweep = tiltedCap();
  const QuadLaplacian laplacian = hexsweep::quadLaplacian(sweep.source, sweep.quads);
  const Eigen::VectorXd f = 3.0 * sweep.cap.col(0) - 4.0 * sweep.cap.col(1);
  EXPECT_NEAR(f.dot(laplacian.stiffness * f), 25.0 * 2.0, 1e-11);
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(f.size());
  EXPECT_NEAR(one.dot(laplacian.mass * one), 2.0, 1e-13);
}

TEST(QuadLaplacian, RowsSumToZeroAndMatricesAreSymmetric)
{
  const Sweep sweep = tiltedCap();
  const QuadLaplacian laplacian = hexsweep::quadLaplacian(bulged(sweep), sweep.quads);
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(sweep.source.rows());
  EXPECT_LT((laplacian.stiffness * one).cwiseAbs().maxCoeff(), 1e-12);
  const Eigen::MatrixXd K = laplacian.stiffness;
  const Eigen::MatrixXd M = laplacian.mass;
  EXPECT_LT((K - K.transpose()).norm(), 1e-13);
  EXPECT_LT((M - M.transpose()).norm(), 1e-15);
}

TEST(QuadLaplacian, OrientationDoesNotMatterAndSizeScalesAsItShould)
{
  const Sweep sweep = tiltedCap();
  const Points points = bulged(sweep);
  const QuadLaplacian one = hexsweep::quadLaplacian(points, sweep.quads);
  const hexsweep::Quads turned = sweep.quads.rowwise().reverse();
  const QuadLaplacian other = hexsweep::quadLaplacian(points * 1e-6, turned);
  EXPECT_LT((one.stiffness - other.stiffness).norm(), 1e-12);
  EXPECT_LT((one.mass * 1e-12 - other.mass).norm(), 1e-12 * 1e-12);
}

TEST(QuadLaplacian, MassOfASphericalPatchConvergesToItsArea)
{
  // A spherical rectangle: 0.5 < polar angle < 1.5, longitude from 0 to 2.
  const double exact = 2.0 * (std::cos(0.5) - std::cos(1.5));
  double before = 0.0;
  for (const int n : { 10, 20, 40 })
  {
    const Sweep sweep =
      test::makeSweep(2 * n, n, false, { 0, 1 }, [](double x, double y, double t) {
        const double polar = 0.5 + y;
        return Eigen::RowVector3d((1 + t) * std::sin(polar) * std::cos(x),
          (1 + t) * std::sin(polar) * std::sin(x), (1 + t) * std::cos(polar));
      });
    const QuadLaplacian laplacian = hexsweep::quadLaplacian(sweep.source, sweep.quads);
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(sweep.source.rows());
    const double error = std::abs(one.dot(laplacian.mass * one) - exact);
    if (before > 0.0)
    {
      EXPECT_NEAR(before / error, 4.0, 0.4);
    }
    before = error;
  }
}

TEST(QuadLaplacian, CollapsedQuadsLeaveFiniteMatrices)
{
  Sweep sweep = tiltedCap();
  for (int c = 0; c < 4; ++c)
  {
    sweep.source.row(sweep.quads(5, c)) = sweep.source.row(sweep.quads(5, 0));
  }
  const QuadLaplacian laplacian = hexsweep::quadLaplacian(sweep.source, sweep.quads);
  EXPECT_TRUE(Eigen::MatrixXd(laplacian.stiffness).allFinite());
  EXPECT_TRUE(Eigen::MatrixXd(laplacian.mass).allFinite());
}
}
