// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The faces of a solid, each with its triangles, and the connected patches they consist of.
 */
#ifndef hexsweep_FacePatches_h
#define hexsweep_FacePatches_h

#include "Core/Solids/SolidSurface.h"
#include "Core/Surfaces/HalfEdgeTriangles.h"

#include <vector>

namespace hexsweep
{
/// Faces go by numbers here, which do not depend on their ids: in the order of their first
/// triangles.
struct FacePatches
{
  std::vector<Index> ids;                    ///< by number
  std::vector<std::vector<Index>> triangles; ///< of each face, rising
  std::vector<std::size_t> faceOfTriangle;
  /// Connected part of one face that each triangle belongs to, numbered by their first triangles.
  std::vector<Index> patchOfTriangle;
  Index numberOfPatches = 0;
};

FacePatches findFacePatches(const SolidSurface& solid, const HalfEdgeTriangles& halfEdges);

/// The patches that each patch shares an edge with, rising.
std::vector<std::vector<Index>> patchNeighbors(
  const FacePatches& patches, const HalfEdgeTriangles& halfEdges);
}

#endif
