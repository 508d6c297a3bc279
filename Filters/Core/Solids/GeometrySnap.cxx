// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/GeometrySnap.h"

#include "Core/Common/StandardIndex.h"
#include "Core/Common/StoppablePieces.h"
#include "Core/Geometry/TriangleSearch.h"
#include "Core/Solids/CageNodes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
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

/// Where nodes belong.
class Places
{
public:
  Places(const SolidSurface& solid, const ModelGeometry& geometry, const CageNodes& boundary)
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
  const CageNodes& Nodes;
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
void putBack(const CageNodes& boundary, Points& places)
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
  const CageNodes boundary = cageNodes(cage, solid, topology);
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
