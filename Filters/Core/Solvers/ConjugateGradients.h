// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Approximate solutions of linear systems with two unknowns a node.
 */
#ifndef hexsweep_ConjugateGradients_h
#define hexsweep_ConjugateGradients_h

#include "Core/Common/ParallelFor.h"
#include "Core/Solvers/SparseMatrix.h"

namespace hexsweep
{
/**
 * Conjugate gradients with the inverse blocks of the diagonal as preconditioner, from zero.
 *
 * Every step lowers the quadratic function whose minimum is the solution: what comes out is a
 * direction of descent however few the steps. Sums are taken piece by piece in one order, so that
 * the bits do not depend on the threads.
 *
 * @param matrix    2 n x 2 n, symmetric, compressed; unknowns 2 i and 2 i + 1 have one pattern, in
 *                  which every block is complete.
 * @param steps     at the most.
 * @param tolerance relative, of the residual in the preconditioner's norm.
 * @return the approximation; where the matrix is found not to be positive definite, that before.
 */
Eigen::VectorXd conjugateGradients(const SparseMatrix& matrix, const Eigen::VectorXd& b, int steps,
  double tolerance, const ParallelFor& parallelFor = {});
}

#endif
