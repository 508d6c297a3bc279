// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/GeometrySnap.h"

#include "Core/Common/StandardIndex.h"
#include "Core/Common/StoppablePieces.h"
#include "Core/Geometry/TriangleSearch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
using Place = Eigen::RowVector3d;

/// Of the shortest edge beside a node: what is nearer to a CAD edge lies on it.
constexpr double OnEdge = 0.05;
/// The same of an end of a CAD edge.
constexpr double AtEnd = 0.02;
/// The same: a node that would have to go further belongs somewhere else.
constexpr double Farthest = 0.5;
/// Of the length of a column: one that bends by less is straight.
constexpr double StraightColumn = 1e-9;
constexpr Index NodesAPiece = 256;

/// A boundary quad as the snap needs it.
struct FacedQuad
{
  std::array<Index, 4> nodes; ///< rows of Boundary::places
  Index faceId;
  bool isCap;
  Place normal; ///< of its triangle
};

/// The boundary nodes of a cage, each once.
struct Boundary
{
  std::vector<Index> points; ///< of the swept mesh
  Points places;
  std::vector<FacedQuad> quads;
  std::vector<std::vector<Index>> quadsOf; ///< by node
};

/// Loop, and place on it; -1: a point on none.
using Column = std::pair<std::size_t, Index>;

/// By point of the source quads.
std::vector<Column> columnPlaces(const RingStack& rings, Index points)
{
  std::vector<Column> columns(at(points), { 0, -1 });
  for (std::size_t l = 0; l < rings.loops.size(); ++l)
  {
    for (std::size_t j = 0; j < rings.loops[l].size(); ++j)
    {
      columns[at(rings.loops[l][j])] = { l, static_cast<Index>(j) };
    }
  }
  return columns;
}

Boundary boundaryOf(const SolidCage& cage, const SolidSurface& solid, const SweepTopology& topology)
{
  const Index n = cage.source.rows();
  const Index layers = cage.linking.rings.numberOfLayers();
  const RingStack& rings = cage.linking.rings;
  const std::vector<BoundaryQuad> quads = boundaryQuads(cage, solid, topology);
  Boundary result;
  std::vector<Index> rowOf(at((layers + 1) * n), -1);
  const std::vector<Column> columnOf = columnPlaces(rings, n);
  std::vector<Place> places;
  const Index caps = 2 * cage.quads.rows();
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    FacedQuad quad{};
    for (std::size_t c = 0; c < 4; ++c)
    {
      const Index point = quads[q].points[c];
      Index& row = rowOf[at(point)];
      if (row < 0)
      {
        row = static_cast<Index>(places.size());
        result.points.push_back(point);
        const Index layer = point / n;
        const Index i = point % n;
        const auto& [l, j] = columnOf[at(i)];
        places.emplace_back(layer == 0 ? cage.source.row(i)
            : layer == layers          ? cage.target.row(i)
                                       : rings.points.row(rings.tables[l](layer, j)));
      }
      quad.nodes[c] = row;
    }
    const Index triangle = quads[q].triangle;
    const Place a = solid.points.row(solid.triangles(triangle, 0));
    const Place b = solid.points.row(solid.triangles(triangle, 1));
    const Place c = solid.points.row(solid.triangles(triangle, 2));
    quad.normal = (b - a).cross(c - a);
    quad.faceId = solid.faceIds[at(triangle)];
    quad.isCap = static_cast<Index>(q) < caps;
    result.quads.push_back(quad);
  }
  result.places.resize(static_cast<Index>(places.size()), 3);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    result.places.row(static_cast<Index>(i)) = places[i];
  }
  result.quadsOf.resize(places.size());
  for (std::size_t q = 0; q < result.quads.size(); ++q)
  {
    for (const Index node : result.quads[q].nodes)
    {
      result.quadsOf[at(node)].push_back(static_cast<Index>(q));
    }
  }
  return result;
}

double shortestEdge(const Boundary& boundary, Index node)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (const Index q : boundary.quadsOf[at(node)])
  {
    const std::array<Index, 4>& nodes = boundary.quads[at(q)].nodes;
    for (std::size_t c = 0; c < 4; ++c)
    {
      if (nodes[c] == node)
      {
        for (const std::size_t other : { (c + 1) % 4, (c + 3) % 4 })
        {
          shortest = std::min(
            shortest, (boundary.places.row(nodes[other]) - boundary.places.row(node)).norm());
        }
      }
    }
  }
  return shortest;
}

/// Where nodes belong.
class Places
{
public:
  Places(const SolidSurface& solid, const ModelGeometry& geometry, const Boundary& boundary)
    : Solid(solid)
    , Geometry(geometry)
    , Nodes(boundary)
    , Facets(solid.points, solid.triangles)
  {
  }

  /// @return nothing where a node has to stay.
  std::optional<Place> of(Index node) const
  {
    const Place here = this->Nodes.places.row(node);
    const double edge = shortestEdge(this->Nodes, node);
    std::optional<Place> found = this->find(node, here, edge);
    return found && (*found - here).norm() <= Farthest * edge ? found : std::nullopt;
  }

private:
  std::optional<Place> find(Index node, const Place& here, double edge) const
  {
    std::set<Index> caps;
    std::set<Index> sides;
    for (const Index q : this->Nodes.quadsOf[at(node)])
    {
      const FacedQuad& quad = this->Nodes.quads[at(q)];
      (quad.isCap ? caps : sides).insert(quad.faceId);
    }
    const bool isOnLoop = !caps.empty() && !sides.empty();
    std::set<Index> all = caps;
    all.insert(sides.begin(), sides.end());
    if (all.size() > 1)
    {
      std::optional<Place> onEdge =
        isOnLoop ? this->onEdges(caps, sides, here, edge) : this->onEdges(all, all, here, edge);
      if (onEdge && (isOnLoop || (*onEdge - here).norm() <= OnEdge * edge))
      {
        return onEdge;
      }
    }
    if (isOnLoop)
    {
      return std::nullopt;
    }
    if (all.size() == 1)
    {
      return this->Geometry.closestOnFace(*all.begin(), here);
    }
    const Index triangle = this->Facets.closest(here).triangle;
    return this->Geometry.closestOnFace(this->Solid.faceIds[at(triangle)], here);
  }

  /// The nearest point of the edges between two sets of faces.
  std::optional<Place> onEdges(const std::set<Index>& some, const std::set<Index>& others,
    const Place& here, double edge) const
  {
    std::optional<Place> best;
    Points ends(0, 3);
    for (const Index a : some)
    {
      for (const Index b : others)
      {
        for (const Index id : a == b ? std::vector<Index>() : this->Geometry.edgesBetween(a, b))
        {
          const std::optional<Place> place = this->Geometry.closestOnEdge(id, here);
          if (place && (!best || (*place - here).norm() < (*best - here).norm()))
          {
            best = place;
            ends = this->Geometry.endsOfEdge(id);
          }
        }
      }
    }
    for (Index e = 0; best && e < ends.rows(); ++e)
    {
      if ((ends.row(e) - here).norm() <= AtEnd * edge)
      {
        best = ends.row(e);
      }
    }
    return best;
  }

  const SolidSurface& Solid;
  const ModelGeometry& Geometry;
  const Boundary& Nodes;
  TriangleSearch Facets;
};

/// Whether a quad has a corner that is turned over against its triangle.
bool isTurned(const FacedQuad& quad, const Points& places)
{
  for (std::size_t c = 0; c < 4; ++c)
  {
    const Place corner = places.row(quad.nodes[c]);
    const Place next = places.row(quad.nodes[(c + 1) % 4]);
    const Place last = places.row(quad.nodes[(c + 3) % 4]);
    if (!((next - corner).cross(last - corner).dot(quad.normal) > 0.0))
    {
      return true;
    }
  }
  return false;
}

/// Puts nodes back until no quad is turned over that was not before.
void putBack(const Boundary& boundary, Points& places)
{
  std::vector<bool> wasTurned;
  for (const FacedQuad& quad : boundary.quads)
  {
    wasTurned.push_back(isTurned(quad, boundary.places));
  }
  bool changed = true;
  while (changed) // each round puts one node back at least
  {
    changed = false;
    for (std::size_t q = 0; q < boundary.quads.size(); ++q)
    {
      if (wasTurned[q] || !isTurned(boundary.quads[q], places))
      {
        continue;
      }
      for (const Index node : boundary.quads[q].nodes)
      {
        changed = changed || (places.row(node) - boundary.places.row(node)).squaredNorm() > 0.0;
        places.row(node) = boundary.places.row(node);
      }
    }
  }
}

void setPlaces(const Boundary& boundary, const Points& places, SolidCage& cage)
{
  const Index n = cage.source.rows();
  RingStack& rings = cage.linking.rings;
  const Index layers = rings.numberOfLayers();
  const std::vector<Column> columnOf = columnPlaces(rings, n);
  for (std::size_t row = 0; row < boundary.points.size(); ++row)
  {
    const Index layer = boundary.points[row] / n;
    const Index i = boundary.points[row] % n;
    const Place place = places.row(static_cast<Index>(row));
    if (layer == 0)
    {
      cage.source.row(i) = place;
    }
    if (layer == layers)
    {
      cage.target.row(i) = place;
    }
    const auto& [l, j] = columnOf[at(i)];
    if (j >= 0)
    {
      rings.points.row(rings.tables[l](layer, j)) = place;
    }
  }
  cage.boundary = gatherSweepBoundary(cage.source, cage.target, rings);
}

/// Whether all columns of the sides run straight.
bool hasStraightColumns(const SweepBoundary& boundary)
{
  const Points& first = boundary.rings.front();
  const Points way = boundary.rings.back() - first;
  for (std::size_t k = 1; k + 1 < boundary.rings.size(); ++k)
  {
    const Points off = boundary.rings[k] - (first + boundary.fractions[k] * way);
    if (off.rowwise().norm().maxCoeff() > StraightColumn * boundary.meanColumnLength)
    {
      return false;
    }
  }
  return true;
}
}

GeometrySnap snapToGeometry(const SolidSurface& solid, const SweepTopology& topology,
  const ModelGeometry& geometry, SolidCage& cage, const Progress& progress,
  const ParallelFor& parallelFor)
{
  const Boundary boundary = boundaryOf(cage, solid, topology);
  const Places belongs(solid, geometry, boundary);
  Points places = boundary.places;
  const Index count = places.rows();
  std::vector<unsigned char> isFound(at(count), 0);
  forStoppablePieces(
    parallelFor, progressPart(progress, 0.0, 0.9), count, NodesAPiece, [&](Index begin, Index end) {
      for (Index node = begin; node < end; ++node)
      {
        if (const std::optional<Place> place = belongs.of(node))
        {
          places.row(node) = *place;
          isFound[at(node)] = 1;
        }
      }
    });
  const Points wanted = places;
  putBack(boundary, places);
  GeometrySnap result;
  for (Index node = 0; node < count; ++node)
  {
    const bool isOn =
      isFound[at(node)] != 0 && (wanted.row(node) - places.row(node)).squaredNorm() == 0.0;
    ++(isOn ? result.moved : result.left);
    result.greatestMove =
      std::max(result.greatestMove, (places.row(node) - boundary.places.row(node)).norm());
  }
  setPlaces(boundary, places, cage);
  cage.isRuled = cage.isRuled && hasStraightColumns(cage.boundary);
  reportProgress(progress, 1.0);
  return result;
}
}
