// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sets of faces that may be a cap of a sweep, and how well each one suits.
 */
#ifndef hexsweep_CapCandidates_h
#define hexsweep_CapCandidates_h

#include "Core/Solids/FaceGraph.h"

#include <optional>
#include <vector>

namespace hexsweep
{
using FaceSet = std::vector<std::size_t>; ///< numbers of faces, see FaceGraph, rising

struct CapCandidate
{
  FaceSet faces;
  std::vector<Index> faceIds; ///< of these, rising
  /// Half-edges of the cap's triangles along its boundary, as SweepCap::loops.
  std::vector<std::vector<Index>> loops;
  std::vector<Index> rimPoints; ///< on its loops, rising
  double area = 0.0;
  double perimeter = 0.0; ///< of all loops
  /// In (0, 1]: mean (geometric, by length) of the sine of the angle between cap and sides; 1 where
  /// they stand upright on its rim, near 0 where they go on smoothly or the solid is re-entrant.
  double upright = 0.0;
  double flatness = 0.0; ///< length of the mean normal, 1 for a plane cap
  /// In (0, 1]: 1 where its faces meet smoothly, less the longer and sharper its inner edges are.
  double smooth = 1.0;
  Index corners = 0; ///< places where a loop turns by more than 40 degrees
};

/**
 * Costs O(n log n) in the points on the borders of its faces, whatever their triangles.
 *
 * @return nothing where the faces are no disk with holes: makeSweepCap() says why.
 */
std::optional<CapCandidate> makeCapCandidate(const FaceGraph& graph, const FaceSet& faces);

/// Whether the cap's upright rim and its size make it likely; of any scale, for comparison.
double likelihoodOf(const CapCandidate& cap);

/**
 * Single faces and faces that meet smoothly: at 5 and 15 degrees and the solid's feature angle.
 *
 * @param allowed one a face: the others are in no set.
 * @return each set once, larger ones of the same faces first.
 */
std::vector<FaceSet> smoothFaceSets(const FaceGraph& graph, const std::vector<char>& allowed);

/**
 * What is above and below where the solid is seen along a direction: faces that lie along it are
 * sides, the others caps.
 *
 * @param direction of length 1.
 * @return nothing where there is not just one connected set of faces at each end.
 */
std::optional<std::pair<FaceSet, FaceSet>> endsAlong(
  const FaceGraph& graph, const Eigen::RowVector3d& direction);
}

#endif
