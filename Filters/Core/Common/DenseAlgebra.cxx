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
  constexpr double Opposite = 1e-12; // of 1 + cosine
  const Eigen::Vector3d a = from.normalized();
  const Eigen::Vector3d b = to.normalized();
  const double cosine = a.dot(b);
  if (1.0 + cosine < Opposite)
  {
    const Eigen::Vector3d axis = a.unitOrthogonal();
    return 2.0 * axis * axis.transpose() - Eigen::Matrix3d::Identity();
  }
  const Eigen::Vector3d axis = a.cross(b);
  Eigen::Matrix3d cross;
  cross << 0.0, -axis.z(), axis.y(), axis.z(), 0.0, -axis.x(), -axis.y(), axis.x(), 0.0;
  return cosine * Eigen::Matrix3d::Identity() + cross + axis * axis.transpose() / (1.0 + cosine);
}
}
