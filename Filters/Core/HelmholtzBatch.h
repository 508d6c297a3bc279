// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Several Helmholtz problems on one quad mesh, solved side by side.
 */
#ifndef hexsweep_HelmholtzBatch_h
#define hexsweep_HelmholtzBatch_h

#include "HelmholtzMesh.h"

#include <array>

namespace hexsweep
{
/// What a batch asks for.
struct HelmholtzProblems
{
  std::array<double, LanesPerBatch> lambda{};
  /// Greatest error at a node, about; lanes without a load do not care.
  std::array<double, LanesPerBatch> tolerance{};
  /// Greatest value at a given node, to see how far inside the solution is not yet negligible.
  std::array<double, LanesPerBatch> amplitude{};
  /// Right-hand sides of the first nodes, loadEnd x BatchWidth; the other nodes have none.
  std::vector<double> load;
  Index loadEnd = 0;
};

/// Values of the first `size` nodes, size x BatchWidth; the others are zero to the tolerance.
struct HelmholtzSolution
{
  std::vector<double> values;
  Index size = 0;
  int iterations = 0;
};

/**
 * Solves (K + lambda M) u = load for the eight modes and three components of a batch.
 *
 * Conjugate gradients in single precision inside iterative refinement in double precision, with
 * the preconditioner of PrismKernels.h, relaxed modified incomplete Cholesky (O. Axelsson, G.
 * Lindskog, "On the eigenvalue distribution of a class of preconditioning methods", 1986); double
 * precision with symmetric Gauss-Seidel where that does not converge. Only nodes that the solution
 * reaches take part: with no load inside, it falls like exp(-sqrt(lambda) d) with the distance d to
 * the given nodes. That is estimated first, and checked on the solution.
 *
 * An object keeps its memory from batch to batch and serves one thread at a time; a result does not
 * depend on what was solved before.
 */
class HelmholtzBatchSolver
{
public:
  HelmholtzBatchSolver(const HelmholtzMesh& mesh, const PrismKernels& kernels);

  /// @return the solution, kept until the next call.
  /// @throw SolverFailure when the iteration does not converge.
  const HelmholtzSolution& solve(const HelmholtzProblems& problems);

private:
  template <typename Real>
  struct Vectors
  {
    std::vector<Real> pivot, inverse, x, r, p, t, s;
  };
  template <typename Real>
  class Iteration;

  const HelmholtzMesh& Mesh;
  const PrismKernels& Kernels;
  HelmholtzSolution Solution;
  std::vector<double> Residual;
  Vectors<float> InSingle;
  Vectors<double> InDouble;
};
}

#endif
