// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the edges of a mesh run over its intrinsic triangulation.
 */
#ifndef hexsweep_MeshEdgeTracing_h
#define hexsweep_MeshEdgeTracing_h

#include "Core/Surfaces/IntrinsicDelaunay.h"

namespace hexsweep
{
/// Where an edge of the mesh crosses an intrinsic edge.
struct Crossing
{
  Index half;       ///< intrinsic half-edge, of the triangle that the mesh edge comes from
  double along;     ///< on the mesh edge, in (0, 1)
  double alongHalf; ///< on the intrinsic half-edge, in [0, 1]
};

/// A mesh edge and its crossings in order.
struct TracedEdge
{
  Index from;
  Index to;
  std::vector<Crossing> crossings;
};

/**
 * All mesh edges that cross an intrinsic one, each from its lower to its higher point id.
 *
 * Which edges cross, and in which order, follows from integer counts alone (see
 * TriangleCrossings.h); only where they cross is subject to rounding. Places along a mesh edge rise
 * strictly all the same.
 */
std::vector<TracedEdge> traceMeshEdges(const IntrinsicTriangulation& intrinsic);
}

#endif
