// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The quads beside the edges of the linking sides.
 */
#ifndef hexsweep_QuadNeighbors_h
#define hexsweep_QuadNeighbors_h

#include "Core/Surfaces/FaceSides.h"

#include <utility>

namespace hexsweep
{
/// The one or two quads beside each edge, which may have any orientation.
class QuadNeighbors
{
public:
  /**
   * @param points m x 3, read for messages only.
   * @param quads  ids in [0, m), seams welded.
   * @throw InvalidInput, with the place, for an edge of no length or with more than two quads.
   */
  QuadNeighbors(const PointsRef& points, const Quads& quads);

  /// The one or two sides of the edge between two points; an empty range when there is none.
  std::pair<const FaceSide*, const FaceSide*> edge(Index a, Index b) const;

  /// Ids of the points on edges that have one quad, rising.
  std::vector<Index> boundary() const { return boundaryPoints(this->Sides); }

private:
  std::vector<FaceSide> Sides;
};
}

#endif
