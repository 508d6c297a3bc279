// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/TopologicalModel.h"

#include "Core/Interior/CageMesh.h"

#include <Eigen/Geometry>

#include <cmath>

namespace hexsweep
{
namespace
{
/// Cosine of the angle between trajectory and vector area below which the first is no guide.
constexpr double LeastCosine = 0.2;
/// Vector area of a loop over its squared size below which it has no direction of its own.
constexpr double NoArea = 1e-6;

Points outerRing(const SweepBoundary& boundary, Index layer)
{
  return boundary.rings[static_cast<std::size_t>(layer)].middleRows(
    boundary.outerBegin, boundary.outerSize);
}

/// Of the loop's line, so that it depends on the spacing of the nodes but little.
Eigen::RowVector3d centroid(const Points& loop)
{
  // About a node: no digits are lost far from the origin.
  const Eigen::RowVector3d origin = loop.row(0);
  Eigen::RowVector3d moment = Eigen::RowVector3d::Zero();
  double length = 0.0;
  for (Index j = 0; j < loop.rows(); ++j)
  {
    const auto a = loop.row(j);
    const auto b = loop.row((j + 1) % loop.rows());
    moment += (b - a).norm() * (0.5 * (a + b) - origin);
    length += (b - a).norm();
  }
  return length > 0.0 ? Eigen::RowVector3d(origin + moment / length) : origin;
}

/// Slope at the target of the parabola through the centroids of the last three rings, unit length.
Eigen::RowVector3d arrival(const SweepBoundary& boundary)
{
  const Index layers = boundary.numberOfLayers();
  const Eigen::RowVector3d end = centroid(outerRing(boundary, layers));
  const Eigen::RowVector3d last = end - centroid(outerRing(boundary, layers - 1));
  if (layers == 1)
  {
    return last.stableNormalized();
  }
  const Eigen::RowVector3d both = end - centroid(outerRing(boundary, layers - 2));
  const double s = 1.0 - boundary.fractions[static_cast<std::size_t>(layers - 1)];
  const double r = 1.0 - boundary.fractions[static_cast<std::size_t>(layers - 2)];
  const Eigen::RowVector3d slope = last * (r / s) - both * (s / r);
  return (s > 0.0 && r > s ? slope : last).stableNormalized();
}

/// Unit length, either way: the caller tells the sides of the cap apart.
Eigen::RowVector3d sweepingDirection(const SweepBoundary& boundary)
{
  const Points loop = outerRing(boundary, boundary.numberOfLayers());
  const Eigen::RowVector3d area = areaVector(loop);
  const double size2 = (loop.rowwise() - loop.row(0)).rowwise().squaredNorm().maxCoeff();
  const Eigen::RowVector3d along = arrival(boundary);
  const bool sideways = std::abs(along.dot(area)) < LeastCosine * area.norm();
  return area.norm() > NoArea * size2 && sideways ? Eigen::RowVector3d(area.normalized()) : along;
}
}

Points topologicalModel(
  const PointsRef& targetPoints, const QuadsRef& cage, const SweepBoundary& boundary)
{
  const Index n = targetPoints.rows();
  const Index layers = boundary.numberOfLayers();
  const double height = boundary.meanColumnLength / static_cast<double>(layers);
  const auto translated = [&](const Eigen::RowVector3d& direction) {
    Points model((layers + 1) * n, 3);
    for (Index k = 0; k < layers; ++k)
    {
      model.middleRows(k * n, n) =
        targetPoints.rowwise() - static_cast<double>(layers - k) * height * direction;
    }
    model.bottomRows(n) = targetPoints;
    return model;
  };
  const Eigen::RowVector3d direction = sweepingDirection(boundary);
  Points model = translated(direction);
  return enclosedVolume(cage, model) < 0.0 ? translated(-direction) : model;
}
}
