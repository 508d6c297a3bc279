// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/CapCorners.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexsweep
{
namespace
{
/// Below it a column is LeaningColumns; which side of the surface it is on, the others tell.
constexpr double LeastColumnHeight = 0.05;
constexpr Index CornersAtOnce = 4096;
}

double cornerScaledJacobian(
  const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& normal)
{
  return a.cross(b).dot(normal) / (a.norm() * b.norm());
}

CapCorners::CapCorners(const QuadsRef& quads, const std::vector<bool>& fixed,
  std::shared_ptr<const SurfaceSearch> surface, const std::vector<ColumnDirection>& columns,
  const PointsRef& start, LeaningColumns leaning, const ParallelFor& parallelFor)
  : CapQuads(quads)
  , Surface(std::move(surface))
  , Threads(parallelFor)
{
  const Points normals = this->Surface->normals(start, this->Threads);
  double area = 0.0;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    const Eigen::RowVector3d first = start.row(quads(q, 2)) - start.row(quads(q, 0));
    const Eigen::RowVector3d second = start.row(quads(q, 3)) - start.row(quads(q, 1));
    area += first.cross(second).dot(normals.row(quads(q, 0)));
  }
  this->Side = area < 0.0 ? -1.0 : 1.0;

  const std::vector<Index> columnOfNode = this->setColumns(columns, normals);

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
      if (corner.column >= 0 &&
        (this->ColumnHeights[corner.column] >= LeastColumnHeight ||
          (leaning == LeaningColumns::WhereUpright &&
            cornerScaledJacobian(start.row(corner.node[1]) - start.row(corner.node[0]),
              start.row(corner.node[2]) - start.row(corner.node[0]),
              this->ColumnNormals.row(corner.column)) > 0.0)))
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

CapCorners::CapCorners(
  const CapCorners& whole, const CellPatch& patch, const ParallelFor& parallelFor)
  : CapQuads(patch.corners)
  , Surface(whole.Surface)
  , Side(whole.Side)
  , ColumnNormals(whole.ColumnNormals)
  , ColumnHeights(whole.ColumnHeights)
  , Threads(parallelFor)
{
  for (std::size_t q = 0; q < patch.cells.size(); ++q)
  {
    const auto nodes = this->CapQuads.row(static_cast<Index>(q));
    // The whole's corners stand in the order of its quads.
    for (auto found = std::lower_bound(whole.Corners.begin(), whole.Corners.end(), patch.cells[q],
           [](const QuadCorner&corner, Index quad) { return corner.quad < quad; });
         found != whole.Corners.end() && found->quad == patch.cells[q]; ++found)
    {
      QuadCorner corner = *found;
      corner.quad = static_cast<Index>(q);
      corner.movable = false;
      for (Index i = 0; i < 3; ++i)
      {
        constexpr Index Steps[3] = { 0, 1, 3 };
        corner.node[i] = nodes[(corner.corner + Steps[i]) % 4];
        corner.movable = corner.movable || patch.free[static_cast<std::size_t>(corner.node[i])];
      }
      this->Corners.push_back(corner);
    }
  }
  for (std::size_t i = 0; i < patch.free.size(); ++i)
  {
    if (patch.free[i])
    {
      this->FreeNodes.push_back(static_cast<Index>(i));
    }
  }
}

std::vector<Index> CapCorners::setColumns(
  const std::vector<ColumnDirection>& columns, const PointsRef& normals)
{
  const Index count = static_cast<Index>(columns.size());
  this->ColumnNormals.resize(count, 3);
  this->ColumnHeights.resize(count);
  std::vector<Index> columnOfNode(static_cast<std::size_t>(normals.rows()), -1);
  for (Index c = 0; c < count; ++c)
  {
    const ColumnDirection& column = columns[static_cast<std::size_t>(c)];
    this->ColumnNormals.row(c) = column.direction.normalized();
    this->ColumnHeights[c] = this->Side * this->ColumnNormals.row(c).dot(normals.row(column.point));
    columnOfNode[static_cast<std::size_t>(column.point)] = c;
  }
  const double most = this->ColumnHeights.sum() < 0.0 ? -1.0 : 1.0;
  for (Index c = 0; c < count; ++c)
  {
    double& height = this->ColumnHeights[c];
    const double side = std::abs(height) < LeastColumnHeight ? most : std::copysign(1.0, height);
    this->ColumnNormals.row(c) *= side;
    height = std::abs(height);
  }
  return columnOfNode;
}

SurfacePlaces CapCorners::place(const PointsRef& points) const
{
  SurfacePlaces places = this->Surface->project(points, this->Threads);
  places.normals *= this->Side;
  return places;
}

Points CapCorners::normals(const PointsRef& points) const
{
  return this->Side * this->Surface->normals(points, this->Threads);
}

SurfacePlace CapCorners::place(const Eigen::RowVector3d& point, Index start) const
{
  SurfacePlace place = this->Surface->project(point, start);
  place.normal *= this->Side;
  return place;
}

double CapCorners::scaledJacobian(
  const QuadCorner& corner, const PointsRef& points, const PointsRef& normals) const
{
  return cornerScaledJacobian(points.row(corner.node[1]) - points.row(corner.node[0]),
    points.row(corner.node[2]) - points.row(corner.node[0]), this->normal(corner, normals));
}

std::vector<double> CapCorners::scaledJacobians(const PointsRef& points) const
{
  const Points normals = this->normals(points);
  std::vector<double> values(this->Corners.size());
  forPieces(
    this->Threads, static_cast<Index>(values.size()), CornersAtOnce, [&](Index begin, Index end) {
      for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c)
      {
        values[c] = this->scaledJacobian(this->Corners[c], points, normals);
      }
    });
  return values;
}

CornerQuality CapCorners::measure(const PointsRef& points) const
{
  const std::vector<double> jacobians = this->scaledJacobians(points);
  Eigen::VectorXd least = Eigen::VectorXd::Ones(this->CapQuads.rows());
  CornerQuality quality;
  for (std::size_t c = 0; c < jacobians.size(); ++c)
  {
    const QuadCorner& corner = this->Corners[c];
    const double jacobian = jacobians[c];
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

std::vector<Index> CapCorners::quadsBelow(double floor, const PointsRef& points) const
{
  const std::vector<double> jacobians = this->scaledJacobians(points);
  std::vector<Index> quads;
  for (std::size_t c = 0; c < jacobians.size(); ++c)
  {
    const QuadCorner& corner = this->Corners[c];
    if (corner.movable && (quads.empty() || quads.back() != corner.quad) && !(jacobians[c] > floor))
    {
      quads.push_back(corner.quad);
    }
  }
  return quads;
}
}
