// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Parts of a linking side that are meshed already, as columns on the nodes of a ring.
 *
 * Volumes that share a face of their linking sides get the same nodes there when the second one is
 * given the quads of the first.
 */
#ifndef hexsweep_SidePatches_h
#define hexsweep_SidePatches_h

#include "Core/Common/Mesh.h"

#include <string>
#include <vector>

namespace hexsweep
{
struct MeshedColumns
{
  Index layers = 0; ///< 0 where there are no patches
  /// One a ring node: (layers + 1) x 3 nodes from source to target, or no rows where the column is
  /// not part of a patch.
  std::vector<Points> columns;
  /// Why patches could not be used: what to tell the user.
  std::vector<std::string> refused;
};

/**
 * Walks over the quads of each patch from ring to ring.
 *
 * @param patches structured quads, any orientation; each begins at neighbouring nodes of the ring.
 * @param ring    n x 3, the nodes of the source loop in order.
 * @param targetLoop m x 3, a closed polygon.
 * @param matchTolerance relative to the shorter ring edge at a node, and to the last edge of a
 *        column.
 * A patch of one layer counts as tessellation: it is how walls of an extrusion are given. A patch
 * that has no edge on the ring, does not reach the target loop, is not structured or has quads left
 * over is refused.
 *
 * @throw InvalidInput when patches have different numbers of layers.
 */
MeshedColumns tracePatches(const std::vector<QuadMesh>& patches, const PointsRef& ring,
  const PointsRef& targetLoop, double matchTolerance);

/**
 * @param isHeld one a column: whether it is a CAD edge.
 * @param wanted of a column's length.
 * @return fractions of the column's length: those of a patch where the column bounds it; in between
 *         them and the wanted ones of the nearest column that is held, linearly.
 */
std::vector<double> fractionsBeside(const MeshedColumns& meshed, const std::vector<bool>& isHeld,
  std::size_t column, const std::vector<double>& wanted);
}

#endif
