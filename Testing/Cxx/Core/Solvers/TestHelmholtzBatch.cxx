// SPDX-License-Identifier: BSD-3-Clause
// Helmholtz problems, batched and one by one, against Eigen's Cholesky factorisation, with the
// kernels of every instruction set that this processor has.
#include "Core/Solvers/HelmholtzBatch.h"

#include "Core/Common/Errors.h"
#include "Core/Solvers/HelmholtzDirect.h"

#include "Support/SweepMeshes.h"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <random>

namespace TestHelmholtzBatch
{
using hexsweep::BatchWidth;
using hexsweep::HelmholtzBatchSolver;
using hexsweep::HelmholtzDirectSolver;
using hexsweep::HelmholtzMesh;
using hexsweep::HelmholtzProblems;
using hexsweep::Index;
using hexsweep::LanesPerBatch;
using hexsweep::PrismKernels;
using hexsweep::QuadLaplacian;
using Sparse = Eigen::SparseMatrix<double>;

std::size_t at(Index i)
{
  return static_cast<std::size_t>(i);
}

/// A cap whose left part, x < 0.3, is given. Quads are narrower the further up, by `stretch`.
struct Problem
{
  QuadLaplacian laplacian;
  std::vector<char> given;
  HelmholtzMesh mesh;

  explicit Problem(int cells, double stretch = 0.0)
  {
    const test::Sweep sweep =
      test::makeSweep(2 * cells, cells, true, { 0, 1 }, [stretch](double x, double y, double t) {
        return Eigen::RowVector3d(x, y * std::exp(-stretch * y), t);
      });
    this->laplacian = hexsweep::quadLaplacian(sweep.source, sweep.quads);
    for (Index i = 0; i < sweep.source.rows(); ++i)
    {
      this->given.push_back(sweep.source(i, 0) < 0.3);
    }
    this->mesh = hexsweep::helmholtzMesh(this->laplacian, this->given);
  }

  /// Column c of the load of lane l, solved by Eigen; in the order of the mesh.
  Eigen::VectorXd expected(const HelmholtzProblems& problems, int lane, int component) const
  {
    const Index n = this->mesh.size();
    std::vector<Index> place(this->given.size(), -1);
    for (Index i = 0; i < n; ++i)
    {
      place[at(this->mesh.ids[at(i)])] = i;
    }
    const Sparse all = this->laplacian.stiffness + problems.lambda[at(lane)] * this->laplacian.mass;
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < all.outerSize(); ++column)
    {
      for (Sparse::InnerIterator entry(all, column); entry; ++entry)
      {
        const Index i = place[at(entry.row())];
        const Index j = place[at(column)];
        if (i >= 0 && j >= 0)
        {
          entries.emplace_back(static_cast<int>(i), static_cast<int>(j), entry.value());
        }
      }
    }
    Sparse matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::VectorXd load = Eigen::VectorXd::Zero(n);
    for (Index i = 0; i < problems.loadEnd; ++i)
    {
      load[i] = problems.load[at(i * BatchWidth + component * LanesPerBatch + lane)];
    }
    return Eigen::SimplicialLLT<Sparse>(matrix).solve(load);
  }
};

HelmholtzProblems randomProblems(const HelmholtzMesh& mesh, Index loadEnd, double lambda)
{
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  HelmholtzProblems problems;
  for (int l = 0; l < LanesPerBatch; ++l)
  {
    problems.lambda[at(l)] = lambda * (1.0 + 0.1 * l);
    problems.tolerance[at(l)] = 1e-12;
    problems.amplitude[at(l)] = 1.0;
  }
  problems.loadEnd = loadEnd;
  problems.load.resize(at(loadEnd * BatchWidth));
  for (double& value : problems.load)
  {
    // As large as what a given value of 1 makes.
    value = uniform(generator) * (1.0 + lambda * mesh.diagonal.mass.front());
  }
  return problems;
}

void expectSolution(const Problem& problem, const HelmholtzProblems& problems,
  const hexsweep::HelmholtzSolution& solution, double tolerance)
{
  const Index n = problem.mesh.size();
  for (int lane = 0; lane < LanesPerBatch; ++lane)
  {
    EXPECT_TRUE(solution.isSolved[at(lane)]) << lane;
    for (int c = 0; c < 3; ++c)
    {
      const Eigen::VectorXd expected = problem.expected(problems, lane, c);
      double difference = 0.0;
      for (Index i = 0; i < n; ++i)
      {
        const double value =
          i < solution.size ? solution.values[at(i * BatchWidth + c * LanesPerBatch + lane)] : 0.0;
        difference = std::max(difference, std::abs(value - expected[i]));
      }
      EXPECT_LT(difference, tolerance * std::max(1.0, expected.cwiseAbs().maxCoeff()))
        << problems.lambda[at(lane)] << ' ' << lane << ' ' << c;
    }
  }
}

TEST(HelmholtzBatch, EqualsADirectSolveOnEveryInstructionSet)
{
  const Problem problem(12);
  const PrismKernels* kernels[3];
  const int count = hexsweep::availablePrismKernels(kernels);
  ASSERT_GE(count, 1);
  for (int k = 0; k < count; ++k)
  {
    SCOPED_TRACE(kernels[k]->name);
    HelmholtzBatchSolver solver(problem.mesh, *kernels[k]);
    for (const double lambda : { 1e-8, 1.0, 300.0, 1e4, 1e8 })
    {
      for (const Index loadEnd : { problem.mesh.levels[1], problem.mesh.size() })
      {
        const HelmholtzProblems problems = randomProblems(problem.mesh, loadEnd, lambda);
        expectSolution(problem, problems, solver.solve(problems), 1e-10);
      }
    }
  }
}

TEST(HelmholtzBatch, GivesUpLowModesOfPoorQuadsAndKeepsWhatItSolves)
{
  // Quads up to 1 : 700.
  const Problem problem(30, 6.0);
  HelmholtzBatchSolver solver(problem.mesh, hexsweep::prismKernels());
  HelmholtzProblems problems = randomProblems(problem.mesh, problem.mesh.levels[1], 1.0);
  for (std::size_t l = 0; l < LanesPerBatch; ++l)
  {
    problems.lambda[l] = l % 2 == 0 ? 1e-3 : 1e9;
  }
  const hexsweep::HelmholtzSolution& solution = solver.solve(problems);
  for (int lane = 0; lane < LanesPerBatch; ++lane)
  {
    EXPECT_EQ(solution.isSolved[at(lane)], lane % 2 == 1) << lane;
    for (Index i = 0; i < solution.size && lane % 2 == 1; ++i)
    {
      ASSERT_LT(std::abs(solution.values[at(i * BatchWidth + lane)]), 10.0);
    }
  }
}

TEST(HelmholtzDirect, EqualsEigensOnPoorQuads)
{
  const Problem problem(20, 6.0);
  const HelmholtzDirectSolver first(problem.mesh);
  HelmholtzDirectSolver solver(first);
  for (const double lambda : { 1e9, 1e-3, 1.0 })
  {
    const HelmholtzProblems problems = randomProblems(problem.mesh, problem.mesh.size(), lambda);
    hexsweep::Points load(problem.mesh.size(), 3);
    hexsweep::Points expected(problem.mesh.size(), 3);
    for (int c = 0; c < 3; ++c)
    {
      expected.col(c) = problem.expected(problems, 0, c);
      for (Index i = 0; i < load.rows(); ++i)
      {
        load(i, c) = problems.load[at(i * BatchWidth + c * LanesPerBatch)];
      }
    }
    const double size = expected.cwiseAbs().maxCoeff();
    const hexsweep::Points solution = solver.solve(lambda, load, 1e-12 * size);
    EXPECT_LT((solution - expected).cwiseAbs().maxCoeff(), 1e-10 * size) << lambda;
    EXPECT_EQ(solution, HelmholtzDirectSolver(first).solve(lambda, load, 1e-12 * size));
  }
}

TEST(HelmholtzDirect, SaysWhatCannotBeSolved)
{
  const Problem problem(4);
  HelmholtzDirectSolver solver(problem.mesh);
  const hexsweep::Points load = hexsweep::Points::Ones(problem.mesh.size(), 3);
  EXPECT_THROW(solver.solve(-1e6, load, 1e-12), hexsweep::SolverFailure); // not definite
  EXPECT_THROW(solver.solve(std::nan(""), load, 1e-12), hexsweep::SolverFailure);
  EXPECT_THROW(solver.solve(1.0, load, 0.0), hexsweep::SolverFailure); // beyond rounding
}

TEST(HelmholtzBatch, HighModesStayNearTheGivenNodes)
{
  const Problem problem(30);
  HelmholtzBatchSolver solver(problem.mesh, hexsweep::prismKernels());
  const HelmholtzProblems problems = randomProblems(problem.mesh, problem.mesh.levels[1], 3000.0);
  const hexsweep::HelmholtzSolution& solution = solver.solve(problems);
  EXPECT_LT(solution.size, problem.mesh.size() / 2);
  expectSolution(problem, problems, solution, 1e-10);
}

TEST(HelmholtzBatch, AnEstimateThatIsTooSmallIsNoticed)
{
  const Problem problem(30);
  HelmholtzBatchSolver solver(problem.mesh, hexsweep::prismKernels());
  HelmholtzProblems problems = randomProblems(problem.mesh, problem.mesh.levels[1], 1000.0);
  const Index size = solver.solve(problems).size;
  problems.amplitude.fill(1e-11); // as if the given values were tiny
  const hexsweep::HelmholtzSolution& solution = solver.solve(problems);
  EXPECT_GE(solution.size, size / 2);
  expectSolution(problem, problems, solution, 1e-10);
}

TEST(HelmholtzBatch, NodesAreNumberedByTheirDistance)
{
  const Problem problem(8);
  const Sparse& K = problem.laplacian.stiffness;
  // Distances by repeated passes over all edges.
  std::vector<Index> distance(problem.given.size());
  for (std::size_t i = 0; i < distance.size(); ++i)
  {
    distance[i] = problem.given[i] ? 0 : 1000000;
  }
  for (bool changed = true; changed;)
  {
    changed = false;
    for (int j = 0; j < K.outerSize(); ++j)
    {
      for (Sparse::InnerIterator entry(K, j); entry; ++entry)
      {
        if (distance[at(entry.row())] + 1 < distance[at(j)])
        {
          distance[at(j)] = distance[at(entry.row())] + 1;
          changed = true;
        }
      }
    }
  }
  ASSERT_FALSE(problem.mesh.levels.empty());
  EXPECT_EQ(problem.mesh.levels.front(), 0);
  EXPECT_EQ(problem.mesh.levels.back(),
    std::count_if(distance.begin(), distance.end(), [](Index steps) { return steps > 0; }));
  for (std::size_t l = 0; l + 1 < problem.mesh.levels.size(); ++l)
  {
    for (Index i = problem.mesh.levels[l]; i < problem.mesh.levels[l + 1]; ++i)
    {
      ASSERT_EQ(distance[at(problem.mesh.ids[at(i)])], static_cast<Index>(l) + 1);
    }
  }
}

TEST(PrismKernels, ProductsEqualEigensOnEveryInstructionSet)
{
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const PrismKernels* kernels[3];
  const int count = hexsweep::availablePrismKernels(kernels);
  ASSERT_GE(count, 1);
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const Index rows : { 1, 2, 3, 4, 9, 18 })
  {
    for (const Index inner : { 0, 1, 7, 30 })
    {
      const Matrix a = Matrix::NullaryExpr(rows, inner + 2, [&] { return uniform(generator); });
      const Matrix b =
        Matrix::NullaryExpr(inner, 2 * hexsweep::PanelWidth, [&] { return uniform(generator); });
      const Matrix expected = a.leftCols(inner) * b.leftCols(hexsweep::PanelWidth);
      for (int k = 0; k < count; ++k)
      {
        Matrix c(rows, Index{ hexsweep::PanelWidth });
        kernels[k]->multiply(rows, inner, a.data(), a.cols(), b.data(), b.cols(), c.data());
        EXPECT_LT((c - expected).cwiseAbs().maxCoeff(), 1e-13) << kernels[k]->name;
      }
    }
  }
}
}
