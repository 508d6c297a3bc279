// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/RevolvedSpace.h"

#include "Core/Common/Constants.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr double LeastRadius = 1e-3; // of the extent
constexpr double LeastGap = 15.0 * Pi / 180.0;
constexpr double LeastPlaneAngle = 5.0 * Pi / 180.0;
constexpr double IsPlane = 1.0 - 1e-6;
constexpr std::size_t MostPlanes = 12;

struct FacePlane
{
  double area = 0.0;
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero(); ///< of area vectors
  Eigen::RowVector3d point = Eigen::RowVector3d::Zero();
};

/// The largest plane faces.
std::vector<FacePlane> planesOf(const SolidSurface& solid)
{
  std::map<Index, FacePlane> faces;
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = solid.points.row(solid.triangles(t, 0));
    const Eigen::RowVector3d b = solid.points.row(solid.triangles(t, 1));
    const Eigen::RowVector3d c = solid.points.row(solid.triangles(t, 2));
    const Eigen::RowVector3d vector = 0.5 * (b - a).cross(c - a);
    FacePlane& face = faces[solid.faceIds[static_cast<std::size_t>(t)]];
    face.area += vector.norm();
    face.sum += vector;
    face.point = a;
  }
  std::vector<FacePlane> planes;
  for (const auto& [id, face] : faces)
  {
    if (face.area > 0.0 && face.sum.norm() > IsPlane * face.area)
    {
      planes.push_back(face);
    }
  }
  std::stable_sort(planes.begin(), planes.end(),
    [](const FacePlane& a, const FacePlane& b) { return a.area > b.area; });
  planes.resize(std::min(planes.size(), MostPlanes));
  return planes;
}

std::optional<RevolutionAxis> lineBetween(const FacePlane& first, const FacePlane& second)
{
  const Eigen::RowVector3d a = first.sum.normalized();
  const Eigen::RowVector3d b = second.sum.normalized();
  const Eigen::RowVector3d direction = a.cross(b);
  if (direction.norm() < std::sin(LeastPlaneAngle))
  {
    return std::nullopt;
  }
  Eigen::Matrix3d equations;
  equations << a, b, direction;
  const Eigen::Vector3d sides(a.dot(first.point), b.dot(second.point), direction.dot(first.point));
  return RevolutionAxis{ (equations.inverse() * sides).transpose(), direction };
}
}

RevolvedSpace::RevolvedSpace(const RevolutionAxis& axis, const PointsRef& points)
  : Axis(axis)
{
  this->Axis.direction.normalize();
  this->Outward = this->Axis.direction.unitOrthogonal();
  this->Around = this->Axis.direction.cross(this->Outward);
  std::vector<double> angles;
  double radii = 0.0;
  for (Index i = 0; i < points.rows(); ++i)
  {
    angles.push_back(this->angle(points.row(i)));
    radii += (points.row(i) - this->Axis.point).cross(this->Axis.direction).norm();
  }
  this->Radius = radii / static_cast<double>(points.rows());
  std::sort(angles.begin(), angles.end());
  double gap = angles.front() + 2.0 * Pi - angles.back();
  double begin = angles.front() - 0.5 * gap;
  for (std::size_t i = 1; i < angles.size(); ++i)
  {
    if (angles[i] - angles[i - 1] > gap)
    {
      gap = angles[i] - angles[i - 1];
      begin = angles[i] - 0.5 * gap;
    }
  }
  // Angles are in (-pi, pi]: the cut between them lies in the gap.
  const double turn = begin + Pi;
  const Eigen::RowVector3d outward = std::cos(turn) * this->Outward + std::sin(turn) * this->Around;
  this->Outward = outward;
  this->Around = this->Axis.direction.cross(outward);
}

double RevolvedSpace::angle(const Eigen::RowVector3d& point) const
{
  const Eigen::RowVector3d way = point - this->Axis.point;
  return std::atan2(way.dot(this->Around), way.dot(this->Outward));
}

std::optional<RevolvedSpace> RevolvedSpace::make(
  const RevolutionAxis& axis, const PointsRef& points)
{
  if (points.rows() == 0 || !(axis.direction.norm() > 0.0))
  {
    return std::nullopt;
  }
  const RevolvedSpace space(axis, points);
  const double extent = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
  const Points straight = space.straight(points);
  const double most = (Pi - 0.5 * LeastGap) * space.Radius;
  if (!(straight.col(1).minCoeff() > LeastRadius * extent) ||
    !(straight.col(2).cwiseAbs().maxCoeff() < most))
  {
    return std::nullopt;
  }
  return space;
}

Points RevolvedSpace::straight(const PointsRef& points) const
{
  Points result(points.rows(), 3);
  for (Index i = 0; i < points.rows(); ++i)
  {
    const Eigen::RowVector3d point = points.row(i);
    const Eigen::RowVector3d way = point - this->Axis.point;
    result.row(i) << way.dot(this->Axis.direction), way.cross(this->Axis.direction).norm(),
      this->Radius * this->angle(point);
  }
  return result;
}

Points RevolvedSpace::revolved(const PointsRef& points) const
{
  Points result(points.rows(), 3);
  for (Index i = 0; i < points.rows(); ++i)
  {
    const double angle = points(i, 2) / this->Radius;
    result.row(i) = this->Axis.point + points(i, 0) * this->Axis.direction +
      points(i, 1) * (std::cos(angle) * this->Outward + std::sin(angle) * this->Around);
  }
  return result;
}

std::optional<RevolvedStack> revolvedStack(
  const SolidSurface& solid, const RevolutionAxis& axis, double draft)
{
  const std::optional<RevolvedSpace> space = RevolvedSpace::make(axis, solid.points);
  if (!space)
  {
    return std::nullopt;
  }
  SolidSurface straight = solid;
  straight.points = space->straight(solid.points);
  CapLikeFaces faces = capLikeFaces(straight, Eigen::RowVector3d::UnitZ(), draft);
  return RevolvedStack{ *space, std::move(straight), std::move(faces) };
}

std::optional<RevolvedStack> findRevolvedStack(const SolidSurface& solid, double draft)
{
  const std::vector<FacePlane> planes = planesOf(solid);
  std::optional<RevolvedStack> best;
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const std::optional<RevolutionAxis> axis = lineBetween(planes[j], planes[i]);
      std::optional<RevolvedStack> stack = axis ? revolvedStack(solid, *axis, draft) : std::nullopt;
      if (stack && stack->faces.isStack() && stack->faces.tops > 0 && stack->faces.bottoms > 0 &&
        (!best ||
          stack->faces.tops + stack->faces.bottoms < best->faces.tops + best->faces.bottoms))
      {
        best = std::move(stack);
      }
    }
  }
  return best;
}
}
