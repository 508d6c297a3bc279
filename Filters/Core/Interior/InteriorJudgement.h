// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which hexahedra of a filled cage are bad: for those who may not know a hexahedron.
 */
#ifndef hexsweep_InteriorJudgement_h
#define hexsweep_InteriorJudgement_h

#include "Core/Interior/SweepInterior.h"

namespace hexsweep
{
/**
 * @param points (L + 1) n x 3, row k n + i is source point i on layer k.
 * @return numbers of the hexahedra that are not certified, rising; hexahedron k M + j is quad j in
 *         layer k.
 * @throw InvalidInput as sweptHexes(); Aborted.
 */
std::vector<Index> uncertifiedHexes(const SweepCage& cage, const PointsRef& points,
  const ParallelFor& parallelFor = {}, const Progress& progress = {});

/// The least scaled Jacobian of an interior whose qualities were kept; 0 where a hexahedron is not
/// certified.
double leastMerit(const SweepInterior& interior);
}

#endif
