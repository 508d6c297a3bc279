// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SolidCage.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Geometry/TriangleSearch.h"
#include "Core/Interior/RingCollapse.h"
#include "Core/Linking/LinkingRings.h"
#include "Core/Surfaces/SurfacePart.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace hexsweep
{
namespace
{
/// Source quads this far from the source cap (of the cap's diameter) are another cap's.
constexpr double FarFromCap = 0.05;

std::size_t at(Index i)
{
  return static_cast<std::size_t>(i);
}

SurfacePart partOf(const SolidSurface& solid, const std::vector<Index>& rows)
{
  return surfacePart(solid.points, solid.triangles, rows);
}

std::vector<SideTube> linkingSides(const SolidCageInput& input)
{
  std::vector<SideTube> sides;
  for (std::size_t s = 0; s < input.topology.sides.size(); ++s)
  {
    const SweepSide& given = input.topology.sides[s];
    SurfacePart part = partOf(input.solid, given.triangles);
    SideTube side;
    side.surface = std::move(part.mesh);
    for (const Index row : given.triangles)
    {
      side.faceIds.push_back(input.solid.faceIds[at(row)]);
    }
    for (const Index point : given.sourceLoop)
    {
      side.sourceLoop.push_back(part.idOf(point));
    }
    if (!input.patches.empty())
    {
      side.patches = input.patches[s];
    }
    sides.push_back(std::move(side));
  }
  return sides;
}

/// The rings of linking sides that were meshed here: nothing needs to be searched for.
LinkingRings ringsOf(const LinkingMesh& linking, const std::vector<Loop>& loops)
{
  LinkingRings rings;
  Index first = 0;
  for (const Loop& loop : loops)
  {
    const Index n = static_cast<Index>(loop.size());
    RingTable table(linking.layers + 1, n);
    for (Index k = 0; k <= linking.layers; ++k)
    {
      for (Index j = 0; j < n; ++j)
      {
        table(k, j) = first + k * n + j;
      }
    }
    first += (linking.layers + 1) * n;
    rings.loops.push_back(std::move(table));
  }
  return rings;
}

/// The target quads' boundary nodes are those of the last rings, bit for bit.
void snapTarget(Points& target, const std::vector<Loop>& loops, const LinkingRings& rings,
  const PointsRef& linkingPoints)
{
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    for (std::size_t j = 0; j < loops[l].size(); ++j)
    {
      target.row(loops[l][j]) =
        linkingPoints.row(rings.loops[l](rings.numberOfLayers(), static_cast<Index>(j)));
    }
  }
}

double distanceFromCap(const QuadMesh& quads, const TriangleMesh& cap)
{
  const TriangleSearch search(cap.points, cap.triangles);
  std::vector<bool> seen(at(quads.points.rows()), false);
  double greatest = 0.0;
  Index place = -1;
  Index near = -1;
  for (Index i = 0; i < quads.quads.size(); ++i)
  {
    const Index point = quads.quads.data()[i];
    if (seen[at(point)])
    {
      continue;
    }
    seen[at(point)] = true;
    const TrianglePoint found = search.closest(quads.points.row(point), near);
    near = found.triangle;
    if (found.distance > greatest)
    {
      greatest = found.distance;
      place = point;
    }
  }
  const double diameter =
    (cap.points.colwise().maxCoeff() - cap.points.colwise().minCoeff()).norm();
  if (greatest > FarFromCap * diameter)
  {
    throw InvalidInput("the source quads do not lie on the source cap: point " +
      std::to_string(place) + " at " + describe(quads.points.row(place)) + " is " +
      describe(greatest) + " away from it, and the cap measures " + describe(diameter) +
      ". Name the faces under these quads as source faces, or give quads that mesh the source "
      "cap.");
  }
  return greatest;
}

class Stages
{
public:
  explicit Stages(std::vector<std::pair<std::string, double>>& seconds)
    : Seconds(seconds)
  {
  }

  void finish(const char* name)
  {
    const auto now = std::chrono::steady_clock::now();
    this->Seconds.emplace_back(name, std::chrono::duration<double>(now - this->Start).count());
    this->Start = now;
  }

private:
  std::vector<std::pair<std::string, double>>& Seconds;
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};
}

SolidCage makeSolidCage(const SolidCageInput& input, const Progress& progress)
{
  const SurfaceTopology topology =
    checkSurface(input.source.quads, input.source.points.rows(), "source quads");
  checkCap(topology, "source quads");
  if (topology.loops.size() != input.topology.sides.size())
  {
    throw InvalidInput("the source quads have " + std::to_string(topology.loops.size() - 1) +
      " holes and the source cap of the solid has " +
      std::to_string(input.topology.sides.size() - 1) +
      ". Mesh the whole source cap with quads, and leave out each of its holes.");
  }
  SolidCage cage;
  Stages stages(cage.seconds);
  cage.loops = topology.loops;
  const SurfacePart source = partOf(input.solid, input.topology.sourceTriangles);
  const SurfacePart target = partOf(input.solid, input.topology.targetTriangles);
  cage.greatestDistance = distanceFromCap(input.source, source.mesh);
  stages.finish("Check");

  cage.linking = meshLinkingSides(input.source.points, cage.loops, linkingSides(input),
    input.layers, input.matchTolerance, progressPart(progress, 0.0, 0.4));
  stages.finish("Linking sides");

  SweepProjectionInput projection;
  projection.source = input.source;
  projection.target = target.mesh;
  projection.linking = cage.linking.mesh;
  projection.sourceSurface = source.mesh;
  projection.matchTolerance = input.matchTolerance;
  projection.singlePrecision = input.singlePrecision;
  projection.ensureValid = input.ensureValid;
  projection.improveQuality = input.improveQuality;
  cage.projection = projectSweep(projection, progressPart(progress, 0.4, 1.0));
  stages.finish("Target quads");

  const LinkingRings rings = ringsOf(cage.linking, cage.loops);
  cage.source = input.source.points;
  cage.target = cage.projection.quads.points;
  cage.quads = input.source.quads;
  snapTarget(cage.target, cage.loops, rings, cage.linking.mesh.points);
  cage.boundary =
    gatherSweepBoundary(cage.source, cage.target, cage.loops, rings, cage.linking.mesh.points);
  checkRings(cage.boundary, cage.loops);
  stages.finish("Cage");
  return cage;
}

std::vector<BoundaryQuad> boundaryQuads(
  const SolidCage& cage, const SolidSurface& solid, const SweepTopology& topology)
{
  const Index n = cage.source.rows();
  const Index m = cage.quads.rows();
  const Index layers = cage.linking.layers;
  std::vector<BoundaryQuad> result;
  result.reserve(at(2 * m + cage.linking.mesh.quads.rows()));

  const auto turnAlong = [&](BoundaryQuad& quad, const Eigen::RowVector3d(&p)[4]) {
    const Index* corners = &solid.triangles(quad.triangle, 0);
    const Eigen::RowVector3d a = solid.points.row(corners[0]);
    const Eigen::RowVector3d normal =
      (solid.points.row(corners[1]) - a).cross(solid.points.row(corners[2]) - a);
    if ((p[2] - p[0]).cross(p[3] - p[1]).dot(normal) < 0.0)
    {
      std::swap(quad.points[1], quad.points[3]);
    }
  };
  const auto addCap = [&](const Points& points, const std::vector<Index>& triangles, Index layer) {
    const SurfacePart part = partOf(solid, triangles);
    const TriangleSearch search(part.mesh.points, part.mesh.triangles);
    Index near = -1;
    for (Index q = 0; q < m; ++q)
    {
      Eigen::RowVector3d p[4];
      BoundaryQuad quad{};
      for (Index c = 0; c < 4; ++c)
      {
        p[c] = points.row(cage.quads(q, c));
        quad.points[at(c)] = layer * n + cage.quads(q, c);
      }
      near = search.closest(0.25 * (p[0] + p[1] + p[2] + p[3]), near).triangle;
      quad.triangle = triangles[at(near)];
      quad.hex = layer == 0 ? q : (layers - 1) * m + q;
      quad.face = layer == 0 ? 4 : 5;
      turnAlong(quad, p);
      result.push_back(quad);
    }
  };
  addCap(cage.source, topology.sourceTriangles, 0);
  addCap(cage.target, topology.targetTriangles, layers);

  // By point of a loop: the quad at the edge to the next one, and the number of that edge. Loops
  // run the way of the quads.
  const std::vector<Index> next = nextOnLoops(cage.loops, n);
  std::vector<std::pair<Index, int>> sideOf(at(n));
  for (Index q = 0; q < m; ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      if (next[at(cage.quads(q, c))] == cage.quads(q, (c + 1) % 4))
      {
        sideOf[at(cage.quads(q, c))] = { q, static_cast<int>(c) };
      }
    }
  }
  for (Index q = 0; q < cage.linking.mesh.quads.rows(); ++q)
  {
    const auto corners = cage.linking.mesh.quads.row(q);
    const Index layer = cage.linking.quadLayer[at(q)];
    BoundaryQuad quad{};
    Eigen::RowVector3d p[4];
    for (Index c = 0; c < 4; ++c)
    {
      const Index node = corners[c];
      quad.points[at(c)] = cage.linking.nodeRing[at(node)] * n + cage.linking.sourcePoint[at(node)];
      p[c] = cage.linking.mesh.points.row(node);
    }
    const auto [hex, side] = sideOf[at(cage.linking.sourcePoint[at(corners[0])])];
    quad.hex = layer * m + hex;
    quad.face = side;
    quad.triangle = topology.sides[at(cage.linking.quadSide[at(q)])]
                      .triangles[at(cage.linking.quadTriangle[at(q)])];
    turnAlong(quad, p);
    result.push_back(quad);
  }
  return result;
}
}
