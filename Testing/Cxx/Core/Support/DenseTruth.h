// SPDX-License-Identifier: BSD-3-Clause
#ifndef hexsweep_DenseTruth_h
#define hexsweep_DenseTruth_h

#include <Eigen/Core>

/// Eigen's dense solvers, which tests take for the truth, instantiated once.

namespace test
{
/// Eigenvalues of a symmetric matrix, the least first.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);

/// Solves A X = B by an LU factorisation with full pivoting.
Eigen::MatrixXd denseSolution(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// The X that makes |A X - B| least, by a QR factorisation with column pivoting.
Eigen::MatrixXd leastSquaresSolution(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);
}

#endif
