// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/HinderingEdges.h"

#include "Core/Common/Errors.h"
#include "Core/Interior/BlendInterior.h"
#include "Core/Interior/InteriorJudgement.h"

#include <algorithm>

namespace hexsweep
{
namespace
{
/// Of the bad hexahedra with CAD edges: no more are left without those that are given up.
constexpr double LeftWithout = 0.5;

/// A cage as blendInterior() fills it, before any untangling.
struct CageForecast
{
  Index notCertified = 0;
  std::vector<bool> hindered; ///< by side of the topology: whether bad hexahedra lie on it
};

CageForecast forecastCage(const SolidCage& cage, std::size_t sides, const ParallelFor& parallelFor,
  const Progress& progress)
{
  CageForecast forecast;
  forecast.hindered.assign(sides, false);
  const std::vector<Index> bad =
    uncertifiedHexes(cage, blendInterior(cage, progressPart(progress, 0.0, 0.7), parallelFor),
      parallelFor, progressPart(progress, 0.7, 1.0));
  forecast.notCertified = static_cast<Index>(bad.size());
  // The side of each node on a loop; -1 inside.
  std::vector<Index> sideOf(static_cast<std::size_t>(cage.source.rows()), -1);
  Index quad = 0;
  for (const Loop& loop : cage.loops)
  {
    const Index side = cage.linking.quadSide[static_cast<std::size_t>(quad)];
    quad += static_cast<Index>(loop.size()) * cage.linking.rings.numberOfLayers();
    for (const Index node : loop)
    {
      sideOf[static_cast<std::size_t>(node)] = side;
    }
  }
  for (const Index hex : bad)
  {
    for (const Index node : cage.quads.row(hex % cage.quads.rows()))
    {
      const Index side = sideOf[static_cast<std::size_t>(node)];
      if (side >= 0)
      {
        forecast.hindered[static_cast<std::size_t>(side)] = true;
      }
    }
  }
  return forecast;
}

std::vector<Index> facesOfSides(const SolidCageInput& input)
{
  std::vector<Index> triangles;
  for (std::size_t s = 0; s < input.topology.sides.size(); ++s)
  {
    if (input.freeSides[s])
    {
      const std::vector<Index>& own = input.topology.sides[s].triangles;
      triangles.insert(triangles.end(), own.begin(), own.end());
    }
  }
  return facesOfTriangles(input.solid, triangles);
}
}

SolidCage makeUnhinderedCage(
  SolidCageInput input, const ParallelFor& parallelFor, const Progress& progress)
{
  SolidCage kept = makeSolidCage(input, progressPart(progress, 0.0, 0.5));
  if (kept.isRuled || kept.linking.keptEdges == 0)
  {
    return kept;
  }
  const std::size_t sides = input.topology.sides.size();
  const CageForecast with =
    forecastCage(kept, sides, parallelFor, progressPart(progress, 0.5, 0.6));
  if (std::find(with.hindered.begin(), with.hindered.end(), true) == with.hindered.end())
  {
    return kept;
  }
  input.freeSides = with.hindered;
  try
  {
    SolidCage freed = makeSolidCage(input, progressPart(progress, 0.6, 0.9));
    const CageForecast without =
      forecastCage(freed, sides, parallelFor, progressPart(progress, 0.9, 1.0));
    if (freed.linking.keptEdges < kept.linking.keptEdges &&
      static_cast<double>(without.notCertified) <
        LeftWithout * static_cast<double>(with.notCertified))
    {
      freed.freedSides = facesOfSides(input);
      return freed;
    }
  }
  catch (const InvalidInput&)
  {
    // What cannot be meshed without its edges stays as it is.
  }
  catch (const SolverFailure&)
  {
  }
  return kept;
}
}
