// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Inserts points into the edges of a triangulated cap without changing its shape.
 */
#ifndef hexsweep_SurfaceRefinement_h
#define hexsweep_SurfaceRefinement_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// Points to insert into the edge from one vertex to another.
struct EdgeSubdivision
{
  Index from;
  Index to;
  /// Strictly rising, in (0, 1), measured from `from`.
  std::vector<double> fractions;
};

/// Original points come first, unchanged.
struct RefinedSurface
{
  TriangleMesh mesh;
  /// Row of the unrefined mesh that each triangle is part of.
  std::vector<Index> triangleOrigin;
  /// inserted[s][k]: id of the point at subdivisions[s].fractions[k].
  std::vector<std::vector<Index>> inserted;
};

/**
 * Whether there is a chord: an inner edge with both ends on one boundary loop.
 *
 * @param loops of the surface, in the direction of the triangles (see checkSurface()).
 */
bool hasChords(const TrianglesRef& triangles, Index numberOfPoints, const std::vector<Loop>& loops);

/**
 * Subdivides edges, then, if asked, halves every chord (see hasChords()). A harmonic map can
 * collapse a chord, since nothing holds it off the loop.
 *
 * Half-edge operations are OpenMesh's.
 *
 * @throw InvalidInput when the mesh is no oriented manifold (see checkSurface()), has more points
 *        than OpenMesh can number, or a named edge does not exist.
 */
RefinedSurface refineSurface(
  const TriangleMesh& mesh, const std::vector<EdgeSubdivision>& subdivisions, bool splitChords);
}

#endif
