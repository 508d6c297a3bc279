// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Structured quads on a face of a linking side, from the nodes of its curves alone: whoever
 * meshes the face gets the same ones.
 */
#ifndef hexsweep_FaceGrid_h
#define hexsweep_FaceGrid_h

#include "Core/Assemblies/AssemblyIntervals.h"
#include "Core/Assemblies/AssemblyMesh.h"

namespace hexsweep
{
/**
 * A face with more corners, or with a face inside it: each node in the middle of its four
 * neighbours, put on the face. Else transfinite interpolation between the four chains \cite
 * GordonHall1973, put on the face; on a tube rows that run straight through its harmonic map (see
 * LinkingSideColumns).
 *
 * @param intervals layers of tubes, and where faces lie in others.
 * @param mesh   gets the nodes inside the face and its quads.
 * @throw InvalidInput naming the face where chains that face each other have different numbers of
 *        edges; SolverFailure.
 */
void meshSideFace(const AssemblyComplex& complex, const AssemblyGeometry& geometry,
  const SideFace& side, const AssemblyIntervals& intervals, AssemblyMesh& mesh);
}

#endif
