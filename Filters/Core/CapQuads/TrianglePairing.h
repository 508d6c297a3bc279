// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Joins the triangles of a mesh in pairs that make good quads.
 */
#ifndef hexsweep_TrianglePairing_h
#define hexsweep_TrianglePairing_h

#include "Core/Common/Mesh.h"

#include <utility>

namespace hexsweep
{
/// Quads, and the triangles that found no partner.
struct PairedTriangles
{
  Quads quads;
  Triangles triangles;
};

/**
 * Pairs neighbouring triangles.
 *
 * A quad counts 1 - max |pi / 2 - angle| / (pi / 2) over its corners \cite Remacle2012. Best pairs
 * are taken first; then paths along which pairs and other edges alternate are followed from one
 * triangle that is left to another.
 *
 * @param normals    n x 3, of the surface at the points.
 * @param keptEdges  pairs of points: no pair lies across them, and no quad has an angle of more
 *                   than 140 degrees between two of them, where nothing could be moved later.
 */
PairedTriangles pairTriangles(const TriangleMesh& mesh, const PointsRef& normals,
  const std::vector<std::pair<Index, Index>>& keptEdges);
}

#endif
