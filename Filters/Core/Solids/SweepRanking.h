// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which of several sweeps of a solid will give the better hexahedra, and why.
 */
#ifndef hexsweep_SweepRanking_h
#define hexsweep_SweepRanking_h

#include "Core/Solids/SweepMeasure.h"

#include <string>

namespace hexsweep
{
/// In (0, 1], what is known from the caps alone: upright and smooth ones, alike in area and shape.
double scoreOfCaps(const CapCandidate& first, const CapCandidate& second);

/**
 * In (0, 1]: the caps' score, less where sides turn across the layers, lean or are long against
 * the caps, or shoulders are wide.
 *
 * @param remoteness in [0, 1]: steps over faces from source to target, over those to the farthest
 *        face.
 */
double scoreOfSweep(const CapCandidate& source, const CapCandidate& target,
  const SweepMeasure& measure, double remoteness);

/// What speaks against a sweep, the gravest first, in words; "straight prism" or "good caps and
/// sides" where nothing does.
std::string describeSweep(
  const CapCandidate& source, const CapCandidate& target, const SweepMeasure& measure);

/**
 * Whether the first of two caps is better meshed with quads than the other: the rounder one (a
 * column may end in a corner, but not begin in one that vanishes), then the one with more faces,
 * whose borders its quads follow, then the larger one, then the one with the lower ids.
 */
bool isBetterSource(const CapCandidate& first, const CapCandidate& second);
}

#endif
