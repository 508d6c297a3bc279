// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/PointGrid.h"

#include <cmath>

namespace hexsweep
{
PointGrid::PointGrid(const PointsRef& points, const std::vector<Index>& ids, double radius)
  : Positions(points)
{
  if (ids.empty())
  {
    return;
  }
  this->Origin = points.row(ids.front());
  Eigen::RowVector3d top = this->Origin;
  for (const Index id : ids)
  {
    this->Origin = this->Origin.cwiseMin(points.row(id));
    top = top.cwiseMax(points.row(id));
  }
  // The lower bound keeps cell numbers far below 2^63.
  this->CellSize = std::max(radius, 1e-13 * (top - this->Origin).norm());
  if (this->CellSize <= 0.0)
  {
    this->CellSize = 1.0;
  }
  this->Entries.reserve(ids.size());
  for (const Index id : ids)
  {
    this->Entries.emplace_back(this->cellOf(points.row(id)), id);
  }
  std::sort(this->Entries.begin(), this->Entries.end());
}

PointGrid::Cell PointGrid::cellOf(const Eigen::RowVector3d& place) const
{
  Cell cell;
  for (int c = 0; c < 3; ++c)
  {
    cell[c] = static_cast<Index>(std::floor((place[c] - this->Origin[c]) / this->CellSize));
  }
  return cell;
}

bool PointGrid::isNearGrid(const Eigen::RowVector3d& place) const
{
  return ((place - this->Origin) / this->CellSize).cwiseAbs().maxCoeff() < 1e17;
}
}
