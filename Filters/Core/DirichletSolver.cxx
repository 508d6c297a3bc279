// SPDX-License-Identifier: BSD-3-Clause
#include "DirichletSolver.h"

#include "Errors.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

namespace hexsweep
{
struct DirichletSolver::Factor
{
  std::vector<Index> FreeVertices;
  SparseMatrix FreeToFixed; // rows of the free vertices, all columns, free columns zero
  Eigen::SimplicialLDLT<SparseMatrix> Cholesky;
  Eigen::SparseLU<SparseMatrix> LU;
  bool Symmetric = true;

  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const
  {
    return this->Symmetric ? Eigen::MatrixXd(this->Cholesky.solve(b))
                           : Eigen::MatrixXd(this->LU.solve(b));
  }
};

namespace
{
bool isSymmetric(const SparseMatrix& matrix)
{
  const SparseMatrix transposed = matrix.transpose();
  // The two halves of a symmetric matrix are summed in different orders: allow for rounding.
  return (matrix - transposed).norm() <= 1e-12 * matrix.norm();
}
}

DirichletSolver::DirichletSolver(const SparseMatrix& laplacian, const std::vector<bool>& fixed)
  : Implementation(std::make_unique<Factor>())
{
  Factor& factor = *this->Implementation;
  const Index n = laplacian.rows();
  std::vector<int> freeIndex(static_cast<std::size_t>(n), -1);
  const Eigen::VectorXd diagonal = laplacian.diagonal();
  for (Index i = 0; i < n; ++i)
  {
    if (!fixed[static_cast<std::size_t>(i)] && diagonal[i] != 0.0)
    {
      freeIndex[static_cast<std::size_t>(i)] = static_cast<int>(factor.FreeVertices.size());
      factor.FreeVertices.push_back(i);
    }
  }

  std::vector<Eigen::Triplet<double, int>> inner;
  std::vector<Eigen::Triplet<double, int>> outer;
  for (Index column = 0; column < laplacian.outerSize(); ++column)
  {
    for (SparseMatrix::InnerIterator it(laplacian, column); it; ++it)
    {
      const int row = freeIndex[static_cast<std::size_t>(it.row())];
      const int freeColumn = freeIndex[static_cast<std::size_t>(column)];
      if (row >= 0 && freeColumn >= 0)
      {
        inner.emplace_back(row, freeColumn, it.value());
      }
      else if (row >= 0)
      {
        outer.emplace_back(row, static_cast<int>(column), it.value());
      }
    }
  }
  const Index m = static_cast<Index>(factor.FreeVertices.size());
  SparseMatrix matrix(m, m);
  matrix.setFromTriplets(inner.begin(), inner.end());
  factor.FreeToFixed.resize(m, n);
  factor.FreeToFixed.setFromTriplets(outer.begin(), outer.end());
  if (m == 0)
  {
    return;
  }

  factor.Symmetric = isSymmetric(laplacian);
  Eigen::ComputationInfo info = Eigen::Success;
  if (factor.Symmetric)
  {
    factor.Cholesky.compute(matrix);
    info = factor.Cholesky.info();
  }
  else
  {
    factor.LU.compute(matrix);
    info = factor.LU.info();
  }
  if (info != Eigen::Success)
  {
    throw SolverFailure("the harmonic map's linear system is singular: part of the surface has no "
                        "boundary, or triangles are degenerate.");
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
  const Eigen::MatrixXd x = factor.solve(b);
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
