// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/CornerTerms.h"
#include "Support/DenseTruth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace TestCornerTerms
{
using hexsweep::CornerTerm;

Eigen::Matrix2d randomMatrix(std::mt19937& generator)
{
  std::normal_distribution<double> normal;
  return Eigen::Matrix2d::NullaryExpr([&] { return normal(generator); });
}

/// Gradients against differences of the values, and curvatures without negative eigenvalues.
void expectDerivatives(const std::function<CornerTerm(const Eigen::Matrix2d&)>& term)
{
  std::mt19937 generator(17);
  int inverted = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    const Eigen::Matrix2d edges = randomMatrix(generator);
    const Eigen::Matrix2d direction = randomMatrix(generator);
    inverted += edges.determinant() < 0.0 ? 1 : 0;
    const CornerTerm at = term(edges);
    const double h = 1e-6 * edges.colwise().norm().minCoeff();
    const double difference =
      (term(edges + h * direction).value - term(edges - h * direction).value) / (2.0 * h);
    EXPECT_NEAR(at.gradient.cwiseProduct(direction).sum(), difference,
      1e-6 * (1.0 + at.gradient.norm() * direction.norm()));
    const Eigen::VectorXd bends = test::eigenvalues(at.curvature);
    EXPECT_GE(bends.minCoeff(), -1e-10 * (1.0 + bends.maxCoeff()));
  }
  EXPECT_GT(inverted, 50);
}

hexsweep::CurvePoint falling(double x)
{
  return { std::exp(-2.0 * x), -2.0 * std::exp(-2.0 * x), 4.0 * std::exp(-2.0 * x) };
}

TEST(CornerTerms, DistortionMatchesDifferences)
{
  Eigen::Matrix2d inverseReference;
  inverseReference << 0.8, 0.3, -0.1, 1.4;
  expectDerivatives([&](const Eigen::Matrix2d& edges) {
    return hexsweep::distortionTerm(edges, inverseReference, 0.3);
  });
}

// The curvature in the edges is that in the Jacobian, whose columns are combinations of them.
TEST(CornerTerms, DistortionOfAWantedCornerIsThatOfTheJacobian)
{
  std::mt19937 generator(29);
  for (int trial = 0; trial < 50; ++trial)
  {
    const Eigen::Matrix2d edges = randomMatrix(generator);
    const Eigen::Matrix2d inverse = randomMatrix(generator);
    const CornerTerm term = hexsweep::distortionTerm(edges, inverse, 0.3);
    EXPECT_NEAR(hexsweep::distortionValueOf(edges, inverse, 0.3), term.value, 1e-12 * term.value);
    const CornerTerm plain =
      hexsweep::distortionTerm(edges * inverse, Eigen::Matrix2d::Identity(), 0.3);
    const Eigen::Matrix2d a = randomMatrix(generator);
    const Eigen::Matrix2d b = randomMatrix(generator);
    const auto bilinear = [](const Eigen::Matrix4d& curvature, const Eigen::Matrix2d& u,
                            const Eigen::Matrix2d& v) {
      return Eigen::Map<const Eigen::Vector4d>(u.data()).dot(
        curvature * Eigen::Map<const Eigen::Vector4d>(v.data()));
    };
    const Eigen::Matrix2d ja = a * inverse;
    const Eigen::Matrix2d jb = b * inverse;
    EXPECT_NEAR(bilinear(term.curvature, a, b), bilinear(plain.curvature, ja, jb),
      1e-12 * term.curvature.norm() * a.norm() * b.norm());
  }
}

TEST(CornerTerms, JacobianMatchesDifferences)
{
  expectDerivatives(
    [](const Eigen::Matrix2d& edges) { return hexsweep::jacobianTerm(edges, falling); });
}

TEST(CornerTerms, SumMatchesDifferences)
{
  expectDerivatives([](const Eigen::Matrix2d& edges) {
    const CornerTerm distortion = hexsweep::distortionTerm(edges, Eigen::Matrix2d::Identity(), 0.3);
    return hexsweep::sumOfTerms(distortion, hexsweep::jacobianTerm(edges, falling), 0.7);
  });
}

TEST(CornerTerms, JacobianIsTheSineOfTheAngle)
{
  for (const double angle : { -1.0, 0.2, 1.5, 3.0 })
  {
    Eigen::Matrix2d edges;
    edges << 3.0, 0.5 * std::cos(angle), 0.0, 0.5 * std::sin(angle);
    const auto identity = [](double x) { return hexsweep::CurvePoint{ x, 1.0, 0.0 }; };
    EXPECT_NEAR(hexsweep::jacobianTerm(edges, identity).value, std::sin(angle), 1e-15);
  }
}

TEST(CornerTerms, HexJacobianMatchesDifferences)
{
  std::mt19937 generator(23);
  std::normal_distribution<double> normal;
  int inverted = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    const auto random = [&] {
      return hexsweep::CornerEdges(
        hexsweep::CornerEdges::NullaryExpr([&] { return normal(generator); }));
    };
    const hexsweep::CornerEdges edges = random();
    const hexsweep::CornerEdges direction = random();
    const auto term = [](const hexsweep::CornerEdges& e) {
      return hexsweep::hexJacobianTerm(e, falling);
    };
    const hexsweep::ColumnCornerTerm at = term(edges);
    const double h = 1e-6 * edges.colwise().norm().minCoeff();
    const double difference =
      (term(edges + h * direction).value - term(edges - h * direction).value) / (2.0 * h);
    EXPECT_NEAR(at.gradient.cwiseProduct(direction).sum(), difference,
      1e-6 * (1.0 + at.gradient.norm() * direction.norm()));
    const Eigen::VectorXd bends = test::eigenvalues(at.curvature);
    EXPECT_GE(bends.minCoeff(), -1e-10 * (1.0 + bends.maxCoeff()));

    const Eigen::Vector3d a = edges.col(0);
    const Eigen::Vector3d b = edges.col(1);
    Eigen::Matrix3d arms;
    arms << a.normalized(), b.normalized(), Eigen::Vector3d::UnitZ();
    inverted += arms.determinant() < 0.0;
    EXPECT_NEAR(at.value, falling(arms.determinant()).value, 1e-12);
  }
  EXPECT_GT(inverted, 50);
}
}
