// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/SweptBoxes.h"

#include <algorithm>

namespace hexsweep
{
namespace
{
/// Columns bunch up where a start is folded: what is wanted there keeps this share of the mean.
constexpr double LeastHeight = 0.3;
/// Likewise of the mean side of the cap's quads.
constexpr double LeastSide = 1e-3;

/// m x 2: mean lengths of sides 0-1, 3-2 and of 0-3, 1-2.
Eigen::Matrix<double, Eigen::Dynamic, 2> sideLengths(const PointsRef& points, const QuadsRef& quads)
{
  Eigen::Matrix<double, Eigen::Dynamic, 2> sides(quads.rows(), 2);
  for (Index q = 0; q < quads.rows(); ++q)
  {
    const auto length = [&](int a, int b) {
      return (points.row(quads(q, a)) - points.row(quads(q, b))).norm();
    };
    sides(q, 0) = 0.5 * (length(0, 1) + length(3, 2));
    sides(q, 1) = 0.5 * (length(0, 3) + length(1, 2));
  }
  return sides.cwiseMax(LeastSide * sides.mean());
}
}

HexBoxes sweptBoxes(const PointsRef& points, const QuadsRef& quads, const SweepBoundary& boundary)
{
  const Index layers = boundary.numberOfLayers();
  const Index n = points.rows() / (layers + 1);
  const Index m = quads.rows();
  const auto onSource = sideLengths(points.topRows(n), quads);
  const auto onTarget = sideLengths(points.bottomRows(n), quads);
  HexBoxes boxes(layers * m, 3);
  for (Index k = 0; k < layers; ++k)
  {
    const double t = 0.5 * (boundary.fractions[k] + boundary.fractions[k + 1]);
    boxes.block(k * m, 0, m, 2) = (1.0 - t) * onSource + t * onTarget;
    const double mean = (boundary.rings[k + 1] - boundary.rings[k]).rowwise().norm().mean();
    for (Index q = 0; q < m; ++q)
    {
      double height = 0.0;
      for (int c = 0; c < 4; ++c)
      {
        height +=
          0.25 * (points.row((k + 1) * n + quads(q, c)) - points.row(k * n + quads(q, c))).norm();
      }
      boxes(k * m + q, 2) = std::max(height, LeastHeight * mean);
    }
  }
  return boxes;
}
}
