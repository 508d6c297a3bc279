// SPDX-License-Identifier: BSD-3-Clause
#include "GluedSphere.h"

#include "DiskFill.h"

#include <cmath>
#include <complex>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

using Complex = std::complex<double>;

/// Below this arc the closed form cancels more digits than its series leaves out.
constexpr double ShortArc = 1e-2;

/// Integrals over the circle of each node's hat function times (1, cos angle, sin angle).
Eigen::MatrixXd hatMoments(const std::vector<double>& angles)
{
  const std::size_t m = angles.size();
  Eigen::MatrixXd moments = Eigen::MatrixXd::Zero(static_cast<Index>(m), 3);
  const auto add = [&](std::size_t node, double arc, const Complex& moment) {
    moments.row(static_cast<Index>(node)) +=
      Eigen::RowVector3d(0.5 * arc, moment.real(), moment.imag());
  };
  for (std::size_t i = 0; i < m; ++i)
  {
    const std::size_t j = (i + 1) % m;
    const double d = angles[j] - angles[i] + (j == 0 ? 2.0 * Pi : 0.0);
    const double d2 = d * d;
    // Integral of (1 - t / d) e^(i t) over [0, d].
    const Complex falling = d > ShortArc
      ? (Complex(1.0, d) - std::polar(1.0, d)) / d
      : Complex(d / 2.0 * (1.0 - d2 / 12.0 + d2 * d2 / 360.0), d2 / 6.0 * (1.0 - d2 / 20.0));
    add(i, d, std::polar(1.0, angles[i]) * falling);
    add(j, d, std::polar(1.0, angles[j]) * std::conj(falling));
  }
  return moments;
}

/// Points that no triangle uses get a one on the diagonal, so that the matrix is not singular.
SparseMatrix withoutEmptyRows(SparseMatrix matrix)
{
  std::vector<Eigen::Triplet<double, int>> ones;
  for (int i = 0; i < static_cast<int>(matrix.rows()); ++i)
  {
    if (matrix.outerIndexPtr()[i] == matrix.outerIndexPtr()[i + 1])
    {
      ones.emplace_back(i, i, 1.0);
    }
  }
  if (!ones.empty())
  {
    SparseMatrix identity(matrix.rows(), matrix.rows());
    identity.setFromTriplets(ones.begin(), ones.end());
    matrix += identity;
  }
  return matrix;
}
}

GluedSphere::GluedSphere(
  const SparseMatrix& laplacian, std::vector<Loop> loops, const PointsRef& points)
  : Laplacian(withoutEmptyRows(laplacian))
  , Loops(std::move(loops))
  , Solver(Laplacian, MultifrontalSolver::Kind::Cholesky, Loops, points)
  , Source(Eigen::MatrixXd::Zero(laplacian.rows(), 2))
{
}

void GluedSphere::glue(const std::vector<std::vector<double>>& angles)
{
  this->Fills.clear();
  for (const std::vector<double>& loop : angles)
  {
    this->Fills.push_back(diskFillEnergy(loop));
  }
  const Eigen::MatrixXd moments = hatMoments(angles[0]);
  // The map is determined but for a translation: this puts the outer loop's mean at the origin.
  this->Fills[0] += moments.col(0) * moments.col(0).transpose() / (2.0 * Pi);
  // In the outer disk the map is w + (what vanishes at infinity) with w = e^(i angle) on the loop.
  // The flow of w, and what the rest costs on account of w, put the same on each node.
  for (std::size_t i = 0; i < this->Loops[0].size(); ++i)
  {
    this->Source.row(this->Loops[0][i]) = 4.0 * moments.row(static_cast<Index>(i)).tail<2>();
  }
}

void GluedSphere::map(const std::vector<std::vector<double>>& angles)
{
  this->glue(angles);
  this->Solver.factorize(this->Laplacian, this->Fills);
  this->Image = this->Solver.solve(this->Source);
}

void GluedSphere::correct(const std::vector<std::vector<double>>& angles)
{
  this->glue(angles);
  Eigen::MatrixXd residual = this->Source - this->Laplacian * this->Image;
  for (std::size_t p = 0; p < this->Loops.size(); ++p)
  {
    const Loop& loop = this->Loops[p];
    Eigen::MatrixXd values(static_cast<Index>(loop.size()), 2);
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      values.row(static_cast<Index>(k)) = this->Image.row(loop[k]);
    }
    values = (this->Fills[p] * values).eval();
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      residual.row(loop[k]) -= values.row(static_cast<Index>(k));
    }
  }
  this->Image += this->Solver.solve(residual);
}
}
