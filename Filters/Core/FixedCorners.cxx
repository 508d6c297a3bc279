// SPDX-License-Identifier: BSD-3-Clause
#include "FixedCorners.h"

#include "HexCorner.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace hexsweep
{
namespace
{
/// 0 where an edge has no length.
double scaledJacobian(const PointsRef& points, const HexesRef& hexes, Index h, int corner)
{
  std::array<Eigen::RowVector3d, 3> arms;
  for (std::size_t e = 0; e < 3; ++e)
  {
    const Eigen::RowVector3d arm =
      points.row(hexes(h, HexCornerNeighbors[corner][e])) - points.row(hexes(h, corner));
    arms[e] = arm.stableNormalized();
  }
  return arms[0].dot(arms[1].cross(arms[2]));
}
}

FixedCorners fixedCorners(
  const PointsRef& points, const HexesRef& hexes, const std::vector<bool>& fixed)
{
  FixedCorners result;
  const auto isFixed = [&](Index h, int c) { return fixed[static_cast<std::size_t>(hexes(h, c))]; };
  for (Index h = 0; h < hexes.rows(); ++h)
  {
    bool conflict = false;
    for (int c = 0; c < 8; ++c)
    {
      const int* to = HexCornerNeighbors[c];
      if (isFixed(h, c) && isFixed(h, to[0]) && isFixed(h, to[1]) && isFixed(h, to[2]))
      {
        const double quality = scaledJacobian(points, hexes, h, c);
        result.floor = std::min(result.floor, quality);
        conflict = conflict || !(quality > 0.0);
      }
    }
    if (conflict)
    {
      result.conflicts.push_back(h);
    }
  }
  return result;
}
}
