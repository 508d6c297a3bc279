// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Manifoldness, orientation, connected components and boundary loops of a surface mesh.
 *
 * Everything here is combinatorial; no coordinates are read.
 */
#ifndef hexsweep_SurfaceTopology_h
#define hexsweep_SurfaceTopology_h

#include "Core/Common/Mesh.h"

#include <string>

namespace hexsweep
{
/// What is true of a mesh once checkSurface() has let it pass.
struct SurfaceTopology
{
  /// Boundary loops in the direction of the faces (the surface lies on the left, seen from the
  /// normal's side), each beginning at its smallest point id, ordered by that id.
  std::vector<Loop> loops;
  Index numberOfComponents = 0;
  /// V - E + F, counting only points that a face uses.
  Index eulerCharacteristic = 0;
};

/**
 * Checks that faces form an oriented 2-manifold with boundary and describes it.
 *
 * @param faces m x 3 or m x 4 point ids in [0, numberOfPoints).
 * @param what  name of the mesh for the error text, e.g. "source quads".
 * @throw InvalidInput when a face repeats a point, an edge has more than two faces, two
 *        neighbouring faces disagree in orientation, or faces meet in a point only.
 */
SurfaceTopology checkSurface(const FacesRef& faces, Index numberOfPoints, const std::string& what);

/**
 * Turns faces so that neighbours agree; the first face of each component keeps its orientation.
 *
 * @return the turned faces, same rows, same first point in each row.
 * @throw InvalidInput when the surface cannot be oriented or an edge has more than two faces.
 */
Faces orientFaces(const FacesRef& faces, const std::string& what);

/**
 * Checks that a surface is one genus-0 piece with at least one boundary loop, as a cap must be.
 *
 * @throw InvalidInput saying which of the three fails and what to do.
 */
void checkCap(const SurfaceTopology& topology, const std::string& what);

/// Neighbour of triangle t across the edge (corner c, corner c + 1): row t, column c; -1: none.
Triangles triangleNeighbors(const TrianglesRef& triangles);
}

#endif
