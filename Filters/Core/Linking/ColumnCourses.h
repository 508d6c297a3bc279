// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The ways of columns through the strip of their linking side.
 */
#ifndef hexsweep_ColumnCourses_h
#define hexsweep_ColumnCourses_h

#include "Core/Linking/StripSearch.h"

namespace hexsweep
{
/// Straight lines from where columns begin to where they end, and what they are moved aside.
struct ColumnCourses
{
  std::vector<double> begin; ///< v at u = 0, rising within less than 1
  std::vector<double> end;   ///< v at u = 1, rising within less than 1
  /// Row: column; what it is ahead of the straight line at evenly spaced heights from 0 to 1,
  /// linearly in between. Without columns where nothing is moved.
  Eigen::MatrixXd aside{ 0, 0 };

  std::size_t size() const { return this->begin.size(); }
  /// @return v at a height. @param u in [0, 1].
  double at(std::size_t column, double u) const;
};

/**
 * Moves columns aside so that they share each ring as they share the loops, by length.
 *
 * The harmonic map of a bent tube is a conformal one far from its ends: v changes faster on the
 * inside of the bend, so that straight columns crowd there and rings of other loops do not follow.
 * The length of rings has no such memory: sections of a torus or of a helix stay what they were at
 * the source.
 *
 * @param search  of the strip.
 * @param courses straight.
 * @param isHeld  one a column: stays; the others share the ring between those that stay. Where none
 *        stays, all are moved on so that they are where they were in the mean.
 */
Eigen::MatrixXd asideByLength(
  const StripSearch& search, const ColumnCourses& courses, const std::vector<bool>& isHeld);
}

#endif
