// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/CageInterior.h"

#include "Core/Common/Errors.h"
#include "Core/Interior/CageMesh.h"
#include "Core/Interior/TopologicalModel.h"

#include <algorithm>

namespace hexsweep
{
namespace
{
/// Visits of a triangle by a node between two reports of progress: about a tenth of a second.
constexpr Index VisitsBetweenReports = 2000000;
/// Nodes between two reports at least, so that each of several threads has some.
constexpr Index LeastNodesBetweenReports = 8;

/// Rows of the swept points that a quad uses and that are not on the cage.
std::vector<Index> interiorRows(
  const QuadsRef& quads, Index numberOfPoints, const SweepBoundary& boundary)
{
  std::vector<char> inside(static_cast<std::size_t>(numberOfPoints), 0);
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (int c = 0; c < 4; ++c)
    {
      inside[static_cast<std::size_t>(quads(q, c))] = 1;
    }
  }
  for (const Index i : boundary.nodes)
  {
    inside[static_cast<std::size_t>(i)] = 0;
  }
  std::vector<Index> rows;
  for (Index k = 1; k < boundary.numberOfLayers(); ++k)
  {
    for (Index i = 0; i < numberOfPoints; ++i)
    {
      if (inside[static_cast<std::size_t>(i)])
      {
        rows.push_back(k * numberOfPoints + i);
      }
    }
  }
  return rows;
}
}

Points cageInterior(const SweepCage& sweep, const CageMethod& method, const Progress& progress,
  const ParallelFor& parallelFor)
{
  const Points& sourcePoints = sweep.source;
  const Points& targetPoints = sweep.target;
  const Quads& quads = sweep.quads;
  const SweepBoundary& boundary = sweep.boundary;
  Points swept = physicalModel(sourcePoints, targetPoints, quads, boundary);
  const std::vector<Index> inside = interiorRows(quads, sourcePoints.rows(), boundary);
  if (inside.empty())
  {
    return swept;
  }
  const Quads boundaryQuads = cageQuads(quads, swept, boundary.numberOfLayers());
  const Points model = topologicalModel(targetPoints, boundaryQuads, boundary);
  const CageMesh cage = triangulateCage(boundaryQuads, swept, model);
  const Points deformed = cageVertices(cage, swept);
  // About the middle: far from the origin the rounding of weights that sum to one would show.
  const Eigen::RowVector3d middle = deformed.colwise().mean();
  const CageMap map =
    method(cageVertices(cage, model), deformed.rowwise() - middle, cage.triangles);

  const Index count = static_cast<Index>(inside.size());
  const Index batch =
    std::max(LeastNodesBetweenReports, VisitsBetweenReports / cage.triangles.rows());
  const Index grain = (batch + LeastNodesBetweenReports - 1) / LeastNodesBetweenReports;
  for (Index first = 0; first < count; first += batch)
  {
    reportProgress(progress, static_cast<double>(first) / static_cast<double>(count));
    forPieces(parallelFor, std::min(batch, count - first), grain, [&](Index begin, Index end) {
      for (Index j = first + begin; j < first + end; ++j)
      {
        const Index row = inside[static_cast<std::size_t>(j)];
        swept.row(row) = map(model.row(row)) + middle;
      }
    });
  }
  reportProgress(progress, 1.0);
  return swept;
}
}
