// SPDX-License-Identifier: BSD-3-Clause
#ifndef hexsweep_DenseAlgebra_h
#define hexsweep_DenseAlgebra_h

#include <Eigen/Core>

/// Decompositions of small dense matrices by Eigen. A compiler takes seconds for each of these
/// templates in each source that names it, so they are instantiated here alone.

namespace hexsweep
{
struct PrincipalAxes
{
  Eigen::Vector3d values; ///< Eigenvalues, the least first.
  Eigen::Matrix3d axes;   ///< Unit eigenvectors in columns, in the same order.
};

/// Eigenvalues and eigenvectors of a symmetric matrix, of which the lower triangle is read.
PrincipalAxes principalAxes(const Eigen::Matrix3d& symmetric);

struct GeneralizedAxes
{
  Eigen::VectorXd values;  ///< Rising; empty where `b` is not positive definite.
  Eigen::MatrixXd vectors; ///< In columns, in the same order, each with v^T b v = 1.
};

/// The v and k with a v = k b v, for a symmetric `a` and a symmetric positive definite `b`.
GeneralizedAxes generalizedAxes(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/**
 * The symmetric square root of a symmetric positive definite matrix.
 *
 * In closed form: (A + sqrt(det A) I) / sqrt(tr A + 2 sqrt(det A)), by the theorem of Cayley and
 * Hamilton.
 */
Eigen::Matrix2d symmetricRoot(const Eigen::Matrix2d& matrix);

/// The x of least norm among those that make |A x - b| least, for each column of b. Rank is
/// judged relative to the matrix.
Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// The rotation by the least angle that takes one direction to another, as two half
/// turns; neither needs unit length. One of those by half a turn where they are opposite, none
/// where one has no length.
Eigen::Matrix3d leastRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);
}

#endif
