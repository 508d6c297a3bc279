// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief CAD edges of the linking sides that are worth less than valid hexahedra.
 */
#ifndef hexsweep_HinderingEdges_h
#define hexsweep_HinderingEdges_h

#include "Core/Solids/SolidCage.h"

namespace hexsweep
{
/**
 * Makes a cage whose columns keep to CAD edges where that is no hindrance.
 *
 * The cage is filled by blendInterior(); where hexahedra are bad on sides with such columns, it is
 * made again without the CAD edges of these sides, and that one is taken if it has less than half
 * of the bad hexahedra. Where that does not decide, both are filled to the end (from the first
 * start, and not where twice as many are bad), and the one without
 * edges is taken if the other one's least scaled Jacobian is below 0.25 and its own is half as much
 * again.
 *
 * Where sides have steps (see ruledShape()) and slanted quads, and the least scaled Jacobian is
 * below 0.25 in the end, cages with columns in the metric of flatter steps are filled to the end as
 * well: of 0.8 of their depth, and of 0.4 where that gains but does not double it. One that gains a
 * tenth is taken, or half as much again if fewer columns are CAD edges. None is filled where
 * blendInterior() leaves more than 0.5 percent of the hexahedra to be untangled.
 *
 * Then nodes of the sides slide where hexahedra are poor there (slideCageSides()), if the finished
 * hexahedra are better for it.
 *
 * @return with SolidCage::freedSides where edges were given up.
 * @throw as makeSolidCage().
 */
SolidCage makeUnhinderedCage(
  const SolidCageInput& input, const ParallelFor& parallelFor = {}, const Progress& progress = {});
}

#endif
