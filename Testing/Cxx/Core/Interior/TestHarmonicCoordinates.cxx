// SPDX-License-Identifier: BSD-3-Clause
// Numbers in parentheses are the properties listed in section 4.3 of Cai and Tautges (2013).
#include "Core/Interior/HarmonicCoordinates.h"

#include "Core/Common/Errors.h"
#include "Support/CageTests.h"

namespace TestHarmonicCoordinates
{
using hexsweep::Index;
using hexsweep::Points;
using test::CageModels;
using test::Sweep;

Points harmonic(const Sweep& sweep)
{
  return test::run(hexsweep::harmonicInterior, sweep);
}

/// Coordinates of all cage vertices at all points.
Eigen::MatrixXd allCoordinates(const Sweep& sweep, const CageModels& models)
{
  return hexsweep::harmonicCoordinates(
    sweep.target, sweep.quads, models.boundary, models.cage.nodes);
}

Sweep bentSweep()
{
  return test::makeSweep(6, 6, true, test::evenLayers(4), test::bendingMotion);
}

/// Rows of the 26 grid neighbours of an inner point, by distance.
std::vector<Index> neighbours(const Points& grid, Index row, double step)
{
  std::vector<Index> rows;
  for (Index other = 0; other < grid.rows(); ++other)
  {
    const double distance = (grid.row(other) - grid.row(row)).cwiseAbs().maxCoeff();
    if (other != row && distance < 1.5 * step)
    {
      rows.push_back(other);
    }
  }
  return rows;
}

TEST(HarmonicCoordinates, InterpolateAtCageVertices)
{
  // (1), bit for bit.
  const Sweep sweep = bentSweep();
  const CageModels models = test::modelsOf(sweep);
  const Eigen::MatrixXd coordinates = allCoordinates(sweep, models);
  for (std::size_t j = 0; j < models.cage.nodes.size(); ++j)
  {
    Eigen::RowVectorXd unit = Eigen::RowVectorXd::Zero(coordinates.cols());
    unit(static_cast<Index>(j)) = 1.0;
    ASSERT_EQ(coordinates.row(models.cage.nodes[j]), unit);
  }
}

TEST(HarmonicCoordinates, AreWeightsWithoutInteriorExtrema)
{
  // (3), (4) on cubes, where no weight of the discrete mean over the neighbours is negative.
  const Sweep sweep = test::makeSweep(12, 6, true, test::evenLayers(4), test::cubesMotion(12, 4));
  const CageModels models = test::modelsOf(sweep);
  const Eigen::MatrixXd coordinates = allCoordinates(sweep, models);
  EXPECT_GE(coordinates.minCoeff(), -1e-15);
  EXPECT_LE(coordinates.maxCoeff(), 1.0);
  const std::vector<Index> inside = test::insideRows(sweep);
  ASSERT_GT(inside.size(), 50u);
  for (const Index row : inside)
  {
    const std::vector<Index> around = neighbours(sweep.layers, row, 1.0 / 6);
    ASSERT_EQ(around.size(), 26u);
    for (Index j = 0; j < coordinates.cols(); ++j)
    {
      double least = 1.0;
      double greatest = 0.0;
      for (const Index other : around)
      {
        least = std::min(least, coordinates(other, j));
        greatest = std::max(greatest, coordinates(other, j));
      }
      // Down to values of rounding size.
      ASSERT_GT(coordinates(row, j), least - 1e-15);
      ASSERT_LT(coordinates(row, j), greatest + 1e-15);
    }
  }
}

TEST(HarmonicCoordinates, OvershootLittleOnStretchedCells)
{
  // (3) elsewhere: hexahedra up to 3.4 times as wide as high, or 3 times as high as wide. The mean
  // over the neighbours has negative weights there.
  for (const double height : { 0.2, 1.0, 2.0 })
  {
    const Sweep sweep = test::makeSweep(12, 6, true, test::evenLayers(4),
      [=](double x, double y, double t) { return Eigen::RowVector3d(x, y, height * t); });
    const Eigen::MatrixXd coordinates = allCoordinates(sweep, test::modelsOf(sweep));
    RecordProperty(
      "LeastCoordinateAtHeight" + std::to_string(height), std::to_string(coordinates.minCoeff()));
    EXPECT_GT(coordinates.minCoeff(), -0.25) << height;
    EXPECT_LT(coordinates.maxCoeff(), 1.0 + 1e-15) << height;
  }
}

/// Each of some hundred coordinates is solved for to PrismSolver's accuracy, and they add up.
constexpr double Accuracy = 1e-10;

TEST(HarmonicCoordinates, SumToOneAndReproduceLinearFunctions)
{
  // (6) and (5): on the topological model of planar caps.
  const Sweep sweep = bentSweep();
  const Sweep planar = test::makeSweep(6, 6, true, test::evenLayers(4), test::affineMotion);
  for (const Sweep& either : { planar, test::placed(planar, 1e-6, Eigen::RowVector3d::Zero()) })
  {
    const CageModels models = test::modelsOf(either);
    const Eigen::MatrixXd coordinates = allCoordinates(either, models);
    const Eigen::VectorXd sums = coordinates.rowwise().sum();
    EXPECT_LT((sums.array() - 1.0).abs().maxCoeff(), Accuracy);
    const Points reproduced = coordinates * hexsweep::cageVertices(models.cage, models.model);
    EXPECT_LT(test::greatestDistance(reproduced, models.model), Accuracy * test::sizeOf(either));
  }
  // (6) for any caps.
  const Eigen::VectorXd sums = allCoordinates(sweep, test::modelsOf(sweep)).rowwise().sum();
  EXPECT_LT((sums.array() - 1.0).abs().maxCoeff(), Accuracy);
}

TEST(HarmonicCoordinates, GeneraliseBarycentricCoordinates)
{
  // (7): the four barycentric coordinates of a tetrahedron round the model, given at the cage
  // vertices, come back inside.
  const Sweep sweep = test::makeSweep(6, 6, true, test::evenLayers(4), test::affineMotion);
  const CageModels models = test::modelsOf(sweep);
  const Eigen::MatrixXd coordinates = allCoordinates(sweep, models);
  const Eigen::RowVector3d middle = models.model.colwise().mean();
  Eigen::Matrix4d corners;
  const double size = 10 * test::sizeOf(sweep);
  corners << 1, 1, 1, 1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1, 1;
  corners.rightCols<3>() *= size;
  corners.rightCols<3>().rowwise() += middle;
  Eigen::MatrixXd homogeneous(models.model.rows(), 4);
  homogeneous << Eigen::VectorXd::Ones(models.model.rows()), models.model;
  const Eigen::MatrixXd barycentric = homogeneous * corners.inverse();
  ASSERT_GT(barycentric.minCoeff(), 0.0);
  Eigen::MatrixXd onCage(coordinates.cols(), 4);
  for (Index j = 0; j < onCage.rows(); ++j)
  {
    onCage.row(j) = barycentric.row(models.cage.nodes[static_cast<std::size_t>(j)]);
  }
  EXPECT_LT((coordinates * onCage - barycentric).cwiseAbs().maxCoeff(), Accuracy);
}

TEST(HarmonicCoordinates, SumOverTheCageIsTheThreeSolveResult)
{
  const Sweep sweep = bentSweep();
  const CageModels models = test::modelsOf(sweep);
  const Points sum =
    allCoordinates(sweep, models) * hexsweep::cageVertices(models.cage, models.physical);
  EXPECT_LT(test::greatestDistance(harmonic(sweep), sum), 1e-10 * test::sizeOf(sweep));
}

TEST(HarmonicCoordinates, NodesInsideHaveNone)
{
  const Sweep sweep = bentSweep();
  const CageModels models = test::modelsOf(sweep);
  for (const Index node : { test::insideRows(sweep).front(), Index{ -1 }, sweep.layers.rows() })
  {
    EXPECT_THROW(
      hexsweep::harmonicCoordinates(sweep.target, sweep.quads, models.boundary, { node }),
      hexsweep::InvalidInput);
  }
}

TEST(HarmonicInterior, StraightAffineSweepsAreExact)
{
  test::expectStraightAffineSweepsExact(harmonic, 1e-12);
}

TEST(HarmonicInterior, BoundaryIsKeptBitForBit)
{
  test::expectBoundaryBitForBit(hexsweep::harmonicInterior);
  test::expectInteriorContract(hexsweep::harmonicInterior, 1e-13);
}

TEST(HarmonicInterior, UnusedPointsGoStraight)
{
  Sweep sweep = test::makeSweep(6, 5, false, test::evenLayers(4), test::straightAffineMotion);
  const Index n = sweep.source.rows();
  sweep.source.conservativeResize(n + 1, 3);
  sweep.target.conservativeResize(n + 1, 3);
  sweep.source.row(n) << 10, 20, 30;
  sweep.target.row(n) << 14, 20, 34;
  const Points swept = harmonic(sweep);
  for (Index k = 0; k <= 4; ++k)
  {
    const double t = static_cast<double>(k) / 4;
    EXPECT_LT(
      (swept.row(k * (n + 1) + n) - Eigen::RowVector3d(10 + 4 * t, 20, 30 + 4 * t)).norm(), 1e-12);
    EXPECT_LT(
      test::greatestDistance(swept.middleRows(k * (n + 1), n), sweep.layers.middleRows(k * n, n)),
      1e-11);
  }
}

TEST(HarmonicInterior, FarFromTheOrigin)
{
  const Sweep plain = test::makeSweep(12, 9, true, test::evenLayers(5), test::straightAffineMotion);
  const Sweep far = test::placed(plain, 1.0, 1e6 * Eigen::RowVector3d(2, -3, 1));
  // Coordinates keep ten digits of the size there.
  EXPECT_LT(test::greatestDistance(harmonic(far), far.layers), 1e-8 * test::sizeOf(far));
}

TEST(HarmonicInterior, Aborts)
{
  const Sweep sweep = bentSweep();
  EXPECT_THROW(hexsweep::harmonicInterior(test::cageOf(sweep), [](double) { return false; }),
    hexsweep::Aborted);
}
}
