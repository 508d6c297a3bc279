// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/AnnulusMap.h"

#include "Core/Common/Errors.h"
#include "Core/DiskMaps/DiskDomain.h"
#include "Core/DiskMaps/FilledDiskMap.h"
#include "Core/Solvers/DirichletSolver.h"

#include <cmath>

namespace hexsweep
{
namespace
{
AngleFunction angleAbout(const FilledDiskMap& map)
{
  const PlanePoints arms = map.disk.rowwise() - map.holes[0].center;
  AngleFunction angle;
  angle.values.resize(arms.rows());
  for (Index i = 0; i < arms.rows(); ++i)
  {
    angle.values[i] = std::atan2(arms(i, 1), arms(i, 0));
  }
  return angle;
}

/// Whether the differences along the three edges of each triangle sum to zero.
bool isClosed(const AngleFunction& angle, const TrianglesRef& triangles)
{
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    double sum = 0.0;
    for (Index c = 0; c < 3; ++c)
    {
      sum += wrapAngle(angle.values[triangles(t, (c + 1) % 3)] - angle.values[triangles(t, c)]);
    }
    if (std::abs(sum) > 1.0) // either rounding or a whole turn
    {
      return false;
    }
  }
  return true;
}

/// All weights one: an embedding of any cap \cite Tutte1963.
SparseMatrix graphLaplacian(Index numberOfPoints, const TrianglesRef& triangles)
{
  std::vector<Eigen::Triplet<double, int>> entries;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const int i = static_cast<int>(triangles(t, c));
      const int j = static_cast<int>(triangles(t, (c + 1) % 3));
      entries.insert(
        entries.end(), { { i, j, -1.0 }, { j, i, -1.0 }, { i, i, 1.0 }, { j, j, 1.0 } });
    }
  }
  SparseMatrix matrix(numberOfPoints, numberOfPoints);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}
}

AngleFunction windingAngle(const PointsRef& points, const TrianglesRef& triangles,
  const SparseMatrix& laplacian, const std::vector<Loop>& loops)
{
  const PlanePoints outer =
    circlePoints({ { 0.0, 0.0 }, 1.0 }, arcLengthAngles(loopPoints(points, loops[0])));
  AngleFunction angle = angleAbout(filledDiskMap(laplacian, points, loops, outer));
  if (isClosed(angle, triangles))
  {
    return angle;
  }
  angle = angleAbout(filledDiskMap(graphLaplacian(points.rows(), triangles), points, loops, outer));
  if (!isClosed(angle, triangles))
  {
    throw InvalidInput("no angle about the hole can be defined: the surface's triangulation is too "
                       "coarse or too distorted. Refine it, or smooth it first.");
  }
  return angle;
}

Eigen::VectorXd angleSource(const SparseMatrix& laplacian, const AngleFunction& angle)
{
  Eigen::VectorXd source = Eigen::VectorXd::Zero(laplacian.rows());
  for (Index j = 0; j < laplacian.outerSize(); ++j)
  {
    for (SparseMatrix::InnerIterator it(laplacian, j); it; ++it)
    {
      if (it.row() != j)
      {
        source[it.row()] -= it.value() * wrapAngle(angle.values[j] - angle.values[it.row()]);
      }
    }
  }
  return source;
}

Eigen::VectorXd conformalCorrection(
  const SparseMatrix& symmetricLaplacian, const AngleFunction& angle, Index pinned)
{
  std::vector<bool> fixed(static_cast<std::size_t>(symmetricLaplacian.rows()), false);
  fixed[static_cast<std::size_t>(pinned)] = true;
  const DirichletSolver solver(symmetricLaplacian, fixed);
  return solver.solve(
    Eigen::VectorXd::Zero(symmetricLaplacian.rows()), angleSource(symmetricLaplacian, angle));
}
}
