// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Lays the triangle beyond an edge into the plane of the one before it.
 */
#ifndef hexsweep_TriangleUnfolding_h
#define hexsweep_TriangleUnfolding_h

#include <Eigen/Core>

namespace hexsweep
{
/// A triangle in a plane of its own, counter-clockwise.
struct PlaneTriangle
{
  Eigen::RowVector2d from;
  Eigen::RowVector2d to;
  Eigen::RowVector2d apex;
};

/// Twice the signed area that u and v span: positive where v lies left of u.
inline double cross(const Eigen::RowVector2d& u, const Eigen::RowVector2d& v)
{
  return u.x() * v.y() - u.y() * v.x();
}

/**
 * The apex once the triangle is turned and shifted (not scaled) so that its side runs from
 * `newFrom` towards `newTo`.
 *
 * The side and its image are the same edge, known in two planes; their lengths may differ by
 * rounding. The apex is reckoned from the end that it is nearer to, so that the apex of a needle
 * keeps its digits.
 *
 * @param triangle whose side from `from` to `to` has a length.
 */
Eigen::RowVector2d unfoldedApex(const PlaneTriangle& triangle, const Eigen::RowVector2d& newFrom,
  const Eigen::RowVector2d& newTo);
}

#endif
