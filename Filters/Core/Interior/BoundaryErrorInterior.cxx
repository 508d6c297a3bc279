// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/BoundaryErrorInterior.h"

#include "Core/Common/Errors.h"

#include <algorithm>

namespace hexsweep
{
namespace
{
/// Row i, column j: share of loop node j in the residual at cap point first + i; rows sum to 1.
Eigen::MatrixXd inverseSquareWeights(
  const PointsRef& capPoints, const Points& loopNodes, Index first, Index count)
{
  Eigen::MatrixXd weights(count, loopNodes.rows());
  for (Index i = 0; i < count; ++i)
  {
    const Eigen::RowVector3d place = capPoints.row(first + i);
    Eigen::VectorXd distance2 = (loopNodes.rowwise() - place).rowwise().squaredNorm();
    // Relative to the nearest one: neither overflow nor a division by zero, at any length scale.
    const double nearest = distance2.minCoeff();
    weights.row(i) = nearest > 0.0
      ? Eigen::VectorXd((distance2.array() / nearest).inverse()).transpose()
      : Eigen::VectorXd((distance2.array() == 0.0).cast<double>()).transpose();
    weights.row(i) /= weights.row(i).sum();
  }
  return weights;
}

/// Adds share(k) * (affine image of the cap + interpolated residual) to each inner layer.
void addFromCap(const PointsRef& capPoints, const SweepBoundary& boundary, Index cap,
  const Progress& progress, Points& swept)
{
  const Index n = capPoints.rows();
  const Index layers = boundary.numberOfLayers();
  const Points& loopNodes = boundary.rings[cap];
  const auto share = [&](Index k) {
    return cap == 0 ? 1.0 - boundary.fractions[k] : boundary.fractions[k];
  };

  // Three columns a layer, so that one product interpolates all layers.
  Eigen::MatrixXd residuals(loopNodes.rows(), 3 * (layers - 1));
  for (Index k = 1; k < layers; ++k)
  {
    const AffineMap map = fitLayerMap(boundary, cap, k);
    swept.middleRows(k * n, n) += share(k) * map.apply(capPoints);
    residuals.middleCols(3 * (k - 1), 3) = boundary.rings[k] - map.apply(loopNodes);
  }

  constexpr Index RowsAtOnce = 256;
  for (Index first = 0; first < n; first += RowsAtOnce)
  {
    const Index count = std::min(RowsAtOnce, n - first);
    const Eigen::MatrixXd interpolated =
      inverseSquareWeights(capPoints, loopNodes, first, count) * residuals;
    for (Index k = 1; k < layers; ++k)
    {
      swept.middleRows(k * n + first, count) += share(k) * interpolated.middleCols(3 * (k - 1), 3);
    }
    reportProgress(progress, static_cast<double>(first + count) / static_cast<double>(n));
  }
}
}

Points boundaryErrorInterior(const SweepCage& cage, const Progress& progress, const ParallelFor&)
{
  const Points& sourcePoints = cage.source;
  const Points& targetPoints = cage.target;
  const Quads& quads = cage.quads;
  const SweepBoundary& boundary = cage.boundary;
  const Index layers = boundary.numberOfLayers();
  Points swept = Points::Zero((layers + 1) * sourcePoints.rows(), 3);
  addFromCap(sourcePoints, boundary, 0, progressPart(progress, 0.0, 0.5), swept);
  addFromCap(targetPoints, boundary, layers, progressPart(progress, 0.5, 1.0), swept);
  setGivenPoints(sourcePoints, targetPoints, quads, boundary, swept);
  return swept;
}
}
