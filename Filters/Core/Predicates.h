// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Exact orientation of three points of the plane.
 */
#ifndef hexsweep_Predicates_h
#define hexsweep_Predicates_h

#include <Eigen/Core>

namespace hexsweep
{
/**
 * The sign of the area of the triangle a, b, c: 1 counter-clockwise, -1 clockwise, 0 collinear.
 *
 * Exact for all finite doubles whose products neither overflow nor underflow. A floating-point
 * filter decides almost always; what it leaves open is evaluated as an exact sum of six two-term
 * products (T. J. Dekker, "A floating-point technique for extending the available precision",
 * 1971; J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
 * predicates", 1997).
 */
int orientation(
  const Eigen::RowVector2d& a, const Eigen::RowVector2d& b, const Eigen::RowVector2d& c);
}

#endif
