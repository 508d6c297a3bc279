// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The ways in which a solid can be swept, best first.
 */
#ifndef hexsweep_SweepCandidates_h
#define hexsweep_SweepCandidates_h

#include "Core/Solids/SolidSurface.h"

#include <string>
#include <vector>

namespace hexsweep
{
struct SweepCandidate
{
  std::vector<Index> sourceFaceIds; ///< rising
  std::vector<Index> targetFaceIds;
  double score = 0.0; ///< in (0, 1], see scoreOfSweep(); 0: not swept at all
  /// Whether it is worth meshing: the sides are tubes without a wide shoulder.
  bool fits = false;
  std::string reasons; ///< in words, see describeSweep(), or why it is refused
};

/// "fits"; "poor" where it can be swept but does not fit; "refused".
std::string verdictOn(const SweepCandidate& candidate);

struct SweepCandidates
{
  /// Those that fit, best first, then some of the likeliest that do not, with the reason.
  std::vector<SweepCandidate> list;
  /// Whether more pairs of caps were there than were looked at: only the likeliest were.
  bool cut = false;
};

/**
 * Pairs of caps whose rest falls into tubes. Caps are single faces, faces that meet smoothly, and
 * what lies at both ends of a direction along which the other faces lie.
 *
 * Costs O(n log n) for the faces and at most a constant number of passes over the triangles.
 */
SweepCandidates findSweepCandidates(const SolidSurface& solid);

/**
 * The same with a source cap that is given. Faces without a cap's shape or number of loops are not
 * listed; candidates with a wide shoulder count as fitting here, since the source was chosen.
 *
 * @param sourceFaceIds at least one, any order.
 * @throw InvalidInput when the source faces are no cap.
 */
SweepCandidates findTargetCandidates(
  const SolidSurface& solid, const std::vector<Index>& sourceFaceIds);
}

#endif
