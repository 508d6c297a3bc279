// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SurfaceMoments.h"

#include "Core/Common/Constants.h"
#include "Core/Surfaces/HalfEdgeTriangles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
constexpr double SharpTurn = Pi / 6.0;

Eigen::RowVector3d triangleAreaVector(const TriangleMesh& surface, Index t)
{
  const Eigen::RowVector3d a = surface.points.row(surface.triangles(t, 0));
  const Eigen::RowVector3d u = surface.points.row(surface.triangles(t, 1)) - a;
  const Eigen::RowVector3d v = surface.points.row(surface.triangles(t, 2)) - a;
  return 0.5 * u.cross(v);
}
}

SurfaceMoments surfaceMoments(const TriangleMesh& surface)
{
  // About a point of the surface: far from the origin plain sums lose digits.
  const Eigen::RowVector3d origin = surface.points.row(surface.triangles(0, 0));
  SurfaceMoments moments;
  Eigen::RowVector3d first = Eigen::RowVector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (Index t = 0; t < surface.triangles.rows(); ++t)
  {
    const Eigen::RowVector3d vector = triangleAreaVector(surface, t);
    const double area = vector.norm();
    Eigen::Matrix3d corners; // a row each
    for (int c = 0; c < 3; ++c)
    {
      corners.row(c) = surface.points.row(surface.triangles(t, c)) - origin;
    }
    const Eigen::RowVector3d sum = corners.colwise().sum();
    moments.area += area;
    moments.areaVector += vector;
    first += area / 3.0 * sum;
    second += area / 12.0 * (corners.transpose() * corners + sum.transpose() * sum);
  }
  const Eigen::RowVector3d mean = first / moments.area;
  moments.center = origin + mean;
  moments.covariance = second / moments.area - mean.transpose() * mean;
  return moments;
}

double facetSagitta(const TriangleMesh& surface)
{
  const HalfEdgeTriangles edges(surface.triangles);
  double greatest = 0.0;
  for (Index half = 0; half < edges.numberOfHalfEdges(); ++half)
  {
    const Index twin = edges.twin(half);
    if (twin < half)
    {
      continue;
    }
    const Eigen::RowVector3d own = triangleAreaVector(surface, half / 3);
    const Eigen::RowVector3d other = triangleAreaVector(surface, twin / 3);
    const double turn = std::atan2(own.cross(other).norm(), own.dot(other));
    const double length =
      (surface.points.row(edges.from(half)) - surface.points.row(edges.to(half))).norm();
    if (turn < SharpTurn)
    {
      greatest = std::max(greatest, 2.0 * std::max(own.norm(), other.norm()) / length * turn / 8.0);
    }
  }
  return greatest;
}
}
