// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The edges of a triangle mesh, numbered.
 */
#ifndef hexsweep_TriangleEdges_h
#define hexsweep_TriangleEdges_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// So that what belongs to an edge is computed once for all its triangles.
struct TriangleEdges
{
  /// e x 2, the ends of each edge, the smaller id first; in lexical order.
  Eigen::Matrix<Index, Eigen::Dynamic, 2, Eigen::RowMajor> ends;
  /// Row t, column c: the edge of triangle t opposite its corner c.
  Triangles opposite;
  /// Same place: 1 where the edge runs from corner c + 1 to corner c + 2, -1 where it runs back.
  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> direction;
};

/// @param triangles m x 3 ids.
TriangleEdges triangleEdges(const TrianglesRef& triangles);
}

#endif
