// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The plane domains that caps are mapped to, and the triangles of a map in them.
 */
#ifndef hexsweep_DiskDomain_h
#define hexsweep_DiskDomain_h

#include "Core/Common/Mesh.h"

#include <Eigen/Geometry>

namespace hexsweep
{
/// Where the disk coordinates of a cap lie.
enum class DiskDomain
{
  Disk,    ///< the unit disk; one loop, or holes of any shape
  Annulus, ///< r <= |z| <= 1; linear in (log |z|, arg z) over each triangle
  Circles  ///< the unit disk with circular holes
};

/**
 * Triangles of a disk map in coordinates in which the map is linear over each of them.
 *
 * For Disk and Circles these are the disk coordinates. For Annulus they are (log |z|, arg z): the
 * annulus becomes a strip with straight sides, in which a harmonic map with positive weights has
 * no flipped triangle whatever the angles on its two loops (a harmonic map to a flat cylinder
 * with geodesic boundary), while the annulus itself folds as soon as its hole turns or grows too
 * much (the Nitsche bound). Triangles across the cut arg z = 0 appear twice.
 */
struct DomainTriangles
{
  /// 3 t x 3, z = 0: corners of the positively oriented triangles.
  Points corners;
  /// Row of the mesh that each of the t triangles is.
  std::vector<Index> triangle;
  /// Rows of the mesh that are flipped or have no area, by exact orientation.
  std::vector<Index> flipped;
};

/// The three corners (rows) of one triangle, arg z unwrapped from corner to corner.
Eigen::Matrix<double, 3, 2, Eigen::RowMajor> domainCorners(DiskDomain domain,
  const PlanePointsRef& disk, const Eigen::Ref<const Eigen::Matrix<Index, 1, 3>>& triangle);

/// All of them. Rows of `triangles` must be positively oriented on the surface.
DomainTriangles domainTriangles(
  DiskDomain domain, const PlanePointsRef& disk, const TrianglesRef& triangles);

/// arg z of a point in domain coordinates moved to [0, 2 pi); nothing to do but for Annulus.
Eigen::RowVector2d wrapDomainPoint(DiskDomain domain, const Eigen::RowVector2d& point);

/// The angle brought to (-pi, pi].
double wrapAngle(double angle);
}

#endif
