// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The harmonic angle about the hole of a cap; DiskMaps/CylinderCap adds the height.
 *
 * The height is the harmonic function that is 0 on the outer loop and 1 on the hole; the angle is
 * a harmonic function that grows by 2 pi round the hole: its differential is a closed harmonic
 * 1-form (paper section 3.1.2, step 2, where the two are conjugate).
 */
#ifndef hexsweep_AnnulusMap_h
#define hexsweep_AnnulusMap_h

#include "Core/Common/Mesh.h"
#include "Core/Solvers/SparseMatrix.h"

namespace hexsweep
{
/// A function that grows by 2 pi round the hole, known by values and by differences along edges.
struct AngleFunction
{
  /// n values, each up to a multiple of 2 pi.
  Eigen::VectorXd values;
};

/**
 * An angle function of the right winding, from an injective map of the filled cap: the argument
 * seen from the middle of the hole.
 *
 * @throw InvalidInput when no map of the filled cap can be found that winds once round the hole.
 */
AngleFunction windingAngle(const PointsRef& points, const TrianglesRef& triangles,
  const SparseMatrix& laplacian, const std::vector<Loop>& loops);

/// Right-hand side of the correction f for which angle + f is harmonic: sum_j w_ij d_ij.
Eigen::VectorXd angleSource(const SparseMatrix& laplacian, const AngleFunction& angle);

/**
 * The correction that makes the angle conjugate to the height: harmonic with free boundaries.
 *
 * @param symmetricLaplacian cotangent weights.
 * @param pinned a used vertex; the correction is 0 there.
 * @return n values to be added to angle.values.
 */
Eigen::VectorXd conformalCorrection(
  const SparseMatrix& symmetricLaplacian, const AngleFunction& angle, Index pinned);
}

#endif
