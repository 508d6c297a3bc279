// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How many faces of a triangulation that is to become quads meet at nodes of its loops.
 *
 * A corner of a cap is filled best by as few quads as bring its angle near 90 degrees. A sweep may
 * want more: where the corner opens on the way to the target, the hexahedra of a single quad would
 * be flat there.
 */
#ifndef hexsweep_CornerFans_h
#define hexsweep_CornerFans_h

#include "Core/Geometry/SurfaceSearch.h"

#include <utility>
#include <vector>

namespace hexsweep
{
/// A node on a loop, and how many faces are to meet there at least.
struct CornerFan
{
  Eigen::RowVector3d place; ///< of the node, exactly
  Index faces = 2;
};

/**
 * Makes room for the fans: where too few triangles meet, an edge opposite the node is flipped, or
 * halved where that would leave a flat triangle; a triangle whose opposite edge is kept is cut at
 * its centroid.
 *
 * @param mesh    oriented; gets further points, at the end, on `surface`.
 * @param kept    pairs of points, lower one first: edges that stay.
 * @return further edges to keep, lower point first: those that part the faces of the fans. Places
 *         that are no point of the mesh are left out.
 */
std::vector<std::pair<Index, Index>> openCornerFans(TriangleMesh& mesh,
  const std::vector<CornerFan>& fans, const std::vector<std::pair<Index, Index>>& kept,
  const SurfaceSearch& surface);
}

#endif
