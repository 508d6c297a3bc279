// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/LeaningSides.h"

#include "Core/Geometry/TriangleSearch.h"
#include "Core/Stacks/SegmentGrid.h"
#include "Core/Surfaces/HalfEdgeTriangles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr int MostLeanSteps = 40;
constexpr double LeanReached = 1e-12; // of the whole
constexpr int MostLeanSweeps = 400;
constexpr double LeanRelaxation = 1.7;
constexpr double LeanSettled = 1e-7; // of the greatest move

/// The borders of leaning sides with caps, and the edges between sides.
struct SideBorders
{
  std::map<Index, Segments> lower; ///< of each leaning side
  /// Upper border points and the leaning sides below them.
  std::map<Index, std::set<Index>> upper;
  std::map<Index, std::vector<Index>> along; ///< neighbours along edges between two sides
};

SideBorders bordersOfSides(const SolidSurface& solid, const CapLikeFaces& faces,
  const PointsRef& points, const std::set<Index>& leaning)
{
  const HalfEdgeTriangles halfEdges(solid.triangles);
  SideBorders result;
  for (Index h = 0; h < halfEdges.numberOfHalfEdges(); ++h)
  {
    const std::size_t own = faces.faceOf[static_cast<std::size_t>(h / 3)];
    const std::size_t other = faces.faceOf[static_cast<std::size_t>(halfEdges.twin(h) / 3)];
    const Index id = faces.faces[own].id;
    if (own == other || leaning.count(id) == 0)
    {
      continue;
    }
    const Index a = halfEdges.from(h);
    const Index b = halfEdges.to(h);
    if (faces.faces[other].kind == StackFaceKind::Side)
    {
      result.along[a].push_back(b);
      result.along[b].push_back(a);
      continue;
    }
    const double middle = 0.5 * (points(a, 2) + points(b, 2));
    if (points(halfEdges.apex(h), 2) > middle)
    {
      result.lower[id].emplace_back(a, b);
    }
    else
    {
      result.upper[a].insert(id);
      result.upper[b].insert(id);
    }
  }
  return result;
}

/// The lowest point along an edge between sides; the point itself where there is none.
Index footOf(const SideBorders& borders, const PointsRef& points, Index point)
{
  for (;;)
  {
    const auto found = borders.along.find(point);
    Index next = point;
    for (const Index other : found == borders.along.end() ? std::vector<Index>() : found->second)
    {
      next = points(other, 2) < points(next, 2) ? other : next;
    }
    if (next == point)
    {
      return point;
    }
    point = next;
  }
}

/// Nearest place on faces, of their true surfaces or their triangles.
class WallSearch
{
public:
  explicit WallSearch(const LeaningSides& sides)
    : Sides(sides)
  {
  }

  Eigen::RowVector2d near(Index faceId, const Eigen::RowVector3d& place)
  {
    if (this->Sides.geometry)
    {
      const auto found = this->Sides.geometry->closestOnFace(
        faceId, this->Sides.frame.fromFrame(Points(place)).row(0));
      if (found)
      {
        return this->Sides.frame.toFrame(Points(*found)).row(0).head<2>();
      }
    }
    Wall& wall = this->wall(faceId);
    const TrianglePoint found = wall.search->closest(place);
    Eigen::RowVector3d point = Eigen::RowVector3d::Zero();
    for (Index c = 0; c < 3; ++c)
    {
      point +=
        found.coordinates[c] * this->Sides.framePoints.row(wall.triangles(found.triangle, c));
    }
    return point.head<2>();
  }

private:
  struct Wall
  {
    Triangles triangles;
    std::unique_ptr<TriangleSearch> search;
  };

  Wall& wall(Index faceId)
  {
    Wall& wall = this->Walls[faceId];
    if (!wall.search)
    {
      std::vector<Index> rows;
      for (Index t = 0; t < this->Sides.solid.triangles.rows(); ++t)
      {
        if (this->Sides.solid.faceIds[static_cast<std::size_t>(t)] == faceId)
        {
          rows.push_back(t);
        }
      }
      wall.triangles.resize(static_cast<Index>(rows.size()), 3);
      for (std::size_t i = 0; i < rows.size(); ++i)
      {
        wall.triangles.row(static_cast<Index>(i)) = this->Sides.solid.triangles.row(rows[i]);
      }
      wall.search = std::make_unique<TriangleSearch>(this->Sides.framePoints, wall.triangles);
    }
    return wall;
  }

  const LeaningSides& Sides;
  std::map<Index, Wall> Walls;
};

using NodePairs = std::vector<std::pair<Index, Index>>;

void tidyPairs(NodePairs& pairs)
{
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

/// Neighbours along the edges of hexahedra, each pair both ways, sorted.
NodePairs hexNeighbors(const HexesRef& hexes)
{
  constexpr int Edges[12][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 },
    { 6, 7 }, { 7, 4 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
  NodePairs pairs;
  for (Index h = 0; h < hexes.rows(); ++h)
  {
    for (const auto& edge : Edges)
    {
      pairs.emplace_back(hexes(h, edge[0]), hexes(h, edge[1]));
      pairs.emplace_back(hexes(h, edge[1]), hexes(h, edge[0]));
    }
  }
  tidyPairs(pairs);
  return pairs;
}

/// The same along the edges of outer quads on sides.
NodePairs sideNeighbors(const StackColumns& columns)
{
  NodePairs pairs;
  for (const StackQuad& quad : columns.boundary)
  {
    for (std::size_t c = 0; c < 4 && quad.cap < 0; ++c)
    {
      pairs.emplace_back(quad.points[c], quad.points[(c + 1) % 4]);
      pairs.emplace_back(quad.points[(c + 1) % 4], quad.points[c]);
    }
  }
  tidyPairs(pairs);
  return pairs;
}

/// Moves of the points, harmonic between those that are known.
void spreadMoves(const NodePairs& pairs, const std::vector<bool>& known, PlanePoints& moves)
{
  const double greatest = moves.rowwise().norm().maxCoeff();
  for (int sweep = 0; sweep < MostLeanSweeps; ++sweep)
  {
    double change = 0.0;
    for (std::size_t i = 0; i < pairs.size();)
    {
      const Index point = pairs[i].first;
      Eigen::RowVector2d mean = Eigen::RowVector2d::Zero();
      double count = 0.0;
      for (; i < pairs.size() && pairs[i].first == point; ++i)
      {
        mean += moves.row(pairs[i].second);
        count += 1.0;
      }
      if (!known[static_cast<std::size_t>(point)])
      {
        const Eigen::RowVector2d step = LeanRelaxation * (mean / count - moves.row(point));
        moves.row(point) += step;
        change = std::max(change, step.norm());
      }
    }
    if (!(change > LeanSettled * greatest))
    {
      break;
    }
  }
}

/// A place on all of some faces at the height of another one.
Eigen::RowVector3d onWalls(
  WallSearch& walls, const std::set<Index>& faces, Eigen::RowVector3d place, double extent)
{
  for (int step = 0; step < MostLeanSteps; ++step)
  {
    const Eigen::RowVector3d before = place;
    for (const Index id : faces)
    {
      place.head<2>() = walls.near(id, place);
    }
    if ((place - before).norm() <= LeanReached * extent)
    {
      break;
    }
  }
  return place;
}
}

UprightSolid uprightSolid(
  const SolidSurface& solid, const CapLikeFaces& faces, const PointsRef& framePoints)
{
  UprightSolid result;
  result.points = framePoints;
  result.leaning.insert(faces.leaning.begin(), faces.leaning.end());
  if (result.leaning.empty())
  {
    return result;
  }
  const SideBorders borders = bordersOfSides(solid, faces, framePoints, result.leaning);
  for (const auto& [point, sides] : borders.upper)
  {
    const Eigen::RowVector2d place = framePoints.row(point).head<2>();
    Eigen::RowVector2d best = place;
    const Index foot = footOf(borders, framePoints, point);
    double least = std::numeric_limits<double>::infinity();
    if (foot != point)
    {
      best = framePoints.row(foot).head<2>();
      least = 0.0;
    }
    for (const Index side : least > 0.0 ? sides : std::set<Index>())
    {
      const auto lower = borders.lower.find(side);
      for (const auto& [a, b] : lower == borders.lower.end() ? Segments() : lower->second)
      {
        const Eigen::RowVector2d p = framePoints.row(a).head<2>();
        const Eigen::RowVector2d q = framePoints.row(b).head<2>();
        const SegmentPlace at = nearestOnSegment(place, p, q);
        if (at.distance < least)
        {
          least = at.distance;
          best = p + at.along * (q - p);
        }
      }
    }
    result.greatestMove = std::max(result.greatestMove, (best - place).norm());
    result.points.row(point).head<2>() = best;
  }
  return result;
}

void leanBack(const LeaningSides& sides, const StackColumns& columns, const HexesRef& hexes,
  const std::vector<Index>& sideFaces, Points& points)
{
  std::vector<std::set<Index>> facesAt(static_cast<std::size_t>(points.rows()));
  std::vector<bool> known(facesAt.size(), false);
  for (std::size_t b = 0; b < columns.boundary.size(); ++b)
  {
    if (columns.boundary[b].cap >= 0)
    {
      continue;
    }
    for (const Index p : columns.boundary[b].points)
    {
      facesAt[static_cast<std::size_t>(p)].insert(sideFaces[b]);
      known[static_cast<std::size_t>(p)] = true;
    }
  }
  const double extent = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
  const auto leans = [&](Index p) {
    const std::set<Index>& all = facesAt[static_cast<std::size_t>(p)];
    return std::any_of(
      all.begin(), all.end(), [&](Index id) { return sides.leaning.count(id) > 0; });
  };
  WallSearch walls(sides);
  PlanePoints moves = PlanePoints::Zero(points.rows(), 2);
  const auto move = [&](Index p) {
    const Eigen::RowVector3d start(
      points(p, 0) + moves(p, 0), points(p, 1) + moves(p, 1), points(p, 2));
    moves.row(p) =
      (onWalls(walls, facesAt[static_cast<std::size_t>(p)], start, extent) - points.row(p))
        .head<2>();
  };
  // Between the edges of two sides, which come nearer to each other, nodes do so as well.
  std::vector<bool> leads(known.size(), false);
  for (Index p = 0; p < points.rows(); ++p)
  {
    leads[static_cast<std::size_t>(p)] =
      !leans(p) || facesAt[static_cast<std::size_t>(p)].size() > 1;
    if (leans(p) && leads[static_cast<std::size_t>(p)])
    {
      move(p);
    }
  }
  spreadMoves(sideNeighbors(columns), leads, moves);
  for (Index p = 0; p < points.rows(); ++p)
  {
    if (leans(p) && !leads[static_cast<std::size_t>(p)])
    {
      move(p);
    }
  }
  spreadMoves(hexNeighbors(hexes), known, moves);
  points.leftCols<2>() += moves;
}
}
