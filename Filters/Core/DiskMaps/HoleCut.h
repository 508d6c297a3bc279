// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cut from a hole to the outer loop (paper section 3.1.2, step 1).
 */
#ifndef hexsweep_HoleCut_h
#define hexsweep_HoleCut_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/**
 * A shortest path of edges from one loop to another.
 *
 * Shortest in the number of edges: it meets each of the two loops in one vertex and has no
 * shortcut, so that cutting along it leaves a surface. Among equals the lowest ids are taken.
 *
 * @param triangles ids in [0, numberOfPoints).
 * @return vertex ids, the first on `from`, the last on `to`.
 * @throw InvalidInput when no path of edges leads from one to the other.
 */
std::vector<Index> shortestCut(
  const TrianglesRef& triangles, Index numberOfPoints, const Loop& from, const Loop& to);

/// One flag a corner.
using Corners = Eigen::Matrix<bool, Eigen::Dynamic, 3, Eigen::RowMajor>;

/**
 * The corners on the left of a cut: those of its vertices, in the triangles left of it.
 *
 * A function that jumps by one across the cut is 1 at these corners and 0 at all others. Its
 * differences sum to zero over each triangle and agree on each edge that two triangles share: they
 * are a closed 1-form, with period -1 along the loop where the cut ends (surface on the left).
 *
 * @param triangles oriented.
 * @param cut       see shortestCut().
 */
Corners leftOfCut(const TrianglesRef& triangles, const std::vector<Index>& cut);
}

#endif
