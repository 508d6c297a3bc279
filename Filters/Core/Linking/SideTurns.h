// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Turns linking sides that no CAD edge holds along with the others.
 */
#ifndef hexsweep_SideTurns_h
#define hexsweep_SideTurns_h

#include "Core/Linking/LinkingSideColumns.h"

#include <deque>

namespace hexsweep
{
/**
 * How far the columns of free sides are to turn on their way, beyond what the strip has.
 *
 * Every strip has its own idea of which place of the target loop is straight ahead. Where a wall
 * between two loops is thin, a small disagreement shears the quads of the target cap. Hence free
 * sides follow the held ones, or, where all are free, the one with the longest loop: level by
 * level, so that whole turns count, by the least-squares affine map of their rings. The shear is
 * shared between the cap (turn over gap to the next loop) and the side (turn over height) such that
 * the sum of their squares is least.
 *
 * @return one a side, in v; 0 for sides that are not free.
 */
std::vector<double> sideTurns(const std::deque<LinkingSideColumns>& sides);
}

#endif
