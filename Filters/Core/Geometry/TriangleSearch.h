// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Closest point on a set of triangles, in space or in the disk.
 */
#ifndef hexsweep_TriangleSearch_h
#define hexsweep_TriangleSearch_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// A point of a triangle: position = sum of coordinates[c] * corner c.
struct TrianglePoint
{
  Index triangle = -1;
  Eigen::RowVector3d coordinates = Eigen::RowVector3d::Zero(); ///< barycentric, in [0, 1], sum 1
  double distance = 0.0; ///< from the point that was asked for
};

/// The point of the triangle with rows a, b, c nearest to p (barycentric coordinates, distance).
TrianglePoint closestPointOnTriangle(const Eigen::RowVector3d& p, const Eigen::RowVector3d& a,
  const Eigen::RowVector3d& b, const Eigen::RowVector3d& c);

/**
 * A bounding-volume tree over triangles that are given by their corners.
 *
 * Building costs O(n log n), a query O(log n) on meshes. Ties go to the lowest triangle id.
 */
class TriangleSearch
{
public:
  /// @param corners 3 t x 3: the corners of triangle i are rows 3 i, 3 i + 1, 3 i + 2.
  explicit TriangleSearch(Points corners);
  TriangleSearch(const PointsRef& points, const TrianglesRef& triangles);

  /// @param start a triangle near p if one is known (any valid one is correct), or -1.
  /// @return some triangle where p is not finite; triangle -1 only where there are none.
  TrianglePoint closest(const Eigen::RowVector3d& p, Index start = -1) const;

private:
  struct Node
  {
    Eigen::RowVector3d low;
    Eigen::RowVector3d high;
    Index begin; // first triangle in Order
    Index end;   // one past the last
    Index right; // right child; the left one follows its parent; 0 in a leaf
  };
  void build();
  double squaredDistanceToBoxOf(const Eigen::RowVector3d& p, Index place) const;
  TrianglePoint onTriangle(const Eigen::RowVector3d& p, Index place) const;

  Points Corners;           // in the order of the leaves
  std::vector<Index> Order; // ids of the triangles
  std::vector<Index> Place; // of each id in Order
  std::vector<Node> Nodes;
};
}

#endif
