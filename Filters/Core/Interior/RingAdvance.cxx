// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/RingAdvance.h"

#include "Core/Geometry/AffineMap.h"
#include "Core/Geometry/ClosedPolygon.h"

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
/// Of the nodes' way: where the centre advances less, rings go outward or inward.
constexpr double LeastAdvance = 0.05;
}

double backwardShare(const SweepBoundary& boundary)
{
  double forward = 0.0;
  double backward = 0.0;
  double way = 0.0; // mean of the nodes'
  Points last;
  Eigen::RowVector3d lastCenter;
  Eigen::RowVector3d lastNormal;
  for (std::size_t k = 0; k < boundary.rings.size(); ++k)
  {
    const Points ring = boundary.rings[k].middleRows(boundary.outerBegin, boundary.outerSize);
    const Eigen::RowVector3d center = ClosedPolygon(ring).center();
    const Eigen::RowVector3d normal = areaVector(ring).normalized();
    if (k > 0)
    {
      const double step = (center - lastCenter).dot(lastNormal + normal);
      (step > 0.0 ? forward : backward) += 0.5 * std::abs(step);
      way += (ring - last).rowwise().norm().mean();
    }
    last = ring;
    lastCenter = center;
    lastNormal = normal;
  }
  const double less = std::min(forward, backward);
  const double more = std::max(forward, backward);
  return more > LeastAdvance * way ? less / more : 0.0;
}
}
