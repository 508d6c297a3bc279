// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Improves the quads of a cap: first the worst corner, then all.
 */
#ifndef hexsweep_QuadPolishing_h
#define hexsweep_QuadPolishing_h

#include "Core/CapQuads/QuadUntangling.h"

namespace hexsweep
{
/**
 * Moves inner nodes over the surface, a fixed budget of Newton steps:
 *  1. sum exp(k (m - SJ)) over the corners with rising k and m the least scaled Jacobian so far: a
 *     smooth minimum, which raises the worst corners;
 *  2. sum (1 - SJ)^2 with a logarithmic barrier, which raises the mean and gives away at most
 *     a seventh of the minimum that was gained, none of the minimum that was given.
 * At a column the scaled Jacobian is that of the hexahedron's corner there. The nearer a column is
 * to the surface, as where a rounded body's sides run into its cap, the less can be given away:
 * there the cap's inner nodes alone decide whether the hexahedra have any room, and it is little.
 * Both with a little distortion() against the source's proportions, since a scaled Jacobian says
 * nothing about lengths.
 *
 * @param points n x 3, on the surface. A mesh with inverted corners that can move is returned as
 *        it is; those between fixed edges are passed over.
 * @return never more inverted corners nor a lower minimum (of the corners that can move at all)
 *         than the start.
 * @throw Aborted.
 */
ImprovedQuads polishQuads(const CapCorners& cap, const Points& points, const PointsRef& source,
  const Progress& progress = {});
}

#endif
