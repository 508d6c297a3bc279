// SPDX-License-Identifier: BSD-3-Clause
// Separation of variables against an assembled trilinear finite element solve in three dimensions.
#include "Core/Solvers/PrismSolver.h"

#include "Core/Common/Errors.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "Support/DenseTruth.h"
#include "Support/SweepMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <random>
#include <thread>

namespace TestPrismSolver
{
using hexsweep::Index;
using hexsweep::ParallelFor;
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
Points solveInThreeDimensions(const Points& cap, const Quads& quads, const Eigen::VectorXd& heights,
  const std::vector<Index>& fixed, const Points& values)
{
  const Index n = cap.rows();
  const Index layers = heights.size();
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
        corners(a, 2) += heights.head(layer).sum();
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
  return test::denseSolution(stiffness, load);
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

/// The greatest difference from the assembled solve over the greatest given value, which is 1.
double differenceFromAssembly(
  const Sweep& sweep, const Eigen::VectorXd& heights, bool caps, const ParallelFor& threads = {})
{
  const Index n = sweep.source.rows();
  const auto fixed = boundaryOf(sweep);
  Points values = randomValues((heights.size() + 1) * n);
  if (!caps)
  {
    clearCaps(values, fixed, n);
  }
  const PrismSolver prism(hexsweep::quadLaplacian(sweep.source, sweep.quads), heights, fixed);
  const Points expected = solveInThreeDimensions(sweep.source, sweep.quads, heights, fixed, values);
  return test::greatestDistance(prism.extend(values, {}, threads), expected);
}

/// Threads of the standard library, which take the pieces as they come.
void twoThreads(Index count, const std::function<void(Index)>& call)
{
  std::atomic<Index> next{ 0 };
  const auto work = [&] {
    for (Index i = next++; i < count; i = next++)
    {
      call(i);
    }
  };
  std::thread other(work);
  work();
  other.join();
}

TEST(PrismSolver, EqualsTheAssembledTrilinearSolve)
{
  for (const bool hole : { false, true })
  {
    const Sweep sweep = flatCap(9, 6, hole);
    for (const Index layers : { 1, 2, 3, 5, 8 })
    {
      // Flat layers, where the mass matrix prevails, to thick ones, where it is the stiffness.
      for (const double height : { 1e-4, 0.01, 0.17, 20.0 })
      {
        for (const bool caps : { false, true })
        {
          EXPECT_LT(
            differenceFromAssembly(sweep, Eigen::VectorXd::Constant(layers, height), caps), 1e-11)
            << hole << ' ' << layers << ' ' << height << ' ' << caps;
        }
      }
    }
  }
}

TEST(PrismSolver, EqualsTheAssembledSolveOnUnequalLayers)
{
  const Sweep sweep = flatCap(9, 6, true);
  for (const bool caps : { false, true })
  {
    EXPECT_LT(differenceFromAssembly(sweep, Eigen::Vector2d(0.1, 0.4), caps), 1e-11);
    Eigen::VectorXd heights(9);
    for (Index k = 0; k < 9; ++k)
    {
      heights[k] = 0.01 * std::pow(1.7, static_cast<double>(k));
    }
    EXPECT_LT(differenceFromAssembly(sweep, heights, caps), 1e-11);
    EXPECT_LT(differenceFromAssembly(sweep, heights.reverse(), caps, twoThreads), 1e-11);
  }
}

TEST(PrismSolver, EqualsTheAssembledSolveOnNeedles)
{
  // Quads of 1 : 1000, and with them quads of 1000 : 1 in the same mesh.
  Sweep sweep = flatCap(9, 6, false);
  for (Index i = 0; i < sweep.source.rows(); ++i)
  {
    sweep.source(i, 0) = std::sinh(6.0 * (sweep.source(i, 0) - 1.0));
    sweep.source(i, 1) *= 0.01;
  }
  for (const double height : { 1e-3, 0.1, 10.0 })
  {
    EXPECT_LT(differenceFromAssembly(sweep, Eigen::VectorXd::Constant(6, height), true), 1e-10)
      << height;
  }
}

/// Greatest residual at a free node of the difference equation that the assembled system is, in
/// units of the values.
double residualOf(const hexsweep::QuadLaplacian& laplacian, double h,
  const std::vector<Index>& fixed, const Points& result)
{
  const Index n = laplacian.stiffness.rows();
  std::vector<char> isFixed(static_cast<std::size_t>(n), 0);
  for (const Index id : fixed)
  {
    isFixed[static_cast<std::size_t>(id)] = 1;
  }
  double greatest = 0.0;
  for (Index k = 1; k + 1 < result.rows() / n; ++k)
  {
    const auto layer = [&](Index l) { return result.middleRows(l * n, n); };
    const Points mass = (h / 6.0) * (layer(k - 1) + 4.0 * layer(k) + layer(k + 1));
    const Points stiffness = (2.0 * layer(k) - layer(k - 1) - layer(k + 1)) / h;
    const Points residual = laplacian.stiffness * mass + laplacian.mass * stiffness;
    for (Index i = 0; i < n; ++i)
    {
      const double diagonal = laplacian.stiffness.coeff(i, i) * h + laplacian.mass.coeff(i, i) / h;
      greatest = std::max(greatest,
        isFixed[static_cast<std::size_t>(i)] ? 0.0
                                             : residual.row(i).cwiseAbs().maxCoeff() / diagonal);
    }
  }
  return greatest;
}

TEST(PrismSolver, ManyLayersOfFewQuads)
{
  const Index layers = 300;
  const Sweep sweep = flatCap(4, 3, false);
  const auto fixed = boundaryOf(sweep);
  // Too large to assemble.
  const Points values = randomValues((layers + 1) * sweep.source.rows());
  const double h = 0.02;
  const auto laplacian = hexsweep::quadLaplacian(sweep.source, sweep.quads);
  const Points result = PrismSolver(laplacian, layers, h, fixed).extend(values);
  EXPECT_LT(residualOf(laplacian, h, fixed, result), 1e-11);
}

TEST(PrismSolver, SameBitsWhereModesAreGivenUp)
{
  // Quads of up to 1 : 700, thick layers, and values given at one end only.
  Sweep sweep = flatCap(60, 30, true);
  std::vector<Index> fixed;
  for (Index i = 0; i < sweep.source.rows(); ++i)
  {
    sweep.source(i, 1) *= std::exp(-6.0 * sweep.source(i, 1));
    if (sweep.source(i, 0) < 0.3)
    {
      fixed.push_back(i);
    }
  }
  const Index layers = 6;
  const double h = 30.0;
  const Points values = randomValues((layers + 1) * sweep.source.rows());
  const auto laplacian = hexsweep::quadLaplacian(sweep.source, sweep.quads);
  const PrismSolver prism(laplacian, layers, h, fixed);
  std::size_t reports = 0;
  const Points alone = prism.extend(values, [&](double) { return ++reports > 0; });
  EXPECT_GT(reports, 6u); // five for the batch, the synthesis and the end; one for each mode
  EXPECT_LT(residualOf(laplacian, h, fixed, alone), 1e-11);
  const Points together = prism.extend(values, {}, twoThreads);
  EXPECT_EQ(std::memcmp(alone.data(), together.data(),
              static_cast<std::size_t>(alone.size()) * sizeof(double)),
    0);
  std::size_t calls = 0;
  EXPECT_THROW(
    prism.extend(values, [&](double) { return ++calls < reports - 2; }), hexsweep::Aborted);
}

TEST(PrismSolver, SameBitsWithAnyNumberOfThreads)
{
  const Sweep sweep = flatCap(60, 45, true);
  const auto fixed = boundaryOf(sweep);
  const Index layers = 41;
  const Points values = randomValues((layers + 1) * sweep.source.rows());
  const PrismSolver prism(hexsweep::quadLaplacian(sweep.source, sweep.quads), layers, 0.02, fixed);
  const Points alone = prism.extend(values);
  for (int round = 0; round < 3; ++round)
  {
    const Points together = prism.extend(values, {}, twoThreads);
    EXPECT_EQ(std::memcmp(alone.data(), together.data(),
                static_cast<std::size_t>(alone.size()) * sizeof(double)),
      0);
  }
}

TEST(PrismSolver, ReportsProgressAndStopsWhereverItIsAsked)
{
  const Sweep sweep = flatCap(24, 18, false);
  const auto fixed = boundaryOf(sweep);
  const Index layers = 100;
  const Points values = randomValues((layers + 1) * sweep.source.rows());
  const PrismSolver prism(hexsweep::quadLaplacian(sweep.source, sweep.quads), layers, 0.02, fixed);
  std::vector<double> reports;
  prism.extend(values, [&](double done) {
    reports.push_back(done);
    return true;
  });
  EXPECT_GE(reports.size(), 10u);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  EXPECT_EQ(reports.back(), 1.0);
  const std::thread::id caller = std::this_thread::get_id();
  for (std::size_t calls = 0; calls < 3; ++calls)
  {
    std::size_t count = 0;
    const auto stop = [&](double) {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      return count++ < calls;
    };
    EXPECT_THROW(prism.extend(values, stop, twoThreads), hexsweep::Aborted) << calls;
    EXPECT_EQ(count, calls + 1);
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
  EXPECT_THROW(
    PrismSolver(laplacian, Eigen::Vector3d(1.0, 0.0, 1.0), fixed), hexsweep::InvalidInput);
  const PrismSolver prism(laplacian, 3, 1.0, fixed);
  EXPECT_THROW(prism.extend(randomValues(5)), hexsweep::InvalidInput);
  EXPECT_THROW(prism.extend(randomValues(4 * sweep.source.rows()), [](double) { return false; }),
    hexsweep::Aborted);

  Sweep broken = sweep;
  broken.source(broken.quads(7, 0), 0) = std::nan("");
  const PrismSolver hopeless(hexsweep::quadLaplacian(broken.source, broken.quads), 3, 1.0, fixed);
  EXPECT_THROW(hopeless.extend(randomValues(4 * sweep.source.rows())), hexsweep::SolverFailure);
}
}
