// SPDX-License-Identifier: BSD-3-Clause
// Against a dense factorisation.
#include "Core/Solvers/ConjugateGradients.h"

#include "Support/DenseTruth.h"
#include "Support/LentThreads.h"

namespace TestConjugateGradients
{
using hexsweep::conjugateGradients;
using hexsweep::Index;
using hexsweep::SparseMatrix;

/// Springs between the nodes of a grid, stiffer along one direction that differs from spring to
/// spring; the nodes outside the grid stay.
SparseMatrix springs(int cells)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Eigen::Triplet<double, int>> entries;
  const auto add = [&](int a, int b, const Eigen::Matrix2d& block) {
    for (int i = 0; i < 2; ++i)
    {
      for (int j = 0; j < 2; ++j)
      {
        entries.emplace_back(2 * a + i, 2 * b + j, block(i, j));
      }
    }
  };
  const auto node = [&](int i, int j) {
    return i >= 0 && j >= 0 && i < cells && j < cells ? i * cells + j : -1;
  };
  for (int i = -1; i < cells; ++i)
  {
    for (int j = -1; j < cells; ++j)
    {
      for (const auto& [di, dj] : { std::pair{ 0, 1 }, std::pair{ 1, 0 } })
      {
        const double angle = 3.0 * uniform(generator);
        const Eigen::Vector2d axis(std::cos(angle), std::sin(angle));
        const Eigen::Matrix2d block =
          0.1 * Eigen::Matrix2d::Identity() + uniform(generator) * axis * axis.transpose();
        const int a = node(i, j);
        const int b = node(i + di, j + dj);
        if (a >= 0)
        {
          add(a, a, block);
        }
        if (b >= 0)
        {
          add(b, b, block);
        }
        if (a >= 0 && b >= 0)
        {
          add(a, b, -block);
          add(b, a, -block);
        }
      }
    }
  }
  SparseMatrix matrix(2 * cells * cells, 2 * cells * cells);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::VectorXd randomVector(Index size)
{
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  return Eigen::VectorXd::NullaryExpr(size, [&] { return normal(generator); });
}

double quadratic(const SparseMatrix& matrix, const Eigen::VectorXd& b, const Eigen::VectorXd& x)
{
  return 0.5 * x.dot(matrix * x) - b.dot(x);
}

TEST(ConjugateGradients, ReachTheSolution)
{
  const SparseMatrix matrix = springs(12);
  const Eigen::VectorXd b = randomVector(matrix.rows());
  const Eigen::VectorXd truth = test::denseSolution(matrix, b);
  const Eigen::VectorXd x = conjugateGradients(matrix, b, 1000, 1e-12);
  EXPECT_LT((x - truth).norm(), 1e-9 * truth.norm());
}

TEST(ConjugateGradients, EveryStepDescends)
{
  const SparseMatrix matrix = springs(30);
  const Eigen::VectorXd b = randomVector(matrix.rows());
  double last = 0.0;
  for (const int steps : { 1, 2, 5, 10, 20, 40 })
  {
    const double value = quadratic(matrix, b, conjugateGradients(matrix, b, steps, 0.0));
    EXPECT_LT(value, last) << steps;
    last = value;
  }
}

TEST(ConjugateGradients, StopWhereEnoughIsReached)
{
  const SparseMatrix matrix = springs(20);
  const Eigen::VectorXd b = randomVector(matrix.rows());
  const Eigen::VectorXd rough = conjugateGradients(matrix, b, 1000, 0.1);
  const double left = (b - matrix * rough).norm() / b.norm();
  EXPECT_LT(left, 0.3);
  EXPECT_GT(left, 1e-4);
  EXPECT_EQ(conjugateGradients(matrix, Eigen::VectorXd::Zero(b.size()), 10, 0.1).norm(), 0.0);
}

TEST(ConjugateGradients, SameBitsInAnyOrder)
{
  const SparseMatrix matrix = springs(200); // several pieces
  const Eigen::VectorXd b = randomVector(matrix.rows());
  const Eigen::VectorXd one = conjugateGradients(matrix, b, 30, 0.0);
  EXPECT_EQ(one, conjugateGradients(matrix, b, 30, 0.0, test::backwards));
  EXPECT_EQ(one, conjugateGradients(matrix, b, 30, 0.0, test::sideBySide));
}
}
