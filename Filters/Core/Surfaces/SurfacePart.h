// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Some triangles of a surface as a mesh of its own.
 */
#ifndef hexsweep_SurfacePart_h
#define hexsweep_SurfacePart_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
struct SurfacePart
{
  TriangleMesh mesh;         ///< row r is triangle rows[r] of the surface
  std::vector<Index> points; ///< of the surface, rising: one a point of the mesh

  /// Number in the part of a point of the surface that one of its triangles uses.
  Index idOf(Index point) const;
};

/// Costs O(k log k) for k rows, however large the surface is.
SurfacePart surfacePart(
  const PointsRef& points, const TrianglesRef& triangles, const std::vector<Index>& rows);
}

#endif
