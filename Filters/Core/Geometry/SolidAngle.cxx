// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/SolidAngle.h"

#include <Eigen/Geometry>

#include <cmath>

namespace hexsweep
{
double solidAngle(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b,
  const Eigen::RowVector3d& c, const Eigen::RowVector3d& eye)
{
  const Eigen::RowVector3d u = a - eye;
  const Eigen::RowVector3d v = b - eye;
  const Eigen::RowVector3d w = c - eye;
  const double volume = u.dot(v.cross(w));
  if (volume == 0.0)
  {
    return 0.0;
  }
  return 2.0 *
    std::atan2(volume,
      u.norm() * v.norm() * w.norm() + u.dot(v) * w.norm() + v.dot(w) * u.norm() +
        w.dot(u) * v.norm());
}
}
