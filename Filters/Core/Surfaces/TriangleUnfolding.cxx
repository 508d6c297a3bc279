// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/TriangleUnfolding.h"

#include <cmath>

namespace hexsweep
{
Eigen::RowVector2d unfoldedApex(
  const PlaneTriangle& triangle, const Eigen::RowVector2d& newFrom, const Eigen::RowVector2d& newTo)
{
  using Plane = Eigen::RowVector2d;
  const Plane& from = triangle.from;
  const Plane& to = triangle.to;
  const Plane& apex = triangle.apex;
  const Plane old = to - from;
  const Plane now = newTo - newFrom;
  const Plane turn =
    Plane(old.dot(now), cross(old, now)) / std::sqrt(old.squaredNorm() * now.squaredNorm());
  const auto turned = [&turn](const Plane& v) {
    return Plane(turn.x() * v.x() - turn.y() * v.y(), turn.y() * v.x() + turn.x() * v.y());
  };
  const bool nearFrom = (apex - from).squaredNorm() < (apex - to).squaredNorm();
  return nearFrom ? Plane(newFrom + turned(apex - from)) : Plane(newTo + turned(apex - to));
}
}
