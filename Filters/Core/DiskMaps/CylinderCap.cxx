// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/CylinderCap.h"

#include "Core/Common/Constants.h"
#include "Core/DiskMaps/DiskDomain.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Solvers/DirichletSolver.h"

namespace hexsweep
{
CylinderCap measureCylinder(const SparseMatrix& laplacian, const PointsRef& points,
  const TrianglesRef& triangles, const std::vector<Loop>& loops)
{
  CylinderCap result;
  result.angle = windingAngle(points, triangles, laplacian, loops);
  result.correction = conformalCorrection(laplacian, result.angle, loops[0][0]);

  Eigen::VectorXd height = Eigen::VectorXd::Zero(points.rows());
  for (const Index v : loops[1])
  {
    height[v] = 1.0;
  }
  height = DirichletSolver(laplacian, boundaryFlags(points.rows(), loops), points).solve(height);
  // The Dirichlet integral of the height is 2 pi / log(R / r); equation (2) is twice that.
  result.logRadius = 4.0 * Pi / height.dot(laplacian * height);
  return result;
}

std::vector<double> loopAngles(const CylinderCap& cylinder, const Loop& loop)
{
  std::vector<double> angles;
  double angle = cylinder.angle.values[loop[0]];
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    if (k > 0)
    {
      angle += wrapAngle(cylinder.angle.values[loop[k]] - cylinder.angle.values[loop[k - 1]]);
    }
    angles.push_back(angle + cylinder.correction[loop[k]]);
  }
  return angles;
}

std::vector<double> monotoneLoopAngles(const CylinderCap& cylinder, const Loop& loop,
  const std::vector<double>& lengths, double direction)
{
  std::vector<double> angles = loopAngles(cylinder, loop);
  if (turnsOnce(angles, direction))
  {
    return angles;
  }
  double shift = 0.0;
  for (std::size_t k = 0; k < angles.size(); ++k)
  {
    shift += (angles[k] - direction * lengths[k]) / static_cast<double>(angles.size());
  }
  for (std::size_t k = 0; k < angles.size(); ++k)
  {
    angles[k] = direction * lengths[k] + shift;
  }
  return angles;
}
}
