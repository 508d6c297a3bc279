// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Slides nodes of linking sides along their surfaces for the better of the hexahedra there.
 */
#ifndef hexsweep_SideSlides_h
#define hexsweep_SideSlides_h

#include "Core/Interior/SweepCage.h"

namespace hexsweep
{
/// @param row of SweepBoundary::nodes. @return the place of the node's side nearest to a place.
using NearestOnSide = std::function<Eigen::RowVector3d(Index row, const Eigen::RowVector3d& place)>;

struct SlidSides
{
  Points points; ///< of the filled cage
  /// Least scaled Jacobian of the hexahedra that were looked at, in the end; 1 where all at the
  /// sides are good enough.
  double least = 1.0;
};

/**
 * Where a side has a step, columns that were laid by their strip alone leave corners between them
 * that no interior node can open. Nodes of poor hexahedra at the sides, and those around, are moved
 * one after the other towards or away from their neighbours, as long as a soft minimum of the
 * scaled Jacobians around them grows: nodes of a side are put back on it. A pattern search: what
 * steps do to a surface is not smooth.
 *
 * Serial and bounded: at the most 24 rounds over the nodes within one hexahedron of a poor one,
 * none where more than 200 are poor, and no more where four rounds have not raised the least.
 *
 * @param filled the cage as some method fills it, (L + 1) n x 3.
 * @param stays  one a row of SweepBoundary::nodes: columns that may not move. Caps never move.
 * @param enough scaled Jacobian from which on a hexahedron is not poor.
 * @throw Aborted when progress returns false.
 */
SlidSides slideSides(const SweepCage& cage, const PointsRef& filled, const std::vector<bool>& stays,
  const NearestOnSide& nearest, double enough, const ParallelFor& parallelFor = {},
  const Progress& progress = {});
}

#endif
