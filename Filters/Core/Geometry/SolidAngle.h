// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Solid angles, which tell inside from outside.
 */
#ifndef hexsweep_SolidAngle_h
#define hexsweep_SolidAngle_h

#include "Core/Common/Constants.h"
#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// Solid angle of a closed surface (4 pi inside, 2 pi on it, 0 outside) above which a point is
/// inside, whichever way the surface is oriented.
constexpr double InsideAngle = 3.0 * Pi;

/// Solid angle (steradians, in [-2 pi, 2 pi]) under which a point sees a triangle, positive where
/// it runs clockwise seen from there, 0 from its own plane \cite VanOosteromStrackee1983.
double solidAngle(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b,
  const Eigen::RowVector3d& c, const Eigen::RowVector3d& eye);
}

#endif
