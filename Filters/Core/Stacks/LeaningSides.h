// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sides with draft: put upright before a stack is meshed, and the mesh leant back on them.
 */
#ifndef hexsweep_LeaningSides_h
#define hexsweep_LeaningSides_h

#include "Core/Geometry/ModelGeometry.h"
#include "Core/Stacks/StackColumns.h"
#include "Core/Stacks/StackFrame.h"

#include <set>

namespace hexsweep
{
/// A solid whose leaning sides were put upright.
struct UprightSolid
{
  Points points;             ///< in the frame; heights are as they were
  std::set<Index> leaning;   ///< ids of the sides that lean
  double greatestMove = 0.0; ///< of a point, across the direction
};

/**
 * Moves the upper borders of leaning sides over their lower ones: along the edges between sides
 * where there is one, else to the nearest place of the same face's lower border.
 *
 * @param framePoints of the solid, n x 3.
 */
UprightSolid uprightSolid(
  const SolidSurface& solid, const CapLikeFaces& faces, const PointsRef& framePoints);

/// What the mesh of an upright solid is leant back on.
struct LeaningSides
{
  const SolidSurface& solid;
  const PointsRef framePoints; ///< of the solid as it leans
  const StackFrame& frame;
  const std::set<Index>& leaning;
  const ModelGeometry* geometry; ///< may be none
};

/**
 * Moves the nodes on leaning sides across the direction to where these are at the nodes' heights,
 * and takes all others along, harmonically on the edges of the hexahedra; nodes on upright sides
 * stay.
 *
 * @param sideFaces face of each outer quad, -1 on caps.
 * @param points    of the columns, in the frame: moved.
 */
void leanBack(const LeaningSides& sides, const StackColumns& columns, const HexesRef& hexes,
  const std::vector<Index>& sideFaces, Points& points);
}

#endif
