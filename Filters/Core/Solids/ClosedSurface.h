// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Checks that triangles bound a solid, and turns them outward.
 */
#ifndef hexsweep_ClosedSurface_h
#define hexsweep_ClosedSurface_h

#include "Core/Solids/SolidSurface.h"

namespace hexsweep
{
/**
 * The side on the other side of each edge: entry 3 t + c belongs to the side of triangle t from
 * corner c to the next, and holds the number 3 s + d of its only partner.
 *
 * @throw InvalidInput when an edge has one triangle (the surface is open there) or more than two.
 */
std::vector<Index> closedTwins(const SolidSurface& solid);

/// @param twins see closedTwins().
/// @throw InvalidInput when triangles meet in a point without an edge that leads from one to the
///        other.
void checkPointFans(const SolidSurface& solid, const std::vector<Index>& twins);

/**
 * The triangles with their normals out of the solid: same rows, same first corner in each.
 *
 * @param twins see closedTwins().
 * @throw InvalidInput when they cannot be oriented, there are several shells, or they enclose no
 *        volume.
 */
Triangles outwardTriangles(const SolidSurface& solid, const std::vector<Index>& twins);
}

#endif
