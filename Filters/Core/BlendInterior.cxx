// SPDX-License-Identifier: BSD-3-Clause
#include "BlendInterior.h"

#include "PrismSolver.h"
#include "QuadLaplacian.h"

namespace hexsweep
{
Points blendInterior(const PointsRef& sourcePoints, const PointsRef& targetPoints,
  const QuadsRef& quads, const SweepBoundary& boundary, const Progress& progress)
{
  const Index n = sourcePoints.rows();
  const Index layers = boundary.numberOfLayers();

  // On the caps the blend is exact, so the correction is zero there.
  Points swept((layers + 1) * n, 3);
  Points correction = Points::Zero((layers + 1) * n, 3);
  for (Index k = 1; k < layers; ++k)
  {
    const double t = boundary.fractions[k];
    swept.middleRows(k * n, n) = (1.0 - t) * fitLayerMap(boundary, 0, k).apply(sourcePoints) +
      t * fitLayerMap(boundary, layers, k).apply(targetPoints);
    for (std::size_t j = 0; j < boundary.nodes.size(); ++j)
    {
      const Index row = k * n + boundary.nodes[j];
      correction.row(row) = boundary.rings[k].row(static_cast<Index>(j)) - swept.row(row);
    }
  }

  const double layerHeight = boundary.meanColumnLength / static_cast<double>(layers);
  const PrismSolver prism(quadLaplacian(targetPoints, quads), layers, layerHeight, boundary.nodes);
  swept += prism.extend(correction, progress);

  setGivenPoints(sourcePoints, targetPoints, quads, boundary, swept);
  return swept;
}
}
