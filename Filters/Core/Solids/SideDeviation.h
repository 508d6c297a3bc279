// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How far the sides of a mesh keep off the sides of its solid.
 */
#ifndef hexsweep_SideDeviation_h
#define hexsweep_SideDeviation_h

#include "Core/Solids/SolidCage.h"

namespace hexsweep
{
/**
 * The greatest distance of the middle of a boundary quad between the caps from the side of the
 * solid that it lies on: nodes are on the solid, quads cut off ledges, grooves and curves that
 * their layers do not follow.
 *
 * @param cage made of this solid and topology.
 * @return in the unit of the points; the same bits with any number of threads.
 */
double greatestSideDistance(const SolidCage& cage, const SolidSurface& solid,
  const SweepTopology& topology, const ParallelFor& parallelFor = {});
}

#endif
