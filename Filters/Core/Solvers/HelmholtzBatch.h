// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Several Helmholtz problems on one quad mesh, solved side by side.
 */
#ifndef hexsweep_HelmholtzBatch_h
#define hexsweep_HelmholtzBatch_h

#include "Core/Solvers/HelmholtzMesh.h"

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
  /// Not so: given up, values are of no use. HelmholtzDirectSolver costs less then.
  std::array<bool, LanesPerBatch> isSolved{};
  int iterations = 0;
};

/**
 * Solves (K + lambda M) u = load for the eight modes and three components of a batch.
 *
 * Conjugate gradients in single precision inside iterative refinement in double precision. The
 * preconditioner of PrismKernels.h is relaxed modified incomplete Cholesky
 * \cite AxelssonLindskog1986, or symmetric Gauss-Seidel where that does not do. Only nodes that the
 * solution reaches take part: with no load inside, it falls like exp(-sqrt(lambda) d) with the
 * distance d to the given nodes. That is estimated first, and checked on the solution.
 *
 * On poor quads low modes may take hundreds of iterations. Every few iterations the solver counts
 * what is left at the present rate, and gives up the modes that cost less to solve directly.
 *
 * An object keeps its memory from batch to batch and serves one thread at a time; a result does not
 * depend on what was solved before.
 */
class HelmholtzBatchSolver
{
public:
  HelmholtzBatchSolver(const HelmholtzMesh& mesh, const PrismKernels& kernels);

  /// @param check called now and then, from this thread; may throw to give up.
  /// @return the solution, kept until the next call.
  const HelmholtzSolution& solve(
    const HelmholtzProblems& problems, const std::function<void()>& check = {});

private:
  struct Vectors
  {
    std::vector<float> pivot, inverse, x, r, p, t, s;
  };
  class Iteration;
  void clearUnsolved();

  const HelmholtzMesh& Mesh;
  const PrismKernels& Kernels;
  HelmholtzSolution Solution;
  std::vector<double> Residual;
  Vectors Memory;
};
}

#endif
