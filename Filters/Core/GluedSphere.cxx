// SPDX-License-Identifier: BSD-3-Clause
#include "GluedSphere.h"

#include "Constants.h"
#include "DiskFill.h"
#include "FillMesh.h"
#include "LoopGeometry.h"

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

/// Steps of conjugate gradients from nothing to a map, and from one map to the next; each gains
/// about a digit.
constexpr int StepsOfAMap = 4;
constexpr int StepsOfACorrection = 2;

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
  , Source(Eigen::MatrixXd::Zero(laplacian.rows(), 2))
{
  // Holes are filled where they are, the outer disk's mesh is turned inside out.
  std::vector<Eigen::RowVector3d> places;
  for (const Loop& loop : this->Loops)
  {
    this->FirstFillNode.push_back(laplacian.rows() + static_cast<Index>(places.size()));
    const Points ring = loopPoints(points, loop);
    const Eigen::RowVector3d center = ring.colwise().mean();
    const Points fill = fillMesh(arcLengthAngles(ring)).points;
    for (Index i = ring.rows(); i < fill.rows(); ++i)
    {
      const double radius = fill.row(i).norm();
      const double turn = std::atan2(fill(i, 1), fill(i, 0)) / (2.0 * Pi);
      const double along = (turn < 0.0 ? turn + 1.0 : turn) * static_cast<double>(ring.rows());
      const Index node = std::min(static_cast<Index>(along), ring.rows() - 1);
      const double reach = &loop == &this->Loops[0] ? 2.0 - radius : radius;
      places.emplace_back(center + reach * (ring.row(node) - center));
    }
  }
  this->FillPlaces.resize(laplacian.rows() + static_cast<Index>(places.size()), 3);
  this->FillPlaces.topRows(laplacian.rows()) = points;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    this->FillPlaces.row(laplacian.rows() + static_cast<Index>(i)) = places[i];
  }
}

SparseMatrix GluedSphere::approximation(const std::vector<std::vector<double>>& angles) const
{
  const Index n = this->FillPlaces.rows();
  Points points = Points::Zero(n, 3);
  std::vector<Triangles> meshes;
  Index count = 0;
  for (std::size_t p = 0; p < this->Loops.size(); ++p)
  {
    TriangleMesh fill = fillMesh(angles[p]);
    const Loop& loop = this->Loops[p];
    const Index m = static_cast<Index>(loop.size());
    const auto id = [&](Index i) {
      return i < m ? loop[static_cast<std::size_t>(i)] : this->FirstFillNode[p] + i - m;
    };
    for (Index i = 0; i < fill.points.rows(); ++i)
    {
      points.row(id(i)) = fill.points.row(i);
    }
    meshes.push_back(fill.triangles.unaryExpr(id));
    count += fill.triangles.rows();
  }
  Triangles triangles(count, 3);
  Index row = 0;
  for (const Triangles& mesh : meshes)
  {
    triangles.middleRows(row, mesh.rows()) = mesh;
    row += mesh.rows();
  }
  SparseMatrix cap = this->Laplacian;
  cap.conservativeResize(n, n);
  SparseMatrix sum = cap + cotangentLaplacian(points, triangles);
  const Eigen::MatrixXd moments = hatMoments(angles[0]);
  for (std::size_t i = 0; i < this->Loops[0].size(); ++i)
  {
    const Index v = this->Loops[0][i];
    sum.coeffRef(v, v) += MeanWeight * moments(static_cast<Index>(i), 0);
  }
  return sum;
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
  this->Fills[0] += MeanWeight / (2.0 * Pi) * moments.col(0) * moments.col(0).transpose();
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
  const SparseMatrix matrix = this->approximation(angles);
  if (!this->Solver)
  {
    this->Solver.emplace(matrix, MultifrontalSolver::Kind::Cholesky, this->FillPlaces);
  }
  this->Solver->factorize(matrix);
  this->Image = Eigen::MatrixXd::Zero(this->Laplacian.rows(), 2);
  this->improve(StepsOfAMap);
}

void GluedSphere::correct(const std::vector<std::vector<double>>& angles)
{
  this->glue(angles);
  this->improve(StepsOfACorrection);
}

Eigen::MatrixXd GluedSphere::apply(const Eigen::MatrixXd& image) const
{
  Eigen::MatrixXd result = this->Laplacian * image;
  for (std::size_t p = 0; p < this->Loops.size(); ++p)
  {
    const Loop& loop = this->Loops[p];
    Eigen::MatrixXd values(static_cast<Index>(loop.size()), 2);
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      values.row(static_cast<Index>(k)) = image.row(loop[k]);
    }
    values = (this->Fills[p] * values).eval();
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      result.row(loop[k]) += values.row(static_cast<Index>(k));
    }
  }
  return result;
}

void GluedSphere::improve(int steps)
{
  const Index n = this->Laplacian.rows();
  Eigen::MatrixXd extended = Eigen::MatrixXd::Zero(this->FillPlaces.rows(), 2);
  Eigen::MatrixXd residual = this->Source - this->apply(this->Image);
  Eigen::MatrixXd direction = Eigen::MatrixXd::Zero(n, 2);
  Eigen::RowVector2d before = Eigen::RowVector2d::Ones();
  for (int step = 0; step < steps; ++step)
  {
    extended.topRows(n) = residual;
    const Eigen::MatrixXd correction = this->Solver->solve(extended).topRows(n);
    const Eigen::RowVector2d now = residual.cwiseProduct(correction).colwise().sum();
    if (!(now.minCoeff() > 0.0))
    {
      return; // nothing is left but rounding
    }
    const Eigen::RowVector2d keep =
      step > 0 ? Eigen::RowVector2d(now.cwiseQuotient(before)) : Eigen::RowVector2d(0.0, 0.0);
    direction = correction + direction * keep.asDiagonal();
    const Eigen::MatrixXd effect = this->apply(direction);
    const Eigen::RowVector2d length =
      now.cwiseQuotient(direction.cwiseProduct(effect).colwise().sum());
    this->Image += direction * length.asDiagonal();
    residual -= effect * length.asDiagonal();
    before = now;
  }
}
}
