// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Common/DenseAlgebra.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>

#include <cmath>

namespace hexsweep
{
PrincipalAxes principalAxes(const Eigen::Matrix3d& symmetric)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
  return { solver.eigenvalues(), solver.eigenvectors() };
}

GeneralizedAxes generalizedAxes(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(a, b);
  if (solver.info() != Eigen::Success)
  {
    return {};
  }
  return { solver.eigenvalues(), solver.eigenvectors() };
}

Eigen::Matrix2d symmetricRoot(const Eigen::Matrix2d& matrix)
{
  const double root = std::sqrt(matrix.determinant());
  return (matrix + root * Eigen::Matrix2d::Identity()) / std::sqrt(matrix.trace() + 2.0 * root);
}

Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right)
{
  return matrix.completeOrthogonalDecomposition().solve(right);
}

Eigen::Matrix3d leastRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  const Eigen::Vector3d a = from.stableNormalized();
  const Eigen::Vector3d b = to.stableNormalized();
  if (!(a.norm() > 0.0) || !(b.norm() > 0.0))
  {
    return Eigen::Matrix3d::Identity();
  }
  Eigen::Vector3d bisector = a + b;
  const double length = bisector.norm();
  if (length < 1.0)
  {
    // Nearly opposite: the sum has lost digits. Its direction is known from its length, what is
    // left only chooses among rotations that are equally good.
    constexpr double Lost = 1e-15;
    const Eigen::Vector3d across = bisector - a.dot(bisector) * a;
    const Eigen::Vector3d axis =
      across.norm() > Lost ? Eigen::Vector3d(across.normalized()) : a.unitOrthogonal();
    const double half = 0.5 * length; // cosine of half the angle
    bisector = std::sqrt(1.0 - half * half) * axis + half * a;
  }
  // Half a turn about a, and half a turn about the bisector: orthogonal however close they are.
  const auto halfTurn = [](const Eigen::Vector3d& axis) -> Eigen::Matrix3d {
    return 2.0 * axis * axis.transpose() - Eigen::Matrix3d::Identity();
  };
  return halfTurn(bisector.normalized()) * halfTurn(a);
}
}
