// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How the nodes of one loop follow along another one of similar shape.
 */
#ifndef hexsweep_LoopCorrespondence_h
#define hexsweep_LoopCorrespondence_h

#include "Core/Geometry/ClosedPolygon.h"

namespace hexsweep
{
/// What correspondLoops() found.
struct LoopCorrespondence
{
  /// Place (see ClosedPolygon) of each source node on the target loop, unwrapped: rising, the last
  /// less than 1 beyond the first.
  std::vector<double> places;
  /// Pairs of corners that lie on each other; 0 where arc length alone decides.
  Index matchedCorners = 0;
  /// What was minimised, see correspondLoops(): 0 for equal shapes, 2 for shapes that share
  /// nothing.
  double cost = 0.0;
  /// The cost of the best correspondence that is another one (begins elsewhere); infinite if none.
  double runnerUpCost = 0.0;
  /// How much further along the target the runner-up begins, in (-1/2, 1/2] of the length.
  double runnerUpTurn = 0.0;

  /// Whether the runner-up fits nearly as well, so that the choice is a guess.
  bool isGuess() const;
};

/**
 * The monotone correspondence of two loops with the least cost: the mean over the source loop of
 * the squared difference of the unit tangents, and of the squared distance relative to the loop's
 * root-mean-square radius, after both loops are centred and scaled to one length.
 *
 * Candidates are piecewise linear in arc length:
 *  - one straight piece, from each of many starts;
 *  - corner on corner (see loopCorners()), where both loops have as many, at each cyclic offset:
 *    taken unless it is clearly worse;
 *  - a cyclic sequence of corners on corners, some left over on either loop, by dynamic
 *    programming. It has the most freedom, so it must be clearly better than one piece to be taken.
 *
 * @param linear takes vectors of the source loop to the target; its scale does not matter.
 */
LoopCorrespondence correspondLoops(
  const ClosedPolygon& source, const ClosedPolygon& target, const Eigen::Matrix3d& linear);
}

#endif
