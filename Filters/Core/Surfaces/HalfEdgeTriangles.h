// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangles glued along half-edges, for flips and splits.
 *
 * Only the gluing counts, not the vertices: two edges may join the same vertices and an edge may
 * lead from a vertex to itself, as intrinsic triangulations need it.
 */
#ifndef hexsweep_HalfEdgeTriangles_h
#define hexsweep_HalfEdgeTriangles_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// Half-edge 3 t + c runs from corner c of triangle t to the next corner, the triangle on its left.
class HalfEdgeTriangles
{
public:
  /// @param triangles an oriented 2-manifold, see checkSurface().
  explicit HalfEdgeTriangles(const TrianglesRef& triangles);

  Index numberOfTriangles() const { return static_cast<Index>(this->From.size()) / 3; }
  Index numberOfHalfEdges() const { return static_cast<Index>(this->From.size()); }

  static Index next(Index half) { return half % 3 == 2 ? half - 2 : half + 1; }
  static Index previous(Index half) { return half % 3 == 0 ? half + 2 : half - 1; }

  /// The half-edge on the other side; -1 on the boundary.
  Index twin(Index half) const { return this->Twin[static_cast<std::size_t>(half)]; }
  Index from(Index half) const { return this->From[static_cast<std::size_t>(half)]; }
  Index to(Index half) const { return this->from(next(half)); }
  /// The corner across from the half-edge, in its triangle.
  Index apex(Index half) const { return this->from(previous(half)); }

  Triangles triangles() const;

  /**
   * Replaces the edge a b with apexes c (left) and d (right) by the edge c d.
   *
   * The triangle of `half` becomes (c, a, d), that of its twin (d, b, c); the new edge is the
   * last half-edge of both. Half-edges c a, a d, d b, b c are the first two of these triangles.
   *
   * @param half an inner edge whose sides are two different triangles.
   */
  void flip(Index half);

  /**
   * Puts a vertex on an edge a b with apexes c (left) and d (right).
   *
   * The triangle of `half` becomes (a, vertex, c), that of its twin (vertex, a, d); new triangles
   * (vertex, b, c) and, if there is a twin, (b, vertex, d) are appended in this order.
   */
  void splitEdge(Index half, Index vertex);

  /// Puts a vertex into a triangle (a, b, c), which becomes (a, b, vertex); (b, c, vertex) and
  /// (c, a, vertex) are appended.
  void splitTriangle(Index triangle, Index vertex);

private:
  void glue(Index half, Index other);
  Index append(Index a, Index b, Index c);

  std::vector<Index> From;
  std::vector<Index> Twin;
};
}

#endif
