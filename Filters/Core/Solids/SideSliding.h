// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Better places for nodes of a solid's linking sides where hexahedra come out poor there.
 */
#ifndef hexsweep_SideSliding_h
#define hexsweep_SideSliding_h

#include "Core/Solids/SolidCage.h"

namespace hexsweep
{
/**
 * Slides nodes of the linking sides along the solid, see slideSides(), where the cage as
 * blendInterior() fills it has hexahedra with a scaled Jacobian below 0.3 at its sides. Taken where
 * the least of these becomes far better than by moves inside alone. Columns that are CAD edges
 * stay; sides that are meshed already, in part, and straight columns are left as they are.
 *
 * @param input what the cage was made from.
 * @throw SolverFailure; Aborted.
 */
void slideCageSides(const SolidCageInput& input, SolidCage& cage, const ParallelFor& parallelFor,
  const Progress& progress);
}

#endif
