// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SideDeviation.h"

#include "Core/Geometry/TriangleSearch.h"
#include "Core/Surfaces/SurfacePart.h"

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
constexpr Index RingsAtOnce = 8;

/// Rows of the boundary's rings that one loop has.
struct LoopRows
{
  Index begin;
  Index size;
};

double greatestDistance(const SweepBoundary& boundary, const LoopRows& loop,
  const TriangleSearch& side, const ParallelFor& parallelFor)
{
  Eigen::VectorXd ofLayers = Eigen::VectorXd::Zero(boundary.numberOfLayers());
  forPieces(parallelFor, ofLayers.size(), RingsAtOnce, [&](Index first, Index end) {
    Index near = -1;
    for (Index layer = first; layer < end; ++layer)
    {
      const Points& below = boundary.rings[static_cast<std::size_t>(layer)];
      const Points& above = boundary.rings[static_cast<std::size_t>(layer) + 1];
      for (Index j = 0; j < loop.size; ++j)
      {
        const Index a = loop.begin + j;
        const Index b = loop.begin + (j + 1) % loop.size;
        const TrianglePoint found =
          side.closest(0.25 * (below.row(a) + below.row(b) + above.row(a) + above.row(b)), near);
        near = found.triangle;
        ofLayers[layer] = std::max(ofLayers[layer], found.distance);
      }
    }
  });
  return ofLayers.maxCoeff();
}
}

double greatestSideDistance(const SolidCage& cage, const SolidSurface& solid,
  const SweepTopology& topology, const ParallelFor& parallelFor)
{
  double greatest = 0.0;
  LoopRows rows{ 0, 0 };
  Index quad = 0;
  for (const Loop& loop : cage.loops)
  {
    rows.size = static_cast<Index>(loop.size());
    const auto side =
      static_cast<std::size_t>(cage.linking.quadSide[static_cast<std::size_t>(quad)]);
    const TriangleMesh surface =
      surfacePart(solid.points, solid.triangles, topology.sides[side].triangles).mesh;
    greatest = std::max(greatest,
      greatestDistance(
        cage.boundary, rows, TriangleSearch(surface.points, surface.triangles), parallelFor));
    rows.begin += rows.size;
    quad += rows.size * cage.linking.rings.numberOfLayers();
  }
  return greatest;
}
}
