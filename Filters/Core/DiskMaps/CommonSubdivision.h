// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cuts a surface's triangles along intrinsic edges, so that a map that is linear over
 * intrinsic triangles is linear over triangles of the surface.
 */
#ifndef hexsweep_CommonSubdivision_h
#define hexsweep_CommonSubdivision_h

#include "Core/DiskMaps/DiskDomain.h"
#include "Core/Surfaces/IntrinsicDelaunay.h"

namespace hexsweep
{
/// A mesh of the same shape; its first points are those of the mesh that was cut, unchanged.
struct CutSurface
{
  TriangleMesh mesh;
  /// Row of the uncut mesh that each triangle is part of.
  std::vector<Index> triangleOrigin;
  PlanePoints disk; ///< one row a point of mesh
};

/**
 * Carries a disk map from the intrinsic triangles to the surface.
 *
 * A triangle that is cut gets points where intrinsic edges cross its sides, and pieces on which
 * the map is linear in both triangulations: if it flips no intrinsic triangle, then none of the
 * pieces either. A neighbour with points on one side becomes a fan; where that flips, more
 * triangles are cut, if need be all.
 *
 * Which edges cross, and in which order, is free of rounding (see traceMeshEdges()).
 *
 * @param mesh      what `intrinsic` was made from, n points.
 * @param disk      n x 2, a map of the mesh's points to the domain.
 * @param triangles rows of the mesh to be cut, in [0, mesh.triangles.rows()); without any, mesh and
 *                  map come back as they are.
 */
CutSurface cutAlongIntrinsicEdges(const TriangleMesh& mesh, const IntrinsicTriangulation& intrinsic,
  DiskDomain domain, const PlanePointsRef& disk, const std::vector<Index>& triangles);
}

#endif
