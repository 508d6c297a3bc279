// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Linking sides that turn themselves over.
 */
#ifndef hexsweep_RingCollapse_h
#define hexsweep_RingCollapse_h

#include "Core/Interior/SweepBoundary.h"

namespace hexsweep
{
/**
 * Refuses linking sides that collapse on the way, as straight columns between loops that are turned
 * far against each other do.
 *
 * A ring has collapsed where one of its edges has no length, or where an edge that has shrunk below
 * a quarter of its length on both loops runs against the same edge of the ring before (an angle
 * over 90 degrees) so that the linking quad between them is inverted (a corner that is not positive
 * about the quad's own normal, as Verdict measures quads). An edge of a loop of more than eight
 * does so, too, where columns slide over a sharp ridge of the side: the edges beside it run against
 * each other. That, and sides that only twist, in however few layers, are left to the interior.
 *
 * @param loops of the source, in the order of SweepBoundary::nodes.
 * @throw InvalidInput naming the loop, the first such ring and the place.
 */
void checkRings(const SweepBoundary& boundary, const std::vector<Loop>& loops);
}

#endif
