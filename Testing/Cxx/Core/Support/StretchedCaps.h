// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Badly shaped caps: stretched ones, strips of needles.
 */
#ifndef StretchedCaps_h
#define StretchedCaps_h

#include "Support/CapMeshes.h"

namespace test
{
/// A plate with holes, stretched along x; curved in both directions if asked.
TriangleMesh stretchedPlate(std::size_t holes, bool curved, double stretch = 1000.0);

/// Rows of 22 nodes each over the unit square, six pairs of them `height` apart, and triangles
/// between neighbouring rows.
TriangleMesh needleStrips(double height, bool curved);

/// Whether d lies inside the circle through a, b, c of the plane by more than a part of it.
bool isInCircle(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b,
  const Eigen::RowVector3d& c, const Eigen::RowVector3d& d, double part);
}

#endif
