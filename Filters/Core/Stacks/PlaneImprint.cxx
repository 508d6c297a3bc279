// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/PlaneImprint.h"

#include "Core/Common/Errors.h"
#include "Core/Common/Predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace hexsweep
{
namespace
{
constexpr int MostRounds = 60;
constexpr double LeastTolerance = 1e-9; // of the whole extent
/// A neighbour along the chain is on a segment only where they leave their common end at less than
/// an angle with this tangent.
constexpr double NarrowWedge = 0.25;
/// Where two chains leave a point at less than an angle with this tangent they are zipped up this
/// many times as far: quads in the tip would be as narrow as it is.
constexpr double NarrowTip = 0.2;
constexpr double ZippedTolerance = 3.0;
constexpr double WideCrossing = 0.26; // sine
/// Edges shorter than this part of their tolerance become points.
constexpr double ShortEdge = 0.3;

struct ImprintEdge
{
  Index a;
  Index b;
  double tolerance;
  double rise;
};

/// A point that is to lie on an edge.
struct EdgeStop
{
  std::size_t edge;
  double along;
  Index point;
};

/// Edges and points while they change.
class Imprint
{
public:
  explicit Imprint(const PlaneSegments& given)
  {
    for (Index i = 0; i < given.points.rows(); ++i)
    {
      this->Places.push_back(given.points.row(i));
      this->Corner.push_back(given.corner[static_cast<std::size_t>(i)]);
      this->Alias.push_back(i);
    }
    const double extent = given.points.rows() > 0
      ? (given.points.colwise().maxCoeff() - given.points.colwise().minCoeff()).norm()
      : 0.0;
    this->Rounding = LeastTolerance * extent;
    for (std::size_t s = 0; s < given.segments.size(); ++s)
    {
      this->Edges.push_back({ given.segments[s].first, given.segments[s].second,
        std::max(given.tolerance[s], this->Rounding), given.rise[s] });
      this->Reach = std::max({ this->Reach, this->Edges.back().tolerance, given.rise[s] });
    }
  }

  void run()
  {
    for (int round = 0; round < MostRounds; ++round)
    {
      this->tidy();
      if (!this->stopAtCrossings(WideCrossing) && !this->mergePoints() && !this->stopAtPoints() &&
        !this->stopAtCrossings(0.0))
      {
        return;
      }
    }
    throw InvalidInput("the curves of the caps, seen along the sweep, lie so near to each other "
                       "that they cannot be told apart. Set ImprintTolerance to another value.");
  }

  PlaneGraph graph(Index given)
  {
    PlaneGraph result;
    std::vector<Index> number(this->Places.size(), -1);
    std::vector<Index> used;
    for (const ImprintEdge& edge : this->Edges)
    {
      used.push_back(edge.a);
      used.push_back(edge.b);
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    result.points.resize(static_cast<Index>(used.size()), 2);
    for (std::size_t i = 0; i < used.size(); ++i)
    {
      number[static_cast<std::size_t>(used[i])] = static_cast<Index>(i);
      result.points.row(static_cast<Index>(i)) = this->place(used[i]);
      result.corner.push_back(this->Corner[static_cast<std::size_t>(used[i])]);
    }
    std::map<std::pair<Index, Index>, double> edges;
    for (const ImprintEdge& edge : this->Edges)
    {
      edges[std::minmax(number[static_cast<std::size_t>(edge.a)],
        number[static_cast<std::size_t>(edge.b)])] = edge.tolerance;
    }
    for (const auto& [ends, tolerance] : edges)
    {
      result.edges.push_back(ends);
      result.tolerance.push_back(tolerance);
    }
    for (Index i = 0; i < given; ++i)
    {
      result.pointOf.push_back(number[static_cast<std::size_t>(this->root(i))]);
    }
    result.merged = this->Merged;
    result.greatestMove = this->GreatestMove;
    result.greatestGap = this->GreatestGap;
    return result;
  }

private:
  const Eigen::RowVector2d& place(Index i) const
  {
    return this->Places[static_cast<std::size_t>(i)];
  }

  Index root(Index i) const
  {
    while (this->Alias[static_cast<std::size_t>(i)] != i)
    {
      i = this->Alias[static_cast<std::size_t>(i)];
    }
    return i;
  }

  /// Edges between what points have become, each once.
  void tidy()
  {
    std::map<std::pair<Index, Index>, std::pair<double, double>> seen;
    for (const ImprintEdge& edge : this->Edges)
    {
      const Index a = this->root(edge.a);
      const Index b = this->root(edge.b);
      if (a != b)
      {
        auto& known = seen[std::minmax(a, b)];
        known.first = std::max(known.first, edge.tolerance);
        known.second = std::max(known.second, edge.rise);
      }
    }
    this->Edges.clear();
    this->Neighbors.assign(this->Places.size(), {});
    this->PointTolerance.assign(this->Places.size(), { 0.0, 0.0 });
    for (const auto& [ends, limits] : seen)
    {
      this->Edges.push_back({ ends.first, ends.second, limits.first, limits.second });
      for (const Index i : { ends.first, ends.second })
      {
        this->Neighbors[static_cast<std::size_t>(i)].push_back(
          i == ends.first ? ends.second : ends.first);
        auto& own = this->PointTolerance[static_cast<std::size_t>(i)];
        own.first = std::max(own.first, limits.first);
        own.second = std::max(own.second, limits.second);
      }
    }
    Segments segments;
    PlanePoints points(static_cast<Index>(this->Places.size()), 2);
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      points.row(static_cast<Index>(i)) = this->Places[i];
    }
    for (const ImprintEdge& edge : this->Edges)
    {
      segments.emplace_back(edge.a, edge.b);
    }
    this->Grid.emplace(points, segments, ZippedTolerance * this->Reach);
  }

  bool areNeighbors(Index a, Index b) const
  {
    const std::vector<Index>& all = this->Neighbors[static_cast<std::size_t>(a)];
    return std::find(all.begin(), all.end(), b) != all.end();
  }

  double limit(Index point, const ImprintEdge& edge, const SegmentPlace& at) const
  {
    const auto& own = this->PointTolerance[static_cast<std::size_t>(point)];
    const double length = (this->place(edge.b) - this->place(edge.a)).norm();
    const bool isTip =
      (this->areNeighbors(point, edge.a) && at.distance < NarrowTip * at.along * length) ||
      (this->areNeighbors(point, edge.b) && at.distance < NarrowTip * (1.0 - at.along) * length);
    return std::max({ (isTip ? ZippedTolerance : 1.0) * std::min(own.first, edge.tolerance),
      own.second, edge.rise });
  }

  bool isUsed(std::size_t i) const { return !this->Neighbors[i].empty(); }

  /// @param gap between the curves, of the same curve none.
  void note(double move, double gap)
  {
    ++this->Merged;
    this->GreatestMove = std::max(this->GreatestMove, move);
    this->GreatestGap = std::max(this->GreatestGap, gap);
  }

  /// How far a point is from the nearest edge at another one; 0 within the curves' rises.
  double gapBeside(Index point, Index other) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Index end : this->Neighbors[static_cast<std::size_t>(other)])
    {
      least = std::min(
        least, nearestOnSegment(this->place(point), this->place(other), this->place(end)).distance);
    }
    const double rise = std::max(this->PointTolerance[static_cast<std::size_t>(point)].second,
      this->PointTolerance[static_cast<std::size_t>(other)].second);
    return least <= rise ? 0.0 : least;
  }

  /// @return whether there were any.
  bool mergePoints()
  {
    bool any = false;
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      const Index p = static_cast<Index>(i);
      if (!this->isUsed(i) || this->root(p) != p)
      {
        continue;
      }
      Index nearest = -1;
      double least = 0.0;
      for (const Index s : this->Grid->near(this->Places[i]))
      {
        const ImprintEdge& edge = this->Edges[static_cast<std::size_t>(s)];
        for (const Index end : { edge.a, edge.b })
        {
          const Index q = this->root(end);
          const double distance = (this->place(q) - this->Places[i]).norm();
          if (q == p || q != end)
          {
            continue;
          }
          const auto& own = this->PointTolerance[static_cast<std::size_t>(q)];
          // Points of one curve need not be one: each goes onto the other's chords.
          const bool isEdge = edge.a == p || edge.b == p;
          const double most = isEdge   ? std::max(this->Rounding, ShortEdge * edge.tolerance)
            : this->areNeighbors(p, q) ? 0.0
                                       : std::min(own.first, this->PointTolerance[i].first);
          if (distance <= most && (nearest < 0 || distance < least))
          {
            nearest = q;
            least = distance;
          }
        }
      }
      if (nearest < 0)
      {
        continue;
      }
      const bool stays = this->Corner[i] && !this->Corner[static_cast<std::size_t>(nearest)];
      const Index kept = stays ? p : nearest;
      const Index gone = stays ? nearest : p;
      this->Alias[static_cast<std::size_t>(gone)] = kept;
      this->Corner[static_cast<std::size_t>(kept)] = this->Corner[static_cast<std::size_t>(kept)] ||
        this->Corner[static_cast<std::size_t>(gone)];
      this->note(least, std::min(this->gapBeside(p, nearest), this->gapBeside(nearest, p)));
      any = true;
    }
    return any;
  }

  /// Whether an edge may be led through a point: not back into a wide corner at one of its ends.
  bool mayStop(const ImprintEdge& edge, Index point, const SegmentPlace& at) const
  {
    const double length = (this->place(edge.b) - this->place(edge.a)).norm();
    const double fromA = at.along * length;
    const double fromB = length - fromA;
    if (at.along <= 0.0 || at.along >= 1.0)
    {
      return false;
    }
    if (this->areNeighbors(point, edge.a) && at.distance > NarrowWedge * fromA)
    {
      return false;
    }
    return !(this->areNeighbors(point, edge.b) && at.distance > NarrowWedge * fromB);
  }

  bool stopAtPoints()
  {
    std::vector<EdgeStop> stops;
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      const Index p = static_cast<Index>(i);
      if (!this->isUsed(i))
      {
        continue;
      }
      for (const Index s : this->Grid->near(this->Places[i]))
      {
        const ImprintEdge& edge = this->Edges[static_cast<std::size_t>(s)];
        if (edge.a == p || edge.b == p)
        {
          continue;
        }
        const SegmentPlace at =
          nearestOnSegment(this->Places[i], this->place(edge.a), this->place(edge.b));
        if (at.distance <= this->limit(p, edge, at) && this->mayStop(edge, p, at))
        {
          stops.push_back({ static_cast<std::size_t>(s), at.along, p });
          const double rise =
            std::max(edge.rise, this->PointTolerance[static_cast<std::size_t>(p)].second);
          this->note(at.distance, at.distance <= rise ? 0.0 : at.distance);
        }
      }
    }
    this->cut(stops);
    return !stops.empty();
  }

  /// Where two curves cross at a wide angle away from their points, these are not to bend the other
  /// curve, near as they may be.
  /// @param sine least one of the angle; 0: any crossing. @return whether there were any.
  bool stopAtCrossings(double sine)
  {
    std::vector<EdgeStop> stops;
    for (std::size_t s = 0; s < this->Edges.size(); ++s)
    {
      const ImprintEdge edge = this->Edges[s];
      const Eigen::RowVector2d a = this->place(edge.a);
      const Eigen::RowVector2d b = this->place(edge.b);
      for (const Index other : this->Grid->near(a.cwiseMin(b), a.cwiseMax(b)))
      {
        const ImprintEdge second = this->Edges[static_cast<std::size_t>(other)];
        if (other <= static_cast<Index>(s) || second.a == edge.a || second.a == edge.b ||
          second.b == edge.a || second.b == edge.b)
        {
          continue;
        }
        const Eigen::RowVector2d c = this->place(second.a);
        const Eigen::RowVector2d d = this->place(second.b);
        if (orientation(a, b, c) * orientation(a, b, d) >= 0 ||
          orientation(c, d, a) * orientation(c, d, b) >= 0)
        {
          continue;
        }
        const Eigen::RowVector2d way = b - a;
        const Eigen::RowVector2d across = d - c;
        const double along = ((c - a).x() * across.y() - (c - a).y() * across.x()) /
          (way.x() * across.y() - way.y() * across.x());
        const Eigen::RowVector2d place = a + std::clamp(along, 0.0, 1.0) * way;
        const double area = std::abs(way.x() * across.y() - way.y() * across.x());
        const double near = std::min(edge.tolerance, second.tolerance);
        const double end = std::min(
          { (a - place).norm(), (b - place).norm(), (c - place).norm(), (d - place).norm() });
        if (sine > 0.0 && (area < sine * way.norm() * across.norm() || end <= near))
        {
          continue;
        }
        const Index point = static_cast<Index>(this->Places.size());
        this->Places.push_back(place);
        this->Corner.push_back(false);
        this->Alias.push_back(point);
        stops.push_back({ s, along, point });
        stops.push_back(
          { static_cast<std::size_t>(other), nearestOnSegment(place, c, d).along, point });
      }
    }
    this->cut(stops);
    return !stops.empty();
  }

  void cut(std::vector<EdgeStop>& stops)
  {
    std::sort(stops.begin(), stops.end(), [](const EdgeStop& a, const EdgeStop& b) {
      return a.edge != b.edge ? a.edge < b.edge
        : a.along != b.along  ? a.along < b.along
                              : a.point < b.point;
    });
    std::size_t next = 0;
    while (next < stops.size())
    {
      const std::size_t edge = stops[next].edge;
      const ImprintEdge whole = this->Edges[edge];
      Index from = whole.a;
      for (; next < stops.size() && stops[next].edge == edge; ++next)
      {
        this->Edges.push_back({ from, stops[next].point, whole.tolerance, whole.rise });
        from = stops[next].point;
      }
      this->Edges[edge].a = from;
    }
  }

  std::vector<Eigen::RowVector2d> Places;
  std::vector<bool> Corner;
  std::vector<Index> Alias;
  std::vector<ImprintEdge> Edges;
  std::vector<std::vector<Index>> Neighbors;
  std::vector<std::pair<double, double>> PointTolerance; // and rise
  std::optional<SegmentGrid> Grid;
  double Rounding = 0.0; // points that are nearer are one even where an edge joins them
  double Reach = 0.0;
  Index Merged = 0;
  double GreatestMove = 0.0;
  double GreatestGap = 0.0;
};
}

PlaneGraph imprintSegments(const PlaneSegments& segments)
{
  Imprint imprint(segments);
  imprint.run();
  return imprint.graph(segments.points.rows());
}
}
