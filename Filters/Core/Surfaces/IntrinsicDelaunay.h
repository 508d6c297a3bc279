// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The Delaunay triangulation of a surface in its own metric.
 *
 * After A. I. Bobenko, B. A. Springborn \cite BobenkoSpringborn2007 and M. Fisher et al.
 * \cite Fisher2007.
 */
#ifndef hexsweep_IntrinsicDelaunay_h
#define hexsweep_IntrinsicDelaunay_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/**
 * A triangulation of a surface by geodesic edges between its vertices.
 *
 * Edges are straight within the unfolded surface but need not be edges of the mesh. Two edges may
 * join the same vertices, and an edge may lead from a vertex back to itself.
 */
struct IntrinsicTriangulation
{
  Triangles triangles;
  /// Row t, column c: length of the edge from corner c to corner c + 1 of triangle t.
  Points edgeLengths;
  /// Row t, column c: cotangent of the angle at corner c.
  Points cotangents;
  /// Row t, column c: half-edge 3 t' + c' across from half-edge 3 t + c (see HalfEdgeTriangles).
  Triangles twins;
  /// Rows 3 t to 3 t + 2: the corners of triangle t in a plane of its own, counter-clockwise.
  PlanePoints corners;
  /// Row t, column c: how many edges of the mesh cross the edge from corner c to corner c + 1.
  Triangles crossings;
  /// Flips it took from the mesh's own triangles.
  Index flips = 0;
};

/**
 * Flips inner edges until all are Delaunay: angles across from an edge sum to at most pi.
 *
 * The boundary stays. The surface's shape is not touched: triangles are unfolded in pairs, each
 * held by plane coordinates of its corners rather than by edge lengths, from which the height of a
 * needle would be the difference of almost equal numbers. The rounding error of an angle stays at
 * machine precision times the triangle's aspect. How often edges of the mesh cross those of the
 * result is counted in integers, free of rounding (see triangleCrossings()).
 *
 * @param triangles an oriented 2-manifold, see checkSurface().
 * @throw InvalidInput when a triangle has no area.
 */
IntrinsicTriangulation intrinsicDelaunay(const PointsRef& points, const TrianglesRef& triangles);
}

#endif
