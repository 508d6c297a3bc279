// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SolidSides.h"

#include "Core/Surfaces/SurfacePart.h"

#include <utility>

namespace hexsweep
{
std::vector<SideTube> solidSides(const SolidSurface& solid, const SweepTopology& topology,
  const std::vector<std::vector<QuadMesh>>& patches, const std::vector<bool>& isFree)
{
  std::vector<SideTube> sides;
  for (std::size_t s = 0; s < topology.sides.size(); ++s)
  {
    const SweepSide& given = topology.sides[s];
    SurfacePart part = surfacePart(solid.points, solid.triangles, given.triangles);
    SideTube side;
    side.surface = std::move(part.mesh);
    const bool keepsEdges = isFree.empty() || !isFree[s];
    for (const Index row : keepsEdges ? given.triangles : std::vector<Index>{})
    {
      side.faceIds.push_back(solid.faceIds[static_cast<std::size_t>(row)]);
    }
    for (const Index point : given.sourceLoop)
    {
      side.sourceLoop.push_back(part.idOf(point));
    }
    if (!patches.empty())
    {
      side.patches = patches[s];
    }
    sides.push_back(std::move(side));
  }
  return sides;
}
}
