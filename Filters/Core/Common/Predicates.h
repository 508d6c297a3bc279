// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Exact orientation of three points of the plane.
 */
#ifndef hexsweep_Predicates_h
#define hexsweep_Predicates_h

#include <Eigen/Core>

#include <cmath>
#include <limits>

namespace hexsweep
{
/**
 * Bound of the rounding error of u v - w z, as a multiple of |u v| + |w z|, where u, v, w and z are
 * differences of two doubles (J. R. Shewchuk \cite Shewchuk1997).
 */
constexpr double OrientationErrorBound =
  (3.0 + 8.0 * std::numeric_limits<double>::epsilon()) * std::numeric_limits<double>::epsilon() / 2;

/// orientation() without its filter: an exact sum of six two-term products.
int exactOrientation(
  const Eigen::RowVector2d& a, const Eigen::RowVector2d& b, const Eigen::RowVector2d& c);

/**
 * The sign of the area of the triangle a, b, c: 1 counter-clockwise, -1 clockwise, 0 collinear.
 *
 * Exact for all finite doubles whose products neither overflow nor underflow. A floating-point
 * filter decides almost always; what it leaves open is evaluated as an exact sum of six two-term
 * products \cite Dekker1971, \cite Shewchuk1997.
 */
inline int orientation(
  const Eigen::RowVector2d& a, const Eigen::RowVector2d& b, const Eigen::RowVector2d& c)
{
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double area = left - right;
  if (std::abs(area) > OrientationErrorBound * (std::abs(left) + std::abs(right)))
  {
    return area > 0.0 ? 1 : -1;
  }
  return exactOrientation(a, b, c);
}
}

#endif
