// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The nodes of all linking sides by loop, ring and column.
 *
 * Ring k of a loop is the closed node row of layer k: ring 0 lies on the source loop, ring L on the
 * target loop. A column is the node path that leads from one to the other.
 */
#ifndef hexsweep_RingStack_h
#define hexsweep_RingStack_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// Row k, column j: linking point id of the node of ring k on the column of node j of the loop.
using RingTable = Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/**
 * Who meshes the linking sides knows it (meshLinkingSides()); from quads that somebody else made it
 * is traced (traceLinkingRings()). Nothing below needs to search for a ring again.
 */
struct RingStack
{
  Points points; ///< of all linking sides
  /// One a source loop, (numberOfLayers() + 1) x (nodes of the loop). Where points coincide along a
  /// seam, the id is the smallest one.
  std::vector<RingTable> tables;
  /// loops[l][j]: point of the source quads that column j of table l begins at.
  std::vector<Loop> loops;
  /// One a loop: whether the side's first quad, as it was given, runs against its ring.
  std::vector<bool> turned;

  /// Greatest distance between a source loop node and the linking node that it was matched to.
  double maximumMatchDistance = 0.0;
  /// Number of loop nodes whose linking node is not at bit for bit the same place.
  Index snapped = 0;

  /// L >= 1 (0 when there is no loop).
  Index numberOfLayers() const
  {
    return this->tables.empty() ? 0 : static_cast<Index>(this->tables.front().rows()) - 1;
  }
};

/**
 * Coordinates of one ring, one row a column, in the order of the nodes of the source loop.
 *
 * @param ring in [0, numberOfLayers()].
 */
Points ringPoints(const RingStack& rings, std::size_t loop, Index ring);

/**
 * The stack of sides that are numbered side after side, node k n + j of each being that of ring k
 * and column j.
 *
 * @param points of all sides, so numbered.
 * @param loops  see RingStack.
 */
RingStack stackRings(Points points, std::vector<Loop> loops, Index layers);
}

#endif
