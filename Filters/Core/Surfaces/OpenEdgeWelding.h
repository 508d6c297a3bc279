// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Joins triangles that repeat the points of their common edges, as STL and CAD exports do.
 */
#ifndef hexsweep_OpenEdgeWelding_h
#define hexsweep_OpenEdgeWelding_h

#include "Core/Common/Mesh.h"

#include <vector>

namespace hexsweep
{
/**
 * Which points coincide. Only points on edges with one triangle are looked at, and the ends of
 * edges without length, so that surfaces that touch without being joined stay apart.
 *
 * Points that are equal to the last bit are joined first, then those on edges that are still open
 * and nearer than the tolerance. Costs O(n) where there is nothing to join, O(n log n) otherwise.
 *
 * @param points         n x 3; those of the triangles are finite.
 * @param triangles      m x 3 ids in [0, n).
 * @param matchTolerance relative to the shortest edge at a point, in [0, 0.5).
 * @return n entries: the smallest id of the points that each one coincides with (its own, if none).
 */
std::vector<Index> weldOpenEdges(
  const PointsRef& points, const TrianglesRef& triangles, double matchTolerance);
}

#endif
