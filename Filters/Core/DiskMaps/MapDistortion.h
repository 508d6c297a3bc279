// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How far a disk map is from an isometry of angles, and its energy.
 */
#ifndef hexsweep_MapDistortion_h
#define hexsweep_MapDistortion_h

#include "Core/DiskMaps/CapDisk.h"

namespace hexsweep
{
/// Angles of the triangles' corners in the domain against those on the surface.
struct MapDistortion
{
  double worstAngle = 0.0; ///< greatest difference, in degrees
  double meanAngle = 0.0;  ///< mean difference over all corners, in degrees
  /// A quarter of equation (2) with cotangent weights: half the integral of the squared gradients
  /// of both coordinates. No less than the area of the image, and equal to it for a conformal map.
  /// Free of units.
  double dirichletEnergy = 0.0;
};

/// In the coordinates in which the map is linear, see domainTriangles(): for an annulus these are
/// (log r, angle), which differ from the plane's by a conformal map.
MapDistortion mapDistortion(const CapDisk& cap);
}

#endif
