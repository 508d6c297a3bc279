// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/DiskDomain.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Predicates.h"

#include <cmath>

namespace hexsweep
{
double wrapAngle(double angle)
{
  const double wrapped = std::remainder(angle, 2.0 * Pi);
  return wrapped <= -Pi ? wrapped + 2.0 * Pi : wrapped;
}

Eigen::RowVector2d wrapDomainPoint(DiskDomain domain, const Eigen::RowVector2d& point)
{
  if (domain != DiskDomain::Annulus)
  {
    return point;
  }
  const double turns = std::floor(point.y() / (2.0 * Pi));
  return { point.x(), point.y() - 2.0 * Pi * turns };
}

Eigen::Matrix<double, 3, 2, Eigen::RowMajor> domainCorners(DiskDomain domain,
  const PlanePointsRef& disk, const Eigen::Ref<const Eigen::Matrix<Index, 1, 3>>& triangle)
{
  Eigen::Matrix<double, 3, 2, Eigen::RowMajor> corners;
  for (Index c = 0; c < 3; ++c)
  {
    corners.row(c) = disk.row(triangle[c]);
    if (domain == DiskDomain::Annulus)
    {
      const double angle = std::atan2(corners(c, 1), corners(c, 0));
      corners(c, 0) = std::log(corners.row(c).norm());
      corners(c, 1) = c == 0 ? wrapDomainPoint(domain, { 0.0, angle }).y()
                             : corners(0, 1) + wrapAngle(angle - corners(0, 1));
    }
  }
  return corners;
}

DomainTriangles domainTriangles(
  DiskDomain domain, const PlanePointsRef& disk, const TrianglesRef& triangles)
{
  DomainTriangles result;
  std::vector<double> corners;
  const auto append = [&](const Eigen::Matrix<double, 3, 2, Eigen::RowMajor>& triangle,
                        double shift) {
    for (Index c = 0; c < 3; ++c)
    {
      corners.insert(corners.end(), { triangle(c, 0), triangle(c, 1) + shift, 0.0 });
    }
  };
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    const auto triangle = domainCorners(domain, disk, triangles.row(t));
    if (orientation(triangle.row(0), triangle.row(1), triangle.row(2)) <= 0)
    {
      result.flipped.push_back(t);
      continue;
    }
    append(triangle, 0.0);
    result.triangle.push_back(t);
    if (domain == DiskDomain::Annulus)
    {
      const double low = triangle.col(1).minCoeff();
      const double high = triangle.col(1).maxCoeff();
      for (const double shift : { -2.0 * Pi, 2.0 * Pi })
      {
        if (low + shift <= 2.0 * Pi && high + shift >= 0.0)
        {
          append(triangle, shift);
          result.triangle.push_back(t);
        }
      }
    }
  }
  result.corners =
    Eigen::Map<const Points>(corners.data(), static_cast<Index>(corners.size()) / 3, 3);
  return result;
}
}
