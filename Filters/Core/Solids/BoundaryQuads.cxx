// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/BoundaryQuads.h"

#include "Core/Common/StandardIndex.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Geometry/TriangleSearch.h"
#include "Core/Surfaces/SurfacePart.h"

#include <Eigen/Geometry>

#include <utility>

namespace hexsweep
{
namespace
{
using Corners = std::array<Eigen::RowVector3d, 4>;

/// Turns a quad over where it runs against its triangle.
void turnAlong(BoundaryQuad& quad, const Corners& p, const SolidSurface& solid)
{
  const Index* corners = &solid.triangles(quad.triangle, 0);
  const Eigen::RowVector3d a = solid.points.row(corners[0]);
  const Eigen::RowVector3d normal =
    (solid.points.row(corners[1]) - a).cross(solid.points.row(corners[2]) - a);
  if ((p[2] - p[0]).cross(p[3] - p[1]).dot(normal) < 0.0)
  {
    std::swap(quad.points[1], quad.points[3]);
  }
}

/// The quads of one cap. @param triangles rows of the solid's triangles that form the cap.
void addCap(const SolidCage& cage, const SolidSurface& solid, const std::vector<Index>& triangles,
  bool isSource, std::vector<BoundaryQuad>& result)
{
  const Index m = cage.quads.rows();
  const Index layers = cage.linking.rings.numberOfLayers();
  const Points& points = isSource ? cage.source : cage.target;
  const SurfacePart part = surfacePart(solid.points, solid.triangles, triangles);
  const TriangleSearch search(part.mesh.points, part.mesh.triangles);
  Index near = -1;
  for (Index q = 0; q < m; ++q)
  {
    Corners p;
    BoundaryQuad quad{};
    for (Index c = 0; c < 4; ++c)
    {
      p[at(c)] = points.row(cage.quads(q, c));
      quad.points[at(c)] = (isSource ? 0 : layers * points.rows()) + cage.quads(q, c);
    }
    near = search.closest(0.25 * (p[0] + p[1] + p[2] + p[3]), near).triangle;
    quad.triangle = triangles[at(near)];
    quad.hex = isSource ? q : (layers - 1) * m + q;
    quad.face = isSource ? 4 : 5;
    turnAlong(quad, p, solid);
    result.push_back(quad);
  }
}

/// A quad of the caps at an edge of a loop.
struct LoopEdge
{
  Index quad = -1;
  int edge = -1; ///< from this corner of the quad to the next one
};

/// By point of a loop: the edge to the next one. Loops run the way of the quads.
std::vector<LoopEdge> loopEdges(const SolidCage& cage)
{
  const std::vector<Index> next = nextOnLoops(cage.loops, cage.source.rows());
  std::vector<LoopEdge> edges(next.size());
  for (Index q = 0; q < cage.quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      if (next[at(cage.quads(q, c))] == cage.quads(q, (c + 1) % 4))
      {
        edges[at(cage.quads(q, c))] = { q, static_cast<int>(c) };
      }
    }
  }
  return edges;
}

void addSides(const SolidCage& cage, const SolidSurface& solid, const SweepTopology& topology,
  std::vector<BoundaryQuad>& result)
{
  const LinkingMesh& linking = cage.linking;
  const std::vector<LoopEdge> edges = loopEdges(cage);
  for (Index q = 0; q < linking.quads.rows(); ++q)
  {
    const auto corners = linking.quads.row(q);
    BoundaryQuad quad{};
    Corners p;
    for (Index c = 0; c < 4; ++c)
    {
      const std::size_t node = at(corners[c]);
      quad.points[at(c)] = linking.nodeRing[node] * cage.source.rows() + linking.sourcePoint[node];
      p[at(c)] = linking.rings.points.row(corners[c]);
    }
    const LoopEdge& edge = edges[at(linking.sourcePoint[at(corners[0])])];
    quad.hex = linking.quadLayer[at(q)] * cage.quads.rows() + edge.quad;
    quad.face = edge.edge;
    quad.triangle =
      topology.sides[at(linking.quadSide[at(q)])].triangles[at(linking.quadTriangle[at(q)])];
    turnAlong(quad, p, solid);
    result.push_back(quad);
  }
}
}

std::vector<BoundaryQuad> boundaryQuads(
  const SolidCage& cage, const SolidSurface& solid, const SweepTopology& topology)
{
  std::vector<BoundaryQuad> result;
  result.reserve(at(2 * cage.quads.rows() + cage.linking.quads.rows()));
  addCap(cage, solid, topology.sourceTriangles, true, result);
  addCap(cage, solid, topology.targetTriangles, false, result);
  addSides(cage, solid, topology, result);
  return result;
}
}
