// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/LinkedCaps.h"

#include "Core/Linking/LoopMatching.h"

#include <utility>

namespace hexsweep
{
LinkedDisks mapLinkedCaps(const TriangleMesh& cap, const TriangleMesh& partner,
  const std::optional<QuadMesh>& linking, Weights weights, double matchTolerance,
  const Progress& progress, TriangulationImprovement improvement)
{
  const Cap first = makeCap(cap, "input surface");
  const Cap second = makeCap(partner, "partner surface");
  const CapNames names{ "input surface", "partner surface",
    linking ? "linking sides" : "input surface" };
  LinkedLoops linked;
  MatchedLoops matched;
  if (linking)
  {
    linked = linkLoops(first.points(), first.loops(), second.points(), second.loops(),
      linking->points, linking->quads, matchTolerance);
  }
  else
  {
    matched = matchLoopsByShape(first.points(), first.loops(), second.points(), second.loops(),
      "input surface", "partner surface");
    linked.pairs = outerFirst(std::move(matched.pairs));
  }
  LinkedDisks disks;
  static_cast<CommonDisks&>(disks) =
    mapPairs(first, second, linked, weights, matchTolerance, progress, names, improvement);
  std::vector<Points> rings;
  for (const LoopPair& pair : linked.pairs)
  {
    rings.push_back(linked.swapped ? pair.second : pair.first);
  }
  disks.mismatch = mismatchOf(first, rings, matchTolerance);
  disks.startFractions = std::move(matched.startFractions);
  disks.doubts = std::move(matched.doubts);
  return disks;
}

CommonDisks mapPairs(const Cap& cap, const Cap& partner, const LinkedLoops& linked, Weights weights,
  double matchTolerance, const Progress& progress, const CapNames& names,
  TriangulationImprovement improvement)
{
  if (!linked.swapped)
  {
    return commonDiskMap(
      cap, partner, linked.pairs, weights, matchTolerance, progress, names, improvement);
  }
  CommonDisks disks = commonDiskMap(partner, cap, linked.pairs, weights, matchTolerance, progress,
    { names.second, names.first, names.rings }, improvement);
  std::swap(disks.first, disks.second);
  return disks;
}

BoundaryMismatch mismatchOf(const Cap& cap, const std::vector<Points>& rings, double matchTolerance)
{
  if (rings.empty())
  {
    return {};
  }
  return boundaryMismatch(cap.points(), cap.loops(), rings, matchTolerance);
}
}
