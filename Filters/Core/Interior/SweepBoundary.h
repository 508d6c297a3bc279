// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the interior methods need to know of the cage: loop nodes and their rings.
 */
#ifndef hexsweep_SweepBoundary_h
#define hexsweep_SweepBoundary_h

#include "Core/Common/Mesh.h"
#include "Core/Geometry/AffineMap.h"
#include "Core/Linking/RingStack.h"

namespace hexsweep
{
/// The loop nodes of all loops in one row, and where they are on every layer.
struct SweepBoundary
{
  /// Source point id of each loop node, loop after loop.
  std::vector<Index> nodes;
  /// rings[k], row j: position of loop node j on layer k; k = 0 ... L. rings[0] are the source
  /// points and rings[L] the target points, bit for bit.
  std::vector<Points> rings;
  /// Rows of the outer loop (the loop whose vector area on the source is largest).
  Index outerBegin = 0;
  Index outerSize = 0;
  /// First row of each loop, then the number of rows.
  std::vector<Index> begins;
  /// How far along its columns layer k lies: mean over the columns of the fraction of the length,
  /// 0 at the source, 1 at the target, rising. Equals k / L where the layers are equally thick.
  std::vector<double> fractions;
  /// Mean length of the columns.
  double meanColumnLength = 0.0;

  Index numberOfLayers() const { return static_cast<Index>(this->rings.size()) - 1; }
};

/**
 * Collects loop nodes and rings.
 *
 * @param sourcePoints, targetPoints n x 3, same order.
 * @throw InvalidInput when source and target loops coincide (a volume without height).
 */
SweepBoundary gatherSweepBoundary(
  const PointsRef& sourcePoints, const PointsRef& targetPoints, const RingStack& rings);

/// Least-squares affine map of the loop nodes from layer `from` to layer `to` (fitAffineMap()).
AffineMap fitLayerMap(const SweepBoundary& boundary, Index from, Index to);

/**
 * Writes what needs no method into the swept points: the source points on layer 0, the target
 * points on layer L and the rings between them, bit for bit; points that no quad uses go on the
 * straight line between the caps.
 *
 * @param swept (L + 1) n x 3, row k n + i is source point i on layer k.
 */
void setGivenPoints(const PointsRef& sourcePoints, const PointsRef& targetPoints,
  const QuadsRef& quads, const SweepBoundary& boundary, Points& swept);
}

#endif
