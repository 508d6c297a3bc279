// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A disk map as a mesh of the plane in which it is linear over each triangle.
 */
#ifndef hexsweep_DomainTriangulation_h
#define hexsweep_DomainTriangulation_h

#include "Core/DiskMaps/DiskDomain.h"

namespace hexsweep
{
/**
 * Triangles that share edges as those of the map do, in domain coordinates (see DomainTriangles).
 *
 * For Annulus the mesh covers the strip 0 <= arg z <= 2 pi: triangles across the cut are there
 * twice, at its lower and at its upper edge, on copies of the points that lie beyond.
 */
struct DomainTriangulation
{
  PlanePoints points;
  Triangles triangles; ///< of any orientation: those of the map
  /// Row of the map that each triangle is; rising.
  std::vector<Index> origin;
};

/// @param disk n x 2, a map to the domain. @param triangles ids in [0, n), of any orientation.
DomainTriangulation domainTriangulation(
  DiskDomain domain, const PlanePointsRef& disk, const TrianglesRef& triangles);
}

#endif
