// SPDX-License-Identifier: BSD-3-Clause
#include "QuadQuality.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hexsweep
{
QuadQuality quadQuality(const PointsRef& points, const QuadsRef& quads, const PointsRef& normals)
{
  const auto cornerArea = [&](Index q, Index c) {
    const Index i = quads(q, c);
    const Eigen::RowVector3d a = points.row(quads(q, (c + 1) % 4)) - points.row(i);
    const Eigen::RowVector3d b = points.row(quads(q, (c + 3) % 4)) - points.row(i);
    return std::make_pair(a.cross(b).dot(normals.row(i)), a.norm() * b.norm());
  };
  double whole = 0.0;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      whole += cornerArea(q, c).first;
    }
  }
  const double side = whole < 0.0 ? -1.0 : 1.0;
  QuadQuality quality;
  quality.scaledJacobian.resize(quads.rows());
  quality.minimum = std::numeric_limits<double>::infinity();
  double sum = 0.0;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    double least = std::numeric_limits<double>::infinity();
    for (Index c = 0; c < 4; ++c)
    {
      const auto [area, lengths] = cornerArea(q, c);
      const double jacobian = side * area / lengths;
      // A comparison with NaN is false: keep the NaN of an edge without length.
      least = std::isnan(least) || jacobian >= least ? least : jacobian;
    }
    quality.scaledJacobian[q] = least;
    quality.inverted += least > 0.0 ? 0 : 1;
    quality.minimum = std::min(quality.minimum, std::isnan(least) ? -1.0 : least);
    sum += std::isnan(least) ? -1.0 : least;
  }
  quality.mean = sum / static_cast<double>(std::max<Index>(1, quads.rows()));
  return quality;
}
}
