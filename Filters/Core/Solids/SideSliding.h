// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Better places for nodes of a solid's linking sides where hexahedra come out poor there.
 */
#ifndef hexsweep_SideSliding_h
#define hexsweep_SideSliding_h

#include "Core/Solids/SolidCage.h"

#include <optional>

namespace hexsweep
{
/// Whether quads of the linking sides have corners that make hexahedra poor whatever is inside.
bool hasSlantedSides(const SolidCage& cage);

/**
 * Slides nodes of the linking sides along the solid, see slideSides(), where the cage as
 * blendInterior() fills it has hexahedra with a scaled Jacobian below 0.3 at its sides. Taken where
 * the least of these becomes far better than by moves inside alone. Columns that are CAD edges
 * slide along these; sides that are meshed already, in part, and straight columns are left as they
 * are.
 *
 * @param input what the cage was made from.
 * @return the cage with the sides that slid, none where none did. The hexahedra of a finished
 *         interior may still be better without: untangling opens other corners than a blend has.
 * @throw SolverFailure; Aborted.
 */
std::optional<SolidCage> slideCageSides(const SolidCageInput& input, const SolidCage& cage,
  const ParallelFor& parallelFor, const Progress& progress);
}

#endif
