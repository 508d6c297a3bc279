// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the target cap that belongs to a source cap.
 */
#ifndef hexsweep_TargetFaces_h
#define hexsweep_TargetFaces_h

#include "Core/Solids/SweepTopology.h"

namespace hexsweep
{
/**
 * The faces that make the best target cap of a source cap: the first of findTargetCandidates().
 *
 * @return rising ids.
 * @throw InvalidInput when no cap fits (it says what is wrong with the likeliest one), and what
 *        findSweepTopology() says of the source cap.
 */
std::vector<Index> findTargetFaces(
  const SolidSurface& solid, const std::vector<Index>& sourceFaceIds);

/**
 * sweepBetween() with the target cap that findTargetFaces() finds where none is named.
 *
 * @param sourceFaceIds at least one, any order.
 * @param targetFaceIds empty: the target cap is found.
 * @throw InvalidInput as these two do.
 */
SweepTopology findSweepTopology(const SolidSurface& solid, const std::vector<Index>& sourceFaceIds,
  const std::vector<Index>& targetFaceIds = {});
}

#endif
