// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Pairs the loops of two caps by their shape, where no linking sides say how they belong.
 */
#ifndef hexsweep_LoopMatching_h
#define hexsweep_LoopMatching_h

#include "Core/Linking/CapBoundary.h"

#include <string>

namespace hexsweep
{
/// Loops paired by shape.
struct MatchedLoops
{
  /// pairs[l].first: the nodes of source loop l; pairs[l].second: their places on the target.
  std::vector<LoopPair> pairs;
  /// Arc length along the target loop, as a fraction of its length, from its first vertex to the
  /// place of the first node of source loop l, the way the source runs: the chosen start.
  std::vector<double> startFractions;
  /// What could as well be otherwise, in words: an empty list where shape decides everything.
  std::vector<std::string> doubts;
};

/**
 * Matches loops as a sweep along a straight line or a circular arc would, without turning about it.
 *
 *  - The longest loops are the outer ones. Both run the same way about the line that joins their
 *    centres; where that line lies in both planes (a sweep through half a circle), opposite ways.
 *  - The source turns by the smallest rotation that brings its area vector to the target's.
 *  - Nodes follow each other corner on corner where that fits, by arc length in between (see
 *    correspondLoops()).
 *  - Holes move with the affine map that fits the outer loop best; the pairs have the least sum of
 *    squared distances between the centres, and differences between the radii, all together.
 *
 * A wrong guess is a silent twist: show startFractions and doubts to the user, and prefer linking
 * sides.
 *
 * @param sourceLoops loops of the quads; the result is in their order.
 * @param sourceName, targetName the two as the user knows them, for the texts.
 * @throw InvalidInput when the caps have different numbers of loops, or a loop has no length.
 */
MatchedLoops matchLoopsByShape(const PointsRef& sourcePoints, const std::vector<Loop>& sourceLoops,
  const PointsRef& targetPoints, const std::vector<Loop>& targetLoops,
  const std::string& sourceName = "source", const std::string& targetName = "target surface");

/// MatchedLoops::doubts as one warning, or an empty text; the first ten are named.
std::string describeDoubts(const std::vector<std::string>& doubts);
}

#endif
