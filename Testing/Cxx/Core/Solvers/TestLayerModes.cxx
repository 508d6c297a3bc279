// SPDX-License-Identifier: BSD-3-Clause
// The eigenfunctions of a stack of layers.
#include "Core/Solvers/LayerModes.h"

#include "Core/Common/Errors.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace TestLayerModes
{
using hexsweep::Index;
using hexsweep::LayerModes;

/// Mass and stiffness of all L + 1 layers, one element after the other.
std::pair<Eigen::MatrixXd, Eigen::MatrixXd> assemble(const Eigen::VectorXd& heights)
{
  const Index size = heights.size() + 1;
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(size, size);
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size);
  for (Index k = 0; k + 1 < size; ++k)
  {
    mass.block<2, 2>(k, k) += heights[k] / 6.0 * (Eigen::Matrix2d() << 2, 1, 1, 2).finished();
    stiffness.block<2, 2>(k, k) += (Eigen::Matrix2d() << 1, -1, -1, 1).finished() / heights[k];
  }
  return { mass, stiffness };
}

Eigen::VectorXd gradedHeights(Index layers, double ratio)
{
  Eigen::VectorXd heights(layers);
  for (Index k = 0; k < layers; ++k)
  {
    heights[k] = 0.3 * std::pow(ratio, static_cast<double>(k));
  }
  return heights;
}

void expectModes(const Eigen::VectorXd& heights, double size)
{
  const Index inner = heights.size() - 1;
  const auto [allMass, allStiffness] = assemble(heights);
  const Eigen::MatrixXd mass = allMass.block(1, 1, inner, inner);
  const Eigen::MatrixXd stiffness = allStiffness.block(1, 1, inner, inner);
  const LayerModes modes = hexsweep::layerModes(size * heights);
  // In the unit of the heights without the factor.
  const Eigen::MatrixXd functions = std::sqrt(size) * modes.functions;
  const Eigen::VectorXd eigenvalues = size * size * modes.eigenvalues;
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(inner, inner);
  const double tolerance = 1e-11;
  EXPECT_LT((functions.transpose() * mass * functions - identity).cwiseAbs().maxCoeff(), tolerance);
  EXPECT_LT(
    (functions.transpose() * stiffness * functions - Eigen::MatrixXd(eigenvalues.asDiagonal()))
      .cwiseAbs()
      .maxCoeff(),
    tolerance * eigenvalues.maxCoeff());
  EXPECT_LT((functions * modes.analysis / std::sqrt(size) - identity).cwiseAbs().maxCoeff(),
    tolerance * functions.cwiseAbs().maxCoeff());
  for (Index j = 0; j + 1 < inner; ++j)
  {
    EXPECT_LT(eigenvalues[j], eigenvalues[j + 1]);
  }

  double height = 0.0;
  Eigen::VectorXd t = Eigen::VectorXd::Zero(inner + 2);
  for (Index k = 0; k <= inner; ++k)
  {
    height += heights[k];
    t[k + 1] = height / heights.sum();
  }
  EXPECT_LT((modes.fractions - t).cwiseAbs().maxCoeff(), 1e-14);
  const Eigen::VectorXd last = functions.transpose() * (allMass * t).segment(1, inner);
  EXPECT_LT((modes.lastLoad / std::sqrt(size) - last).cwiseAbs().maxCoeff(), tolerance);
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(inner + 2);
  const Eigen::VectorXd first = functions.transpose() * (allMass * (one - t)).segment(1, inner);
  EXPECT_LT((modes.firstLoad / std::sqrt(size) - first).cwiseAbs().maxCoeff(), tolerance);
}

TEST(LayerModes, SolveTheEigenproblemOfTheLayers)
{
  for (const double size : { 1e-6, 1.0, 1e6 })
  {
    for (const Index layers : { 2, 3, 10, 31 })
    {
      expectModes(gradedHeights(layers, 1.0), size);
      expectModes(gradedHeights(layers, 1.15), size);
    }
  }
}

TEST(LayerModes, EqualLayersHaveEvenAndOddFunctions)
{
  for (const Index layers : { 2, 7, 12 })
  {
    const LayerModes modes = hexsweep::layerModes(gradedHeights(layers, 1.0));
    ASSERT_TRUE(modes.isSymmetric);
    for (Index j = 0; j + 1 < layers; ++j)
    {
      const double sign = j % 2 == 0 ? 1.0 : -1.0;
      EXPECT_LT(
        (modes.functions.col(j) - sign * modes.functions.col(j).reverse()).cwiseAbs().maxCoeff(),
        1e-14);
    }
  }
  EXPECT_FALSE(hexsweep::layerModes(gradedHeights(5, 1.1)).isSymmetric);
}

TEST(LayerModes, OneLayerHasNone)
{
  EXPECT_EQ(hexsweep::layerModes(gradedHeights(1, 1.0)).eigenvalues.size(), 0);
}

TEST(LayerModes, RefusesLayersWithoutHeight)
{
  EXPECT_THROW(hexsweep::layerModes(Eigen::VectorXd()), hexsweep::InvalidInput);
  EXPECT_THROW(hexsweep::layerModes(Eigen::Vector3d(1, -1, 1)), hexsweep::InvalidInput);
  EXPECT_THROW(hexsweep::layerModes(Eigen::Vector2d(1, std::nan(""))), hexsweep::InvalidInput);
}
}
