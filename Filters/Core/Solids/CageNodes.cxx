// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/CageNodes.h"

#include "Core/Common/StandardIndex.h"
#include "Core/Solids/BoundaryQuads.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <utility>

namespace hexsweep
{
namespace
{
using Place = Eigen::RowVector3d;

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
}

CageNodes cageNodes(const SolidCage& cage, const SolidSurface& solid, const SweepTopology& topology)
{
  const Index n = cage.source.rows();
  const Index layers = cage.linking.rings.numberOfLayers();
  const RingStack& rings = cage.linking.rings;
  const std::vector<BoundaryQuad> quads = boundaryQuads(cage, solid, topology);
  CageNodes result;
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

double shortestEdge(const CageNodes& nodes, Index node)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (const Index q : nodes.quadsOf[at(node)])
  {
    const std::array<Index, 4>& corners = nodes.quads[at(q)].nodes;
    for (std::size_t c = 0; c < 4; ++c)
    {
      if (corners[c] == node)
      {
        for (const std::size_t other : { (c + 1) % 4, (c + 3) % 4 })
        {
          shortest =
            std::min(shortest, (nodes.places.row(corners[other]) - nodes.places.row(node)).norm());
        }
      }
    }
  }
  return shortest;
}

void setPlaces(const CageNodes& nodes, const Points& places, SolidCage& cage)
{
  const Index n = cage.source.rows();
  RingStack& rings = cage.linking.rings;
  const Index layers = rings.numberOfLayers();
  const std::vector<Column> columnOf = columnPlaces(rings, n);
  for (std::size_t row = 0; row < nodes.points.size(); ++row)
  {
    const Index layer = nodes.points[row] / n;
    const Index i = nodes.points[row] % n;
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
}
