// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/HinderingEdges.h"

#include "Core/Common/Errors.h"
#include "Core/Interior/BlendInterior.h"
#include "Core/Interior/InteriorJudgement.h"
#include "Core/Interior/InteriorStarts.h"
#include "Core/Interior/SectionInterior.h"
#include "Core/Solids/SideSliding.h"

#include <algorithm>
#include <iterator>
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
/// What is tried of the depth of steps where meshes are poor: the next while the one before gains
/// so much, and not more than twice as much as there was.
constexpr double StepDepths[] = { 0.8, 0.4 };
constexpr double WorthOtherColumns = 1.1;
constexpr double WorthNoMore = 2.0;
/// Part of the hexahedra: to untangle more takes longer than all the rest.
constexpr double MostTangled = 0.005;
/// Bad hexahedra: to untangle more, so that two meshes can be compared, takes seconds.
constexpr Index MostCompared = 300;

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
  const std::vector<Index> ofLoops = sidesOfLoops(cage);
  for (std::size_t l = 0; l < cage.loops.size(); ++l)
  {
    for (const Index node : cage.loops[l])
    {
      sideOf[static_cast<std::size_t>(node)] = ofLoops[l];
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
  options.persists = false;
  options.parallelFor = parallelFor;
  try
  {
    // All starts: to untangle the first alone may take far longer than to make another.
    return leastMerit(sweepInterior(cage,
      interiorStarts(InteriorKind::Automatic, cage.isRuled, windingOf(cage.boundary)), options,
      progress));
  }
  catch (const SolverFailure&)
  {
    return 0.0;
  }
}

/// A cage, and what it is filled with, each known once it was asked for.
struct JudgedCage
{
  SolidCage cage;
  std::optional<CageForecast> knownForecast;
  std::optional<double> knownLeast;

  const CageForecast& forecast(
    std::size_t sides, const ParallelFor& parallelFor, const Progress& progress)
  {
    if (!this->knownForecast)
    {
      this->knownForecast = forecastCage(this->cage, sides, parallelFor, progress);
    }
    return *this->knownForecast;
  }

  double least(const ParallelFor& parallelFor, const Progress& progress)
  {
    if (!this->knownLeast)
    {
      this->knownLeast = leastInTheEnd(this->cage, parallelFor, progress);
    }
    return *this->knownLeast;
  }
};

/// Whether a cage without CAD edges comes out so much better that these are worth less. Where it
/// would take long to know, fewer bad hexahedra are enough.
bool isWorthMoreThanEdges(JudgedCage& freed, JudgedCage& kept, std::size_t sides,
  const ParallelFor& parallelFor, const Progress& progress)
{
  const Index without = freed.forecast(sides, parallelFor, {}).notCertified;
  const Index bad = kept.forecast(sides, parallelFor, {}).notCertified;
  if (std::max(without, bad) > MostCompared)
  {
    return without < bad;
  }
  const double with = kept.least(parallelFor, progressPart(progress, 0.0, 0.5));
  return with < PoorMesh &&
    freed.least(parallelFor, progressPart(progress, 0.5, 1.0)) > WorthAnEdge * with;
}

std::vector<Index> facesOfSides(const SolidCageInput& input, const std::vector<bool>& isMeant)
{
  std::vector<Index> triangles;
  for (std::size_t s = 0; s < input.topology.sides.size(); ++s)
  {
    if (isMeant[s])
    {
      const std::vector<Index>& own = input.topology.sides[s].triangles;
      triangles.insert(triangles.end(), own.begin(), own.end());
    }
  }
  return facesOfTriangles(input.solid, triangles);
}

/// @param input whose sides are free afterwards where CAD edges were given up.
JudgedCage cageWithItsEdgesOrWithout(
  SolidCageInput& input, const ParallelFor& parallelFor, const Progress& progress)
{
  JudgedCage kept{ makeSolidCage(input, progressPart(progress, 0.0, 0.5)), {}, {} };
  if (kept.cage.isRuled || kept.cage.leftBorders || kept.cage.linking.keptEdges == 0)
  {
    return kept;
  }
  const std::size_t sides = input.topology.sides.size();
  const CageForecast& with = kept.forecast(sides, parallelFor, progressPart(progress, 0.5, 0.6));
  if (std::find(with.hindered.begin(), with.hindered.end(), true) == with.hindered.end())
  {
    return kept;
  }
  input.freeSides = with.hindered;
  try
  {
    JudgedCage freed{ makeSolidCage(input, progressPart(progress, 0.6, 0.7)), {}, {} };
    if (freed.cage.linking.keptEdges >= kept.cage.linking.keptEdges)
    {
      input.freeSides.clear();
      return kept;
    }
    const CageForecast& without =
      freed.forecast(sides, parallelFor, progressPart(progress, 0.7, 0.75));
    const double bad = static_cast<double>(with.notCertified);
    const double left = static_cast<double>(without.notCertified);
    const bool isWorse = LeftWithout * left > bad;
    if (left < LeftWithout * bad ||
      (!isWorse &&
        isWorthMoreThanEdges(freed, kept, sides, parallelFor, progressPart(progress, 0.75, 1.0))))
    {
      freed.cage.freedSides = facesOfSides(input, input.freeSides);
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
  input.freeSides.clear();
  return kept;
}

/// Whether blendInterior() leaves so little to untangle that the cage is worth filling to the end.
bool isWorthFilling(
  JudgedCage& judged, std::size_t sides, const ParallelFor& parallelFor, const Progress& progress)
{
  const Index hexes = judged.cage.quads.rows() * judged.cage.boundary.numberOfLayers();
  const Index bad = judged.forecast(sides, parallelFor, progress).notCertified;
  return static_cast<double>(bad) <= MostTangled * static_cast<double>(hexes);
}

/// Lays columns in the metric of flatter steps, as long as hexahedra are poor and gain by that.
void flattenSteps(
  SolidCageInput input, const ParallelFor& parallelFor, const Progress& progress, JudgedCage& best)
{
  const std::size_t sides = input.topology.sides.size();
  constexpr double Share = 1.0 / static_cast<double>(1 + std::size(StepDepths));
  if (!isWorthFilling(best, sides, parallelFor, progressPart(progress, 0.0, 0.1 * Share)))
  {
    return;
  }
  const double before = best.least(parallelFor, progressPart(progress, 0.1 * Share, Share));
  const Index edges = best.cage.linking.keptEdges;
  double least = before;
  double done = Share;
  bool goesOn = true;
  for (std::size_t i = 0; goesOn && least < PoorMesh && i < std::size(StepDepths); ++i)
  {
    goesOn = false;
    input.stepDepth = StepDepths[i];
    try
    {
      JudgedCage other{ makeSolidCage(input, progressPart(progress, done, done + 0.5 * Share)), {},
        {} };
      if (other.cage.leftBorders ||
        !isWorthFilling(other, sides, parallelFor,
          progressPart(progress, done + 0.5 * Share, done + 0.6 * Share)))
      {
        return;
      }
      const double found =
        other.least(parallelFor, progressPart(progress, done + 0.6 * Share, done + Share));
      goesOn = found > before && found < WorthNoMore * before;
      const bool keepsEdges = other.cage.linking.keptEdges >= edges;
      if (found > (keepsEdges ? WorthOtherColumns : WorthAnEdge) * before && found > least)
      {
        other.cage.freedSides =
          keepsEdges ? best.cage.freedSides : facesOfSides(input, other.cage.linking.hasSteps);
        best = std::move(other);
        least = found;
      }
    }
    catch (const InvalidInput&)
    {
      // What cannot be meshed with other columns keeps those that it has.
    }
    catch (const SolverFailure&)
    {
    }
    done += Share;
  }
}
}

SolidCage makeUnhinderedCage(
  const SolidCageInput& given, const ParallelFor& parallelFor, const Progress& progress)
{
  SolidCageInput input = given;
  JudgedCage best = cageWithItsEdgesOrWithout(input, parallelFor, progressPart(progress, 0.0, 0.4));
  if (best.cage.leftBorders)
  {
    return std::move(best.cage);
  }
  const std::vector<bool>& steps = best.cage.linking.hasSteps;
  if (std::find(steps.begin(), steps.end(), true) != steps.end() && hasSlantedSides(best.cage))
  {
    flattenSteps(input, parallelFor, progressPart(progress, 0.4, 0.7), best);
  }
  std::optional<SolidCage> slid =
    slideCageSides(input, best.cage, parallelFor, progressPart(progress, 0.7, 0.8));
  if (slid)
  {
    const double with = leastInTheEnd(*slid, parallelFor, progressPart(progress, 0.8, 0.9));
    if (with > best.least(parallelFor, progressPart(progress, 0.9, 1.0)))
    {
      return *std::move(slid);
    }
  }
  return std::move(best.cage);
}
}
