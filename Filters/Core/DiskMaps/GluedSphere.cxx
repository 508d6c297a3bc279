// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/GluedSphere.h"

#include "Core/Common/Constants.h"
#include "Core/DiskMaps/DiskFill.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace hexsweep
{
namespace
{
using Complex = std::complex<double>;

/// How much the outer loop's mean weighs: little against the energies of maps, whose loops' is 2
/// pi.
constexpr double MeanWeight = 0.1;

/// What remains of the error that a change of the angles makes: less than the next change is.
constexpr double StepReduction = 0.03;

constexpr double Rounding = 1e-15;

/// Of conjugate gradients, at each change of the angles.
constexpr int GradientSteps = 40;

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

/// Loop by loop.
std::vector<Index> nodesOf(const std::vector<Loop>& loops)
{
  std::vector<Index> nodes;
  for (const Loop& loop : loops)
  {
    nodes.insert(nodes.end(), loop.begin(), loop.end());
  }
  return nodes;
}

/// What keeps the first loop's mean where it is, had each node a disk's even share of it.
Eigen::VectorXd anchor(const std::vector<Loop>& loops)
{
  Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Index>(nodesOf(loops).size()));
  const Index m = static_cast<Index>(loops[0].size());
  result.head(m).setConstant(MeanWeight * 2.0 * Pi / static_cast<double>(m));
  return result;
}

/// The Laplacian and the anchor; a one on the diagonal for points that no triangle uses.
SparseMatrix anchored(
  SparseMatrix laplacian, const Eigen::VectorXd& anchor, const std::vector<Loop>& loops)
{
  for (std::size_t i = 0; i < loops[0].size(); ++i)
  {
    laplacian.coeffRef(loops[0][i], loops[0][i]) += anchor[static_cast<Index>(i)];
  }
  std::vector<Eigen::Triplet<double, int>> ones;
  for (int i = 0; i < static_cast<int>(laplacian.rows()); ++i)
  {
    if (laplacian.outerIndexPtr()[i] == laplacian.outerIndexPtr()[i + 1])
    {
      ones.emplace_back(i, i, 1.0);
    }
  }
  if (!ones.empty())
  {
    SparseMatrix identity(laplacian.rows(), laplacian.rows());
    identity.setFromTriplets(ones.begin(), ones.end());
    laplacian += identity;
  }
  return laplacian;
}
}

GluedSphere::GluedSphere(
  const SparseMatrix& laplacian, const std::vector<Loop>& loops, const PointsRef& points)
  : GluedSphere(anchored(laplacian, anchor(loops), loops), loops, points, Anchored{})
{
}

GluedSphere::GluedSphere(const SparseMatrix& matrix, const std::vector<Loop>& loops,
  const PointsRef& points, Anchored /*tag*/)
  : Anchor(anchor(loops))
  , Solver(matrix, MultifrontalSolver::Kind::Cholesky, points)
  , LoopNodes(Solver.select(nodesOf(loops)))
  , Source(Eigen::MatrixXd::Zero(Anchor.size(), 2))
  , Image(Eigen::MatrixXd::Zero(Anchor.size(), 2))
  , CapForces(Eigen::MatrixXd::Zero(Anchor.size(), 2))
{
  this->Solver.factorize(matrix);
  this->First.push_back(0);
  for (const Loop& loop : loops)
  {
    this->First.push_back(this->First.back() + static_cast<Index>(loop.size()));
  }
}

PlanePoints GluedSphere::image(std::size_t loop) const
{
  return this->Image.middleRows(this->First[loop], this->First[loop + 1] - this->First[loop]);
}

void GluedSphere::glue(const Gluing& angles)
{
  this->Fills.clear();
  for (const std::vector<double>& loop : angles)
  {
    this->Fills.push_back(diskFillEnergy(loop));
  }
  const Eigen::MatrixXd moments = hatMoments(angles[0]);
  // The map is determined but for a translation: this puts the outer loop's mean at the origin.
  this->Fills[0] += MeanWeight / (2.0 * Pi) * moments.col(0) * moments.col(0).transpose();
  // In the outer disk the map is w + (what vanishes at infinity) with w = e^(i angle) on the loop.
  // The flow of w, and what the rest costs on account of w, put the same on each node.
  this->Source.topRows(moments.rows()) = 4.0 * moments.rightCols(2);
}

Eigen::MatrixXd GluedSphere::fillForces(const Eigen::MatrixXd& values) const
{
  Eigen::MatrixXd forces(values.rows(), 2);
  for (std::size_t p = 0; p < this->Fills.size(); ++p)
  {
    const Index size = this->First[p + 1] - this->First[p];
    for (Index c = 0; c < 2; ++c)
    {
      forces.col(c).segment(this->First[p], size).noalias() =
        this->Fills[p] * values.col(c).segment(this->First[p], size);
    }
  }
  return forces;
}

void GluedSphere::map(const Gluing& angles)
{
  this->glue(angles);
  const Index m = this->Source.rows();
  Eigen::MatrixXd residual = this->Source - this->CapForces - this->fillForces(this->Image);
  Eigen::MatrixXd direction = Eigen::MatrixXd::Zero(m, 2);
  Eigen::MatrixXd preconditioned = Eigen::MatrixXd::Zero(m, 2); // the factor's matrix by it
  Eigen::RowVector2d before = Eigen::RowVector2d::Ones();
  double enough = 0.0;
  for (int step = 0; step < GradientSteps; ++step)
  {
    const Eigen::MatrixXd correction = this->Solver.solve(this->LoopNodes, residual);
    const Eigen::RowVector2d now = residual.cwiseProduct(correction).colwise().sum();
    if (!(now.minCoeff() > 0.0))
    {
      return; // nothing is left but rounding
    }
    const Eigen::RowVector2d keep =
      step > 0 ? Eigen::RowVector2d(now.cwiseQuotient(before)) : Eigen::RowVector2d(0.0, 0.0);
    direction = correction + direction * keep.asDiagonal();
    preconditioned = residual + preconditioned * keep.asDiagonal();
    // The cap's matrix, its inner nodes eliminated, times the direction.
    const Eigen::MatrixXd capForces = preconditioned - this->Anchor.asDiagonal() * direction;
    const Eigen::MatrixXd forces = capForces + this->fillForces(direction);
    const Eigen::RowVector2d length =
      now.cwiseQuotient(direction.cwiseProduct(forces).colwise().sum());
    this->Image += direction * length.asDiagonal();
    this->CapForces += capForces * length.asDiagonal();
    residual -= forces * length.asDiagonal();
    before = now;
    const double gain = now.cwiseProduct(length).sum();
    if (step == 0)
    {
      enough = std::max(StepReduction * StepReduction * gain,
        Rounding * Rounding * this->Source.cwiseProduct(this->Image).sum());
    }
    if (gain <= enough)
    {
      return;
    }
  }
}
}
