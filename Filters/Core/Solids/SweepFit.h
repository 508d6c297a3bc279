// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Whether two caps leave nothing but tubes between them.
 */
#ifndef hexsweep_SweepFit_h
#define hexsweep_SweepFit_h

#include "Core/Solids/CapCandidates.h"

namespace hexsweep
{
/// Whether two caps have no point in common.
bool areApart(const CapCandidate& first, const CapCandidate& second);

/// Whether caps with so many loops can be those of a sweep: the sides' Euler characteristics then
/// add up to that of tubes.
bool hasLoopsOfSweep(const FaceGraph& graph, const CapCandidate& cap);

/// Whether everything but the two caps falls into annuli from a loop of one to a loop of the other:
/// sweepBetween() then takes them. Costs O(faces) and allocates nothing that grows with triangles.
bool capsFit(const FaceGraph& graph, const CapCandidate& source, const CapCandidate& target);
}

#endif
