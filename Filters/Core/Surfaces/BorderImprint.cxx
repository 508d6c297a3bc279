// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/BorderImprint.h"

#include "Core/Common/StandardIndex.h"
#include "Core/Surfaces/BorderSearch.h"
#include "Core/Surfaces/SplitSurface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace hexsweep
{
namespace
{
/// Of the edges near by: what is nearer to a point or an edge is there.
constexpr double Near = 1e-6;

using Pair = PointPair;

Pair sorted(Index a, Index b)
{
  return { std::min(a, b), std::max(a, b) };
}

class Imprinter
{
public:
  Imprinter(const ImprintBase& base, const BorderLines& lines)
    : Base(base)
    , Lines(lines)
    , Surface(base.surface)
    , Search(base.surface.points, base.surface.triangles)
    , Border(base.surface, base.faceIds, base.keep)
  {
    for (const BorderEdge& edge : this->Border.edges())
    {
      this->Marks[edge.ends] = { true, -1 };
    }
    for (const Pair& edge : base.undivided)
    {
      this->Undivided[sorted(edge.first, edge.second)] = true;
    }
  }

  std::optional<ImprintedSurface> run()
  {
    ImprintedSurface result;
    this->Sagittas.assign(at(this->Lines.points.rows()), 0.0);
    for (Index i = 0; i < this->Lines.points.rows(); ++i)
    {
      result.pointOf.push_back(this->put(i));
    }
    const ChainShape shape = chainShape(this->Lines.points, this->Lines.pieces);
    for (std::size_t p = 0; p < this->Lines.pieces.size(); ++p)
    {
      const Index from = result.pointOf[at(this->Lines.pieces[p].first)];
      const Index to = result.pointOf[at(this->Lines.pieces[p].second)];
      this->Piece = static_cast<Index>(p);
      this->Reach = this->Base.snap + shape.sagitta[p] +
        std::max(this->Sagittas[at(this->Lines.pieces[p].first)],
          this->Sagittas[at(this->Lines.pieces[p].second)]);
      Index last = from;
      for (const Index stop : this->stops(from, to))
      {
        if (last != stop && !this->join(last, stop))
        {
          return std::nullopt;
        }
        last = stop;
      }
    }
    result.mesh = this->Surface.mesh();
    result.triangleOrigin = this->Surface.origins();
    for (const auto& [ends, mark] : this->Marks)
    {
      if (mark.piece >= 0)
      {
        result.edges.push_back({ ends, mark.piece });
      }
    }
    return result;
  }

private:
  struct Mark
  {
    bool border = false; ///< of the surface's own
    Index piece = -1;
  };

  const Eigen::RowVector3d& place(Index v) const { return this->Surface.point(v); }

  /// The point of the surface for one of the lines.
  Index put(Index i)
  {
    const Eigen::RowVector3d place = this->Lines.points.row(i);
    const bool onBoundary = this->Lines.onBoundary[at(i)];
    const BorderSearch::Place border = this->Border.closest(place, onBoundary);
    const double reach = this->Base.snap + border.sagitta;
    if (!onBoundary && border.distance > reach)
    {
      const Index given = this->Search.closest(place).triangle;
      return this->insert(this->Surface.locate(given, place));
    }
    this->Sagittas[at(i)] = border.sagitta;
    if (this->Undivided.count(border.edge.ends) > 0)
    {
      return border.along < 0.5 ? border.edge.ends.first : border.edge.ends.second;
    }
    const Eigen::RowVector3d onBorder = (1.0 - border.along) * this->place(border.edge.ends.first) +
      border.along * this->place(border.edge.ends.second);
    Index nearest = -1;
    double least = reach;
    for (const Index corner : this->Border.corners())
    {
      const double distance = (this->place(corner) - onBorder).norm();
      if (distance <= least)
      {
        nearest = corner;
        least = distance;
      }
    }
    return nearest >= 0 ? nearest
                        : this->insert(this->Surface.locate(border.edge.triangle, onBorder));
  }

  Index insert(const TrianglePoint& found)
  {
    const HalfEdgeTriangles& triangles = this->Surface.triangles();
    const Index first = 3 * found.triangle;
    Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
    double longest = 0.0;
    for (Index c = 0; c < 3; ++c)
    {
      const Index v = triangles.from(first + c);
      place += found.coordinates[c] * this->place(v);
      longest = std::max(longest, (this->place(triangles.to(first + c)) - this->place(v)).norm());
    }
    for (Index half = first; half < first + 3; ++half)
    {
      const Eigen::RowVector3d a = this->place(triangles.from(half));
      if ((place - a).norm() <= Near * longest)
      {
        return triangles.from(half);
      }
    }
    Index nearest = -1;
    double least = Near * longest;
    double along = 0.0;
    for (Index half = first; half < first + 3; ++half)
    {
      const Eigen::RowVector3d a = this->place(triangles.from(half));
      const Eigen::RowVector3d way = this->place(triangles.to(half)) - a;
      const double t = (place - a).dot(way) / way.squaredNorm();
      const double distance = (place - a - t * way).norm();
      if (distance <= least)
      {
        nearest = half;
        least = distance;
        along = t;
      }
    }
    return nearest >= 0 ? this->splitEdge(nearest, along)
                        : this->Surface.splitTriangle(found.triangle, place);
  }

  Index splitEdge(Index half, double along)
  {
    const Index a = this->Surface.triangles().from(half);
    const Index b = this->Surface.triangles().to(half);
    const Index v =
      this->Surface.splitEdge(half, (1.0 - along) * this->place(a) + along * this->place(b));
    const auto known = this->Marks.find(sorted(a, b));
    if (known != this->Marks.end())
    {
      const Mark mark = known->second;
      this->Marks.erase(known);
      this->Marks[sorted(a, v)] = this->Marks[sorted(v, b)] = mark;
    }
    return v;
  }

  /// Corners that a line passes so closely that it is to run through them, and its end.
  std::vector<Index> stops(Index from, Index to) const
  {
    const Eigen::RowVector3d way = this->place(to) - this->place(from);
    std::vector<std::pair<double, Index>> passed;
    for (const Index corner : this->Border.corners())
    {
      const Eigen::RowVector3d there = this->place(corner) - this->place(from);
      const double along = there.dot(way) / way.squaredNorm();
      if (corner != from && corner != to && along > 0.0 && along < 1.0 &&
        (there - along * way).norm() <= this->Base.snap)
      {
        passed.emplace_back(along, corner);
      }
    }
    std::sort(passed.begin(), passed.end());
    std::vector<Index> stops;
    for (const auto& [along, corner] : passed)
    {
      stops.push_back(corner);
    }
    stops.push_back(to);
    return stops;
  }

  void mark(Index a, Index b)
  {
    Mark& mark = this->Marks[sorted(a, b)];
    mark.piece = mark.piece < 0 ? this->Piece : mark.piece;
  }

  bool join(Index from, Index to)
  {
    return this->joinAlongBorder(from, to) || this->joinStraight(from, to);
  }

  double distanceFromLine(Index v, Index from, Index to) const
  {
    const Eigen::RowVector3d way = this->place(to) - this->place(from);
    const Eigen::RowVector3d there = this->place(v) - this->place(from);
    const double along = std::clamp(there.dot(way) / way.squaredNorm(), 0.0, 1.0);
    return (there - along * way).norm();
  }

  bool joinAlongBorder(Index from, Index to)
  {
    const Eigen::RowVector3d way = this->place(to) - this->place(from);
    std::vector<Index> path{ from };
    while (path.back() != to)
    {
      const Index here = path.back();
      Index best = -1;
      double least = this->Reach;
      for (const Index next : this->Surface.neighbors(here))
      {
        const auto mark = this->Marks.find(sorted(here, next));
        if (mark == this->Marks.end() || !mark->second.border ||
          !((this->place(next) - this->place(here)).dot(way) > 0.0))
        {
          continue;
        }
        const double distance = next == to ? 0.0 : this->distanceFromLine(next, from, to);
        if (distance <= least)
        {
          best = next;
          least = distance;
        }
      }
      if (best < 0)
      {
        return false;
      }
      path.push_back(best);
    }
    for (std::size_t k = 1; k < path.size(); ++k)
    {
      this->mark(path[k - 1], path[k]);
    }
    return true;
  }

  /// Where the line's plane leaves the triangles round a point.
  struct Exit
  {
    Index half = -1;
    double along = 0.0;
  };

  Exit exitFrom(Index here, Index from, const Eigen::RowVector3d& direction,
    const Eigen::RowVector3d& normal) const
  {
    const HalfEdgeTriangles& triangles = this->Surface.triangles();
    Exit exit;
    double best = 0.0;
    for (const Index half : this->Surface.around(here))
    {
      const Index across = HalfEdgeTriangles::next(half);
      const Eigen::RowVector3d a = this->place(triangles.from(across));
      const Eigen::RowVector3d b = this->place(triangles.to(across));
      const double left = (a - this->place(from)).dot(normal);
      const double right = (b - this->place(from)).dot(normal);
      if (left * right > 0.0 || left == right)
      {
        continue;
      }
      const double along = left / (left - right);
      const Eigen::RowVector3d step = a + along * (b - a) - this->place(here);
      const double forward = step.norm() > 0.0 ? step.dot(direction) / step.norm() : 0.0;
      if (forward > best)
      {
        best = forward;
        exit = { across, along };
      }
    }
    return exit;
  }

  /// The neighbour that leads nearest to the end; -1: none is nearer than here.
  Index nearestNeighbor(Index here, Index to) const
  {
    Index best = -1;
    double least = (this->place(to) - this->place(here)).norm();
    for (const Index next : this->Surface.neighbors(here))
    {
      const double distance = (this->place(to) - this->place(next)).norm();
      if (distance < least)
      {
        best = next;
        least = distance;
      }
    }
    return best;
  }

  bool joinStraight(Index from, Index to)
  {
    const HalfEdgeTriangles& triangles = this->Surface.triangles();
    const Eigen::RowVector3d direction = (this->place(to) - this->place(from)).normalized();
    const Eigen::RowVector3d normal =
      (this->Surface.normal(from) + this->Surface.normal(to)).cross(direction).normalized();
    // Each step crosses an edge of now or leads through a point of now.
    Index steps = 3 * triangles.numberOfTriangles() + this->Surface.numberOfPoints();
    for (Index here = from; here != to; --steps)
    {
      if (steps == 0)
      {
        return false;
      }
      Index next = this->Surface.edge(here, to) >= 0 ? to : -1;
      const Exit exit = next < 0 ? this->exitFrom(here, from, direction, normal) : Exit{};
      if (next < 0 && exit.half >= 0)
      {
        next = exit.along <= Near          ? triangles.from(exit.half)
          : exit.along >= 1.0 - Near       ? triangles.to(exit.half)
          : triangles.twin(exit.half) >= 0 ? this->splitEdge(exit.half, exit.along)
                                           : -1;
      }
      if (next < 0)
      {
        next = this->nearestNeighbor(here, to);
      }
      if (next < 0)
      {
        return false;
      }
      this->mark(here, next);
      here = next;
    }
    return true;
  }

  const ImprintBase& Base;
  const BorderLines& Lines;
  SplitSurface Surface;
  TriangleSearch Search;
  BorderSearch Border;
  std::map<Pair, Mark> Marks; // of borders and of what is imprinted
  std::map<Pair, bool> Undivided;
  std::vector<double> Sagittas; // of the border that each of the lines' points is on
  Index Piece = 0;              // that is being joined
  double Reach = 0.0;           // within which it runs on a border
};
}

std::optional<ImprintedSurface> imprintBorders(const ImprintBase& base, const BorderLines& lines)
{
  return Imprinter(base, lines).run();
}
}
