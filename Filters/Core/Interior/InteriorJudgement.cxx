// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/InteriorJudgement.h"

#include "Core/Hexahedra/HexQuality.h"
#include "Core/Interior/SweptHexes.h"

#include <algorithm>

namespace hexsweep
{
std::vector<Index> uncertifiedHexes(const SweepCage& cage, const PointsRef& points,
  const ParallelFor& parallelFor, const Progress& progress)
{
  const Hexes hexes = sweptHexes(cage.quads, points, cage.boundary.numberOfLayers(), parallelFor);
  const std::vector<HexQuality> qualities = hexVerdicts(points, hexes, parallelFor, progress);
  std::vector<Index> bad;
  for (std::size_t h = 0; h < qualities.size(); ++h)
  {
    if (qualities[h].validity != Validity::Certified)
    {
      bad.push_back(static_cast<Index>(h));
    }
  }
  return bad;
}

double leastMerit(const SweepInterior& interior)
{
  const HexQualitySummary summary = summarize(interior.qualities);
  return summary.notCertified > 0 ? 0.0 : std::max(0.0, summary.minScaledJacobian);
}
}
