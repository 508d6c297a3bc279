// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How the edges of one triangulation run through a triangle of another, in integers.
 *
 * Normal coordinates, after M. Gillespie, N. Sharp, K. Crane \cite GillespieSharpCrane2021.
 */
#ifndef hexsweep_TriangleCrossings_h
#define hexsweep_TriangleCrossings_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// Side c leads from corner c to corner c + 1.
struct TriangleCrossings
{
  /// around[c] >= 0: how many cut off corner c; they cross the sides before and after it.
  Index around[3];
  /// from[c] >= 0: how many start in corner c and cross the side opposite (not 0 for one corner
  /// only).
  Index from[3];
};

/**
 * From how many edges cross each of the three sides (>= 0), given that these edges do not cross
 * each other: side c has around[c], from[c + 2] and around[c + 1] of them, in this order.
 */
TriangleCrossings triangleCrossings(Index side0, Index side1, Index side2);
}

#endif
