// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Whether a surface crosses or overlaps itself.
 */
#ifndef hexsweep_SurfaceCrossings_h
#define hexsweep_SurfaceCrossings_h

#include "Core/Common/Mesh.h"

#include <optional>

namespace hexsweep
{
/// Two triangles of a surface that go through each other, or lie upon each other in one plane.
struct SurfaceCrossing
{
  Index first;                                           ///< row of the triangles, the lower one
  Index second;                                          ///< row of the triangles
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero(); ///< a point of both
};

/**
 * Looks for a place where a surface goes through itself or is folded onto itself.
 *
 * Only what is clear counts: triangles that reach a millionth of their size into each other.
 * Contact in a point or along an edge is none.
 *
 * Costs O(n log n) on surfaces whose triangles are near to few others.
 *
 * @param surface triangles with an area each.
 * @return of all crossings the one with the lowest `first`, then `second`.
 */
std::optional<SurfaceCrossing> findCrossing(const TriangleMesh& surface);
}

#endif
