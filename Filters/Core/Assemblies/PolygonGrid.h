// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Structured quads on a face of a linking side with more than four corners, or with a face
 * inside it.
 */
#ifndef hexsweep_PolygonGrid_h
#define hexsweep_PolygonGrid_h

#include "Core/Assemblies/AssemblyGeometry.h"
#include "Core/Assemblies/AssemblyMesh.h"
#include "Core/Assemblies/SideLayout.h"

#include <array>

namespace hexsweep
{
/**
 * Each node in the middle of its four neighbours, put on the face.
 *
 * @param side   a face with rims in whole steps, see SideFace::isPolygon().
 * @param inside column and row of the lower left corner of the face that lies in this one.
 * @param mesh   gets the nodes inside the face and its quads.
 */
void meshPolygon(const AssemblyComplex& complex, const AssemblyGeometry& geometry,
  const SideFace& side, const std::array<Index, 2>& inside, AssemblyMesh& mesh);
}

#endif
