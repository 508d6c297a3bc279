// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Pairs the loops of two caps by their shape, where no linking sides say how they belong.
 */
#ifndef hexsweep_LoopMatching_h
#define hexsweep_LoopMatching_h

#include "CapBoundary.h"

namespace hexsweep
{
/// Loops paired by shape.
struct MatchedLoops
{
  /// pairs[l].first: the nodes of source loop l; pairs[l].second: their places on the target.
  std::vector<LoopPair> pairs;
  /// Arc length along the target loop, as a fraction of its length, from its first vertex to the
  /// place of the first node of source loop l: the chosen start.
  std::vector<double> startFractions;
};

/**
 * Matches loops as a sweep without turning would: the target is taken to be the source moved by
 * its centre, turned by the smallest rotation that brings the area vectors of the outer loops
 * together, and scaled to its length. The longest loops are the outer ones; holes are paired by
 * the nearest centres; nodes follow each other by arc length from the start with the least sum of
 * squared distances.
 *
 * A symmetric loop fits with any of several starts, so a wrong guess is a silent twist: report
 * startFractions, and prefer linking sides.
 *
 * @param sourceLoops loops of the quads; the result is in their order.
 * @throw InvalidInput when the caps have different numbers of loops.
 */
MatchedLoops matchLoopsByShape(const PointsRef& sourcePoints, const std::vector<Loop>& sourceLoops,
  const PointsRef& targetPoints, const std::vector<Loop>& targetLoops);
}

#endif
