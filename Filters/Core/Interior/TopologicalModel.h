// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The topological model of a swept volume: the prism over its target quads.
 */
#ifndef hexsweep_TopologicalModel_h
#define hexsweep_TopologicalModel_h

#include "Core/Common/Mesh.h"
#include "Core/Interior/SweepBoundary.h"

namespace hexsweep
{
/**
 * Step 1 of section 4.2 of Cai and Tautges (2013): the target quads translated against the
 * sweeping direction, one copy a layer.
 *
 * The sweeping direction is the tangent, at the target, of the parabola through the centroids of
 * the last three outer rings. So a straight sweep, with caps of any shape, is its own model. Where
 * the rings arrive sideways, at more than 78 degrees from the vector area of the outer target loop,
 * it is the direction of this area instead. Translation keeps the shape of caps that are not
 * planar; a cap that is steeper than the direction makes a model that overlaps itself. Two layers
 * are meanColumnLength / L apart.
 *
 * @param targetPoints n x 3.
 * @param cage         boundary quads of the physical model, facing outwards (cageQuads()); they
 *        tell the two sides of the target cap.
 * @return (L + 1) n x 3, row k n + i is point i on layer k; layer L is the target, bit for bit.
 */
Points topologicalModel(
  const PointsRef& targetPoints, const QuadsRef& cage, const SweepBoundary& boundary);
}

#endif
