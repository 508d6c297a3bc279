// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The volumes that surfaces enclose where more than two of them may meet at an edge.
 */
#ifndef hexsweep_SurfaceRegions_h
#define hexsweep_SurfaceRegions_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// A bounded region.
struct SurfaceRegion
{
  std::vector<Index> rows; ///< triangles around it, rising
  Triangles triangles;     ///< these, outward
};

/**
 * Goes round each edge from triangle to triangle: what lies between two that follow each other is
 * one region.
 *
 * A triangle with the same region on both sides bounds none. Shells that no edge joins to the rest
 * are regions of their own, also where they lie in another one.
 *
 * @param points    coincident ones merged.
 * @param triangles any orientation, each with an area.
 * @return in the order of their first triangles.
 */
std::vector<SurfaceRegion> surfaceRegions(const PointsRef& points, const TrianglesRef& triangles);
}

#endif
