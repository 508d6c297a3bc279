// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/LinkingSurface.h"

#include "Core/Geometry/BoundarySearch.h"
#include "Core/Surfaces/FeatureFaces.h"
#include "Core/Surfaces/OpenEdgeWelding.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <utility>

namespace hexsweep
{
namespace
{
const char* const Target = "target surface";

template <typename Rows>
void renumber(const std::vector<Index>& ids, Rows& faces)
{
  for (Index i = 0; i < faces.size(); ++i)
  {
    Index& point = faces.data()[i];
    point = ids[static_cast<std::size_t>(point)];
  }
}
}

LinkingSurface joinLinkingSurface(LinkingSurface given, double matchTolerance, double featureAngle)
{
  LinkingSurface surface = std::move(given);
  TriangleMesh& mesh = surface.mesh;
  const std::vector<Index> joined = weldOpenEdges(mesh.points, mesh.triangles, matchTolerance);
  renumber(joined, mesh.triangles);
  renumber(joined, surface.quads);
  mesh.triangles = orientFaces(mesh.triangles, "linking surface");
  if (surface.faceIds.empty())
  {
    surface.faceIds = facesByFeatureAngle(mesh.points, mesh.triangles, featureAngle).faceOfTriangle;
  }
  return surface;
}

std::vector<Index> loopsOfQuads(const std::vector<Loop>& loops, Index layers)
{
  std::vector<Index> rows;
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    rows.insert(
      rows.end(), loops[l].size() * static_cast<std::size_t>(layers), static_cast<Index>(l));
  }
  return rows;
}

std::string describeMissedTarget(const PointsRef& nodes, const std::vector<Loop>& loops,
  Index layers, const TriangleMesh& target, double matchTolerance)
{
  const SurfaceTopology topology =
    checkSurface(orientFaces(target.triangles, Target), target.points.rows(), Target);
  checkCap(topology, Target);
  std::vector<Points> rings;
  Index first = 0;
  for (const Loop& loop : loops)
  {
    const Index n = static_cast<Index>(loop.size());
    rings.emplace_back(nodes.middleRows(first + layers * n, n));
    first += (layers + 1) * n;
  }
  return describeMismatch(boundaryMismatch(target.points, topology.loops, rings, matchTolerance),
    Target, "last ring of the linking sides");
}
}
