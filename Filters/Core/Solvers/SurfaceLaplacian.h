// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Edge weights of the discrete harmonic energy on a triangulated surface.
 *
 * Section 3.1.1 of the paper, S. Cai and T. J. Tautges \cite CaiTautges2013, equations (1) to (3).
 */
#ifndef hexsweep_SurfaceLaplacian_h
#define hexsweep_SurfaceLaplacian_h

#include "Core/Common/Mesh.h"
#include "Core/Solvers/SparseMatrix.h"

namespace hexsweep
{
/// How an edge weighs in the harmonic energy.
enum class Weights
{
  Cotangent, ///< equation (1); exact for the metric, negative on obtuse triangles
  MeanValue, ///< \cite Floater2003MeanValue, positive on every triangulation, not symmetric
  Intrinsic  ///< equation (1) on the intrinsic Delaunay triangulation, see intrinsicLaplacian()
};

/**
 * The matrix L with (L f)_i = sum_j w_ij (f_i - f_j), equation (3), with
 * w_ij = cot(theta_k^ij) + cot(theta_l^ij), equation (1) (on the boundary the one angle there is).
 *
 * f^T L f is the energy E(f) of equation (2); it is twice the Dirichlet integral of the piecewise
 * linear function f. Rows of points that no triangle uses are empty.
 *
 * @return n x n, symmetric bit for bit, positive semidefinite, rows sum to zero.
 * @throw InvalidInput when a triangle has no area.
 */
SparseMatrix cotangentLaplacian(const PointsRef& points, const TrianglesRef& triangles);

/// The same from the cotangents of triangles (see cotangents()); an edge from a vertex to itself
/// adds nothing.
SparseMatrix laplacianOfCotangents(
  Index numberOfPoints, const TrianglesRef& triangles, const PointsRef& cotangents);

/**
 * The matrix of M. S. Floater's mean value coordinates (\cite Floater2003MeanValue):
 * w_ij = (tan(a/2) + tan(b/2)) / |v_i v_j|, a and b the angles at v_i beside the edge.
 *
 * @return n x n, not symmetric, off-diagonal entries negative, rows sum to zero.
 * @throw InvalidInput when a triangle has no area.
 */
SparseMatrix meanValueLaplacian(const PointsRef& points, const TrianglesRef& triangles);

/**
 * The matrix of cotangentLaplacian() for the intrinsic Delaunay triangulation.
 *
 * No weight of an inner edge is negative (up to rounding); f^T L f is the least over all
 * triangulations with these vertices, for every f \cite Rippa1990, \cite BobenkoSpringborn2007.
 */
SparseMatrix intrinsicLaplacian(const PointsRef& points, const TrianglesRef& triangles);

/// Any of them.
SparseMatrix surfaceLaplacian(
  const PointsRef& points, const TrianglesRef& triangles, Weights weights);

/// What measures a surface: cotangent weights in place of mean value ones, which are no metric's.
SparseMatrix symmetricLaplacian(
  const PointsRef& points, const TrianglesRef& triangles, Weights weights);
}

#endif
