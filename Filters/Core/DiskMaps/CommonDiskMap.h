// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Harmonic maps of two caps to one domain that they share (paper section 3.2).
 *
 * The paper pins the source cap to the circle domain of the target cap. That map folds whenever a
 * hole grows or turns against the outer loop (for an annulus this is the Nitsche bound). Here both
 * caps are mapped to a domain between theirs:
 *  - one loop: the unit disk, its nodes at the mean of both caps' arc-length angles;
 *  - two loops: an annulus, whose map is a harmonic map to a flat cylinder (see DiskDomain.h) with
 *    the nodes at the mean of both caps' conformal angles;
 *  - more: the unit disk with circular holes, at the mean of both caps' hole centres.
 */
#ifndef hexsweep_CommonDiskMap_h
#define hexsweep_CommonDiskMap_h

#include "Core/DiskMaps/CapDisk.h"
#include "Core/Linking/CapBoundary.h"

namespace hexsweep
{
struct CommonDisks
{
  CapDisk first;
  CapDisk second;
  std::vector<LoopPair> pairs;
};

/// A cap that is still to be mapped: all of CapDisk but the map.
CapDisk unmappedCap(const CapBoundary& cap, Index numberOfOriginalPoints);

/**
 * Maps both caps.
 *
 * Cotangent weights are tried first; where a triangle is flipped, mean value weights are tried and
 * kept if they flip fewer.
 *
 * @param pairs         rings on both, the outer one first.
 * @param improvement   what may be done to the triangulations, see improveCap().
 * @throw InvalidInput (see matchCapBoundaries()), SolverFailure, Aborted.
 */
CommonDisks commonDiskMap(const Cap& first, const Cap& second, const std::vector<LoopPair>& pairs,
  Weights weights, double matchTolerance, const Progress& progress = {}, const CapNames& names = {},
  TriangulationImprovement improvement = TriangulationImprovement::Off);
}

#endif
