// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sheets across the inside of a solid, at the height of its flat caps.
 */
#ifndef hexsweep_CapSections_h
#define hexsweep_CapSections_h

#include "Core/Stacks/CapLikeFaces.h"

#include <utility>
#include <vector>

namespace hexsweep
{
/// Where a plane crosses an edge of a surface.
struct EdgeCrossing
{
  Index low; ///< ends of the edge: points of the surface
  Index high;
  double fraction; ///< of the way from `low` to `high`, in (0, 1)
};

/// The part of a plane that goes on from caps into the inside of a solid, without the caps.
struct CapSection
{
  std::vector<EdgeCrossing> crossings;
  /// Normals along the sweep. Of the solid's points; number n + i of n points is crossings[i].
  Triangles triangles{ 0, 3 };
  std::vector<Index> sheetOf; ///< one a triangle: connected parts, numbered from 0 on
};

/// Heights of the flat caps of a solid but the lowest and the highest, each once, rising.
/// @param heights one a point, along the direction of the faces. @param tolerance a length.
std::vector<double> capLevels(const SolidSurface& solid, const CapLikeFaces& faces,
  const Eigen::VectorXd& heights, double tolerance);

/**
 * Parts of a plane inside a solid that border on triangles of the solid in that plane.
 *
 * @param framePoints of the surface, n x 3: the plane is across the third axis.
 * @param triangles   closed, outward.
 * @param tolerance   a length: points nearer to the plane are on it.
 * @throw InvalidInput where the solid's borders in the plane cross.
 */
CapSection sectionAt(
  const PointsRef& framePoints, const TrianglesRef& triangles, double level, double tolerance);
}

#endif
