// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SideDeviation.h"

#include "Core/Geometry/TriangleSearch.h"
#include "Core/Surfaces/SurfacePart.h"

#include <algorithm>

namespace hexsweep
{
namespace
{
constexpr Index RingsAtOnce = 8;

double greatestDistance(const SweepBoundary& boundary, std::size_t loop, const TriangleSearch& side,
  const ParallelFor& parallelFor)
{
  const Index begin = boundary.begins[loop];
  const Index size = boundary.begins[loop + 1] - begin;
  Eigen::VectorXd ofLayers = Eigen::VectorXd::Zero(boundary.numberOfLayers());
  forPieces(parallelFor, ofLayers.size(), RingsAtOnce, [&](Index first, Index end) {
    Index near = -1;
    for (Index layer = first; layer < end; ++layer)
    {
      const Points& below = boundary.rings[static_cast<std::size_t>(layer)];
      const Points& above = boundary.rings[static_cast<std::size_t>(layer) + 1];
      for (Index j = 0; j < size; ++j)
      {
        const Index a = begin + j;
        const Index b = begin + (j + 1) % size;
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
  const std::vector<Index> sides = sidesOfLoops(cage);
  double greatest = 0.0;
  for (std::size_t l = 0; l < sides.size(); ++l)
  {
    const SweepSide& side = topology.sides[static_cast<std::size_t>(sides[l])];
    const TriangleMesh surface = surfacePart(solid.points, solid.triangles, side.triangles).mesh;
    const TriangleSearch search(surface.points, surface.triangles);
    greatest = std::max(greatest, greatestDistance(cage.boundary, l, search, parallelFor));
  }
  return greatest;
}
}
