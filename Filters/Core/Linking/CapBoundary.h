// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Ties the loops of two caps together through the rings of the linking sides, and gives both
 * triangulations the same boundary nodes (paper section 3.2, step 2).
 */
#ifndef hexsweep_CapBoundary_h
#define hexsweep_CapBoundary_h

#include "Core/Linking/RingStack.h"
#include "Core/Surfaces/Cap.h"

#include <optional>
#include <string>

namespace hexsweep
{
/// One loop as it lies on both caps: row j of either is the node of column j.
struct LoopPair
{
  Points first;  ///< n x 3
  Points second; ///< n x 3
  /// How far the loop turns against the outer one on its way from the first cap to the second, in
  /// radians, whole turns counted, positive as the outer loop runs; nothing where nobody knows.
  std::optional<double> turn = std::nullopt;
};

/// What the user calls the caps and what ties them together, for messages.
struct CapNames
{
  std::string first = "first cap";
  std::string second = "second cap";
  std::string rings = "linking sides";
};

/// The pairs with the longest one, over both caps, moved to the front; the others keep their order.
std::vector<LoopPair> outerFirst(std::vector<LoopPair> pairs);

/// The loops of two caps in pairs, the longest (outer) one first.
struct LinkedLoops
{
  std::vector<LoopPair> pairs;
  /// Whether LoopPair::first lies on the second of the caps that were passed.
  bool swapped = false;
};

/**
 * Pairs the loops of two caps, the source being the first, by the rings between them: a look-up.
 *
 * The same pairs as those of the linking quads that the rings are of, see below.
 */
LinkedLoops linkLoops(const RingStack& rings);

/**
 * Pairs the loops of two caps by the quads of the linking sides, where no cap is known to be the
 * source.
 *
 * Which cap counts as first, which node as the first of a loop, and the order of loops depend on
 * the linking sides alone, so that (a, b) and (b, a) give the same pairs.
 *
 * @param matchTolerance relative to the local edge length.
 * @throw InvalidInput when the linking sides are not structured between the two caps.
 */
LinkedLoops linkLoops(const PointsRef& firstCap, const std::vector<Loop>& firstLoops,
  const PointsRef& secondCap, const std::vector<Loop>& secondLoops, const PointsRef& linkingPoints,
  const QuadsRef& linkingQuads, double matchTolerance);

/// A cap whose boundary polygon has a vertex at every united place of every ring.
struct CapBoundary
{
  TriangleMesh mesh; ///< turned over where needed: the outer loop runs as its ring does
  /// Row of the cap as it was given that each triangle of mesh is part of.
  std::vector<Index> triangleOrigin;
  /// loops[p][k]: vertex at united place k of ring p.
  std::vector<Loop> loops;
  /// Greatest distance between a ring node and the cap's own boundary polygon.
  double maximumDistance = 0.0;
};

/// Both caps with identical loops.
struct CapBoundaries
{
  CapBoundary first;
  CapBoundary second;
  /// Rings; the outer one as given, the others turned so that all run as the loops do.
  std::vector<LoopPair> pairs;
  /// united[p]: places along ring p, see uniteParameters().
  std::vector<std::vector<double>> united;
};

/**
 * Attaches the boundary vertices of both caps to the rings and splits both triangulations at the
 * union of all of them. Chords are split as well (see refineSurface()).
 *
 * @param first, second  with as many loops as pairs.
 * @param matchTolerance relative to the local edge length, see ringParameters().
 * @throw InvalidInput when a ring has no loop within a quarter of the local edge length, two rings
 *        lie on one loop, or the loops of the second cap run against each other.
 */
CapBoundaries matchCapBoundaries(const Cap& first, const Cap& second,
  const std::vector<LoopPair>& pairs, double matchTolerance, const CapNames& names = {});
}

#endif
