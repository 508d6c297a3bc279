// SPDX-License-Identifier: BSD-3-Clause
// Separation of variables against an assembled trilinear finite element solve in three dimensions.
#include "Core/PrismSolver.h"

#include "Core/Errors.h"
#include "Core/SurfaceTopology.h"
#include "SweepMeshes.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <random>

namespace
{
using hexsweep::Index;
using hexsweep::Points;
using hexsweep::PrismSolver;
using hexsweep::Quads;
using test::Sweep;

/// The flat cap at z = 0.
Sweep flatCap(int nx, int ny, bool hole)
{
  return test::makeSweep(nx, ny, hole, { 0, 1 },
    [](double x, double y, double t) { return Eigen::RowVector3d(x, y, t); });
}

std::vector<Index> boundaryOf(const Sweep& sweep)
{
  std::vector<Index> ids;
  for (const auto& loop : hexsweep::checkSurface(sweep.quads, sweep.source.rows(), "cap").loops)
  {
    ids.insert(ids.end(), loop.begin(), loop.end());
  }
  return ids;
}

Points randomValues(Index rows)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Points values(rows, 3);
  for (Index i = 0; i < values.size(); ++i)
  {
    values.data()[i] = uniform(generator);
  }
  return values;
}

/// Stiffness of one trilinear hexahedron, VTK order, 2 x 2 x 2 Gauss points.
Eigen::Matrix<double, 8, 8> hexStiffness(const Eigen::Matrix<double, 8, 3>& corners)
{
  const double sign[8][3] = { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 },
    { -1, -1, 1 }, { 1, -1, 1 }, { 1, 1, 1 }, { -1, 1, 1 } };
  Eigen::Matrix<double, 8, 8> stiffness = Eigen::Matrix<double, 8, 8>::Zero();
  for (int g = 0; g < 8; ++g)
  {
    const Eigen::Vector3d at = Eigen::Vector3d(sign[g][0], sign[g][1], sign[g][2]) / std::sqrt(3.0);
    Eigen::Matrix<double, 8, 3> slope;
    for (int a = 0; a < 8; ++a)
    {
      for (int c = 0; c < 3; ++c)
      {
        const int d = (c + 1) % 3;
        const int e = (c + 2) % 3;
        slope(a, c) = 0.125 * sign[a][c] * (1 + sign[a][d] * at[d]) * (1 + sign[a][e] * at[e]);
      }
    }
    const Eigen::Matrix3d jacobian = corners.transpose() * slope;
    const Eigen::Matrix<double, 8, 3> gradient = slope * jacobian.inverse();
    stiffness += jacobian.determinant() * gradient * gradient.transpose();
  }
  return stiffness;
}

/// Dirichlet problem on the prism, assembled as a dense matrix.
Points solveInThreeDimensions(const Points& cap, const Quads& quads, Index layers, double height,
  const std::vector<Index>& fixed, const Points& values)
{
  const Index n = cap.rows();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero((layers + 1) * n, (layers + 1) * n);
  for (Index k = 0; k < layers; ++k)
  {
    for (Index q = 0; q < quads.rows(); ++q)
    {
      Eigen::Matrix<double, 8, 3> corners;
      Index ids[8];
      for (int a = 0; a < 8; ++a)
      {
        const Index layer = k + a / 4;
        ids[a] = layer * n + quads(q, a % 4);
        corners.row(a) = cap.row(quads(q, a % 4));
        corners(a, 2) += height * static_cast<double>(layer);
      }
      const auto element = hexStiffness(corners);
      for (int a = 0; a < 8; ++a)
      {
        for (int b = 0; b < 8; ++b)
        {
          stiffness(ids[a], ids[b]) += element(a, b);
        }
      }
    }
  }
  std::vector<char> given(static_cast<std::size_t>((layers + 1) * n), 0);
  for (Index i = 0; i < n; ++i)
  {
    given[static_cast<std::size_t>(i)] = given[static_cast<std::size_t>(layers * n + i)] = 1;
  }
  for (Index k = 0; k <= layers; ++k)
  {
    for (const Index id : fixed)
    {
      given[static_cast<std::size_t>(k * n + id)] = 1;
    }
  }
  Eigen::MatrixXd load = Eigen::MatrixXd::Zero(stiffness.rows(), 3);
  for (Index i = 0; i < stiffness.rows(); ++i)
  {
    if (given[static_cast<std::size_t>(i)])
    {
      stiffness.row(i).setZero();
      stiffness(i, i) = 1.0;
      load.row(i) = values.row(i);
    }
  }
  return stiffness.partialPivLu().solve(load);
}

/// Zero on the inner nodes of layers 0 and L.
void clearCaps(Points& values, const std::vector<Index>& fixed, Index n)
{
  Points kept = Points::Zero(values.rows(), 3);
  for (Index k = 0; k < values.rows() / n; ++k)
  {
    for (const Index id : fixed)
    {
      kept.row(k * n + id) = values.row(k * n + id);
    }
  }
  values = kept;
}
}

TEST(PrismSolver, EqualsTheAssembledTrilinearSolve)
{
  for (const bool hole : { false, true })
  {
    const Sweep sweep = flatCap(9, 6, hole);
    const Index n = sweep.source.rows();
    const auto fixed = boundaryOf(sweep);
    for (const Index layers : { 2, 5, 8 })
    {
      const double height = 0.17;
      for (const bool caps : { false, true })
      {
        Points values = randomValues((layers + 1) * n);
        if (!caps)
        {
          clearCaps(values, fixed, n);
        }
        const PrismSolver prism(
          hexsweep::quadLaplacian(sweep.source, sweep.quads), layers, height, fixed);
        const Points expected =
          solveInThreeDimensions(sweep.source, sweep.quads, layers, height, fixed, values);
        EXPECT_LT(test::greatestDistance(prism.extend(values), expected), 1e-12)
          << hole << ' ' << layers << ' ' << caps;
      }
    }
  }
}

TEST(PrismSolver, ReproducesLinearFunctions)
{
  const Sweep sweep = flatCap(12, 9, true);
  const Index n = sweep.source.rows();
  const Index layers = 7;
  for (const double size : { 1e-6, 1.0, 1e6 })
  {
    Points values((layers + 1) * n, 3);
    for (Index k = 0; k <= layers; ++k)
    {
      for (Index i = 0; i < n; ++i)
      {
        const double x = sweep.source(i, 0);
        const double y = sweep.source(i, 1);
        const double z = 0.3 * static_cast<double>(k);
        values.row(k * n + i) << x - 2 * y + z, 5 * z + 1, 3 * x + y - 4 * z;
      }
    }
    Points given = values;
    const auto fixed = boundaryOf(sweep);
    std::vector<char> isFixed(static_cast<std::size_t>(n), 0);
    for (const Index id : fixed)
    {
      isFixed[static_cast<std::size_t>(id)] = 1;
    }
    for (Index k = 1; k < layers; ++k)
    {
      for (Index i = 0; i < n; ++i)
      {
        if (!isFixed[static_cast<std::size_t>(i)])
        {
          given.row(k * n + i).setConstant(std::nan("")); // not to be read
        }
      }
    }
    const PrismSolver prism(
      hexsweep::quadLaplacian(size * sweep.source, sweep.quads), layers, size * 0.3, fixed);
    EXPECT_LT(test::greatestDistance(prism.extend(given), values), 1e-11) << size;
  }
}

TEST(PrismSolver, GivenRowsAreReturnedBitForBit)
{
  const Sweep sweep = flatCap(9, 6, true);
  const Index n = sweep.source.rows();
  const auto fixed = boundaryOf(sweep);
  const Points values = randomValues(6 * n);
  const PrismSolver prism(hexsweep::quadLaplacian(sweep.source, sweep.quads), 5, 0.2, fixed);
  const Points result = prism.extend(values);
  EXPECT_EQ(result.topRows(n), values.topRows(n));
  EXPECT_EQ(result.bottomRows(n), values.bottomRows(n));
  for (Index k = 1; k < 5; ++k)
  {
    for (const Index id : fixed)
    {
      EXPECT_EQ(result.row(k * n + id), values.row(k * n + id));
    }
  }
}

TEST(PrismSolver, SolutionStaysBetweenItsBoundaryValues)
{
  // The maximum principle on a mesh of squares, where the stiffness matrix is of the right sign.
  const Sweep sweep = test::makeSweep(8, 4, false, { 0, 1 }, [](double x, double y, double t) {
    return Eigen::RowVector3d(std::round(4 * x) / 4, std::round(4 * y) / 4, t);
  });
  const auto fixed = boundaryOf(sweep);
  const Index n = sweep.source.rows();
  const Points values = randomValues(7 * n);
  const PrismSolver prism(hexsweep::quadLaplacian(sweep.source, sweep.quads), 6, 0.25, fixed);
  EXPECT_LE(prism.extend(values).cwiseAbs().maxCoeff(), 1.0);
}

TEST(PrismSolver, OneLayerHasNothingToSolve)
{
  const Sweep sweep = flatCap(4, 3, false);
  const Points values = randomValues(2 * sweep.source.rows());
  const PrismSolver prism(
    hexsweep::quadLaplacian(sweep.source, sweep.quads), 1, 1.0, boundaryOf(sweep));
  EXPECT_EQ(prism.extend(values), values);
}

TEST(PrismSolver, PointsWithoutQuadsDoNotDisturb)
{
  Sweep sweep = flatCap(6, 5, false);
  const Index n = sweep.source.rows();
  const auto fixed = boundaryOf(sweep);
  const Points values = randomValues(4 * n);
  const Points expected =
    PrismSolver(hexsweep::quadLaplacian(sweep.source, sweep.quads), 3, 0.2, fixed).extend(values);

  Points more(n + 1, 3);
  more << sweep.source, Eigen::RowVector3d(7, 8, 9);
  Points moreValues(4 * (n + 1), 3);
  for (Index k = 0; k < 4; ++k)
  {
    moreValues.middleRows(k * (n + 1), n) = values.middleRows(k * n, n);
    moreValues.row(k * (n + 1) + n).setConstant(1e9);
  }
  const Points result =
    PrismSolver(hexsweep::quadLaplacian(more, sweep.quads), 3, 0.2, fixed).extend(moreValues);
  for (Index k = 0; k < 4; ++k)
  {
    EXPECT_LT(
      test::greatestDistance(result.middleRows(k * (n + 1), n), expected.middleRows(k * n, n)),
      1e-13);
  }
}

TEST(PrismSolver, BadArgumentsAndAborts)
{
  const Sweep sweep = flatCap(6, 5, false);
  const auto laplacian = hexsweep::quadLaplacian(sweep.source, sweep.quads);
  const auto fixed = boundaryOf(sweep);
  EXPECT_THROW(PrismSolver(laplacian, 0, 1.0, fixed), hexsweep::InvalidInput);
  EXPECT_THROW(PrismSolver(laplacian, 3, 0.0, fixed), hexsweep::InvalidInput);
  EXPECT_THROW(PrismSolver(laplacian, 3, std::nan(""), fixed), hexsweep::InvalidInput);
  const PrismSolver prism(laplacian, 3, 1.0, fixed);
  EXPECT_THROW(prism.extend(randomValues(5)), hexsweep::InvalidInput);
  EXPECT_THROW(prism.extend(randomValues(4 * sweep.source.rows()), [](double) { return false; }),
    hexsweep::Aborted);

  Sweep broken = sweep;
  broken.source(broken.quads(7, 0), 0) = std::nan("");
  const PrismSolver hopeless(hexsweep::quadLaplacian(broken.source, broken.quads), 3, 1.0, fixed);
  EXPECT_THROW(hopeless.extend(randomValues(4 * sweep.source.rows())), hexsweep::SolverFailure);
}
