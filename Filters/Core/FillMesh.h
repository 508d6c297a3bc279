// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A coarse triangulation of the disk that fills a hole.
 */
#ifndef hexsweep_FillMesh_h
#define hexsweep_FillMesh_h

#include "Mesh.h"

namespace hexsweep
{
/**
 * Rings of nodes in the unit disk, every second one with half as many as the one around it, and one
 * node in the middle: about three times as many as there are on the loop. The connectivity depends
 * on their number alone.
 *
 * Its harmonic energy is that of diskFillEnergy() within a factor of four, for all but the highest
 * frequencies within some tens of per cent, at a sparse matrix in place of a dense one: good for a
 * factor that preconditions the exact one.
 *
 * @param angles m >= 3 angles of the loop's nodes in radians, strictly monotone within a turn.
 *        They are evened out a little, so that arcs of any shortness give triangles with area.
 * @return points 0 ... m - 1 are the loop's nodes on the unit circle (z = 0).
 */
TriangleMesh fillMesh(const std::vector<double>& angles);
}

#endif
