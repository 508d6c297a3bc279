// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/BorderSearch.h"

#include "Core/Common/Constants.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Surfaces/FaceSides.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
constexpr double CornerTurn = 30.5 * Pi / 180.0; // a polygon of twelve sides is a circle still
/// Facets that stay off their curve by what their turns explain may stay off by this times it.
constexpr double SagittaSlack = 1.1;

std::vector<BorderEdge> borderEdges(const TriangleMesh& surface, const std::vector<Index>& faceIds)
{
  std::vector<BorderEdge> edges;
  const std::vector<FaceSide> sides = sortedSides(surface.triangles, surface.points.rows());
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    const FaceSide& side = sides[first];
    const bool onBoundary = last - first == 1;
    if (onBoundary || faceIds[at(side.face)] != faceIds[at(sides[first + 1].face)])
    {
      edges.push_back({ side.face, { side.low, side.high }, onBoundary });
    }
  });
  return edges;
}

std::vector<PointPair> endsOf(const std::vector<BorderEdge>& edges)
{
  std::vector<PointPair> ends;
  for (const BorderEdge& edge : edges)
  {
    ends.push_back(edge.ends);
  }
  return ends;
}
}

TriangleSearch edgeSearch(const PointsRef& points, const std::vector<PointPair>& edges)
{
  Triangles corners(static_cast<Index>(edges.size()), 3);
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    corners.row(static_cast<Index>(e)) << edges[e].first, edges[e].second, edges[e].second;
  }
  return { points, corners };
}

ChainShape chainShape(const PointsRef& points, const std::vector<PointPair>& edges)
{
  std::vector<std::vector<Index>> neighbors(at(points.rows()));
  for (const PointPair& edge : edges)
  {
    neighbors[at(edge.first)].push_back(edge.second);
    neighbors[at(edge.second)].push_back(edge.first);
  }
  ChainShape shape;
  std::vector<double> turns;
  for (Index i = 0; i < points.rows(); ++i)
  {
    const std::vector<Index>& both = neighbors[at(i)];
    double turn = 0.0;
    if (both.size() == 2)
    {
      const Eigen::RowVector3d in = points.row(i) - points.row(both[0]);
      const Eigen::RowVector3d out = points.row(both[1]) - points.row(i);
      turn = std::atan2(in.cross(out).norm(), in.dot(out));
    }
    const bool isCorner = (!both.empty() && both.size() != 2) || turn > CornerTurn;
    shape.corner.push_back(isCorner);
    turns.push_back(isCorner ? 0.0 : turn);
  }
  for (const PointPair& edge : edges)
  {
    const double length = (points.row(edge.first) - points.row(edge.second)).norm();
    shape.sagitta.push_back(
      SagittaSlack * length * std::max(turns[at(edge.first)], turns[at(edge.second)]) / 8.0);
  }
  return shape;
}

BorderSearch::BorderSearch(
  const TriangleMesh& surface, const std::vector<Index>& faceIds, const std::vector<Index>& keep)
  : Edges(borderEdges(surface, faceIds))
  , Shape(chainShape(surface.points, endsOf(this->Edges)))
  , All(edgeSearch(surface.points, endsOf(this->Edges)))
  , Outer(edgeSearch(surface.points, endsOf(this->outer())))
{
  for (const Index point : keep)
  {
    this->Shape.corner[at(point)] = true;
  }
  for (Index i = 0; i < surface.points.rows(); ++i)
  {
    if (this->Shape.corner[at(i)])
    {
      this->Corners.push_back(i);
    }
  }
}

std::vector<BorderEdge> BorderSearch::outer()
{
  std::vector<BorderEdge> edges;
  for (std::size_t e = 0; e < this->Edges.size(); ++e)
  {
    if (this->Edges[e].onBoundary)
    {
      edges.push_back(this->Edges[e]);
      this->OuterEdges.push_back(e);
    }
  }
  return edges;
}

BorderSearch::Place BorderSearch::closest(const Eigen::RowVector3d& place, bool onBoundary) const
{
  const TrianglePoint found = (onBoundary ? this->Outer : this->All).closest(place);
  const std::size_t e = onBoundary ? this->OuterEdges[at(found.triangle)] : at(found.triangle);
  return { this->Edges[e], this->Shape.sagitta[e], 1.0 - found.coordinates[0], found.distance };
}
}
