// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/ConformalAnnulus.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Errors.h"
#include "Core/DiskMaps/HoleCut.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Solvers/DirichletSolver.h"
#include "Core/Surfaces/TriangleAngles.h"

#include <cmath>

namespace hexsweep
{
namespace
{

/// Harmonic angle: values at the vertices, and the energy of equation (2) of its differential.
struct HarmonicAngle
{
  Eigen::VectorXd values;
  double energy;
};

HarmonicAngle harmonicAngle(const PointsRef& points, const TrianglesRef& triangles,
  const SparseMatrix& laplacian, const std::vector<Index>& cut)
{
  // The jump is minus a turn on the left: followed counter-clockwise, the outer loop enters there.
  const Points jump = -2.0 * Pi * leftOfCut(triangles, cut).cast<double>();
  const Points cot = cotangents(points, triangles);
  Eigen::VectorXd source = Eigen::VectorXd::Zero(points.rows());
  double energy = 0.0;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    if (jump.row(t).isZero(0.0))
    {
      continue;
    }
    for (Index c = 0; c < 3; ++c)
    {
      const Index i = (c + 1) % 3;
      const Index j = (c + 2) % 3;
      const double flow = cot(t, c) * (jump(t, i) - jump(t, j));
      source[triangles(t, i)] -= flow;
      source[triangles(t, j)] += flow;
      energy += flow * (jump(t, i) - jump(t, j));
    }
  }
  std::vector<bool> pinned(static_cast<std::size_t>(points.rows()), false);
  pinned[static_cast<std::size_t>(cut.back())] = true;
  const Eigen::VectorXd values =
    DirichletSolver(laplacian, pinned, points).solve(Eigen::VectorXd::Zero(points.rows()), source);
  return { values, energy - source.dot(values) };
}
}

ConformalAnnulus conformalAnnulus(
  const PointsRef& points, const TrianglesRef& triangles, const std::vector<Loop>& loops)
{
  const SparseMatrix laplacian = cotangentLaplacian(points, triangles);
  Eigen::VectorXd height = Eigen::VectorXd::Zero(points.rows());
  for (const Index v : loops[1])
  {
    height[v] = 1.0;
  }
  ConformalAnnulus annulus;
  annulus.height =
    DirichletSolver(laplacian, boundaryFlags(points.rows(), loops), points).solve(height);
  HarmonicAngle angle = harmonicAngle(
    points, triangles, laplacian, shortestCut(triangles, points.rows(), loops[1], loops[0]));
  annulus.angle = std::move(angle.values);

  // Dirichlet integrals on a cylinder of length m and girth 2 pi: 2 pi / m and 2 pi m; equation (2)
  // is twice that.
  const double fromHeight = 4.0 * Pi / annulus.height.dot(laplacian * annulus.height);
  const double fromAngle = angle.energy / (4.0 * Pi);
  annulus.period = fromAngle / fromHeight;
  if (!(fromHeight > 0.0 && fromAngle > 0.0 && std::isfinite(annulus.period)))
  {
    throw InvalidInput("the conformal radius of the hole cannot be told: the triangulation is too "
                       "coarse or too distorted. Refine it, or improve it first.");
  }
  annulus.innerRadius = std::exp(-std::sqrt(fromHeight * fromAngle));
  return annulus;
}
}
