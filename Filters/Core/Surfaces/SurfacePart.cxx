// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SurfacePart.h"

#include <algorithm>

namespace hexsweep
{
Index SurfacePart::idOf(Index point) const
{
  return std::lower_bound(this->points.begin(), this->points.end(), point) - this->points.begin();
}

SurfacePart surfacePart(
  const PointsRef& points, const TrianglesRef& triangles, const std::vector<Index>& rows)
{
  SurfacePart part;
  for (const Index row : rows)
  {
    part.points.insert(
      part.points.end(), { triangles(row, 0), triangles(row, 1), triangles(row, 2) });
  }
  std::sort(part.points.begin(), part.points.end());
  part.points.erase(std::unique(part.points.begin(), part.points.end()), part.points.end());
  part.mesh.points.resize(static_cast<Index>(part.points.size()), 3);
  for (std::size_t i = 0; i < part.points.size(); ++i)
  {
    part.mesh.points.row(static_cast<Index>(i)) = points.row(part.points[i]);
  }
  part.mesh.triangles.resize(static_cast<Index>(rows.size()), 3);
  for (std::size_t r = 0; r < rows.size(); ++r)
  {
    for (Index c = 0; c < 3; ++c)
    {
      part.mesh.triangles(static_cast<Index>(r), c) = part.idOf(triangles(rows[r], c));
    }
  }
  return part;
}
}
