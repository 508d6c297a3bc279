// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/TriangleAngles.h"

#include <Eigen/Geometry>

#include <cmath>

namespace hexsweep
{
Eigen::RowVector3d cornerCotangents(const PointsRef& points, const TriangleRef& triangle)
{
  Eigen::RowVector3d result;
  for (Index c = 0; c < 3; ++c)
  {
    const Eigen::RowVector3d apex = points.row(triangle[c]);
    const Eigen::RowVector3d u = points.row(triangle[(c + 1) % 3]) - apex;
    const Eigen::RowVector3d v = points.row(triangle[(c + 2) % 3]) - apex;
    result[c] = u.dot(v) / u.cross(v).norm();
  }
  return result;
}

Points cotangents(const PointsRef& points, const TrianglesRef& triangles)
{
  Points result(triangles.rows(), 3);
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    result.row(t) = cornerCotangents(points, triangles.row(t));
  }
  return result;
}

double halfAngleTangent(const Eigen::RowVector3d& u, const Eigen::RowVector3d& v)
{
  return u.cross(v).norm() / (u.norm() * v.norm() + u.dot(v));
}

bool hasWeights(const PointsRef& points, const TriangleRef& triangle)
{
  bool finite = true;
  for (Index c = 0; c < 3; ++c)
  {
    const Eigen::RowVector3d corner = points.row(triangle[c]);
    const Eigen::RowVector3d u = points.row(triangle[(c + 1) % 3]) - corner;
    const Eigen::RowVector3d v = points.row(triangle[(c + 2) % 3]) - corner;
    const double tangent = halfAngleTangent(u, v);
    finite = finite && std::isfinite(u.dot(v) / u.cross(v).norm()) && std::isfinite(tangent) &&
      tangent > 0.0;
  }
  return finite;
}
}
