// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Approximate solutions of linear systems with two or three unknowns a node.
 */
#ifndef hexsweep_ConjugateGradients_h
#define hexsweep_ConjugateGradients_h

#include "Core/Common/ParallelFor.h"
#include "Core/Solvers/SparseMatrix.h"

namespace hexsweep
{
enum class NodeUnknowns
{
  Two = 2,
  Three = 3
};

/**
 * Conjugate gradients with the inverse blocks of the diagonal as preconditioner, from zero.
 *
 * Every step lowers the quadratic function whose minimum is the solution: what comes out is a
 * direction of descent however few the steps. Sums are taken piece by piece in one order, so that
 * the bits do not depend on the threads.
 *
 * @param matrix    w n x w n, symmetric, compressed; the w unknowns of a node follow each other and
 *                  have one pattern, in which every block is complete.
 * @param unknowns  w.
 * @param steps     at the most.
 * @param tolerance relative, of the residual in the preconditioner's norm.
 * @return the approximation; where the matrix is found not to be positive definite, that before.
 */
Eigen::VectorXd conjugateGradients(const SparseMatrix& matrix, const Eigen::VectorXd& b,
  NodeUnknowns unknowns, int steps, double tolerance, const ParallelFor& parallelFor = {});
}

#endif
