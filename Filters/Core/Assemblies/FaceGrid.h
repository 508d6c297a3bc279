// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Structured quads on a face of a linking side, from the nodes of its curves alone: whoever
 * meshes the face gets the same ones.
 */
#ifndef hexsweep_FaceGrid_h
#define hexsweep_FaceGrid_h

#include "Core/Assemblies/AssemblyMesh.h"

namespace hexsweep
{
/**
 * Transfinite interpolation between the four chains \cite GordonHall1973, put on the face; on a
 * tube rows that run straight through its harmonic map (see LinkingSideColumns).
 *
 * @param layers of a tube; of a quadrilateral they are those of its chains.
 * @param mesh   gets the nodes inside the face and its quads.
 * @throw InvalidInput naming the face where chains that face each other have different numbers of
 *        edges; SolverFailure.
 */
void meshSideFace(const AssemblyComplex& complex, const AssemblyGeometry& geometry,
  const SideFace& side, Index layers, AssemblyMesh& mesh);
}

#endif
