// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Structured quads on a face of a linking side that runs once round.
 */
#ifndef hexsweep_TubeGrid_h
#define hexsweep_TubeGrid_h

#include "Core/Assemblies/AssemblyGeometry.h"
#include "Core/Assemblies/AssemblyMesh.h"
#include "Core/Assemblies/SideLayout.h"

namespace hexsweep
{
/**
 * Straight lines between the rims where these stay near the face, else rows that run straight
 * through its harmonic map (see LinkingSideColumns), put on the face.
 *
 * @param side a face between two closed rims, see SideFace::isTube(). @param layers quads from rim
 * to rim.
 * @param mesh gets the nodes inside the face and its quads.
 * @throw InvalidInput naming the face where its rims have different numbers of edges;
 * SolverFailure.
 */
void meshTube(const AssemblyComplex& complex, const AssemblyGeometry& geometry,
  const SideFace& side, Index layers, AssemblyMesh& mesh);
}

#endif
