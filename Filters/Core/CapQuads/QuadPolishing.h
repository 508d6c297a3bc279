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
 * Moves inner nodes over the surface, in a bounded number of steps:
 *  1. a few Newton steps of all nodes together down sum (1 - SJ)^2, with a logarithmic barrier at
 *     the minimum that was given, in large caps solved roughly by conjugate gradients;
 *  2. steps of single nodes down sum exp(k (m - SJ)) over the corners that are near the minimum m,
 *     with rising k: a smooth minimum, which raises the worst corners. Where it stays low, because
 *     nodes are in each other's way, all nodes of the patches round the worst corners together;
 *     where it stays below 0.75 likewise, as long as the patches are a small part of the quads;
 *  3. steps of single nodes for the mean again, of all together where 1 was of no use, which give
 *     away at most a seventh of the minimum that was gained, none of the minimum that was given.
 *     In large caps that counts only where the mean gains 0.005 of it.
 * At a column the scaled Jacobian is that of the hexahedron's corner there. The nearer a column is
 * to the surface, as where a rounded body's sides run into its cap, the less can be given away:
 * there the cap's inner nodes alone decide whether the hexahedra have any room, and it is little.
 * All with a little distortion() against the source's proportions, since a scaled Jacobian says
 * nothing about lengths.
 *
 * Measured on a disk with seven holes: 21 000 quads 0.6 s of CPU time, 2.0 s with a factorisation
 * in step 1, least and mean scaled Jacobian the same to 0.001; 98 000 quads least 0.850, 0.626
 * without patches and with any trade in step 3, mean 0.982 both.
 *
 * @param points n x 3, on the surface. A mesh with inverted corners that can move is returned as
 *        it is; those between fixed edges are passed over.
 * @return never more inverted corners nor a lower minimum (of the corners that can move at all)
 *         than the start. The same bits for any number of threads, which are those of the corners.
 * @throw Aborted.
 */
ImprovedQuads polishQuads(const CapCorners& cap, const Points& points, const PointsRef& source,
  const Progress& progress = {});
}

#endif
