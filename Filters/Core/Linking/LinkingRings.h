// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the rings of the structured linking sides by topology, starting at the source loops.
 *
 * The linking sides of a swept volume are structured quads between a loop of the source cap and
 * the same loop of the target cap (step 3 of the introduction of Cai and Tautges
 * \cite CaiTautges2013).
 */
#ifndef hexsweep_LinkingRings_h
#define hexsweep_LinkingRings_h

#include "Core/Linking/RingStack.h"

namespace hexsweep
{
/**
 * Walks over the linking quads from the source loops to the far end.
 *
 * The linking cells may have any orientation, each of them. Patches that do not share points
 * along their seams are joined there: coincident points are welded when both lie on an edge that
 * has one quad only, so that rings which come close to each other are never confused.
 *
 * Costs O(n log n) in the number of linking quads.
 *
 * @param sourcePoints   n x 3.
 * @param sourceLoops    point ids of the boundary loops of the source cap (see checkSurface()).
 * @param linkingPoints  m x 3.
 * @param linkingQuads   q x 4 ids in [0, m).
 * @param matchTolerance distance, relative to the shortest mesh edge at the node, up to which
 *        points count as coincident, in [0, 0.5). Where the coordinates of a mesh are all single
 *        precision numbers, their rounding error is allowed on top of it.
 * @throw InvalidInput, with the loop, the ring and the place, when a loop node has no linking
 *        node, an edge of a ring has no quad (a hole), the quads are not structured, the loops
 *        have different numbers of layers, or quads are left over.
 */
RingStack traceLinkingRings(const PointsRef& sourcePoints, const std::vector<Loop>& sourceLoops,
  const PointsRef& linkingPoints, const QuadsRef& linkingQuads, double matchTolerance = 1e-6);

/**
 * The same for quads whose seams are welded (weldLinkingSeams()), from first rings that are known.
 *
 * @param firstRings linking point ids, one a loop; they become RingStack::loops.
 */
RingStack walkLinkingRings(
  const PointsRef& linkingPoints, const Quads& welded, const std::vector<Loop>& firstRings);

/// What matchTargetLoops() found.
struct TargetMatch
{
  /// Greatest distance between a node of the last ring and its node on the target cap.
  double maximumDistance = 0.0;
  /// Number of nodes that are not at bit for bit the same place.
  Index snapped = 0;
};

/**
 * Checks that the last rings lie on the boundary of the target quads.
 *
 * The target quads have the points of the source quads in the same order, so that the node of
 * ring L on the column of source point i must coincide with target point i.
 *
 * @param targetPoints   n x 3, row i belongs to source point i.
 * @param matchTolerance as for traceLinkingRings().
 * @throw InvalidInput with the number of nodes that differ, the greatest distance, and its place.
 */
TargetMatch matchTargetLoops(
  const PointsRef& targetPoints, const RingStack& rings, double matchTolerance = 1e-6);
}

#endif
