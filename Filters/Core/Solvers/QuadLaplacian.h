// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Bilinear surface finite elements on quads in space.
 */
#ifndef hexsweep_QuadLaplacian_h
#define hexsweep_QuadLaplacian_h

#include "Core/Common/Mesh.h"

#include <Eigen/SparseCore>

namespace hexsweep
{
/// Stiffness and mass matrix of one quad mesh, both n x n, symmetric, with the same sparsity.
struct QuadLaplacian
{
  /// K_ij = integral of grad phi_i . grad phi_j: positive semidefinite, rows sum to zero, no unit.
  Eigen::SparseMatrix<double> stiffness;
  /// M_ij = integral of phi_i phi_j: unit of an area; rows of points that no quad uses are zero.
  Eigen::SparseMatrix<double> mass;
};

/**
 * Assembles the Laplace-Beltrami operator of the bilinear surface through the corners of each
 * quad, with the metric of the quad itself in space, so that no projection plane is needed
 * (surface finite elements \cite Dziuk1988). 2 x 2 Gauss points, which are exact for
 * parallelograms.
 *
 * @param points n x 3.
 * @param quads  m x 4 ids in [0, n). Orientation does not matter. Gauss points where the quad has
 *        no area take a tiny one, so that folded quads leave the matrices finite.
 */
QuadLaplacian quadLaplacian(const PointsRef& points, const QuadsRef& quads);
}

#endif
