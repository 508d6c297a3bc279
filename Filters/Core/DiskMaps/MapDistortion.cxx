// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/MapDistortion.h"

#include "Core/Common/Constants.h"
#include "Core/Surfaces/TriangleAngles.h"

#include <cmath>

namespace hexsweep
{
namespace
{
constexpr double Degrees = 180.0 / Pi;
}

MapDistortion mapDistortion(const CapDisk& cap)
{
  MapDistortion result;
  const Triangles& triangles = cap.mesh.triangles;
  const Points cot = cotangents(cap.mesh.points, triangles);
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    const auto corner = domainCorners(cap.domain, cap.disk, triangles.row(t));
    for (Index c = 0; c < 3; ++c)
    {
      const Eigen::RowVector2d u = corner.row((c + 1) % 3) - corner.row(c);
      const Eigen::RowVector2d v = corner.row((c + 2) % 3) - corner.row(c);
      // A flipped triangle has angles of the other sign.
      const double angle = std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
      const double difference = std::abs(angle - std::atan2(1.0, cot(t, c))) * Degrees;
      result.worstAngle = std::max(result.worstAngle, difference);
      result.meanAngle += difference / static_cast<double>(3 * triangles.rows());
      result.dirichletEnergy += 0.25 * cot(t, c) * (v - u).squaredNorm();
    }
  }
  return result;
}
}
