// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How high the levels of a stack are over each node of its plane mesh.
 */
#ifndef hexsweep_StackSheets_h
#define hexsweep_StackSheets_h

#include "Core/Stacks/StackLevels.h"

namespace hexsweep
{
/// The quads of the plane across the sweep.
struct StackPlane
{
  QuadMesh mesh;               ///< w = 0, counter-clockwise
  std::vector<Index> regionOf; ///< one a quad
};

/// A level over a node.
struct SheetNode
{
  Index level;
  double height;
  bool fixed; ///< on a cap
};

/// The levels over each node, rising.
using StackSheets = std::vector<std::vector<SheetNode>>;

/**
 * On its caps a level is where these are. Between them it is harmonic on the mesh, and keeps off
 * the levels above and below: by its share of the room between caps, or by `gap`, or by what a
 * slope of a quarter gains from the cap that it begins at, whichever is least. So levels of flat
 * caps are planes, unless a step is thin.
 *
 * @param gap length, > 0.
 */
StackSheets placeSheets(const StackPlane& plane, const StackArrangement& arrangement,
  const StackLevels& levels, const CapHeights& heights, double gap);
}

#endif
