// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Puts the boundary nodes of a sweep on the true surfaces and curves of the solid.
 */
#ifndef hexsweep_GeometrySnap_h
#define hexsweep_GeometrySnap_h

#include "Core/Geometry/ModelGeometry.h"
#include "Core/Solids/BoundaryQuads.h"

namespace hexsweep
{
struct GeometrySnap
{
  Index moved = 0;           ///< nodes that lie on the geometry now
  Index left = 0;            ///< nodes that had to stay where they were
  double greatestMove = 0.0; ///< of a node that was moved
};

/**
 * Moves the nodes of caps and sides to the nearest point of what they belong to: nodes of the loops
 * to the CAD edges between cap and sides, nodes where faces meet to the edges between them, all
 * others to their face; corners of the model to its vertices, exactly.
 *
 * A node stays where it is when nothing is found near it, or when a quad beside it would be turned
 * over. Columns that are not straight any more make the cage one that is not ruled.
 *
 * Costs O(n) searches on the geometry. Bits do not depend on threads.
 *
 * @param cage its boundary is gathered anew.
 * @throw Aborted; InvalidInput as gatherSweepBoundary().
 */
GeometrySnap snapToGeometry(const SolidSurface& solid, const SweepTopology& topology,
  const ModelGeometry& geometry, SolidCage& cage, const Progress& progress = {},
  const ParallelFor& parallelFor = {});
}

#endif
