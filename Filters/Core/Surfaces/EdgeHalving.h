// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Halves the long edges of a triangulation without changing its shape.
 */
#ifndef hexsweep_EdgeHalving_h
#define hexsweep_EdgeHalving_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
struct HalvedSurface
{
  TriangleMesh mesh;                 ///< original points first
  std::vector<Index> triangleOrigin; ///< row of the given mesh that each triangle is part of
};

/**
 * Longest edge for which halving makes about so many triangles of one size. Of slender triangles
 * the area does not tell how many they become: where that would be more than fifty times as
 * many, the edge is longer.
 *
 * @throw InvalidInput when the mesh has no area.
 */
double longestEdgeFor(const TriangleMesh& mesh, double triangles);

/**
 * Halves edges, the longest first, until none is longer than `longest` (cutting the longest edge
 * first keeps angles from getting worse \cite Rivara1984).
 *
 * @param mesh    an oriented 2-manifold, see checkSurface().
 * @param longest > 0.
 * @throw InvalidInput an edge that is too short to be halved among its coordinates; too many
 * triangles.
 */
HalvedSurface halveLongEdges(const TriangleMesh& mesh, double longest);

/**
 * Halves the edges for which isChord(from, to) is true; once each, so that a new edge between two
 * old points is not looked at again.
 */
HalvedSurface halveChords(
  const TriangleMesh& mesh, const std::function<bool(Index from, Index to)>& isChord);
}

#endif
