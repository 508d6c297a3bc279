// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief One Helmholtz problem on a quad mesh, solved directly.
 */
#ifndef hexsweep_HelmholtzDirect_h
#define hexsweep_HelmholtzDirect_h

#include "Core/Solvers/HelmholtzMesh.h"
#include "Core/Solvers/MultifrontalSolver.h"

namespace hexsweep
{
/**
 * Solves (K + lambda M) u = load by a sparse Cholesky factorisation and iterative refinement: for
 * the modes on which HelmholtzBatchSolver gives up.
 *
 * The nodes are ordered once, in the constructor; a copy shares no memory and orders nothing. A
 * result does not depend on what was solved before.
 */
class HelmholtzDirectSolver
{
public:
  /// @param mesh must outlive the solver and its copies.
  explicit HelmholtzDirectSolver(const HelmholtzMesh& mesh);

  /**
   * @param load      n x 3, n = mesh.size().
   * @param tolerance greatest error at a node, about (unit of the solution).
   * @return n x 3.
   * @throw SolverFailure when the matrix is singular or the tolerance is not met.
   */
  Points solve(double lambda, const Points& load, double tolerance);

private:
  void setMatrix(double lambda);

  const HelmholtzMesh* Mesh;
  SparseMatrix Matrix;
  MultifrontalSolver Factor;
};
}

#endif
