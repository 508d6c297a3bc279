// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Segments of the plane in square cells, to find those near a place.
 */
#ifndef hexsweep_SegmentGrid_h
#define hexsweep_SegmentGrid_h

#include "Core/Common/Mesh.h"

#include <utility>
#include <vector>

namespace hexsweep
{
/// Ends of segments, as rows of a matrix of points.
using Segments = std::vector<std::pair<Index, Index>>;

/// The point of a segment that is nearest to a place.
struct SegmentPlace
{
  double along = 0.0; ///< fraction of the segment from its first end, in [0, 1]
  double distance = 0.0;
};

SegmentPlace nearestOnSegment(
  const Eigen::RowVector2d& place, const Eigen::RowVector2d& a, const Eigen::RowVector2d& b);

/// O(n) cells for n segments; what is stored is the number of each in the cells of its box.
class SegmentGrid
{
public:
  /// @param reach how far boxes are widened, >= 0.
  SegmentGrid(const PlanePointsRef& points, const Segments& segments, double reach);

  /// Numbers of the segments whose widened boxes share a cell with the box from `low` to `high`,
  /// rising, each once.
  std::vector<Index> near(const Eigen::RowVector2d& low, const Eigen::RowVector2d& high) const;
  std::vector<Index> near(const Eigen::RowVector2d& place) const
  {
    return this->near(place, place);
  }

private:
  Index column(double x) const;
  Index row(double y) const;

  Eigen::RowVector2d Low = Eigen::RowVector2d::Zero();
  double Cell = 1.0;
  Index Columns = 1;
  Index Rows = 1;
  std::vector<Index> First; // of each cell in Members
  std::vector<Index> Members;
};
}

#endif
