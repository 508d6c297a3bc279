// SPDX-License-Identifier: BSD-3-Clause
#include "CommonSubdivision.h"

#include "SurfaceTopology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
using Plane = Eigen::RowVector2d;

double cross(const Plane& u, const Plane& v)
{
  return u.x() * v.y() - u.y() * v.x();
}

/// Where an edge of the mesh crosses an intrinsic edge.
struct Crossing
{
  Index half;       ///< intrinsic half-edge, of the triangle that the mesh edge comes from
  double along;     ///< on the mesh edge, in (0, 1)
  double alongHalf; ///< on the intrinsic half-edge, in (0, 1)
};

/// A mesh edge and its crossings in order.
struct TracedEdge
{
  Index from;
  Index to;
  std::vector<Crossing> crossings;
};

/// Follows mesh edges through intrinsic triangles.
class EdgeTracer
{
public:
  explicit EdgeTracer(const IntrinsicTriangulation& intrinsic)
    : Intrinsic(intrinsic)
  {
  }

  /// All mesh edges that cross an intrinsic one, each from its lower to its higher point id.
  std::vector<TracedEdge> trace() const
  {
    std::vector<TracedEdge> traced;
    for (Index t = 0; t < this->Intrinsic.triangles.rows(); ++t)
    {
      const TriangleCrossings inside = this->inside(t);
      for (Index c = 0; c < 3; ++c)
      {
        for (Index k = 0; k < inside.from[c]; ++k)
        {
          const Index opposite = 3 * t + (c + 1) % 3;
          TracedEdge edge = this->follow(3 * t + c, opposite, inside.around[(c + 1) % 3] + k);
          if (edge.from < edge.to)
          {
            traced.push_back(std::move(edge));
          }
        }
      }
    }
    return traced;
  }

private:
  static Index next(Index half) { return half % 3 == 2 ? half - 2 : half + 1; }
  static Index previous(Index half) { return half % 3 == 0 ? half + 2 : half - 1; }
  Index vertex(Index half) const { return this->Intrinsic.triangles(half / 3, half % 3); }
  Index crossings(Index half) const { return this->Intrinsic.crossings(half / 3, half % 3); }
  TriangleCrossings inside(Index t) const
  {
    const auto& n = this->Intrinsic.crossings;
    return triangleCrossings(n(t, 0), n(t, 1), n(t, 2));
  }

  /// From a corner across a half-edge as the one at this position, counted from its start.
  TracedEdge follow(Index corner, Index half, Index position) const
  {
    TracedEdge edge{ this->vertex(corner), -1, {} };
    // Unfolded about the corner that the edge starts from.
    const Plane start = this->Intrinsic.corners.row(corner);
    std::vector<std::pair<Plane, Plane>> gates;
    Plane a = Plane(this->Intrinsic.corners.row(half)) - start;
    Plane b = Plane(this->Intrinsic.corners.row(next(half))) - start;
    Plane end = Plane::Zero();
    for (;;)
    {
      edge.crossings.push_back({ half, 0.0, 0.0 });
      gates.emplace_back(a, b);
      const Index other = this->Intrinsic.twins(half / 3, half % 3);
      const Plane apex = this->unfoldedApex(other, b, a);
      const Index place = this->crossings(other) - 1 - position; // counted from b
      const TriangleCrossings inside = this->inside(other / 3);
      const Index c = other % 3;
      const Index first = inside.around[c];
      const Index second = first + inside.from[(c + 2) % 3];
      if (place >= first && place < second)
      {
        edge.to = this->vertex(previous(other));
        end = apex;
        break;
      }
      if (place < first) // round b, across the half-edge from the apex to b
      {
        half = previous(other);
        position = this->crossings(half) - 1 - place;
        a = apex;
      }
      else // round a, across the half-edge from a to the apex
      {
        half = next(other);
        position = this->crossings(other) - 1 - place;
        b = apex;
      }
    }
    this->intersect(edge, gates, end);
    return edge;
  }

  /// Intersections of the straight line from the origin with the gates, in strict order.
  void intersect(
    TracedEdge& edge, const std::vector<std::pair<Plane, Plane>>& gates, const Plane& end) const
  {
    double last = 0.0;
    for (std::size_t g = 0; g < gates.size(); ++g)
    {
      const auto& [a, b] = gates[g];
      const double left = cross(end, b);
      const double right = cross(end, a);
      const double alongHalf = std::clamp(right / (right - left), 0.0, 1.0);
      const Plane place = a + alongHalf * (b - a);
      double along = place.dot(end) / end.squaredNorm();
      const double remaining = static_cast<double>(gates.size() - g);
      if (!(along > last) || !(along < 1.0))
      {
        along = last + (1.0 - last) / (remaining + 1.0);
      }
      edge.crossings[g].along = last = along;
      edge.crossings[g].alongHalf = alongHalf;
    }
  }

  /// The apex of a half-edge once its triangle is moved so that the half-edge runs from b to a.
  Plane unfoldedApex(Index half, const Plane& b, const Plane& a) const
  {
    const Plane from = this->Intrinsic.corners.row(half);
    const Plane to = this->Intrinsic.corners.row(next(half));
    const Plane apex = this->Intrinsic.corners.row(previous(half));
    const Plane old = to - from;
    const Plane now = a - b;
    const Plane turn =
      Plane(old.dot(now), cross(old, now)) / std::sqrt(old.squaredNorm() * now.squaredNorm());
    const auto turned = [&turn](const Plane& v) {
      return Plane(turn.x() * v.x() - turn.y() * v.y(), turn.y() * v.x() + turn.x() * v.y());
    };
    const bool nearFrom = (apex - from).squaredNorm() < (apex - to).squaredNorm();
    return nearFrom ? Plane(b + turned(apex - from)) : Plane(a + turned(apex - to));
  }

  const IntrinsicTriangulation& Intrinsic;
};

/// The convex polygon's triangles: the fan whose least triangle is greatest.
void appendFan(std::vector<Index>& ids, const std::vector<Index>& polygon, const Points& points)
{
  const std::size_t n = polygon.size();
  std::size_t best = 0;
  double greatest = -1.0;
  for (std::size_t s = 0; n > 3 && s < n; ++s)
  {
    double least = std::numeric_limits<double>::max();
    for (std::size_t k = 1; k + 1 < n; ++k)
    {
      const Eigen::RowVector3d p = points.row(polygon[s]);
      const Eigen::RowVector3d u = points.row(polygon[(s + k) % n]) - p;
      const Eigen::RowVector3d v = points.row(polygon[(s + k + 1) % n]) - p;
      least = std::min(least, u.cross(v).norm());
    }
    if (least > greatest)
    {
      greatest = least;
      best = s;
    }
  }
  for (std::size_t k = 1; k + 1 < n; ++k)
  {
    ids.insert(ids.end(), { polygon[best], polygon[(best + k) % n], polygon[(best + k + 1) % n] });
  }
}

/// The pieces of a triangle with points on its sides: sides[c] are those from corner c to c + 1.
void appendPieces(std::vector<Index>& ids, const std::array<Index, 3>& corners,
  const std::array<std::vector<Index>, 3>& sides, const Points& points)
{
  const auto count = [&](std::size_t c) { return static_cast<Index>(sides[c].size()); };
  const TriangleCrossings inside = triangleCrossings(count(0), count(1), count(2));
  std::array<std::vector<Index>, 3> middle; // of the side before a corner to that after it
  std::size_t source = 3;                   // corner that edges start from
  for (std::size_t c = 0; c < 3; ++c)
  {
    const std::vector<Index>& after = sides[c];
    const std::vector<Index>& before = sides[(c + 2) % 3];
    Index lastAfter = corners[c];
    Index lastBefore = corners[c];
    for (Index k = 0; k < inside.around[c]; ++k)
    {
      const Index p = after[static_cast<std::size_t>(k)];
      const Index q = before[before.size() - 1 - static_cast<std::size_t>(k)];
      appendFan(ids,
        k == 0 ? std::vector<Index>{ corners[c], p, q }
               : std::vector<Index>{ lastBefore, lastAfter, p, q },
        points);
      lastAfter = p;
      lastBefore = q;
    }
    middle[c] = inside.around[c] == 0 ? std::vector<Index>{ corners[c] }
                                      : std::vector<Index>{ lastBefore, lastAfter };
    if (inside.from[c] > 0)
    {
      source = c;
    }
  }
  if (source == 3)
  {
    std::vector<Index> polygon;
    for (const std::vector<Index>& part : middle)
    {
      polygon.insert(polygon.end(), part.begin(), part.end());
    }
    appendFan(ids, polygon, points);
    return;
  }
  // A fan about the source: the ends are what is left at the other two corners.
  const std::size_t a = (source + 1) % 3;
  const std::size_t b = (source + 2) % 3;
  std::vector<Index> piece{ corners[source] };
  piece.insert(piece.end(), middle[a].begin(), middle[a].end());
  for (Index k = 0; k < inside.from[source]; ++k)
  {
    const Index p = sides[a][static_cast<std::size_t>(inside.around[a] + k)];
    piece.push_back(p);
    appendFan(ids, piece, points);
    piece = { corners[source], p };
  }
  piece.insert(piece.end(), middle[b].begin(), middle[b].end());
  appendFan(ids, piece, points);
}

/// A point of an intrinsic half-edge in the disk.
Plane onHalfEdge(const IntrinsicTriangulation& intrinsic, DiskDomain domain,
  const PlanePointsRef& disk, const Crossing& crossing)
{
  const Index t = crossing.half / 3;
  const Index c = crossing.half % 3;
  const auto corners = domainCorners(domain, disk, intrinsic.triangles.row(t));
  const Plane place =
    (1.0 - crossing.alongHalf) * corners.row(c) + crossing.alongHalf * corners.row((c + 1) % 3);
  return domain == DiskDomain::Annulus
    ? Plane(std::exp(place.x()) * Plane(std::cos(place.y()), std::sin(place.y())))
    : place;
}

/// Cuts more and more triangles until the map is carried without flips that are its own.
class Cutting
{
public:
  Cutting(const TriangleMesh& mesh, const IntrinsicTriangulation& intrinsic, DiskDomain domain,
    const PlanePointsRef& disk)
    : Mesh(mesh)
    , Domain(domain)
    , Neighbors(triangleNeighbors(mesh.triangles))
    , Traced(EdgeTracer(intrinsic).trace())
    , TracedSides(Triangles::Constant(mesh.triangles.rows(), 3, -1))
    , Cut(static_cast<std::size_t>(mesh.triangles.rows()), false)
  {
    std::map<std::pair<Index, Index>, Index> numberOf;
    Index count = 0;
    for (std::size_t e = 0; e < this->Traced.size(); ++e)
    {
      numberOf.emplace(
        std::make_pair(this->Traced[e].from, this->Traced[e].to), static_cast<Index>(e));
      count += static_cast<Index>(this->Traced[e].crossings.size());
    }
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
    {
      for (Index c = 0; c < 3; ++c)
      {
        const Index a = mesh.triangles(t, c);
        const Index b = mesh.triangles(t, (c + 1) % 3);
        const auto known = numberOf.find({ std::min(a, b), std::max(a, b) });
        this->TracedSides(t, c) = known == numberOf.end() ? -1 : known->second;
      }
    }
    // All points that there could be.
    const Index n = mesh.points.rows();
    this->AllPoints.resize(n + count, 3);
    this->AllPoints.topRows(n) = mesh.points;
    this->AllPlaces.resize(n + count, 2);
    this->AllPlaces.topRows(n) = disk;
    Index point = n;
    for (const TracedEdge& edge : this->Traced)
    {
      this->Inserted.emplace_back();
      for (const Crossing& crossing : edge.crossings)
      {
        this->Inserted.back().push_back(point);
        this->AllPoints.row(point) = (1.0 - crossing.along) * mesh.points.row(edge.from) +
          crossing.along * mesh.points.row(edge.to);
        this->AllPlaces.row(point) = onHalfEdge(intrinsic, domain, disk, crossing);
        ++point;
      }
    }
  }

  CutSurface cut(std::vector<Index> open)
  {
    for (std::size_t rings = 1; !open.empty(); rings *= 2)
    {
      this->addRings(std::move(open), rings);
      this->closeUp();
      this->makePieces();
      open.clear();
      const std::vector<Index> flipped =
        domainTriangles(this->Domain, this->AllPlaces, this->Pieces).flipped;
      for (const Index piece : flipped)
      {
        const Index t = this->Origin[static_cast<std::size_t>(piece)];
        if (!this->isCut(t) && this->hasTracedSide(t) && (open.empty() || open.back() != t))
        {
          open.push_back(t);
        }
      }
    }
    return this->compacted();
  }

private:
  bool isCut(Index t) const { return this->Cut[static_cast<std::size_t>(t)]; }
  bool hasTracedSide(Index t) const { return this->TracedSides.row(t).maxCoeff() >= 0; }

  /// Marks triangles and those around them, as far as crossed edges lead.
  void addRings(std::vector<Index> ring, std::size_t rings)
  {
    for (std::size_t r = 0; r < rings && !ring.empty(); ++r)
    {
      std::vector<Index> next;
      for (const Index t : ring)
      {
        this->Cut[static_cast<std::size_t>(t)] = true;
        for (Index c = 0; c < 3; ++c)
        {
          if (this->TracedSides(t, c) >= 0 && !this->isCut(this->Neighbors(t, c)))
          {
            next.push_back(this->Neighbors(t, c));
          }
        }
      }
      ring = std::move(next);
    }
  }

  /// A triangle with points on two sides or more is cut as well.
  void closeUp()
  {
    this->Wanted.assign(this->Traced.size(), false);
    std::vector<Index> open;
    for (Index t = 0; t < this->Mesh.triangles.rows(); ++t)
    {
      if (this->isCut(t))
      {
        open.push_back(t);
      }
    }
    while (!open.empty())
    {
      const Index t = open.back();
      open.pop_back();
      this->Cut[static_cast<std::size_t>(t)] = true;
      for (Index c = 0; c < 3; ++c)
      {
        const Index side = this->TracedSides(t, c);
        if (side < 0)
        {
          continue;
        }
        this->Wanted[static_cast<std::size_t>(side)] = true;
        const Index neighbor = this->Neighbors(t, c);
        if (!this->isCut(neighbor) && this->numberOfWantedSides(neighbor) > 1)
        {
          open.push_back(neighbor);
        }
      }
    }
  }

  Index numberOfWantedSides(Index t) const
  {
    Index count = 0;
    for (Index c = 0; c < 3; ++c)
    {
      const Index side = this->TracedSides(t, c);
      count += side >= 0 && this->Wanted[static_cast<std::size_t>(side)] ? 1 : 0;
    }
    return count;
  }

  void makePieces()
  {
    std::vector<Index> ids;
    this->Origin.clear();
    for (Index t = 0; t < this->Mesh.triangles.rows(); ++t)
    {
      const auto corners = this->Mesh.triangles.row(t);
      std::array<std::vector<Index>, 3> sides;
      for (Index c = 0; c < 3; ++c)
      {
        const Index side = this->TracedSides(t, c);
        if (side >= 0 && this->Wanted[static_cast<std::size_t>(side)])
        {
          std::vector<Index>& points = sides[static_cast<std::size_t>(c)];
          points = this->Inserted[static_cast<std::size_t>(side)];
          if (corners[c] > corners[(c + 1) % 3])
          {
            std::reverse(points.begin(), points.end());
          }
        }
      }
      // With points on one side only this is the fan about the corner opposite.
      appendPieces(ids, { corners[0], corners[1], corners[2] }, sides, this->AllPoints);
      this->Origin.resize(ids.size() / 3, t);
    }
    this->Pieces = Eigen::Map<const Triangles>(ids.data(), static_cast<Index>(ids.size()) / 3, 3);
  }

  /// The pieces, with the points that they use.
  CutSurface compacted() const
  {
    const Index n = this->Mesh.points.rows();
    std::vector<Index> kept;
    for (Index i = 0; i < n; ++i)
    {
      kept.push_back(i);
    }
    std::vector<Index> number(static_cast<std::size_t>(this->AllPoints.rows()), -1);
    for (std::size_t e = 0; e < this->Inserted.size(); ++e)
    {
      if (this->Wanted[e])
      {
        kept.insert(kept.end(), this->Inserted[e].begin(), this->Inserted[e].end());
      }
    }
    CutSurface result;
    result.mesh.points.resize(static_cast<Index>(kept.size()), 3);
    result.disk.resize(static_cast<Index>(kept.size()), 2);
    for (std::size_t i = 0; i < kept.size(); ++i)
    {
      number[static_cast<std::size_t>(kept[i])] = static_cast<Index>(i);
      result.mesh.points.row(static_cast<Index>(i)) = this->AllPoints.row(kept[i]);
      result.disk.row(static_cast<Index>(i)) = this->AllPlaces.row(kept[i]);
    }
    result.mesh.triangles = this->Pieces;
    for (Index i = 0; i < result.mesh.triangles.size(); ++i)
    {
      Index& id = result.mesh.triangles.data()[i];
      id = number[static_cast<std::size_t>(id)];
    }
    result.triangleOrigin = this->Origin;
    return result;
  }

  const TriangleMesh& Mesh;
  DiskDomain Domain;
  Triangles Neighbors;
  std::vector<TracedEdge> Traced;
  std::vector<std::vector<Index>> Inserted; // points of each traced edge
  Triangles TracedSides;                    // traced edge on side c of triangle t; -1: none
  Points AllPoints;
  PlanePoints AllPlaces;
  std::vector<bool> Cut;    // triangles
  std::vector<bool> Wanted; // traced edges
  Triangles Pieces;
  std::vector<Index> Origin;
};
}

CutSurface cutAlongIntrinsicEdges(const TriangleMesh& mesh, const IntrinsicTriangulation& intrinsic,
  DiskDomain domain, const PlanePointsRef& disk, const std::vector<Index>& triangles)
{
  if (triangles.empty())
  {
    std::vector<Index> origin;
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
    {
      origin.push_back(t);
    }
    return { mesh, origin, disk };
  }
  return Cutting(mesh, intrinsic, domain, disk).cut(triangles);
}

std::vector<EdgeSubdivision> middlesOfIntrinsicEdges(
  const IntrinsicTriangulation& intrinsic, const std::vector<Index>& triangles)
{
  const auto twin = [&](Index half) { return intrinsic.twins(half / 3, half % 3); };
  // The longest edges, by the lower of their half-edges.
  std::set<Index> wanted;
  for (const Index t : triangles)
  {
    Index longest = -1;
    for (Index half = 3 * t; half < 3 * t + 3; ++half)
    {
      if (twin(half) >= 0 &&
        (longest < 0 || intrinsic.edgeLengths(t, half % 3) > intrinsic.edgeLengths(t, longest % 3)))
      {
        longest = half;
      }
    }
    if (longest >= 0)
    {
      wanted.insert(std::min(longest, twin(longest)));
    }
  }
  struct Place
  {
    Index from;
    Index to;
    double fraction;
    double fromMiddle;
  };
  std::map<Index, Place> places;
  for (const TracedEdge& edge : EdgeTracer(intrinsic).trace())
  {
    for (const Crossing& crossing : edge.crossings)
    {
      const Index half = std::min(crossing.half, twin(crossing.half));
      const double fromMiddle = std::abs(crossing.alongHalf - 0.5);
      if (wanted.count(half) > 0)
      {
        const Place place{ edge.from, edge.to, crossing.along, fromMiddle };
        const auto known = places.emplace(half, place);
        if (!known.second && fromMiddle < known.first->second.fromMiddle)
        {
          known.first->second = place;
        }
      }
    }
  }
  std::map<std::pair<Index, Index>, std::set<double>> fractions;
  for (const Index half : wanted)
  {
    const auto known = places.find(half);
    const Index a = intrinsic.triangles(half / 3, half % 3);
    const Index b = intrinsic.triangles(half / 3, (half % 3 + 1) % 3);
    const Place place =
      known != places.end() ? known->second : Place{ std::min(a, b), std::max(a, b), 0.5, 0.0 };
    fractions[{ place.from, place.to }].insert(place.fraction);
  }
  std::vector<EdgeSubdivision> result;
  for (const auto& [edge, values] : fractions)
  {
    result.push_back({ edge.first, edge.second, { values.begin(), values.end() } });
  }
  return result;
}
}
