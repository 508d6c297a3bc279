// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The closed, outward oriented, triangulated boundary of a solid.
 */
#ifndef hexsweep_SolidSurface_h
#define hexsweep_SolidSurface_h

#include "Constants.h"
#include "Mesh.h"

#include <vector>

namespace hexsweep
{
/// Triangles as they come from a file.
struct SolidInput
{
  Points points;       ///< all points of the input, used or not
  Triangles triangles; ///< any orientation
  /// Face that each triangle is part of; empty: faces are found by feature angle.
  std::vector<Index> faceIds;
  /// Input cell that each triangle is part of; empty: the triangle's own row.
  std::vector<Index> cellIds;
};

struct SolidOptions
{
  /// Points on open edges that are nearer than this are one; relative to the local edge length, in
  /// [0, 0.5).
  double matchTolerance = 1e-6;
  /// Radians, in (0, pi): neighbours whose normals differ by less are in one face. Only looked at
  /// where there are no face ids.
  double featureAngle = Pi / 6.0;
};

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
  Index turnedTriangles = 0;       ///< triangles that were turned over
  bool facesByAngle = false;       ///< whether faceIds are those of facesByFeatureAngle()
  double featureAngle = Pi / 6.0;  ///< radians, as asked for
};

/**
 * Merges coincident points, leaves out collapsed triangles, turns the others outward and checks
 * that they bound a solid.
 *
 * Points are merged along open edges and edges without length only, so that a solid that touches
 * itself stays as it is.
 * Costs O(n log n).
 *
 * @throw InvalidInput: no triangles; id lists of the wrong length; a point that does not exist or
 *        is not finite; a triangle without area; an edge of one triangle (open solid) or more than
 *        two; triangles that meet in a point only; a surface that cannot be oriented, encloses
 *        nothing or has several shells; a feature angle that leaves one face only.
 */
SolidSurface makeSolidSurface(const SolidInput& input, const SolidOptions& options = {});

/// The different ids of some triangles, rising. @param triangles rows of the solid's triangles.
std::vector<Index> facesOfTriangles(const SolidSurface& solid, const std::vector<Index>& triangles);

/// Rows of the triangles of some faces, rising. @param faceIds in any order.
std::vector<Index> trianglesOfFaces(const SolidSurface& solid, const std::vector<Index>& faceIds);
}

#endif
