// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/SweepBoundary.h"

#include "Core/Common/Errors.h"

#include <algorithm>

namespace hexsweep
{
namespace
{
Points rowsOf(const PointsRef& points, const std::vector<Index>& ids)
{
  Points rows(static_cast<Index>(ids.size()), 3);
  for (std::size_t j = 0; j < ids.size(); ++j)
  {
    rows.row(static_cast<Index>(j)) = points.row(ids[j]);
  }
  return rows;
}

/// Sets fractions and meanColumnLength from the rings.
void measureColumns(SweepBoundary& boundary)
{
  const Index layers = boundary.numberOfLayers();
  const Index columns = boundary.rings.front().rows();
  Eigen::MatrixXd reached = Eigen::MatrixXd::Zero(columns, layers + 1);
  for (Index k = 0; k < layers; ++k)
  {
    reached.col(k + 1) =
      reached.col(k) + (boundary.rings[k + 1] - boundary.rings[k]).rowwise().norm();
  }
  boundary.meanColumnLength = reached.col(layers).mean();

  // Weighted by the column's length: a column of no length has no fractions.
  boundary.fractions.assign(layers + 1, 0.0);
  for (Index k = 1; k <= layers; ++k)
  {
    boundary.fractions[k] = reached.col(k).mean() / boundary.meanColumnLength;
  }
  boundary.fractions.back() = 1.0;
}
}

SweepBoundary gatherSweepBoundary(
  const PointsRef& sourcePoints, const PointsRef& targetPoints, const RingStack& rings)
{
  SweepBoundary boundary;
  double largestArea = -1.0;
  for (const Loop& loop : rings.loops)
  {
    const double area = areaVector(rowsOf(sourcePoints, loop)).norm();
    if (area > largestArea)
    {
      largestArea = area;
      boundary.outerBegin = static_cast<Index>(boundary.nodes.size());
      boundary.outerSize = static_cast<Index>(loop.size());
    }
    boundary.begins.push_back(static_cast<Index>(boundary.nodes.size()));
    boundary.nodes.insert(boundary.nodes.end(), loop.begin(), loop.end());
  }
  boundary.begins.push_back(static_cast<Index>(boundary.nodes.size()));

  const Index layers = rings.numberOfLayers();
  for (Index k = 0; k <= layers; ++k)
  {
    Points ring(static_cast<Index>(boundary.nodes.size()), 3);
    Index row = 0;
    for (std::size_t l = 0; l < rings.loops.size(); ++l)
    {
      const Points part = ringPoints(rings, l, k);
      ring.middleRows(row, part.rows()) = part;
      row += part.rows();
    }
    boundary.rings.push_back(std::move(ring));
  }
  boundary.rings.front() = rowsOf(sourcePoints, boundary.nodes);
  boundary.rings.back() = rowsOf(targetPoints, boundary.nodes);

  measureColumns(boundary);
  if (!(boundary.meanColumnLength > 0.0))
  {
    throw InvalidInput("the source and target loops coincide: the volume has no height.");
  }
  return boundary;
}

AffineMap fitLayerMap(const SweepBoundary& boundary, Index from, Index to)
{
  const auto area = [&boundary](Index layer) {
    return areaVector(boundary.rings[layer].middleRows(boundary.outerBegin, boundary.outerSize));
  };
  return fitAffineMap(boundary.rings[from], boundary.rings[to], area(from), area(to));
}

void setGivenPoints(const PointsRef& sourcePoints, const PointsRef& targetPoints,
  const QuadsRef& quads, const SweepBoundary& boundary, Points& swept)
{
  const Index n = sourcePoints.rows();
  std::vector<char> used(n, 0);
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (int c = 0; c < 4; ++c)
    {
      used[quads(q, c)] = 1;
    }
  }
  for (Index k = 1; k < boundary.numberOfLayers(); ++k)
  {
    const double t = boundary.fractions[k];
    for (Index i = 0; i < n; ++i)
    {
      if (!used[i])
      {
        swept.row(k * n + i) = (1.0 - t) * sourcePoints.row(i) + t * targetPoints.row(i);
      }
    }
    for (std::size_t j = 0; j < boundary.nodes.size(); ++j)
    {
      swept.row(k * n + boundary.nodes[j]) = boundary.rings[k].row(static_cast<Index>(j));
    }
  }
  swept.topRows(n) = sourcePoints;
  swept.bottomRows(n) = targetPoints;
}
}
