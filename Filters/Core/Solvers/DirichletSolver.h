// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Harmonic functions with given values on some vertices: equation (3) of the paper.
 */
#ifndef hexsweep_DirichletSolver_h
#define hexsweep_DirichletSolver_h

#include "Core/Common/Mesh.h"
#include "Core/Solvers/SparseMatrix.h"

#include <memory>

namespace hexsweep
{
/**
 * Solves L f = b at the free vertices with f given at the fixed ones.
 *
 * The matrix is factorised once, in the constructor; solve() may then be called for any number of
 * right-hand sides. Symmetric matrices get a Cholesky factorisation, others LU (see
 * MultifrontalSolver).
 */
class DirichletSolver
{
public:
  /**
   * @param laplacian n x n. Vertices with an empty row are left out; their values pass through.
   * @param fixed     n entries, true where values are given. Every connected part of the mesh
   *                  needs at least one.
   * @param places    n x 3: where each vertex lies in space, for a better elimination order; or no
   *                  rows at all.
   * @throw SolverFailure when the factorisation breaks down.
   */
  DirichletSolver(const SparseMatrix& laplacian, const std::vector<bool>& fixed,
    const PointsRef& places = Points(0, 3));
  ~DirichletSolver();
  DirichletSolver(DirichletSolver&&) noexcept;
  DirichletSolver& operator=(DirichletSolver&&) noexcept;

  /**
   * Factorises another matrix in the elimination order of the first: for one mesh whose vertices
   * move.
   *
   * @param laplacian with the entries of the constructor's, whatever their values; as symmetric.
   * @throw SolverFailure when the factorisation breaks down; solve() is then of no use.
   */
  void factorize(const SparseMatrix& laplacian);

  /**
   * @param values n x k; the fixed rows are read, the others ignored.
   * @return n x k, harmonic at the free vertices, equal to `values` at the fixed ones.
   * @throw SolverFailure when the solution is not finite.
   */
  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& values) const;

  /// The same with a right-hand side (n x k; only free rows are read).
  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& values,
    const Eigen::Ref<const Eigen::MatrixXd>& rightHandSide) const;

private:
  struct Factor;
  std::unique_ptr<Factor> Implementation;
};
}

#endif
