// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/SurfaceSearch.h"

#include <Eigen/Geometry>

#include <cmath>

namespace hexsweep
{
namespace
{
/// Vertex normals weighted by the angles of the triangles at them.
Points vertexNormals(const TriangleMesh& surface)
{
  Points normals = Points::Zero(surface.points.rows(), 3);
  for (Index t = 0; t < surface.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index i = surface.triangles(t, c);
      const Eigen::RowVector3d u =
        surface.points.row(surface.triangles(t, (c + 1) % 3)) - surface.points.row(i);
      const Eigen::RowVector3d v =
        surface.points.row(surface.triangles(t, (c + 2) % 3)) - surface.points.row(i);
      const Eigen::RowVector3d cross = u.cross(v);
      const double length = cross.norm();
      if (length > 0.0)
      {
        normals.row(i) += std::atan2(length, u.dot(v)) / length * cross;
      }
    }
  }
  for (Index i = 0; i < normals.rows(); ++i)
  {
    normals.row(i).normalize();
  }
  return normals;
}
}

SurfaceSearch::SurfaceSearch(const TriangleMesh& surface)
  : Surface(surface)
  , VertexNormals(vertexNormals(surface))
  , Search(surface.points, surface.triangles)
{
}

SurfacePlaces SurfaceSearch::project(const PointsRef& points) const
{
  SurfacePlaces places{ Points(points.rows(), 3), Points(points.rows(), 3) };
  Index last = -1;
  for (Index i = 0; i < points.rows(); ++i)
  {
    const TrianglePoint place = this->Search.closest(points.row(i), last);
    last = place.triangle;
    Eigen::RowVector3d point = Eigen::RowVector3d::Zero();
    Eigen::RowVector3d normal = Eigen::RowVector3d::Zero();
    for (Index c = 0; c < 3; ++c)
    {
      const Index v = this->Surface.triangles(place.triangle, c);
      point += place.coordinates[c] * this->Surface.points.row(v);
      normal += place.coordinates[c] * this->VertexNormals.row(v);
    }
    places.points.row(i) = point;
    places.normals.row(i) = normal.normalized();
  }
  return places;
}
}
