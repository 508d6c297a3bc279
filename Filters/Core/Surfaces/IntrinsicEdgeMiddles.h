// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Points on the mesh that split triangles of its intrinsic triangulation.
 */
#ifndef hexsweep_IntrinsicEdgeMiddles_h
#define hexsweep_IntrinsicEdgeMiddles_h

#include "Core/Surfaces/IntrinsicDelaunay.h"
#include "Core/Surfaces/SurfaceRefinement.h"

namespace hexsweep
{
/**
 * Where to put points on mesh edges to split intrinsic triangles: on the longest inner edge of
 * each, the crossing nearest its middle (its middle itself where it is an edge of the mesh).
 *
 * @param triangles rows of intrinsic.triangles.
 */
std::vector<EdgeSubdivision> middlesOfIntrinsicEdges(
  const IntrinsicTriangulation& intrinsic, const std::vector<Index>& triangles);
}

#endif
