// SPDX-License-Identifier: BSD-3-Clause
// Against a dense solve, and against log r on an annulus.
#include "Core/Solvers/DirichletSolver.h"
#include "Core/Solvers/SurfaceLaplacian.h"

#include "Support/CapMeshes.h"
#include "Support/DenseTruth.h"

#include <limits>

namespace TestDirichletSolver
{
using hexsweep::DirichletSolver;
using hexsweep::Index;
using hexsweep::SparseMatrix;
using hexsweep::TriangleMesh;
using hexsweep::Weights;

Eigen::MatrixXd randomMatrix(Index rows, Index columns, unsigned seed)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(generator); });
}

/// Fixed rows replaced by the identity, solved with full pivoting.
Eigen::MatrixXd denseSolve(const SparseMatrix& laplacian, const std::vector<bool>& fixed,
  const Eigen::MatrixXd& values, const Eigen::MatrixXd& source)
{
  Eigen::MatrixXd matrix(laplacian);
  Eigen::MatrixXd right = source;
  for (Index i = 0; i < matrix.rows(); ++i)
  {
    if (fixed[static_cast<std::size_t>(i)])
    {
      matrix.row(i).setZero();
      matrix(i, i) = 1.0;
      right.row(i) = values.row(i);
    }
  }
  return test::denseSolution(matrix, right);
}

/// Greatest error of the harmonic function 0 at r = 1, 1 at r = inner.
double logarithmError(Index rings, Weights weights)
{
  const double inner = 0.3;
  std::mt19937 generator(4);
  const TriangleMesh mesh = test::annulus(inner, 1.0, rings, 4 * rings, &generator);
  const std::vector<bool> fixed = test::boundaryFlags(mesh);
  Eigen::VectorXd exact(mesh.points.rows());
  for (Index i = 0; i < exact.size(); ++i)
  {
    exact[i] = std::log(mesh.points.row(i).norm()) / std::log(inner);
  }
  Eigen::VectorXd given = exact;
  for (Index i = 0; i < exact.size(); ++i)
  {
    given[i] = fixed[static_cast<std::size_t>(i)] ? std::round(exact[i]) : 0.0;
  }
  const DirichletSolver solver(
    hexsweep::surfaceLaplacian(mesh.points, mesh.triangles, weights), fixed);
  return (solver.solve(given) - exact).cwiseAbs().maxCoeff();
}

TEST(DirichletSolver, FactorisesAMeshAgainThatHasMoved)
{
  TriangleMesh mesh = test::curvedPlate(3, 0.3);
  const std::vector<bool> fixed = test::boundaryFlags(mesh);
  const Index n = mesh.points.rows();
  const Eigen::MatrixXd values = randomMatrix(n, 3, 1);
  DirichletSolver solver(
    hexsweep::surfaceLaplacian(mesh.points, mesh.triangles, Weights::Cotangent), fixed);
  const Eigen::MatrixXd before = solver.solve(values);
  mesh.points.col(0) *= 3.0;
  const SparseMatrix moved =
    hexsweep::surfaceLaplacian(mesh.points, mesh.triangles, Weights::Cotangent);
  solver.factorize(moved);
  const Eigen::MatrixXd after = solver.solve(values);
  EXPECT_LT(
    (after - denseSolve(moved, fixed, values, Eigen::MatrixXd::Zero(n, 3))).cwiseAbs().maxCoeff(),
    1e-12);
  EXPECT_GT((after - before).cwiseAbs().maxCoeff(), 0.01);
}

TEST(DirichletSolver, EqualsADenseSolve)
{
  const TriangleMesh mesh = test::curvedPlate(3, 0.3);
  const std::vector<bool> fixed = test::boundaryFlags(mesh);
  const Index n = mesh.points.rows();
  const Eigen::MatrixXd values = randomMatrix(n, 3, 1);
  const Eigen::MatrixXd source = randomMatrix(n, 3, 2);
  for (const Weights weights : { Weights::Cotangent, Weights::MeanValue })
  {
    const SparseMatrix laplacian = hexsweep::surfaceLaplacian(mesh.points, mesh.triangles, weights);
    const DirichletSolver solver(laplacian, fixed);
    const Eigen::MatrixXd plain = solver.solve(values);
    EXPECT_LT((plain - denseSolve(laplacian, fixed, values, Eigen::MatrixXd::Zero(n, 3))).norm(),
      1e-11 * plain.norm());
    const Eigen::MatrixXd full = solver.solve(values, source);
    EXPECT_LT((full - denseSolve(laplacian, fixed, values, source)).norm(), 1e-11 * full.norm());
  }
}

TEST(DirichletSolver, FixedValuesPassBitForBitAndFreeOnesAreNotRead)
{
  const TriangleMesh mesh = test::curvedPlate(3, 0.3);
  const std::vector<bool> fixed = test::boundaryFlags(mesh);
  Eigen::MatrixXd values = randomMatrix(mesh.points.rows(), 2, 1);
  const DirichletSolver solver(hexsweep::cotangentLaplacian(mesh.points, mesh.triangles), fixed);
  const Eigen::MatrixXd first = solver.solve(values);
  Eigen::MatrixXd other = values;
  for (Index i = 0; i < values.rows(); ++i)
  {
    if (fixed[static_cast<std::size_t>(i)])
    {
      EXPECT_EQ(first.row(i), values.row(i));
    }
    else
    {
      other.row(i).setConstant(1e300);
    }
  }
  EXPECT_EQ(solver.solve(other), first);
}

TEST(DirichletSolver, ObeysTheMaximumPrinciple)
{
  // Mean value weights are positive: every free value lies between those of its neighbours.
  const TriangleMesh mesh = test::curvedPlate(3, 0.3);
  const std::vector<bool> fixed = test::boundaryFlags(mesh);
  const Eigen::MatrixXd values = randomMatrix(mesh.points.rows(), 1, 3);
  const Eigen::VectorXd solved =
    DirichletSolver(hexsweep::meanValueLaplacian(mesh.points, mesh.triangles), fixed).solve(values);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (Index i = 0; i < solved.size(); ++i)
  {
    if (fixed[static_cast<std::size_t>(i)])
    {
      low = std::min(low, values(i, 0));
      high = std::max(high, values(i, 0));
    }
  }
  EXPECT_GT(solved.minCoeff(), low - 1e-12);
  EXPECT_LT(solved.maxCoeff(), high + 1e-12);
}

TEST(DirichletSolver, ConvergesToTheLogarithmOnAnAnnulus)
{
  // Halving the edges divides the error of linear elements by four; cotangent weights are theirs.
  const double coarse = logarithmError(9, Weights::Cotangent);
  const double middle = logarithmError(17, Weights::Cotangent);
  const double fine = logarithmError(33, Weights::Cotangent);
  EXPECT_LT(fine, 1e-3);
  EXPECT_GT(coarse / middle, 3.3);
  EXPECT_GT(middle / fine, 3.3);
  EXPECT_LT(middle / fine, 5.0);
  EXPECT_LT(logarithmError(33, Weights::MeanValue), 5e-2);
}

TEST(DirichletSolver, UnusedVerticesAndAllFixed)
{
  TriangleMesh mesh = test::plate(4, {});
  std::vector<bool> fixed = test::boundaryFlags(mesh);
  mesh.points.conservativeResize(mesh.points.rows() + 1, 3);
  mesh.points.bottomRows<1>() << 5, 5, 5;
  fixed.push_back(false);
  Eigen::MatrixXd values = randomMatrix(mesh.points.rows(), 1, 3);
  const SparseMatrix laplacian = hexsweep::cotangentLaplacian(mesh.points, mesh.triangles);
  EXPECT_EQ(
    DirichletSolver(laplacian, fixed).solve(values).bottomRows<1>(), values.bottomRows<1>());
  fixed.assign(fixed.size(), true);
  EXPECT_EQ(DirichletSolver(laplacian, fixed).solve(values), values);
}

TEST(DirichletSolver, AFactorCanBeMoved)
{
  const TriangleMesh mesh = test::curvedPlate(3, 0.3);
  const std::vector<bool> fixed = test::boundaryFlags(mesh);
  const Eigen::MatrixXd values = randomMatrix(mesh.points.rows(), 1, 1);
  const SparseMatrix laplacian = hexsweep::cotangentLaplacian(mesh.points, mesh.triangles);
  DirichletSolver first(laplacian, fixed);
  const Eigen::MatrixXd expected = first.solve(values);
  DirichletSolver second(std::move(first));
  EXPECT_EQ(second.solve(values), expected);
}

TEST(DirichletSolver, NoFiniteSolutionIsAnError)
{
  const TriangleMesh mesh = test::curvedPlate(3, 0.3);
  const std::vector<bool> fixed = test::boundaryFlags(mesh);
  const SparseMatrix laplacian = hexsweep::cotangentLaplacian(mesh.points, mesh.triangles);
  const Eigen::MatrixXd values =
    Eigen::MatrixXd::Constant(mesh.points.rows(), 1, std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(DirichletSolver(laplacian, fixed).solve(values), hexsweep::SolverFailure);
}
}
