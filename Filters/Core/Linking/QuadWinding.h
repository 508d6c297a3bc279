// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Whether quads on the target cap wind as the sides do.
 */
#ifndef hexsweep_QuadWinding_h
#define hexsweep_QuadWinding_h

#include "Core/Linking/SweepSections.h"

namespace hexsweep
{
/**
 * How many whole turns quads on the target lack.
 *
 * Quads may all be upright and yet be none that the source quads can be moved to between the
 * sides. For every hole there is a path of quad edges to it from the outer loop. By how much its
 * direction, seen from the middle of a hole, turns along the path can change on the way
 * through the sections only by what the ends of the path turn about that hole: it is a sum over the
 * sections, and the difference to what the path on the target does is a whole number of turns.
 *
 * @param source, target n x 2: the quads in the planes of the first and the last section.
 * @return one a loop: of the path to it, over all holes; 0: the quads wind as the sides do. Holes
 *         whose middle lies outside them, on any ring, are passed over: nothing can be said about
 *         them.
 */
std::vector<Index> missedTurns(const SweepSections& sections, const QuadsRef& quads,
  const PlanePoints& source, const PlanePoints& target);
}

#endif
