// SPDX-License-Identifier: BSD-3-Clause
#include "Support/DenseTruth.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

namespace test
{
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric)
{
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly)
    .eigenvalues();
}

Eigen::MatrixXd denseSolution(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right)
{
  return matrix.fullPivLu().solve(right);
}

Eigen::MatrixXd leastSquaresSolution(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right)
{
  return matrix.colPivHouseholderQr().solve(right);
}
}
