// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A surface whose triangles are split at points, one after another, and that keeps its
 * shape.
 */
#ifndef hexsweep_SplitSurface_h
#define hexsweep_SplitSurface_h

#include "Core/Geometry/TriangleSearch.h"
#include "Core/Surfaces/HalfEdgeTriangles.h"

namespace hexsweep
{
/// Half-edges are numbered as in HalfEdgeTriangles; those of the given triangles come first.
class SplitSurface
{
public:
  /// @param surface an oriented 2-manifold, see checkSurface(); each point is used.
  explicit SplitSurface(const TriangleMesh& surface);

  const HalfEdgeTriangles& triangles() const { return this->Triangles; }
  const Eigen::RowVector3d& point(Index v) const
  {
    return this->Places[static_cast<std::size_t>(v)];
  }
  Index numberOfPoints() const { return static_cast<Index>(this->Places.size()); }
  /// Row of the given surface that each triangle is part of.
  const std::vector<Index>& origins() const { return this->Origins; }
  TriangleMesh mesh() const;

  /// The half-edges from a point, one a triangle at it, counter-clockwise; at the boundary the
  /// first one is on it.
  std::vector<Index> around(Index v) const;
  /// The points that an edge joins with v, counter-clockwise.
  std::vector<Index> neighbors(Index v) const;
  /// A half-edge between two points, of either direction; -1: no edge joins them.
  Index edge(Index u, Index v) const;
  /// Sum of the triangles' area vectors round a point, as a unit vector.
  Eigen::RowVector3d normal(Index v) const;

  /// Where a place is, or the nearest place to it, on what has become of a given triangle; the
  /// result's triangle is one of now. Linear in the number of those.
  TrianglePoint locate(Index given, const Eigen::RowVector3d& place) const;

  /// @return the new point. @param place on the edge.
  Index splitEdge(Index half, const Eigen::RowVector3d& place);
  /// @return the new point. @param place in the triangle.
  Index splitTriangle(Index triangle, const Eigen::RowVector3d& place);

private:
  void append(Index origin);
  void touch(Index triangle);

  HalfEdgeTriangles Triangles;
  std::vector<Eigen::RowVector3d> Places;
  std::vector<Index> Origins;
  std::vector<std::vector<Index>> Parts; // of each given triangle
  std::vector<Index> HalfOf;             // some half-edge from each point
};
}

#endif
