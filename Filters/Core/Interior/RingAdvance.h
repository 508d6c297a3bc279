// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Whether the rings of a sweep advance, or turn back on the way.
 */
#ifndef hexsweep_RingAdvance_h
#define hexsweep_RingAdvance_h

#include "Core/Interior/SweepBoundary.h"

namespace hexsweep
{
/**
 * How far the outer rings go back, as a share of how far they advance.
 *
 * A ring advances by the way of its centre along the normal about which it runs. Along a straight
 * line or an arc, however the section changes, the share is 0. From the bottom of a cup over its
 * rim to the bottom inside, which a sweep can follow by topology alone, it is the depth inside over
 * the height.
 *
 * Where the centre hardly moves, rings go outward or inward, as from the outside of a tube's wall
 * to its inside: there is no way back, and the share is 0.
 *
 * @return in [0, 1].
 */
double backwardShare(const SweepBoundary& boundary);
}

#endif
