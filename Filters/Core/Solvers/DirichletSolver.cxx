// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/DirichletSolver.h"

#include "Core/Common/Errors.h"
#include "Core/Solvers/MultifrontalSolver.h"

#include <optional>

namespace hexsweep
{
struct DirichletSolver::Factor
{
  std::vector<Index> FreeVertices;
  std::vector<int> FreeIndex; // number of each free vertex, -1 for the others
  SparseMatrix FreeToFixed;   // rows of the free vertices, all columns, free columns zero
  std::optional<MultifrontalSolver> Solver;

  SparseMatrix split(const SparseMatrix& laplacian);
};

namespace
{
bool isSymmetric(const SparseMatrix& matrix)
{
  // Where more than two triangles add to an entry, the halves may be summed in different orders.
  const SparseMatrix transposed = matrix.transpose();
  return (matrix - transposed).norm() <= 1e-12 * matrix.norm();
}
}

/// The matrix between the free vertices; keeps what leads from fixed ones to them.
SparseMatrix DirichletSolver::Factor::split(const SparseMatrix& laplacian)
{
  const Index m = static_cast<Index>(this->FreeVertices.size());
  const Index n = laplacian.cols();
  SparseMatrix matrix(m, m);
  matrix.reserve(laplacian.nonZeros());
  this->FreeToFixed.resize(m, n);
  for (Index column = 0; column < n; ++column)
  {
    const int freeColumn = this->FreeIndex[static_cast<std::size_t>(column)];
    SparseMatrix& target = freeColumn >= 0 ? matrix : this->FreeToFixed;
    const Index targetColumn = freeColumn >= 0 ? freeColumn : column;
    this->FreeToFixed.startVec(column);
    if (freeColumn >= 0)
    {
      matrix.startVec(freeColumn);
    }
    for (SparseMatrix::InnerIterator it(laplacian, column); it; ++it)
    {
      const int row = this->FreeIndex[static_cast<std::size_t>(it.row())];
      if (row >= 0)
      {
        target.insertBack(row, targetColumn) = it.value();
      }
    }
  }
  matrix.finalize();
  this->FreeToFixed.finalize();
  return matrix;
}

DirichletSolver::DirichletSolver(
  const SparseMatrix& laplacian, const std::vector<bool>& fixed, const PointsRef& places)
  : Implementation(std::make_unique<Factor>())
{
  Factor& factor = *this->Implementation;
  const Index n = laplacian.rows();
  factor.FreeIndex.assign(static_cast<std::size_t>(n), -1);
  const Eigen::VectorXd diagonal = laplacian.diagonal();
  for (Index i = 0; i < n; ++i)
  {
    if (!fixed[static_cast<std::size_t>(i)] && diagonal[i] != 0.0)
    {
      factor.FreeIndex[static_cast<std::size_t>(i)] = static_cast<int>(factor.FreeVertices.size());
      factor.FreeVertices.push_back(i);
    }
  }

  const SparseMatrix matrix = factor.split(laplacian);
  if (matrix.rows() > 0)
  {
    Points freePlaces(places.rows() > 0 ? matrix.rows() : 0, 3);
    for (Index i = 0; i < freePlaces.rows(); ++i)
    {
      freePlaces.row(i) = places.row(factor.FreeVertices[static_cast<std::size_t>(i)]);
    }
    factor.Solver.emplace(matrix,
      isSymmetric(matrix) ? MultifrontalSolver::Kind::Cholesky : MultifrontalSolver::Kind::LU,
      freePlaces);
    factor.Solver->factorize(matrix);
  }
}

void DirichletSolver::factorize(const SparseMatrix& laplacian)
{
  const SparseMatrix matrix = this->Implementation->split(laplacian);
  if (matrix.rows() > 0)
  {
    this->Implementation->Solver->factorize(matrix);
  }
}

DirichletSolver::~DirichletSolver() = default;
DirichletSolver::DirichletSolver(DirichletSolver&&) noexcept = default;
DirichletSolver& DirichletSolver::operator=(DirichletSolver&&) noexcept = default;

Eigen::MatrixXd DirichletSolver::solve(const Eigen::Ref<const Eigen::MatrixXd>& values) const
{
  return this->solve(values, Eigen::MatrixXd::Zero(values.rows(), values.cols()));
}

Eigen::MatrixXd DirichletSolver::solve(const Eigen::Ref<const Eigen::MatrixXd>& values,
  const Eigen::Ref<const Eigen::MatrixXd>& rightHandSide) const
{
  const Factor& factor = *this->Implementation;
  Eigen::MatrixXd result = values;
  const Index m = static_cast<Index>(factor.FreeVertices.size());
  if (m == 0)
  {
    return result;
  }
  Eigen::MatrixXd b = -(factor.FreeToFixed * values);
  for (Index i = 0; i < m; ++i)
  {
    b.row(i) += rightHandSide.row(factor.FreeVertices[static_cast<std::size_t>(i)]);
  }
  const Eigen::MatrixXd x = factor.Solver->solve(b);
  if (!x.allFinite())
  {
    throw SolverFailure("the harmonic map's linear system has no finite solution: triangles are "
                        "degenerate.");
  }
  for (Index i = 0; i < m; ++i)
  {
    result.row(factor.FreeVertices[static_cast<std::size_t>(i)]) = x.row(i);
  }
  return result;
}
}
