// SPDX-License-Identifier: BSD-3-Clause
// Against a dense factorisation.
#include "Core/Solvers/ConjugateGradients.h"

#include "Support/DenseTruth.h"
#include "Support/LentThreads.h"

#include <type_traits>

namespace TestConjugateGradients
{
using hexsweep::conjugateGradients;
using hexsweep::Index;
using hexsweep::NodeUnknowns;
using hexsweep::SparseMatrix;

/// Springs between the nodes of a grid, stiffer along one direction that differs from spring to
/// spring; the nodes outside the grid stay.
template <int Width>
SparseMatrix springs(int cells)
{
  using Block = Eigen::Matrix<double, Width, Width>;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Eigen::Triplet<double, int>> entries;
  const auto add = [&](int a, int b, const Block& block) {
    for (int i = 0; i < Width; ++i)
    {
      for (int j = 0; j < Width; ++j)
      {
        entries.emplace_back(Width * a + i, Width * b + j, block(i, j));
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
        Eigen::Matrix<double, Width, 1> axis = Eigen::Matrix<double, Width, 1>::Zero();
        axis[0] = std::cos(angle);
        axis[Width - 1] = std::sin(angle);
        const Block block = 0.1 * Block::Identity() + uniform(generator) * axis * axis.transpose();
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
  SparseMatrix matrix(Width * cells * cells, Width * cells * cells);
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

template <typename Width>
class ConjugateGradients : public ::testing::Test
{
};
using Widths = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(ConjugateGradients, Widths);

TYPED_TEST(ConjugateGradients, ReachTheSolution)
{
  constexpr auto unknowns = static_cast<NodeUnknowns>(TypeParam::value);
  const SparseMatrix matrix = springs<TypeParam::value>(12);
  const Eigen::VectorXd b = randomVector(matrix.rows());
  const Eigen::VectorXd truth = test::denseSolution(matrix, b);
  const Eigen::VectorXd x = conjugateGradients(matrix, b, unknowns, 1000, 1e-12);
  EXPECT_LT((x - truth).norm(), 1e-9 * truth.norm());
}

TYPED_TEST(ConjugateGradients, EveryStepDescends)
{
  constexpr auto unknowns = static_cast<NodeUnknowns>(TypeParam::value);
  const SparseMatrix matrix = springs<TypeParam::value>(30);
  const Eigen::VectorXd b = randomVector(matrix.rows());
  double last = 0.0;
  for (const int steps : { 1, 2, 5, 10, 20, 40 })
  {
    const double value = quadratic(matrix, b, conjugateGradients(matrix, b, unknowns, steps, 0.0));
    EXPECT_LT(value, last) << steps;
    last = value;
  }
}

TYPED_TEST(ConjugateGradients, StopWhereEnoughIsReached)
{
  constexpr auto unknowns = static_cast<NodeUnknowns>(TypeParam::value);
  const SparseMatrix matrix = springs<TypeParam::value>(20);
  const Eigen::VectorXd b = randomVector(matrix.rows());
  const Eigen::VectorXd rough = conjugateGradients(matrix, b, unknowns, 1000, 0.1);
  const double left = (b - matrix * rough).norm() / b.norm();
  EXPECT_LT(left, 0.3);
  EXPECT_GT(left, 1e-4);
  EXPECT_EQ(
    conjugateGradients(matrix, Eigen::VectorXd::Zero(b.size()), unknowns, 10, 0.1).norm(), 0.0);
}

TYPED_TEST(ConjugateGradients, BlocksNearlyWithoutAnInverseHoldNobodyUp)
{
  constexpr auto unknowns = static_cast<NodeUnknowns>(TypeParam::value);
  constexpr int Width = TypeParam::value;
  const SparseMatrix given = springs<Width>(12);
  const Eigen::VectorXd b = randomVector(given.rows());
  for (const double small : { 1e-7, 1e-8, 1e-9, 1e-10, 1e-12 })
  {
    // What one sample that is nearly flat does to its node: a direction counts far more than
    // others.
    std::mt19937 generator(7);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 20; ++i)
    {
      SparseMatrix matrix = given;
      const Eigen::VectorXd axis =
        Eigen::VectorXd::NullaryExpr(Width, [&] { return normal(generator); });
      for (int r = 0; r < Width; ++r)
      {
        for (int c = 0; c < Width; ++c)
        {
          matrix.coeffRef(Width * 60 + r, Width * 60 + c) += axis[r] * axis[c] / small;
        }
      }
      const double value = quadratic(matrix, b, conjugateGradients(matrix, b, unknowns, 100, 1e-6));
      const Eigen::VectorXd truth = test::denseSolution(matrix, b);
      EXPECT_LT(value, 0.99 * quadratic(matrix, b, truth)) << small; // both are negative
    }
  }
}

TYPED_TEST(ConjugateGradients, SameBitsInAnyOrder)
{
  constexpr auto unknowns = static_cast<NodeUnknowns>(TypeParam::value);
  const SparseMatrix matrix = springs<TypeParam::value>(200); // several pieces
  const Eigen::VectorXd b = randomVector(matrix.rows());
  const Eigen::VectorXd one = conjugateGradients(matrix, b, unknowns, 30, 0.0);
  EXPECT_EQ(one, conjugateGradients(matrix, b, unknowns, 30, 0.0, test::backwards));
  EXPECT_EQ(one, conjugateGradients(matrix, b, unknowns, 30, 0.0, test::sideBySide));
}
}
