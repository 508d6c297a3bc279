// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which triangle of a plane mesh a point lies in, by walking from triangle to triangle.
 */
#ifndef hexsweep_TriangleWalk_h
#define hexsweep_TriangleWalk_h

#include "Core/Geometry/PlaneTriangleSearch.h"

#include <optional>

namespace hexsweep
{
/// A point that lies in no triangle.
struct OutsidePoint
{
  Index point;     ///< row of the points that were asked for
  double distance; ///< from the nearest triangle
};

/// Rows belong to the points that were asked for.
struct LocatedPoints
{
  std::vector<Index> triangles; ///< -1 only where there are none at all
  /// n x 3, barycentric, in [0, 1], sum 1; of the nearest point of the triangle where a point
  /// lies outside.
  Points coordinates;
  std::vector<OutsidePoint> outside; ///< by rising row
};

/**
 * Locates points in the positively oriented triangles of a plane mesh.
 *
 * Mesh and points are visited in the order of Hilbert's curve: the walk to a point begins in the
 * triangle of the point before it, or at the vertex next to it on the curve, whichever is nearer
 * (see visibilityWalk()). Signs are exact. Walks that leave the mesh or grow long are given up for
 * a search by boxes, as are points on a boundary.
 *
 * The answer depends on the point alone, not on the numbering, on the other points or on where a
 * walk began: a point on an edge or a vertex belongs to the lowest row among the triangles that it
 * touches. Triangles must not overlap but by folds of a map: points of flipped triangles, where the
 * positive ones may lie twice, belong to the lowest row too. A point in no triangle gets the
 * nearest one.
 */
class TriangleWalk
{
public:
  /// See PlaneTriangulation for the arguments and for what is thrown. O(n).
  TriangleWalk(const PlanePointsRef& points, const TrianglesRef& triangles);

  /// No triangle is positively oriented.
  bool empty() const { return this->Mesh.numberOfTriangles() == 0; }

  /// Rows of triangles that are flipped, near ones together; like those without area they hold no
  /// points.
  const std::vector<Index>& flipped() const { return this->Mesh.flipped(); }

  /**
   * @param points n x 2.
   * @throw Aborted.
   */
  LocatedPoints locate(const PlanePointsRef& points, const Progress& progress = {});

private:
  using Vertex = PlaneTriangulation::Point;

  /// Where a point is, in the numbers of Mesh.
  struct Place
  {
    std::uint32_t triangle;
    bool outside;
    double distance; // if outside
    Eigen::RowVector3d coordinates;
  };

  Place locate(const Vertex& q, std::uint32_t start);
  std::uint32_t lowestAround(std::uint32_t side, const Vertex& q);
  std::uint32_t search(const Vertex& q);
  bool inFlipped(const Vertex& q) const;
  const BoxTree& boxes();

  PlaneTriangulation Mesh;
  std::optional<BoxTree> Boxes;       // made when a walk fails for the first time
  std::vector<Vertex> FlippedCorners; // three a flipped triangle, positively oriented
  BoxTree FlippedBoxes;
};
}

#endif
