// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Conformal map of a cap with one hole to an annulus (paper section 3.1.2, step 2, to the
 * letter).
 *
 * Sweeps take DiskMaps/CylinderCap instead, which needs no cut and measures both caps alike.
 */
#ifndef hexsweep_ConformalAnnulus_h
#define hexsweep_ConformalAnnulus_h

#include "Core/Solvers/SurfaceLaplacian.h"

namespace hexsweep
{
/// r <= |z| <= 1, z = r^height e^(i angle).
struct ConformalAnnulus
{
  Eigen::VectorXd height; ///< n values: 0 on the outer loop, 1 on the hole
  Eigen::VectorXd angle;  ///< n values in radians, each up to whole turns
  double innerRadius = 0.0;
  /**
   * Period of the form that is conjugate to the height's, round the hole, over the 2 pi of the
   * angle's: 1 for a pair that is conjugate. Above 1 by the energies' discretisation error, since
   * both are bounds of the same modulus; of second order in the edge length.
   */
  double period = 0.0;
};

/**
 * The annulus map by a pair of conjugate harmonic 1-forms: the differential of the harmonic
 * function that is 0 on the outer loop and 1 on the hole, and the harmonic form of period 2 pi
 * round the hole \cite Zeng2009.
 *
 * The latter's class comes from a cut, see leftOfCut(). Its energy bounds log(1 / r) from above,
 * that of the former from below; the radius is taken from their geometric mean.
 *
 * @param points n x 3. @param triangles oriented.
 * @param loops  the outer one, then the hole.
 * @throw InvalidInput when an energy is not a positive number; SolverFailure.
 */
ConformalAnnulus conformalAnnulus(
  const PointsRef& points, const TrianglesRef& triangles, const std::vector<Loop>& loops);
}

#endif
