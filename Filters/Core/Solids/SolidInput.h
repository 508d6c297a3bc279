// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangles from a file, made a checked and oriented SolidSurface.
 */
#ifndef hexsweep_SolidInput_h
#define hexsweep_SolidInput_h

#include "Core/Solids/SolidSurface.h"

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
  /// Input point that each point is; empty: its own row.
  std::vector<Index> pointIds;
  /// Cells that were quads before they were cut into triangles.
  Quads quads{ 0, 4 };
  /// Input cell that each quad is (or, of a volume mesh, is a face of).
  std::vector<Index> quadCellIds;
  /// Row of `quads` that each triangle is half of, -1: none; empty: there are no quads.
  std::vector<Index> quadOfTriangle;
};

struct SolidOptions
{
  /// Points on open edges that are nearer than this are one; relative to the local edge length, in
  /// [0, 0.5).
  double matchTolerance = 1e-6;
  /// Radians, in (0, pi): neighbours whose normals differ by less are in one face. Only looked at
  /// where there are no face ids.
  double featureAngle = Pi / 6.0;
  Index firstFaceId = 0; ///< of faces that are found by angle
  /// Part the surface where it touches itself, see partTouchingSheets(), instead of refusing it.
  bool partTouching = false;
};

/// Some triangles of a solid, in this order, with all of its points; ids are those of the solid.
SolidInput selectTriangles(const SolidInput& input, const std::vector<Index>& rows);

/// @throw InvalidInput: no triangles; id lists of the wrong length; a corner that does not exist;
/// coordinates as in
///        checkCoordinates().
void checkSolidInput(const SolidInput& input);

/**
 * Merges coincident points, leaves out collapsed triangles, flips away those without area (see
 * flipDegenerateTriangles()), turns the others outward and checks that they bound a solid.
 *
 * Points are merged along open edges and edges without length only, so that a solid that touches
 * itself stays as it is.
 * Costs O(n log n).
 *
 * @throw InvalidInput as checkSolidInput(); a triangle without area that cannot be flipped away; an
 * edge of one triangle (open solid) or more than two; triangles that meet in a point only; a
 * surface that cannot be oriented, encloses nothing or has several shells; a feature angle that
 * leaves one face only.
 */
SolidSurface makeSolidSurface(const SolidInput& input, const SolidOptions& options = {});
}

#endif
