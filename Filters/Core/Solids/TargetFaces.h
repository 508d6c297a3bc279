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
 * The faces that can be the target cap of a source cap: one face, or, where none fits, several that
 * meet each other more smoothly than the solid's feature angle.
 *
 * @return rising ids.
 * @throw InvalidInput when several caps fit (it names them all) or none does (it says what is wrong
 *        with the likeliest one), and what findSweepTopology() says of the source cap.
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
