// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SurfaceFolds.h"

#include "Core/Surfaces/SurfaceTopology.h"

#include <Eigen/Geometry>

namespace hexsweep
{
namespace
{
constexpr double Facing = 0.7071067811865476;    // cosine of 45 degrees
constexpr double Opposite = -0.9396926207859084; // of 180 less 20
constexpr double LeastHeight = 1e-3;             // over the edge
}

std::optional<SurfaceFold> findFold(const TriangleMesh& surface)
{
  const Index count = surface.triangles.rows();
  Points areas(count, 3); // doubled
  for (Index t = 0; t < count; ++t)
  {
    const Eigen::RowVector3d a = surface.points.row(surface.triangles(t, 0));
    const Eigen::RowVector3d b = surface.points.row(surface.triangles(t, 1)) - a;
    areas.row(t) = b.cross(surface.points.row(surface.triangles(t, 2)) - a);
  }
  const Eigen::RowVector3d up = areas.colwise().sum().normalized();
  const auto facing = [&](Index t) { return areas.row(t).dot(up) / areas.row(t).norm(); };
  const Triangles neighbors = triangleNeighbors(surface.triangles);
  for (Index t = 0; t < count; ++t)
  {
    if (!(facing(t) < -Facing))
    {
      continue;
    }
    for (Index c = 0; c < 3; ++c)
    {
      const Index other = neighbors(t, c);
      const Eigen::RowVector3d from = surface.points.row(surface.triangles(t, c));
      const Eigen::RowVector3d to = surface.points.row(surface.triangles(t, (c + 1) % 3));
      const double least = LeastHeight * (to - from).squaredNorm();
      if (other >= 0 && facing(other) > Facing && areas.row(t).norm() > least &&
        areas.row(other).norm() > least &&
        areas.row(t).dot(areas.row(other)) <
          Opposite * areas.row(t).norm() * areas.row(other).norm())
      {
        return SurfaceFold{ other, t, 0.5 * (from + to) };
      }
    }
  }
  return std::nullopt;
}
}
