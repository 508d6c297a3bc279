// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cuts a triangulated surface along the polylines of another surface's borders.
 */
#ifndef hexsweep_BorderImprint_h
#define hexsweep_BorderImprint_h

#include "Core/Common/Mesh.h"

#include <optional>
#include <utility>

namespace hexsweep
{
/// Straight lines that are to become edges of a surface; they meet at their ends only.
struct BorderLines
{
  Points points;                ///< on or near the surface
  std::vector<bool> onBoundary; ///< one a point: it belongs on the surface's boundary
  std::vector<std::pair<Index, Index>> pieces; ///< pairs of points
};

/// What the surface has already.
struct ImprintBase
{
  TriangleMesh surface; ///< an oriented 2-manifold with boundary, each point used
  /// One a triangle: edges between different ids are borders, as are those of the boundary.
  std::vector<Index> faceIds;
  std::vector<Index> keep; ///< points of its borders that count as corners
  /// Edges of the boundary that must not be cut: what would begin in them begins at their ends.
  std::vector<std::pair<Index, Index>> undivided;
  /// Lines that are nearer to a border than this, or than what the facets of the two explain, are
  /// on it; lines within it of a corner run through it. In the points' unit, >= 0.
  double snap = 0.0;
};

/// A piece of a line, or of the border that it runs on.
struct ImprintedEdge
{
  std::pair<Index, Index> ends; ///< lower one first
  Index piece;                  ///< of BorderLines, the first where there are several
};

/// A surface of the same shape; the given points come first, unchanged.
struct ImprintedSurface
{
  TriangleMesh mesh;
  std::vector<Index> triangleOrigin; ///< row of the given surface that each triangle is part of
  std::vector<Index> pointOf;        ///< of mesh, one a point of the lines
  std::vector<ImprintedEdge> edges;  ///< by their ends
};

/**
 * Splits triangles at the lines' points and where lines cross edges; a line crosses a border in a
 * point of both.
 *
 * A line runs in the plane through its ends and the mean of the surface's normals there. What lies
 * on a border follows its edges, so that the two are one curve however their facets differ. New
 * points lie on the given triangles to rounding; a line that passes a vertex within a millionth of
 * the edge that it crosses runs through it.
 *
 * @return nothing where a line finds no way over the surface.
 */
std::optional<ImprintedSurface> imprintBorders(const ImprintBase& base, const BorderLines& lines);
}

#endif
