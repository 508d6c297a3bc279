// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Unstructured quads on a face of a cap, on the nodes of its curves.
 */
#ifndef hexsweep_CapFaces_h
#define hexsweep_CapFaces_h

#include "Core/Assemblies/AssemblyMesh.h"
#include "Core/Common/ParallelFor.h"

namespace hexsweep
{
/**
 * Meshes a face with quads of a size, see meshCapWithQuads(); nodes within go to the true surface
 * where it is known, but where that would turn a quad over.
 *
 * @param size > 0.
 * @param mesh gets the nodes inside the face and its quads.
 * @throw InvalidInput naming the face that is no disk with holes, or too narrow for its nodes;
 *        Aborted.
 */
void meshCapFace(const AssemblyComplex& complex, const AssemblyGeometry& geometry, Index face,
  double size, AssemblyMesh& mesh, const Progress& progress = {},
  const ParallelFor& parallelFor = {});

/**
 * Moves points of quads to the true surfaces of the faces below them.
 *
 * @param quads   of `points`.
 * @param isFixed one a point: it stays.
 * @param faces   of a volume, rows: those that the quads cover.
 */
void snapToFaces(const AssemblyComplex& complex, const AssemblyGeometry& geometry, Index volume,
  const std::vector<Index>& faces, const Quads& quads, const std::vector<bool>& isFixed,
  Points& points);
}

#endif
