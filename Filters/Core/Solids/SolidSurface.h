// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The closed, outward oriented, triangulated boundary of a solid.
 */
#ifndef hexsweep_SolidSurface_h
#define hexsweep_SolidSurface_h

#include "Core/Common/Constants.h"
#include "Core/Common/Mesh.h"

#include <vector>

namespace hexsweep
{
/**
 * A surface without boundary: one piece, a manifold, oriented with its normals out of the solid,
 * every triangle with an area.
 */
struct SolidSurface
{
  Points points;                   ///< n x 3, each one in use
  Triangles triangles;             ///< m x 3
  std::vector<Index> faceIds;      ///< m
  std::vector<Index> cellIds;      ///< m; input cell
  std::vector<Index> triangleRows; ///< m; row of SolidInput::triangles
  std::vector<Index> pointRows;    ///< n; row of SolidInput::points, the first of those merged
  Index mergedPoints = 0;          ///< points that were given up for another one
  Index collapsedTriangles = 0;    ///< triangles with two corners in one point, left out
  Index flippedTriangles = 0;      ///< triangles without area, flipped away
  Index turnedTriangles = 0;       ///< triangles that were turned over
  bool facesByAngle = false;       ///< whether faceIds are those of facesByFeatureAngle()
  double featureAngle = Pi / 6.0;  ///< radians, as asked for
};

/// The different ids of some triangles, rising. @param triangles rows of the solid's triangles.
std::vector<Index> facesOfTriangles(const SolidSurface& solid, const std::vector<Index>& triangles);

/// Rows of the triangles of some faces, rising. @param faceIds in any order.
std::vector<Index> trianglesOfFaces(const SolidSurface& solid, const std::vector<Index>& faceIds);
}

#endif
