// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cuts quads into four and triangles into three quads.
 */
#ifndef hexsweep_MidpointSubdivision_h
#define hexsweep_MidpointSubdivision_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
struct SubdividedFaces
{
  QuadMesh mesh; ///< given points first, then one an edge, then one a face
  /// Ends of the edge that point numberOfGivenPoints + e halves, the lower one first; sorted.
  std::vector<std::pair<Index, Index>> edges;
};

/// @param quads, triangles that share edges as a manifold's faces do.
SubdividedFaces subdivideAtMidpoints(
  const PointsRef& points, const QuadsRef& quads, const TrianglesRef& triangles);
}

#endif
