// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/HarmonicCoordinates.h"

#include "Core/Common/Errors.h"
#include "Core/Interior/CageMesh.h"
#include "Core/Solvers/PrismSolver.h"
#include "Core/Solvers/QuadLaplacian.h"

#include <algorithm>
#include <utility>

namespace hexsweep
{
namespace
{
PrismSolver prismOver(
  const PointsRef& targetPoints, const QuadsRef& quads, const SweepBoundary& boundary)
{
  const Index layers = boundary.numberOfLayers();
  return PrismSolver(quadLaplacian(targetPoints, quads), layers,
    boundary.meanColumnLength / static_cast<double>(layers), boundary.nodes);
}
}

Points harmonicInterior(
  const SweepCage& cage, const Progress& progress, const ParallelFor& parallelFor)
{
  const Points& sourcePoints = cage.source;
  const Points& targetPoints = cage.target;
  const Quads& quads = cage.quads;
  const SweepBoundary& boundary = cage.boundary;
  Points swept = physicalModel(sourcePoints, targetPoints, quads, boundary);
  // About the middle of the caps: far from the origin the solver's rounding would be larger than
  // the volume.
  const Eigen::RowVector3d middle =
    0.5 * (sourcePoints.colwise().mean() + targetPoints.colwise().mean());
  swept.rowwise() -= middle;
  swept = prismOver(targetPoints, quads, boundary).extend(std::move(swept), progress, parallelFor);
  swept.rowwise() += middle;
  setGivenPoints(sourcePoints, targetPoints, quads, boundary, swept);
  return swept;
}

Eigen::MatrixXd harmonicCoordinates(const PointsRef& targetPoints, const QuadsRef& quads,
  const SweepBoundary& boundary, const std::vector<Index>& cageNodes, const Progress& progress,
  const ParallelFor& parallelFor)
{
  const Index n = targetPoints.rows();
  const Index layers = boundary.numberOfLayers();
  const Index count = static_cast<Index>(cageNodes.size());
  std::vector<char> onSide(static_cast<std::size_t>(n), 0);
  for (const Index i : boundary.nodes)
  {
    onSide[static_cast<std::size_t>(i)] = 1;
  }
  for (const Index row : cageNodes)
  {
    const bool inside = row >= n && row < layers * n && !onSide[static_cast<std::size_t>(row % n)];
    if (row < 0 || row >= (layers + 1) * n || inside)
    {
      throw InvalidInput("point " + std::to_string(row) +
        " of the swept points is no cage vertex: it has no harmonic coordinate. Take a point of "
        "a cap or of a linking side.");
    }
  }

  const PrismSolver prism = prismOver(targetPoints, quads, boundary);
  Eigen::MatrixXd coordinates((layers + 1) * n, count);
  for (Index first = 0; first < count; first += 3)
  {
    const Index columns = std::min<Index>(3, count - first);
    Points values = Points::Zero((layers + 1) * n, 3);
    for (Index c = 0; c < columns; ++c)
    {
      values(cageNodes[static_cast<std::size_t>(first + c)], c) = 1.0;
    }
    const auto part = [&](Index done) {
      return static_cast<double>(done) / static_cast<double>(count);
    };
    coordinates.middleCols(first, columns) =
      prism
        .extend(std::move(values), progressPart(progress, part(first), part(first + columns)),
          parallelFor)
        .leftCols(columns);
  }
  return coordinates;
}
}
