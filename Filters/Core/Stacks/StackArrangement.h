// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The borders of all caps in one plane, and which caps lie over each part of it.
 */
#ifndef hexsweep_StackArrangement_h
#define hexsweep_StackArrangement_h

#include "Core/Stacks/CapHeights.h"
#include "Core/Stacks/ConstrainedTriangulation.h"
#include "Core/Stacks/StackFrame.h"

#include <string>
#include <vector>

namespace hexsweep
{
/// A border between regions, or of a region.
struct RegionEdge
{
  Index a; ///< points of the arrangement; `left` lies to the left of the way from a to b
  Index b;
  Index left;  ///< region
  Index right; ///< region with a greater number, or -1: no material
};

/// The plane across the sweep, parted by the borders of the caps.
struct StackArrangement
{
  TriangleMesh mesh;           ///< flat (w = 0), counter-clockwise; each point used
  std::vector<Index> regionOf; ///< one a triangle
  /// Of each region the caps over it from below: bottom, top, bottom, top, ... (places in
  /// CapLikeFaces::faces).
  std::vector<std::vector<std::size_t>> stacks;
  std::vector<RegionEdge> edges;
  std::vector<bool> corner; ///< one a point: where three faces of the solid meet
  Index merged = 0;         ///< see PlaneGraph
  double greatestMove = 0.0;
  double greatestGap = 0.0;
  /// Faces of the solid whose parts between merged curves are gone, rising.
  std::vector<Index> slivers;
};

/**
 * Projects the borders of all caps along the direction and parts the plane by them.
 *
 * Regions with the same caps that touch along an edge become one; parts without material are left
 * out. Points at which parts of the material touch are doubled.
 *
 * @param tolerance length up to which curves of different features become one; features that are
 *                  small themselves have less, see PlaneSegments.
 * @throw InvalidInput where caps do not alternate, with the place and the faces.
 */
StackArrangement arrangeStack(const SolidSurface& solid, const CapLikeFaces& faces,
  const StackFrame& frame, const PointsRef& framePoints, const CapHeights& heights,
  double tolerance);
}

#endif
