// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Whether a target cap that nobody named may be taken.
 */
#ifndef hexsweep_FoundTarget_h
#define hexsweep_FoundTarget_h

#include "Core/Interior/SweepBoundary.h"

namespace hexsweep
{
/**
 * Refuses a sweep that turns back on its way, as into a blind hole: topology allows it, but whoever
 * means it should say so.
 *
 * @param boundary      rings of the sweep.
 * @param targetFaceIds of the target that was found, at least one.
 * @throw InvalidInput where backwardShare() is more than a quarter.
 */
void checkFoundTarget(const SweepBoundary& boundary, const std::vector<Index>& targetFaceIds);
}

#endif
