// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Walks over structured linking quads from ring to ring.
 */
#ifndef hexsweep_RingWalk_h
#define hexsweep_RingWalk_h

#include "Core/Linking/QuadNeighbors.h"
#include "Core/Linking/RingStack.h"

#include <string>

namespace hexsweep
{
/// Remembers which quads and nodes it has seen, so that all loops are walked by one and the same.
class RingWalk
{
public:
  /**
   * All three are kept by reference.
   *
   * @param points    m x 3.
   * @param quads     with welded seams, see weldLinkingSeams().
   * @param neighbors of these quads.
   */
  RingWalk(const PointsRef& points, const Quads& quads, const QuadNeighbors& neighbors);

  /**
   * The rings of one loop, from its matched first ring to the far end.
   *
   * @param firstRing linking point ids.
   * @param loop      number of the loop, for messages.
   * @return (layers + 1) x (nodes of the ring), at least one layer.
   * @throw InvalidInput, with the loop, the ring and the place, when the quads have a hole or are
   *        not structured, go on beyond the first ring, or a node is met twice.
   */
  RingTable walk(const Loop& firstRing, std::size_t loop);

  /// @throw InvalidInput when a quad was never reached.
  void checkAllSeen() const;

private:
  Eigen::RowVector3d center(Index quad) const;
  std::string describeEdge(Index a, Index b) const;
  /// Marks the nodes of a ring; no node may be on two.
  void claim(const Loop& ring, std::size_t loop, Index number);
  /// The quad ahead of a ring edge; -1 at the far end.
  Index quadAhead(Index a, Index b, std::size_t loop, Index ring) const;
  /// The node that follows `from` in a quad when one walks away from `beside`.
  Index across(Index quad, Index from, Index beside) const;
  /// The next ring; empty at the far end.
  Loop step(const Loop& ring, std::size_t loop, Index number);

  PointsRef Positions;
  const Quads& Cells;
  const QuadNeighbors& Neighbors;
  std::vector<char> QuadSeen;
  std::vector<char> PointSeen;
};
}

#endif
