// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the points near a place.
 */
#ifndef hexsweep_PointGrid_h
#define hexsweep_PointGrid_h

#include "Core/Common/Mesh.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hexsweep
{
/// Points sorted into a uniform grid of cubes.
class PointGrid
{
public:
  /**
   * @param points n x 3, finite; kept by reference.
   * @param ids    rows of the points that are to be found.
   * @param radius greatest one that will be asked for, >= 0.
   */
  PointGrid(const PointsRef& points, const std::vector<Index>& ids, double radius);

  /// Calls visit(id, distance) for the points within distance <= radius of a place, where radius is
  /// at most that of the grid.
  template <typename Visit>
  void forEachNear(const Eigen::RowVector3d& place, double radius, const Visit& visit) const
  {
    if (this->Entries.empty() || !this->isNearGrid(place))
    {
      return;
    }
    const Cell middle = this->cellOf(place);
    for (Index dx = -1; dx <= 1; ++dx)
    {
      for (Index dy = -1; dy <= 1; ++dy)
      {
        const Cell low = { middle[0] + dx, middle[1] + dy, middle[2] - 1 };
        const Cell high = { middle[0] + dx, middle[1] + dy, middle[2] + 2 };
        auto entry = std::lower_bound(
          this->Entries.begin(), this->Entries.end(), std::make_pair(low, Index{ -1 }));
        for (; entry != this->Entries.end() && entry->first < high; ++entry)
        {
          const double distance = (this->Positions.row(entry->second) - place).norm();
          if (distance <= radius)
          {
            visit(entry->second, distance);
          }
        }
      }
    }
  }

private:
  using Cell = std::array<Index, 3>;

  Cell cellOf(const Eigen::RowVector3d& place) const;
  /// False for places so far away that their cell number would overflow.
  bool isNearGrid(const Eigen::RowVector3d& place) const;

  PointsRef Positions;
  Eigen::RowVector3d Origin = Eigen::RowVector3d::Zero();
  double CellSize = 1.0;
  std::vector<std::pair<Cell, Index>> Entries;
};
}

#endif
