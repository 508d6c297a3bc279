// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The walk from triangle to triangle towards a point of the plane.
 */
#ifndef hexsweep_VisibilityWalk_h
#define hexsweep_VisibilityWalk_h

#include "Core/Geometry/PlaneTriangulation.h"

namespace hexsweep
{
/// The corner of a triangle (0, 1, 2) after this one.
inline std::uint32_t nextCorner(std::uint32_t corner)
{
  return corner == 2 ? 0 : corner + 1;
}

inline PlaneTriangulation::Point difference(
  const PlaneTriangulation::Point& a, const PlaneTriangulation::Point& b)
{
  return { a.x - b.x, a.y - b.y };
}

/// What a walk returns for a point inside of a triangle t: 4 t + NoSide, where a side 4 t + c has
/// c = 0, 1 or 2.
constexpr std::uint32_t NoSide = 3;

inline bool isInside(std::uint32_t arrived)
{
  return (arrived & 3u) == NoSide;
}

/**
 * Walks over edges that part the triangle from the point, any of them where there are two, and
 * never back over the one that it came over \cite DevillersPionTeillaud2002. Signs are exact, so
 * that a point is said to lie on a side only if it does.
 *
 * @param start the triangle to begin in.
 * @return a side (see PlaneTriangulation) of the triangle that was found on which the point lies;
 *         where it lies on none see isInside(); None where the walk left the mesh (over a hole or a
 *         gap) or grew long, as it may in circles.
 */
std::uint32_t visibilityWalk(
  const PlaneTriangulation& mesh, std::uint32_t start, const PlaneTriangulation::Point& q);
}

#endif
