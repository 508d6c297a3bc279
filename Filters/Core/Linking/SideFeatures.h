// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief CAD edges of a linking side that lead from the source cap to the target cap.
 */
#ifndef hexsweep_SideFeatures_h
#define hexsweep_SideFeatures_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/**
 * Traces the borders between faces from one loop of a tube to the other.
 *
 * Each path is the way along borders that is shortest and turns least (1 - cos of a turn counts as
 * that part of the side's size), so that borders that cross the layers (as those of faces that are
 * stacked in the sweep's direction do) are left aside, but followed round a step or a groove. The
 * best paths come first; others give way to them or are left out.
 *
 * @param surface an oriented tube. @param faceIds one a triangle.
 * @param sourceLoop, targetLoop its boundary loops.
 * @return the points of each path, the first on the source loop, the last on the target loop, no
 *         other on a loop and none on two paths; in the order of the source loop.
 */
std::vector<std::vector<Index>> crossingFeatures(const TriangleMesh& surface,
  const std::vector<Index>& faceIds, const Loop& sourceLoop, const Loop& targetLoop);

/**
 * The shortest path along edges from the source loop to the target loop; it meets each of them
 * once. For cutting open a tube that has no CAD edge.
 */
std::vector<Index> shortestCrossing(
  const TriangleMesh& surface, const Loop& sourceLoop, const Loop& targetLoop);
}

#endif
