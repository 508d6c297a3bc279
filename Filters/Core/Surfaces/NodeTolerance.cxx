// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/NodeTolerance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
double singlePrecisionError(const PointsRef& points)
{
  double largest = 0.0;
  for (Index i = 0; i < points.rows(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double x = points(i, c);
      if (static_cast<double>(static_cast<float>(x)) != x)
      {
        return 0.0;
      }
      largest = std::max(largest, std::abs(x));
    }
  }
  // Half a unit in the last place a coordinate, twice that for safety, over three coordinates.
  return std::sqrt(3.0) * largest * double{ std::numeric_limits<float>::epsilon() };
}

double coincidenceDistance(double matchTolerance, double edge, double roundingError)
{
  return std::max(matchTolerance * edge, std::min(roundingError, 0.25 * edge));
}

std::vector<double> loopEdgeLengths(const PointsRef& points, const Loop& loop)
{
  const std::size_t n = loop.size();
  std::vector<double> length(n, std::numeric_limits<double>::max());
  for (std::size_t j = 0; j < n; ++j)
  {
    const std::size_t next = (j + 1) % n;
    const double edge = (points.row(loop[j]) - points.row(loop[next])).norm();
    length[j] = std::min(length[j], edge);
    length[next] = std::min(length[next], edge);
  }
  return length;
}
}
