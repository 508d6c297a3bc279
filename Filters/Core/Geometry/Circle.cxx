// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Circle.h"

#include <cmath>

namespace hexsweep
{
PlanePoints circlePoints(const Circle& circle, const std::vector<double>& angles)
{
  PlanePoints points(static_cast<Index>(angles.size()), 2);
  for (std::size_t i = 0; i < angles.size(); ++i)
  {
    points.row(static_cast<Index>(i)) =
      circle.center + circle.radius * Eigen::RowVector2d(std::cos(angles[i]), std::sin(angles[i]));
  }
  return points;
}
}
