// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Interior nodes on straight lines between the caps.
 */
#ifndef hexsweep_RuledInterior_h
#define hexsweep_RuledInterior_h

#include "Core/Interior/SweepCage.h"

namespace hexsweep
{
/**
 * Each node on the straight line from its source point to its target point, at the fraction of the
 * length that its layer has (SweepBoundary::fractions). For cages whose columns are such lines
 * themselves (SweepCage::isRuled) no other method gives better hexahedra than their quads allow: a
 * right prism has the scaled Jacobians of its source quads.
 *
 * Result and errors as InteriorMethod says.
 */
Points ruledInterior(
  const SweepCage& cage, const Progress& progress = {}, const ParallelFor& parallelFor = {});
}

#endif
