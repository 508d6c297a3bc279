// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The pieces that a triangle falls into where edges of another triangulation cross it.
 */
#ifndef hexsweep_CrossedTriangle_h
#define hexsweep_CrossedTriangle_h

#include "Core/Common/Mesh.h"

#include <array>

namespace hexsweep
{
/// Ids of a piece's corners, in the direction of the triangle that it is part of.
using PieceIds = std::array<Index, 3>;

/**
 * Cuts a triangle along straight lines between points on its sides, which do not cross each other,
 * or from a corner to points on the side opposite. How many points lie on each side says which
 * points are joined (see triangleCrossings()); pieces with more than three corners are cut into the
 * fan whose least triangle is greatest.
 *
 * @param corners ids of the triangle's corners.
 * @param sides   sides[c]: ids of the points from corner c to corner c + 1, in this order, ends not
 *                included. Points on one side only are joined to the corner opposite; without any
 *                points the triangle itself comes back.
 * @param points  row i: place of the point with id i.
 */
std::vector<PieceIds> crossedTrianglePieces(const std::array<Index, 3>& corners,
  const std::array<std::vector<Index>, 3>& sides, const PointsRef& points);
}

#endif
