// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the sides between two caps are like, without a mesh.
 */
#ifndef hexsweep_SweepMeasure_h
#define hexsweep_SweepMeasure_h

#include "Core/Solids/CapCandidates.h"

namespace hexsweep
{
/// Finds ways along the edges of a solid.
class RimDistances
{
public:
  /// Costs O(n). @param graph must outlive this.
  explicit RimDistances(const FaceGraph& graph);

  /// Distances of all points from the rim of a cap along edges, but not through the cap; infinite
  /// where no such way leads. Costs O(n log n).
  std::vector<double> from(const CapCandidate& cap) const;

private:
  const FaceGraph& Graph;
  std::vector<Index> First; // point p has HalfEdges[First[p]] to HalfEdges[First[p + 1] - 1]
  std::vector<Index> HalfEdges;
};

struct SweepMeasure
{
  double height = 0.0;     ///< mean distance of the target rim from the source rim
  double leastShare = 1.0; ///< in [0, 1]: the shortest way over the longest one
  /// SideMotion::slip where the sides lie along a rigid motion, else the least mean of (n d)^2 over
  /// all directions d.
  double leaning = 0.0;
  bool isTurned = false; ///< along a rigid motion that is no shift
  /// Sum over sharp side edges of length across the sweep * angle^2 (radians) over the rims' mean
  /// length: 0 for a prism, about 5 for a step that goes all round, 2.5 for a right-angled bend.
  double turning = 0.0;
  std::vector<Index> turningFaces; ///< ids of faces at such edges, rising
  /// Ids of faces that run across a side all round it, so that all columns turn twice: steps of a
  /// shaft. Rising, empty where there are none.
  std::vector<Index> shoulders;
  double shoulderShare = 0.0; ///< area of the greatest shoulder over that of the smaller cap

  /// Whether a shoulder is so wide that layers cannot follow it: a step of a shaft, but not a
  /// shallow groove.
  bool hasWideShoulder() const { return this->shoulderShare > 1.0 / 3.0; }
};

/**
 * @param fromSource, fromTarget RimDistances of the two caps, which must fit, see capsFit().
 * Costs O(triangles).
 */
SweepMeasure measureSweep(const FaceGraph& graph, const CapCandidate& source,
  const CapCandidate& target, const std::vector<double>& fromSource,
  const std::vector<double>& fromTarget);
}

#endif
