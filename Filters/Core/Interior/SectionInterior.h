// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Interior nodes of sides that wind: the source quads carried from section to section.
 */
#ifndef hexsweep_SectionInterior_h
#define hexsweep_SectionInterior_h

#include "Core/Interior/SweepCage.h"

namespace hexsweep
{
/// How far loops wind on their way (LoopWinding::greatest()), in radians; 0 where the rings have no
/// planes.
double windingOf(const SweepBoundary& boundary);

/**
 * Places the nodes of a swept volume in layers that are unfolded one by one (carryQuads()).
 *
 * In the plane of its section layer k is the source quads as they were carried there, plus what
 * the given caps differ from the first and the last carried layer, each with its share of the way.
 * Over the plane it has the harmonic function of the ring's heights on the layer, plus the
 * bulges of the caps, each with its share of the way. All layers have the winding of the sides,
 * and no layer is folded, however far loops turn, as long as the quads can bear the shear.
 *
 * Result as InteriorMethod says; serial.
 *
 * @throw SolverFailure also where a ring has no plane.
 */
Points sectionInterior(
  const SweepCage& cage, const Progress& progress = {}, const ParallelFor& parallelFor = {});
}

#endif
