// SPDX-License-Identifier: BSD-3-Clause
#include "LinkingRings.h"

#include "Describe.h"
#include "Errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr Index None = -1;

/// Largest rounding error of the coordinates when they all are single precision numbers (then the
/// mesh was stored so, and its partner perhaps was not), otherwise 0.
double singlePrecisionError(const PointsRef& points)
{
  double largest = 0.0;
  for (Index i = 0; i < points.rows(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double x = points(i, c);
      if (static_cast<double>(static_cast<float>(x)) != x)
      {
        return 0.0;
      }
      largest = std::max(largest, std::abs(x));
    }
  }
  // Half a unit in the last place a coordinate, twice that for safety, over three coordinates.
  return std::sqrt(3.0) * largest * double{ std::numeric_limits<float>::epsilon() };
}

/// Distance up to which two points coincide at a node where the shortest edge has length `edge`.
double coincidenceDistance(double matchTolerance, double edge, double roundingError)
{
  // Rounding may never reach the next node.
  return std::max(matchTolerance * edge, std::min(roundingError, 0.25 * edge));
}

/// Shortest of the two loop edges at each node of a loop.
std::vector<double> loopEdgeLengths(const PointsRef& points, const Loop& loop)
{
  const std::size_t n = loop.size();
  std::vector<double> length(n, std::numeric_limits<double>::max());
  for (std::size_t j = 0; j < n; ++j)
  {
    const std::size_t next = (j + 1) % n;
    const double edge = (points.row(loop[j]) - points.row(loop[next])).norm();
    length[j] = std::min(length[j], edge);
    length[next] = std::min(length[next], edge);
  }
  return length;
}

/// Points sorted into a uniform grid: finds those near a place.
class PointGrid
{
public:
  PointGrid(const PointsRef& points, const std::vector<Index>& ids, double radius)
    : Positions(points)
  {
    if (ids.empty())
    {
      return;
    }
    this->Origin = points.row(ids.front());
    Eigen::RowVector3d top = this->Origin;
    for (const Index id : ids)
    {
      this->Origin = this->Origin.cwiseMin(points.row(id));
      top = top.cwiseMax(points.row(id));
    }
    // The lower bound keeps cell numbers far below 2^63.
    this->CellSize = std::max(radius, 1e-13 * (top - this->Origin).norm());
    if (this->CellSize <= 0.0)
    {
      this->CellSize = 1.0;
    }
    this->Entries.reserve(ids.size());
    for (const Index id : ids)
    {
      this->Entries.emplace_back(this->cellOf(points.row(id)), id);
    }
    std::sort(this->Entries.begin(), this->Entries.end());
  }

  /// Calls visit(id, distance) for the points within distance <= radius of the grid's radius.
  template <typename Visit>
  void forEachNear(const Eigen::RowVector3d& place, double radius, const Visit& visit) const
  {
    if (this->Entries.empty() || !this->isNearGrid(place))
    {
      return;
    }
    const Cell middle = this->cellOf(place);
    for (Index dx = -1; dx <= 1; ++dx)
    {
      for (Index dy = -1; dy <= 1; ++dy)
      {
        const Cell low = { middle[0] + dx, middle[1] + dy, middle[2] - 1 };
        const Cell high = { middle[0] + dx, middle[1] + dy, middle[2] + 2 };
        auto entry = std::lower_bound(
          this->Entries.begin(), this->Entries.end(), std::make_pair(low, Index{ None }));
        for (; entry != this->Entries.end() && entry->first < high; ++entry)
        {
          const double distance = (this->Positions.row(entry->second) - place).norm();
          if (distance <= radius)
          {
            visit(entry->second, distance);
          }
        }
      }
    }
  }

private:
  using Cell = std::array<Index, 3>;

  Cell cellOf(const Eigen::RowVector3d& place) const
  {
    Cell cell;
    for (int c = 0; c < 3; ++c)
    {
      cell[c] = static_cast<Index>(std::floor((place[c] - this->Origin[c]) / this->CellSize));
    }
    return cell;
  }

  /// False for places so far away that their cell number would overflow.
  bool isNearGrid(const Eigen::RowVector3d& place) const
  {
    return ((place - this->Origin) / this->CellSize).cwiseAbs().maxCoeff() < 1e17;
  }

  PointsRef Positions;
  Eigen::RowVector3d Origin = Eigen::RowVector3d::Zero();
  double CellSize = 1.0;
  std::vector<std::pair<Cell, Index>> Entries;
};

/// An edge of a quad: its end points in rising order, the quad, and where the edge is in it.
struct QuadEdge
{
  Index low;
  Index high;
  Index quad;
  int corner;

  bool operator<(const QuadEdge& other) const
  {
    return std::tie(this->low, this->high, this->quad, this->corner) <
      std::tie(other.low, other.high, other.quad, other.corner);
  }
};

std::vector<QuadEdge> sortedEdges(const Quads& quads)
{
  std::vector<QuadEdge> edges;
  edges.reserve(4 * static_cast<std::size_t>(quads.rows()));
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (int c = 0; c < 4; ++c)
    {
      const auto ends = std::minmax(quads(q, c), quads(q, (c + 1) % 4));
      edges.push_back({ ends.first, ends.second, q, c });
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Calls visit(first, last) for each run of entries that describe one and the same edge.
template <typename Visit>
void forEachEdge(const std::vector<QuadEdge>& edges, const Visit& visit)
{
  for (auto first = edges.begin(); first != edges.end();)
  {
    auto last = first + 1;
    while (last != edges.end() && last->low == first->low && last->high == first->high)
    {
      ++last;
    }
    visit(first, last);
    first = last;
  }
}

/// Ids of the points on edges that have one quad.
std::vector<Index> boundaryPoints(const std::vector<QuadEdge>& edges)
{
  std::vector<Index> ids;
  forEachEdge(edges, [&ids](auto first, auto last) {
    if (last - first == 1)
    {
      ids.push_back(first->low);
      ids.push_back(first->high);
    }
  });
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

/// Length of the shortest quad edge at each point.
std::vector<double> shortestEdges(const PointsRef& points, const std::vector<QuadEdge>& edges)
{
  std::vector<double> shortest(
    static_cast<std::size_t>(points.rows()), std::numeric_limits<double>::max());
  for (const QuadEdge& edge : edges)
  {
    const double length = (points.row(edge.low) - points.row(edge.high)).norm();
    shortest[edge.low] = std::min(shortest[edge.low], length);
    shortest[edge.high] = std::min(shortest[edge.high], length);
  }
  return shortest;
}

void checkQuads(const PointsRef& points, const QuadsRef& quads)
{
  if (quads.rows() == 0)
  {
    throw InvalidInput("the linking sides have no quads. Mesh them with structured quads first.");
  }
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (int c = 0; c < 4; ++c)
    {
      const Index id = quads(q, c);
      if (id < 0 || id >= points.rows())
      {
        throw InvalidInput("Quad " + std::to_string(q) +
          " of the linking sides names a point that does not exist (" + std::to_string(id) + ").");
      }
      if (!points.row(id).allFinite())
      {
        throw InvalidInput("Point " + std::to_string(id) +
          " of the linking sides has a coordinate that is not a finite number.");
      }
    }
  }
}

/// Joins patches that repeat the points of their common seam: point id -> smallest id there.
std::vector<Index> weldSeams(
  const PointsRef& points, const Quads& quads, double matchTolerance, double roundingError)
{
  std::vector<Index> root(static_cast<std::size_t>(points.rows()));
  std::iota(root.begin(), root.end(), Index{ 0 });
  const auto find = [&root](Index i) {
    while (root[i] != i)
    {
      root[i] = root[root[i]];
      i = root[i];
    }
    return i;
  };

  const std::vector<QuadEdge> edges = sortedEdges(quads);
  const std::vector<Index> candidates = boundaryPoints(edges);
  const std::vector<double> edgeLength = shortestEdges(points, edges);
  const auto radiusOf = [&](Index id) {
    return coincidenceDistance(matchTolerance, edgeLength[id], roundingError);
  };

  double largestRadius = 0.0;
  for (const Index id : candidates)
  {
    largestRadius = std::max(largestRadius, radiusOf(id));
  }
  const PointGrid grid(points, candidates, largestRadius);
  for (const Index id : candidates)
  {
    grid.forEachNear(points.row(id), radiusOf(id), [&](Index other, double) {
      const Index a = find(id);
      const Index b = find(other);
      root[std::max(a, b)] = std::min(a, b);
    });
  }
  for (Index i = 0; i < points.rows(); ++i)
  {
    root[i] = find(i);
  }
  return root;
}

/// The two quads beside each quad edge.
class QuadNeighbors
{
public:
  QuadNeighbors(const PointsRef& points, const Quads& quads)
    : Edges(sortedEdges(quads))
  {
    forEachEdge(this->Edges, [&points](auto first, auto last) {
      if (first->low == first->high)
      {
        throw InvalidInput("Quad " + std::to_string(first->quad) +
          " of the linking sides has an edge of no length at " + describe(points.row(first->low)) +
          ". Remove the collapsed quads.");
      }
      if (last - first > 2)
      {
        throw InvalidInput(std::to_string(last - first) +
          " quads of the linking sides meet at the edge from " + describe(points.row(first->low)) +
          " to " + describe(points.row(first->high)) +
          "; at most two may. Remove duplicate cells, and cells that are not on a linking side.");
      }
    });
  }

  /// The one or two entries of the edge between two points; an empty range when there is none.
  std::pair<const QuadEdge*, const QuadEdge*> edge(Index a, Index b) const
  {
    const auto ends = std::minmax(a, b);
    const auto before = [](const QuadEdge& entry, const std::pair<Index, Index>& key) {
      return std::make_pair(entry.low, entry.high) < key;
    };
    const auto first = std::lower_bound(
      this->Edges.begin(), this->Edges.end(), std::make_pair(ends.first, ends.second), before);
    auto last = first;
    while (last != this->Edges.end() && last->low == ends.first && last->high == ends.second)
    {
      ++last;
    }
    const QuadEdge* base = this->Edges.data();
    return { base + (first - this->Edges.begin()), base + (last - this->Edges.begin()) };
  }

  std::vector<Index> boundary() const { return boundaryPoints(this->Edges); }

private:
  std::vector<QuadEdge> Edges;
};

std::string describeRing(std::size_t loop, Index ring)
{
  return "ring " + std::to_string(ring) + " of loop " + std::to_string(loop);
}

/// Linking node of each loop node; adds to the match statistics of `rings`.
Loop matchLoop(const PointsRef& sourcePoints, const Loop& loop, std::size_t loopNumber,
  const PointsRef& linkingPoints, const std::vector<Index>& candidates, const PointGrid& grid,
  double matchTolerance, double roundingError, LinkingRings& rings)
{
  const std::vector<double> edgeLength = loopEdgeLengths(sourcePoints, loop);
  Loop ring(loop.size(), None);
  for (std::size_t j = 0; j < loop.size(); ++j)
  {
    const Eigen::RowVector3d place = sourcePoints.row(loop[j]);
    const double radius = coincidenceDistance(matchTolerance, edgeLength[j], roundingError);
    double nearest = std::numeric_limits<double>::max();
    grid.forEachNear(place, radius, [&](Index id, double distance) {
      if (distance < nearest || (distance == nearest && id < ring[j]))
      {
        nearest = distance;
        ring[j] = id;
      }
    });
    if (ring[j] == None)
    {
      for (const Index id : candidates)
      {
        nearest = std::min(nearest, (linkingPoints.row(id) - place).norm());
      }
      throw InvalidInput("the linking sides have no boundary node at node " + std::to_string(j) +
        " of loop " + std::to_string(loopNumber) + " of the source quads (point " +
        std::to_string(loop[j]) + ", at " + describe(place) + "): the nearest one is " +
        describe(nearest) + " away, the tolerance is " + describe(radius) +
        ". The first ring of the linking sides must have the nodes of the source loop; check that "
        "both belong to the same model, or raise MatchTolerance.");
    }
    rings.maximumMatchDistance = std::max(rings.maximumMatchDistance, nearest);
    rings.snapped += nearest > 0.0 ? 1 : 0;
  }
  return ring;
}

/// Walks from ring to ring, and remembers which quads and nodes it has seen.
class RingWalk
{
public:
  RingWalk(const PointsRef& points, const Quads& quads, const QuadNeighbors& neighbors)
    : Positions(points)
    , Cells(quads)
    , Neighbors(neighbors)
    , QuadSeen(static_cast<std::size_t>(quads.rows()), 0)
    , PointSeen(static_cast<std::size_t>(points.rows()), 0)
  {
  }

  /// The rings of one loop, from its matched first ring to the far end.
  LinkingRings::RingTable walk(const Loop& firstRing, std::size_t loop)
  {
    std::vector<Loop> rings;
    this->claim(firstRing, loop, 0);
    rings.push_back(firstRing);
    for (Loop next = this->step(firstRing, loop, 0); !next.empty();
         next = this->step(rings.back(), loop, static_cast<Index>(rings.size()) - 1))
    {
      this->claim(next, loop, static_cast<Index>(rings.size()));
      rings.push_back(std::move(next));
    }

    LinkingRings::RingTable table(
      static_cast<Index>(rings.size()), static_cast<Index>(firstRing.size()));
    for (std::size_t k = 0; k < rings.size(); ++k)
    {
      table.row(static_cast<Index>(k)) =
        Eigen::Map<const Eigen::Matrix<Index, 1, Eigen::Dynamic>>(rings[k].data(), table.cols());
    }
    return table;
  }

  /// Throws when a quad was never reached.
  void checkAllSeen() const
  {
    const auto seen = std::count(this->QuadSeen.begin(), this->QuadSeen.end(), 1);
    if (seen == this->Cells.rows())
    {
      return;
    }
    const Index quad =
      std::find(this->QuadSeen.begin(), this->QuadSeen.end(), 0) - this->QuadSeen.begin();
    throw InvalidInput(std::to_string(this->Cells.rows() - seen) +
      " quads of the linking sides are not reached from any loop of the source quads; the first "
      "is quad " +
      std::to_string(quad) + " at " + describe(this->center(quad)) +
      ". The source cap may lack a hole that the linking sides have, or the linking sides contain "
      "cells that are not linking sides (a cap, say): remove them.");
  }

private:
  Eigen::RowVector3d center(Index quad) const
  {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (int c = 0; c < 4; ++c)
    {
      sum += 0.25 * this->Positions.row(this->Cells(quad, c));
    }
    return sum;
  }

  std::string describeEdge(Index a, Index b) const
  {
    return "the edge from " + describe(this->Positions.row(a)) + " to " +
      describe(this->Positions.row(b));
  }

  /// Marks the nodes of a ring; no node may be on two.
  void claim(const Loop& ring, std::size_t loop, Index number)
  {
    for (const Index id : ring)
    {
      if (this->PointSeen[id])
      {
        throw InvalidInput("the linking sides are not structured: " + describeRing(loop, number) +
          " meets itself or another ring at " + describe(this->Positions.row(id)) +
          ". Each loop of the source cap needs its own structured side.");
      }
      this->PointSeen[id] = 1;
    }
  }

  /// The quad ahead of a ring edge; None at the far end.
  Index quadAhead(Index a, Index b, std::size_t loop, Index ring) const
  {
    const auto range = this->Neighbors.edge(a, b);
    if (range.first == range.second)
    {
      throw InvalidInput("the linking sides have a hole, or other nodes than the source quads: " +
        describeRing(loop, ring) + " has no quad at " + this->describeEdge(a, b) + ".");
    }
    if (ring == 0 && range.second - range.first == 2)
    {
      throw InvalidInput("the linking sides go on beyond loop " + std::to_string(loop) +
        " of the source quads at " + this->describeEdge(a, b) +
        ": they must end there. Remove the cells of the cap from the linking sides.");
    }
    for (const QuadEdge* entry = range.first; entry != range.second; ++entry)
    {
      if (!this->QuadSeen[entry->quad])
      {
        return entry->quad;
      }
    }
    return None;
  }

  /// The node that follows `from` in a quad when one walks away from `beside`.
  Index across(Index quad, Index from, Index beside) const
  {
    for (int c = 0; c < 4; ++c)
    {
      if (this->Cells(quad, c) == from)
      {
        const Index after = this->Cells(quad, (c + 1) % 4);
        return after == beside ? this->Cells(quad, (c + 3) % 4) : after;
      }
    }
    return None;
  }

  /// The next ring; empty at the far end.
  Loop step(const Loop& ring, std::size_t loop, Index number)
  {
    const std::size_t n = ring.size();
    std::vector<Index> ahead(n);
    std::size_t missing = n;
    std::size_t count = 0;
    for (std::size_t j = 0; j < n; ++j)
    {
      ahead[j] = this->quadAhead(ring[j], ring[(j + 1) % n], loop, number);
      if (ahead[j] == None)
      {
        missing = j;
      }
      else
      {
        ++count;
      }
    }
    if (count == 0)
    {
      if (number == 0)
      {
        throw InvalidInput("the linking sides have no layer at loop " + std::to_string(loop) +
          " of the source quads.");
      }
      return {};
    }
    if (count < n)
    {
      throw InvalidInput("the linking sides have a hole, or sides with different numbers of "
                         "layers: " +
        describeRing(loop, number) + " has no quad ahead at " +
        this->describeEdge(ring[missing], ring[(missing + 1) % n]) + " but has one at " +
        std::to_string(count) + " of its " + std::to_string(n) +
        " edges. Give all sides the same number of layers.");
    }
    Loop next(n);
    for (std::size_t j = 0; j < n; ++j)
    {
      const std::size_t before = (j + n - 1) % n;
      next[j] = this->across(ahead[j], ring[j], ring[(j + 1) % n]);
      if (next[j] != this->across(ahead[before], ring[j], ring[before]))
      {
        throw InvalidInput("the linking sides are not structured: the two quads ahead of " +
          describeRing(loop, number) + " at " + describe(this->Positions.row(ring[j])) +
          " do not share an edge. Four quads must meet at each inner node, and seams must have "
          "coincident nodes (or raise MatchTolerance).");
      }
      this->QuadSeen[ahead[j]] = 1;
    }
    return next;
  }

  PointsRef Positions;
  const Quads& Cells;
  const QuadNeighbors& Neighbors;
  std::vector<char> QuadSeen;
  std::vector<char> PointSeen;
};

void checkSameLayers(const LinkingRings& rings)
{
  for (std::size_t l = 1; l < rings.loops.size(); ++l)
  {
    if (rings.loops[l].rows() != rings.loops[0].rows())
    {
      throw InvalidInput("the linking sides have " + std::to_string(rings.numberOfLayers()) +
        " layers at loop 0 but " + std::to_string(rings.loops[l].rows() - 1) + " at loop " +
        std::to_string(l) + ". Give all loops the same number of layers.");
    }
  }
}
}

Quads weldLinkingSeams(
  const PointsRef& linkingPoints, const QuadsRef& linkingQuads, double matchTolerance)
{
  checkQuads(linkingPoints, linkingQuads);
  const std::vector<Index> welded =
    weldSeams(linkingPoints, linkingQuads, matchTolerance, singlePrecisionError(linkingPoints));
  Quads quads = linkingQuads;
  for (Index i = 0; i < quads.size(); ++i)
  {
    quads.data()[i] = welded[quads.data()[i]];
  }
  return quads;
}

LinkingRings traceLinkingRings(const PointsRef& sourcePoints, const std::vector<Loop>& sourceLoops,
  const PointsRef& linkingPoints, const QuadsRef& linkingQuads, double matchTolerance)
{
  if (!(matchTolerance >= 0.0 && matchTolerance < 0.5))
  {
    throw InvalidInput("MatchTolerance must lie in [0, 0.5); it is relative to the local edge "
                       "length.");
  }
  const double roundingError =
    std::max(singlePrecisionError(sourcePoints), singlePrecisionError(linkingPoints));
  const Quads quads = weldLinkingSeams(linkingPoints, linkingQuads, matchTolerance);
  const QuadNeighbors neighbors(linkingPoints, quads);

  double largestRadius = 0.0;
  for (const Loop& loop : sourceLoops)
  {
    for (const double edge : loopEdgeLengths(sourcePoints, loop))
    {
      largestRadius =
        std::max(largestRadius, coincidenceDistance(matchTolerance, edge, roundingError));
    }
  }
  const std::vector<Index> candidates = neighbors.boundary();
  const PointGrid grid(linkingPoints, candidates, largestRadius);

  LinkingRings rings;
  RingWalk walk(linkingPoints, quads, neighbors);
  for (std::size_t l = 0; l < sourceLoops.size(); ++l)
  {
    const Loop firstRing = matchLoop(sourcePoints, sourceLoops[l], l, linkingPoints, candidates,
      grid, matchTolerance, roundingError, rings);
    rings.loops.push_back(walk.walk(firstRing, l));
  }
  checkSameLayers(rings);
  walk.checkAllSeen();
  return rings;
}

Points ringPoints(
  const LinkingRings& rings, const PointsRef& linkingPoints, std::size_t loop, Index ring)
{
  const LinkingRings::RingTable& table = rings.loops.at(loop);
  Points points(table.cols(), 3);
  for (Index j = 0; j < table.cols(); ++j)
  {
    points.row(j) = linkingPoints.row(table(ring, j));
  }
  return points;
}

TargetMatch matchTargetLoops(const PointsRef& targetPoints, const std::vector<Loop>& sourceLoops,
  const LinkingRings& rings, const PointsRef& linkingPoints, double matchTolerance)
{
  const double roundingError =
    std::max(singlePrecisionError(targetPoints), singlePrecisionError(linkingPoints));
  TargetMatch match;
  Index apart = 0;
  double worst = 0.0;
  std::string where;
  for (std::size_t l = 0; l < sourceLoops.size(); ++l)
  {
    const Loop& loop = sourceLoops[l];
    const Points ring = ringPoints(rings, linkingPoints, l, rings.numberOfLayers());
    const std::vector<double> edgeLength = loopEdgeLengths(targetPoints, loop);
    for (std::size_t j = 0; j < loop.size(); ++j)
    {
      const Eigen::RowVector3d place = targetPoints.row(loop[j]);
      const double distance = (ring.row(static_cast<Index>(j)) - place).norm();
      match.maximumDistance = std::max(match.maximumDistance, distance);
      match.snapped += distance > 0.0 ? 1 : 0;
      if (!(distance <= coincidenceDistance(matchTolerance, edgeLength[j], roundingError)))
      {
        ++apart;
        if (!(distance <= worst))
        {
          worst = distance;
          where = "point " + std::to_string(loop[j]) + " (loop " + std::to_string(l) +
            ") of the target quads at " + describe(place) + " is " + describe(distance) +
            " away from its linking node at " + describe(ring.row(static_cast<Index>(j)));
        }
      }
    }
  }
  if (apart > 0)
  {
    throw InvalidInput("the last ring of the linking sides does not lie on the boundary of the "
                       "target quads: " +
      std::to_string(apart) + " nodes differ; the worst: " + where +
      ". Target quads must have the point order of the source quads and the boundary nodes of the "
      "last ring; check that they belong to the same model, or raise MatchTolerance.");
  }
  return match;
}
}
