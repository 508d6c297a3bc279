// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The eigenfunctions of a stack of layers.
 */
#ifndef hexsweep_LayerModes_h
#define hexsweep_LayerModes_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/**
 * Linear finite elements on the heights of L layers, with the ends held at zero.
 *
 * With M1 and K1 the (L - 1) x (L - 1) mass and stiffness matrix of the inner layers, column j of
 * `functions` solves K1 f = eigenvalue_j M1 f, and functions^T M1 functions = I. Functions are
 * sorted by their eigenvalue, which grows with the number of their changes of sign.
 */
struct LayerModes
{
  Eigen::VectorXd eigenvalues; ///< L - 1, rising, > 0, unit 1 / length^2
  Eigen::MatrixXd functions;   ///< (L - 1) x (L - 1), row k - 1 is layer k
  Eigen::MatrixXd analysis;    ///< functions^T M1: takes values on layers to coefficients
  /// Coefficients of the load that the functions 1 - t and t make, which are 1 at the first and
  /// last layer and linear in the height: functions^T M1 (L - 1 rows, all L + 1 columns) times
  /// them.
  Eigen::VectorXd firstLoad;
  Eigen::VectorXd lastLoad;
  Eigen::VectorXd fractions; ///< L + 1: t on each layer, 0 to 1
  /// Layers are equal: column j (from 0) is even about the middle layer for even j, else odd.
  bool isSymmetric = false;
};

/**
 * Equal layers: the functions are sines (see \cite Hockney1965 for the transform along a direction
 * of a grid). Unequal ones: a dense generalised eigenproblem, O(L^3).
 *
 * @param heights L >= 1 heights, > 0.
 * @throw InvalidInput for heights that are not positive and finite.
 * @throw SolverFailure when the eigenproblem does not converge (heights of absurd ratios).
 */
LayerModes layerModes(const Eigen::VectorXd& heights);
}

#endif
