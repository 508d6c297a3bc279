// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/CapCorners.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
/// A column that leans more than this out of the normal says nothing about the quads below it.
constexpr double LeastColumnHeight = 0.05;
}

double cornerScaledJacobian(
  const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& normal)
{
  return a.cross(b).dot(normal) / (a.norm() * b.norm());
}

CapCorners::CapCorners(const QuadsRef& quads, const std::vector<bool>& fixed,
  const TriangleMesh& surface, const std::vector<ColumnDirection>& columns, const PointsRef& start)
  : CapQuads(quads)
  , Surface(surface)
{
  const SurfacePlaces places = this->Surface.project(start);
  double area = 0.0;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    const Eigen::RowVector3d first = start.row(quads(q, 2)) - start.row(quads(q, 0));
    const Eigen::RowVector3d second = start.row(quads(q, 3)) - start.row(quads(q, 1));
    area += first.cross(second).dot(places.normals.row(quads(q, 0)));
  }
  this->Side = area < 0.0 ? -1.0 : 1.0;

  std::vector<Index> columnOfNode(fixed.size(), -1);
  this->ColumnNormals.resize(static_cast<Index>(columns.size()), 3);
  for (std::size_t c = 0; c < columns.size(); ++c)
  {
    const Eigen::RowVector3d along = columns[c].direction.normalized();
    const double height = this->Side * along.dot(places.normals.row(columns[c].point));
    if (std::abs(height) >= LeastColumnHeight)
    {
      this->ColumnNormals.row(static_cast<Index>(c)) = height < 0.0 ? -along : along;
      columnOfNode[static_cast<std::size_t>(columns[c].point)] = static_cast<Index>(c);
    }
  }

  const auto isFixed = [&](Index node) { return fixed[static_cast<std::size_t>(node)]; };
  std::vector<bool> used(fixed.size(), false);
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      QuadCorner corner{ { quads(q, c), quads(q, (c + 1) % 4), quads(q, (c + 3) % 4) }, q, c, -1,
        false };
      used[static_cast<std::size_t>(corner.node[0])] = true;
      corner.movable =
        !isFixed(corner.node[0]) || !isFixed(corner.node[1]) || !isFixed(corner.node[2]);
      this->Corners.push_back(corner);
      corner.column = columnOfNode[static_cast<std::size_t>(corner.node[0])];
      if (corner.column >= 0)
      {
        this->Corners.push_back(corner);
      }
    }
  }
  for (std::size_t i = 0; i < fixed.size(); ++i)
  {
    if (used[i] && !fixed[i])
    {
      this->FreeNodes.push_back(static_cast<Index>(i));
    }
  }
}

SurfacePlaces CapCorners::place(const PointsRef& points) const
{
  SurfacePlaces places = this->Surface.project(points);
  places.normals *= this->Side;
  return places;
}

CornerQuality CapCorners::measure(const PointsRef& points) const
{
  const SurfacePlaces places = this->place(points);
  Eigen::VectorXd least = Eigen::VectorXd::Ones(this->CapQuads.rows());
  CornerQuality quality;
  for (const QuadCorner& corner : this->Corners)
  {
    const double jacobian =
      cornerScaledJacobian(points.row(corner.node[1]) - points.row(corner.node[0]),
        points.row(corner.node[2]) - points.row(corner.node[0]),
        this->normal(corner, places.normals));
    (corner.movable ? quality.inverted : quality.fixedInverted) += jacobian > 0.0 ? 0 : 1;
    const double value = std::isnan(jacobian) ? -1.0 : jacobian;
    if (corner.movable)
    {
      quality.minimum = std::min(quality.minimum, value);
    }
    if (corner.column < 0)
    {
      least[corner.quad] = std::min(least[corner.quad], value);
    }
  }
  quality.mean = least.mean();
  return quality;
}
}
