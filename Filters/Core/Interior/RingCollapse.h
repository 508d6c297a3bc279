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
 * A ring has collapsed where one of its edges has no length, or where two neighbouring edges that
 * have shrunk below a quarter of their lengths on both loops run against the same edges of the ring
 * before (an angle over 90 degrees) so that the linking quads between them are inverted (a corner
 * that is not positive about the quad's own normal, as Verdict measures quads). One edge alone does
 * so where columns slide over a sharp ridge of the side. That, and sides that only twist, in
 * however few layers, are left to the interior.
 *
 * @param loops of the source, in the order of SweepBoundary::nodes.
 * @throw InvalidInput naming the loop, the first such ring and the place.
 */
void checkRings(const SweepBoundary& boundary, const std::vector<Loop>& loops);
}

#endif
