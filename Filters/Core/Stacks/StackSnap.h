// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Puts columns of nodes on the true surfaces of the sides that they run along.
 */
#ifndef hexsweep_StackSnap_h
#define hexsweep_StackSnap_h

#include "Core/Geometry/ModelGeometry.h"
#include "Core/Stacks/StackColumns.h"
#include "Core/Stacks/StackFrame.h"

namespace hexsweep
{
struct StackSnap
{
  Index moved = 0;
  /// Nodes beside one side that had to stay: no place is near, or a quad would be turned over.
  Index left = 0;
};

/// Sides that touch a node of the plane, and heights at which they do.
using NodeSides = std::vector<std::map<Index, double>>;

/// @param sideFaces face of each outer quad of the columns; -1: none. @param points of the columns.
NodeSides nodeSides(const StackPlane& plane, const StackColumns& columns, const PointsRef& points,
  const std::vector<Index>& sideFaces);

/**
 * Moves the nodes of the plane on borders to where the sides beside them are; where there are
 * several, to a place that they have in common, if there is one.
 *
 * @param reach length: nodes that would move further stay.
 */
StackSnap snapToSides(const ModelGeometry& geometry, const StackFrame& frame,
  const NodeSides& sides, double reach, StackPlane& plane);
}

#endif
