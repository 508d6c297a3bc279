// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SurfaceArea.h"

#include <Eigen/Geometry>

namespace hexsweep
{
double surfaceArea(const TriangleMesh& mesh)
{
  double area = 0.0;
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = mesh.points.row(mesh.triangles(t, 0));
    const Eigen::RowVector3d b = mesh.points.row(mesh.triangles(t, 1));
    const Eigen::RowVector3d c = mesh.points.row(mesh.triangles(t, 2));
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  return area;
}
}
