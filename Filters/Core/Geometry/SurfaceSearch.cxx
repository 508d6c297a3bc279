// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/SurfaceSearch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
namespace
{
constexpr Index PointsAtOnce = 1024;

/// Places nearer to an edge than this share of the triangle, or whose squared distance from it is
/// less than this share of that from the surface, may be as near to the triangle across, to
/// rounding.
constexpr double EdgeSlack = 1e-9;

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

/// The normal of a plane that all triangles lie in, to rounding, and look the same way from.
std::optional<Eigen::RowVector3d> planeNormal(const TriangleMesh& surface)
{
  constexpr double Rounding = 64.0 * std::numeric_limits<double>::epsilon();
  const auto areaVector = [&](Index t) -> Eigen::RowVector3d {
    const Eigen::RowVector3d a = surface.points.row(surface.triangles(t, 0));
    const Eigen::RowVector3d b = surface.points.row(surface.triangles(t, 1)) - a;
    return b.cross(surface.points.row(surface.triangles(t, 2)) - a);
  };
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (Index t = 0; t < surface.triangles.rows(); ++t)
  {
    sum += areaVector(t);
  }
  const Eigen::RowVector3d normal = sum.normalized();
  if (!(sum.norm() > 0.0) || !normal.allFinite())
  {
    return std::nullopt;
  }
  const double slack = Rounding * surface.points.cwiseAbs().maxCoeff();
  const double height = normal.dot(surface.points.row(surface.triangles(0, 0)));
  for (Index t = 0; t < surface.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      if (!(std::abs(normal.dot(surface.points.row(surface.triangles(t, c))) - height) <= slack))
      {
        return std::nullopt;
      }
    }
    if (!(areaVector(t).dot(normal) > 0.0))
    {
      return std::nullopt;
    }
  }
  return normal;
}
}

SurfaceSearch::SurfaceSearch(const TriangleMesh& surface)
  : Surface(surface)
  , VertexNormals(vertexNormals(surface))
  , Search(surface.points, surface.triangles)
  , PlaneNormal(planeNormal(surface))
{
}

Points SurfaceSearch::normals(const PointsRef& points, const ParallelFor& parallelFor) const
{
  if (this->PlaneNormal)
  {
    return this->PlaneNormal->replicate(points.rows(), 1);
  }
  return this->project(points, parallelFor).normals;
}

SurfacePlaces SurfaceSearch::project(
  const PointsRef& points, const ParallelFor& parallelFor, const std::vector<Index>& starts) const
{
  SurfacePlaces places{ Points(points.rows(), 3), Points(points.rows(), 3),
    std::vector<Index>(static_cast<std::size_t>(points.rows()), -1) };
  forPieces(parallelFor, points.rows(), PointsAtOnce, [&](Index begin, Index end) {
    Index last = -1; // what is near is found faster, and is the same
    for (Index i = begin; i < end; ++i)
    {
      const auto k = static_cast<std::size_t>(i);
      const SurfacePlace place =
        this->project(points.row(i), starts.empty() || starts[k] < 0 ? last : starts[k]);
      last = place.triangle;
      places.triangles[k] = place.triangle;
      places.points.row(i) = place.point;
      places.normals.row(i) = place.normal;
    }
  });
  return places;
}

TrianglePoint SurfaceSearch::nearest(const Eigen::RowVector3d& asked, Index start) const
{
  // No triangle of a plane is nearer than the one that the perpendicular meets inside.
  if (this->PlaneNormal && start >= 0)
  {
    const Eigen::RowVector3d a = this->Surface.points.row(this->Surface.triangles(start, 0));
    const Eigen::RowVector3d b = this->Surface.points.row(this->Surface.triangles(start, 1));
    const Eigen::RowVector3d c = this->Surface.points.row(this->Surface.triangles(start, 2));
    TrianglePoint place = closestPointOnTriangle(asked, a, b, c);
    const double area = (b - a).cross(c - a).dot(*this->PlaneNormal); // doubled
    const double longest2 =
      std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() });
    const double toEdge = place.coordinates.minCoeff() * area; // at least, times the longest edge
    if (toEdge > EdgeSlack * area &&
      toEdge * toEdge > EdgeSlack * longest2 * place.distance * place.distance)
    {
      place.triangle = start;
      return place;
    }
  }
  return this->Search.closest(asked, start);
}

SurfacePlace SurfaceSearch::project(const Eigen::RowVector3d& asked, Index start) const
{
  const TrianglePoint place = this->nearest(asked, start);
  Eigen::RowVector3d point = Eigen::RowVector3d::Zero();
  Eigen::RowVector3d normal = Eigen::RowVector3d::Zero();
  for (Index c = 0; c < 3; ++c)
  {
    const Index v = this->Surface.triangles(place.triangle, c);
    point += place.coordinates[c] * this->Surface.points.row(v);
    normal += place.coordinates[c] * this->VertexNormals.row(v);
  }
  return { point, normal.normalized(), place.triangle };
}
}
