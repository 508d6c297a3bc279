// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/HinderingEdges.h"

#include "Core/Common/Errors.h"
#include "Core/Interior/BlendInterior.h"
#include "Core/Interior/InteriorJudgement.h"
#include "Core/Interior/InteriorStarts.h"
#include "Core/Interior/SectionInterior.h"
#include "Core/Solids/SideSliding.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace hexsweep
{
namespace
{
/// Of the bad hexahedra with CAD edges: no more are left without those that are given up. Where
/// there are twice as many, nothing further is tried.
constexpr double LeftWithout = 0.5;

/// Where the least scaled Jacobian is lower when all is done, CAD edges are given up for more.
constexpr double PoorMesh = 0.25;
constexpr double WorthAnEdge = 1.5;

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

/// The least scaled Jacobian when the cage is filled, untangled and polished; 0 where hexahedra are
/// not certified.
double leastInTheEnd(
  const SolidCage& cage, const ParallelFor& parallelFor, const Progress& progress)
{
  InteriorOptions options;
  options.keepQualities = true;
  options.parallelFor = parallelFor;
  // The first start says enough: others are for meshes that are to be kept.
  std::vector<InteriorStart> starts =
    interiorStarts(InteriorKind::Automatic, cage.isRuled, windingOf(cage.boundary));
  starts.resize(1);
  const SweepInterior interior = sweepInterior(cage, starts, options, progress);
  return leastMerit(interior);
}

/// Whether a cage without CAD edges comes out so much better that these are worth less.
bool isWorthItsEdges(const SolidCage& freed, const SolidCage& kept, const ParallelFor& parallelFor,
  const Progress& progress)
{
  const double with = leastInTheEnd(kept, parallelFor, progressPart(progress, 0.0, 0.5));
  return with < PoorMesh &&
    leastInTheEnd(freed, parallelFor, progressPart(progress, 0.5, 1.0)) > WorthAnEdge * with;
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

SolidCage cageWithItsEdgesOrWithout(
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
    SolidCage freed = makeSolidCage(input, progressPart(progress, 0.6, 0.7));
    if (freed.linking.keptEdges >= kept.linking.keptEdges)
    {
      return kept;
    }
    const CageForecast without =
      forecastCage(freed, sides, parallelFor, progressPart(progress, 0.7, 0.75));
    const double bad = static_cast<double>(with.notCertified);
    const double left = static_cast<double>(without.notCertified);
    const bool isWorse = LeftWithout * left > bad;
    if (left < LeftWithout * bad ||
      (!isWorse && isWorthItsEdges(freed, kept, parallelFor, progressPart(progress, 0.75, 1.0))))
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

SolidCage makeUnhinderedCage(
  const SolidCageInput& input, const ParallelFor& parallelFor, const Progress& progress)
{
  SolidCage cage = cageWithItsEdgesOrWithout(input, parallelFor, progressPart(progress, 0.0, 0.6));
  std::optional<SolidCage> slid =
    slideCageSides(input, cage, parallelFor, progressPart(progress, 0.6, 0.7));
  if (slid &&
    leastInTheEnd(*slid, parallelFor, progressPart(progress, 0.7, 0.85)) >
      leastInTheEnd(cage, parallelFor, progressPart(progress, 0.85, 1.0)))
  {
    return *std::move(slid);
  }
  return cage;
}
}
