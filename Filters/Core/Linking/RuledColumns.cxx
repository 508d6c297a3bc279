// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/RuledColumns.h"

#include "Core/Common/Errors.h"
#include "Core/Geometry/BoundarySearch.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
/// Of an edge: a place that is so near to a node of the loop is that node.
constexpr double NodeRounding = 1e-9;

Loop targetLoopOf(const SideTube& side)
{
  const SurfaceTopology topology =
    checkSurface(side.surface.triangles, side.surface.points.rows(), "linking side");
  for (const Loop& loop : topology.loops)
  {
    if (std::find(loop.begin(), loop.end(), side.sourceLoop.front()) == loop.end())
    {
      return loop;
    }
  }
  throw InvalidInput(
    "a linking side has no loop on the target cap: it is no tube between the caps.");
}

Eigen::RowVector3d placeOn(
  const PointsRef& points, const Loop& loop, const BoundarySearch::Place& place)
{
  const auto edge = static_cast<std::size_t>(place.position);
  const double along = place.position - std::floor(place.position);
  const Eigen::RowVector3d a = points.row(loop[edge % loop.size()]);
  const Eigen::RowVector3d b = points.row(loop[(edge + 1) % loop.size()]);
  return along < NodeRounding ? a : along > 1.0 - NodeRounding ? b : a + along * (b - a);
}
}

RuledColumns::RuledColumns(const SideTube& side, const PointsRef& ring, const AffineMap& map)
  : Search(side.surface.points, side.surface.triangles)
  , Begin(ring)
  , End(map.apply(ring))
{
  const std::vector<Loop> loops{ targetLoopOf(side) };
  const BoundarySearch target(side.surface.points, loops);
  for (Index j = 0; j < this->End.rows(); ++j)
  {
    this->End.row(j) = placeOn(side.surface.points, loops[0], target.closest(this->End.row(j)));
  }
}

double RuledColumns::meanLength() const
{
  return (this->End - this->Begin).rowwise().norm().mean();
}

SideTubeMesh RuledColumns::mesh(const std::vector<double>& fractions) const
{
  const Index n = this->size();
  const Index layers = static_cast<Index>(fractions.size()) - 1;
  SideTubeMesh result;
  result.nodes.resize((layers + 1) * n, 3);
  result.nodes.topRows(n) = this->Begin;
  result.nodes.bottomRows(n) = this->End;
  for (Index k = 1; k < layers; ++k)
  {
    const double along = fractions[static_cast<std::size_t>(k)];
    result.nodes.middleRows(k * n, n) = this->Begin + along * (this->End - this->Begin);
  }
  Index near = -1;
  result.quadTriangle.reserve(static_cast<std::size_t>(layers * n));
  for (Index k = 0; k < layers; ++k)
  {
    for (Index j = 0; j < n; ++j)
    {
      const Index next = (j + 1) % n;
      const Eigen::RowVector3d middle = 0.25 *
        (result.nodes.row(k * n + j) + result.nodes.row(k * n + next) +
          result.nodes.row((k + 1) * n + j) + result.nodes.row((k + 1) * n + next));
      near = this->Search.closest(middle, near).triangle;
      result.quadTriangle.push_back(near);
    }
  }
  return result;
}
}
