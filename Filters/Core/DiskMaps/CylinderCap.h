// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A cap with one hole as the annulus that it is conformal to: its modulus, and the angles of
 * its boundary nodes (paper section 3.1.2, step 2).
 */
#ifndef hexsweep_CylinderCap_h
#define hexsweep_CylinderCap_h

#include "Core/DiskMaps/AnnulusMap.h"

namespace hexsweep
{
/// A cap with one hole on the cylinder that it is conformal to.
struct CylinderCap
{
  AngleFunction angle;
  Eigen::VectorXd correction; ///< radians; conformal angle = angle + correction
  double logRadius = 0.0;     ///< conformal modulus: log(outer radius / hole radius)
};

/**
 * The harmonic angle and the modulus of a cap with one hole.
 *
 * @param laplacian symmetric: cotangent weights, or intrinsic ones.
 * @param loops     the outer one and the hole, each with the surface on its left.
 * @throw InvalidInput (see windingAngle()), SolverFailure.
 */
CylinderCap measureCylinder(const SparseMatrix& laplacian, const PointsRef& points,
  const TrianglesRef& triangles, const std::vector<Loop>& loops);

/// Conformal angles (radians) along a loop, unwrapped from its first node.
std::vector<double> loopAngles(const CylinderCap& cylinder, const Loop& loop);

/**
 * The same where they turn once in the given direction (1: counter-clockwise, as the outer loop
 * does; -1: as the hole does) without standing still; otherwise, on a very distorted
 * triangulation, `lengths` in that direction, turned as a whole to fit.
 *
 * @param lengths arc lengths along the loop, scaled to [0, 2 pi).
 */
std::vector<double> monotoneLoopAngles(const CylinderCap& cylinder, const Loop& loop,
  const std::vector<double>& lengths, double direction);
}

#endif
