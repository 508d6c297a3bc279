// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/FoldoverFreeEnergy.h"
#include "Support/DenseTruth.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <random>

namespace TestFoldoverFreeEnergy
{
template <int Dim>
Eigen::Matrix<double, Dim, Dim> randomMatrix(std::mt19937& generator)
{
  std::normal_distribution<double> normal;
  return Eigen::Matrix<double, Dim, Dim>::NullaryExpr([&] { return normal(generator); });
}

/// The published value, from the formulae alone.
template <int Dim>
double published(const Eigen::Matrix<double, Dim, Dim>& j, double epsilon, double theta)
{
  const double det = j.determinant();
  const double chi = 0.5 * (det + std::sqrt(epsilon * epsilon + det * det));
  return (1.0 - theta) * (j.transpose() * j).trace() / (Dim * std::pow(chi, 2.0 / Dim)) +
    theta * (1.0 + det * det) / (2.0 * chi);
}

template <int Dim>
void checkDerivatives()
{
  using Matrix = Eigen::Matrix<double, Dim, Dim>;
  std::mt19937 generator(7);
  int inverted = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    const Matrix j = randomMatrix<Dim>(generator);
    const double epsilon = 0.3;
    const double theta = 0.1;
    const auto at = hexsweep::distortion<Dim>(j, epsilon, theta);
    inverted += j.determinant() < 0.0 ? 1 : 0;
    ASSERT_NEAR(at.value, published<Dim>(j, epsilon, theta), 1e-9 * at.value);
    ASSERT_NEAR(at.determinant, j.determinant(), 1e-12 * (1.0 + j.squaredNorm()));
    const Matrix direction = randomMatrix<Dim>(generator);
    const double h = 1e-6;
    const double difference = (published<Dim>(j + h * direction, epsilon, theta) -
                                published<Dim>(j - h * direction, epsilon, theta)) /
      (2.0 * h);
    ASSERT_NEAR((at.gradient.array() * direction.array()).sum(), difference,
      1e-6 * (1.0 + at.gradient.norm() * direction.norm()));
    const Eigen::VectorXd bends = test::eigenvalues(at.curvature);
    ASSERT_GE(bends.minCoeff(), -1e-10 * bends.maxCoeff());
  }
  EXPECT_GT(inverted, 50); // both signs were tried
}

TEST(FoldoverFreeEnergy, DerivativesMatchDifferencesInThePlane)
{
  checkDerivatives<2>();
}

TEST(FoldoverFreeEnergy, DerivativesMatchDifferencesInSpace)
{
  checkDerivatives<3>();
}

TEST(FoldoverFreeEnergy, RotationsCostOneAndAreMinima)
{
  const Eigen::Matrix2d plane = Eigen::Rotation2Dd(0.7).toRotationMatrix();
  const Eigen::Matrix3d space =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const auto inPlane = hexsweep::distortion<2>(plane, 1e-12, 0.2);
  const auto inSpace = hexsweep::distortion<3>(space, 1e-12, 0.2);
  EXPECT_NEAR(inPlane.value, 1.0, 1e-12);
  EXPECT_NEAR(inSpace.value, 1.0, 1e-12);
  EXPECT_LT(inPlane.gradient.norm(), 1e-12);
  EXPECT_LT(inSpace.gradient.norm(), 1e-12);
}

TEST(FoldoverFreeEnergy, RegularisationIsPositiveAndKeepsItsDigits)
{
  EXPECT_DOUBLE_EQ(hexsweep::regularized(0.0, 0.5), 0.25);
  EXPECT_NEAR(hexsweep::regularized(3.0, 1e-9), 3.0, 1e-15);
  // (d + sqrt(d^2 + e^2)) / 2 = e^2 / (4 |d|) (1 - e^2 / (4 d^2) + ...) for d < 0
  EXPECT_NEAR(hexsweep::regularized(-1e8, 1.0) * 4e8, 1.0, 1e-12);
}

TEST(FoldoverFreeEnergy, RegularisationFallsToNothingOnceAllIsUpright)
{
  EXPECT_DOUBLE_EQ(hexsweep::nextEpsilon(1e-3, 0.5, 2.0, 1.99, 0.3), 1e-10);
  const double next = hexsweep::nextEpsilon(1.0, -0.2, 2.0, 1.99, 0.3);
  EXPECT_GT(next, 0.0);
  EXPECT_LT(next, 1.0);
  // equation (6): chi of the worst element falls by just the rate
  EXPECT_NEAR(hexsweep::regularized(-0.2, next), 0.7 * hexsweep::regularized(-0.2, 1.0), 1e-12);
}
}
