// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexUntangling.h"

#include "Core/Common/CellPatches.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/CoordinateRange.h"
#include "Core/Geometry/FoldoverFreeEnergy.h"
#include "Core/Hexahedra/FixedCorners.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hexsweep
{
namespace
{
constexpr int FirstRings = 3;
constexpr int Attempts = 2; // the second with twice the rings
/// Share of the progress that each look at all hexahedra takes.
constexpr double Judging = 0.1;
constexpr int MaximumRounds = 200;
/// Rounds in a row without progress that end the search.
constexpr int StagnantRounds = 8;
constexpr double LeastGain = 0.01;     // of the least scaled Jacobian, to count as progress
constexpr double LeastDecrease = 0.05; // relative, of the energy within a round
constexpr int NewtonSteps = 6;
constexpr double Settled = 1e-3;     // relative decrease of the energy that ends a round
constexpr double FirstEpsilon = 1.0; // of the box's volume
constexpr double LeastRate = 0.3;    // by which the regularisation falls in a round
constexpr double WorthMore = 0.5;    // part of the bad hexahedra left that earns a new budget
constexpr double WorkForAny = 5e5;   // that any mesh may cost, see untanglingBudget()
constexpr double WorkPerHex = 50.0;  // and each hexahedron besides

/// How good a patch is: fewer bad hexahedra first, then the higher least scaled Jacobian.
struct PatchQuality
{
  Index bad = 0;
  Index invertedCorners = 0;
  double minimum = 1.0;

  bool betterThan(const PatchQuality& other) const
  {
    return bad != other.bad ? bad < other.bad : minimum > other.minimum;
  }
  /// Better by more than what a search that is stuck creeps on.
  bool isProgress(const PatchQuality& reached) const
  {
    return bad < reached.bad || (bad == reached.bad && minimum > reached.minimum + LeastGain);
  }
};

bool isBad(const HexQuality& quality)
{
  return quality.validity != Validity::Certified;
}

/// A patch without the hexahedra that nothing can cure, which would hold up the others.
struct CurablePatch
{
  Hexes hexes;
  HexBoxes boxes;
};

CurablePatch curable(const CellPatch& patch, const HexBoxes& boxes, const FixedCorners& fixed)
{
  std::vector<Index> rows;
  for (std::size_t c = 0; c < patch.cells.size(); ++c)
  {
    if (!fixed.forbids(patch.cells[c]))
    {
      rows.push_back(static_cast<Index>(c));
    }
  }
  CurablePatch result;
  result.hexes.resize(static_cast<Index>(rows.size()), 8);
  result.boxes.resize(static_cast<Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    result.hexes.row(static_cast<Index>(i)) = patch.corners.row(rows[i]);
    result.boxes.row(static_cast<Index>(i)) =
      boxes.row(patch.cells[static_cast<std::size_t>(rows[i])]);
  }
  return result;
}

PatchQuality measure(const PointsRef& points, const HexesRef& hexes)
{
  PatchQuality result;
  for (const HexQuality& quality : hexVerdicts(points, hexes))
  {
    result.bad += isBad(quality);
    result.invertedCorners += quality.scaledJacobian <= 0.0;
    result.minimum = std::min(result.minimum, quality.scaledJacobian);
  }
  return result;
}

struct PatchResult
{
  Points points;
  PatchQuality quality;
  Index rounds = 0;
  double work = 0.0;
};

PatchResult untanglePatch(const CurablePatch& patch, const std::vector<bool>& free,
  const Points& points, double budget, Precision precision, const Progress& progress)
{
  PatchResult best{ points, measure(points, patch.hexes) };
  const HexDescent descent(patch.hexes, patch.boxes, free);
  if (!descent.hasFreeNodes())
  {
    return best;
  }
  PatchResult current = best;
  std::optional<PatchQuality> reached;
  double epsilon = FirstEpsilon;
  int stagnant = 0;
  double limit = budget;
  Index badAtLimit = best.quality.bad;
  for (int round = 0; round < MaximumRounds && stagnant < StagnantRounds && best.quality.bad > 0;
       ++round)
  {
    const HexSamples samples =
      current.quality.invertedCorners > 0 ? HexSamples::Corners : HexSamples::Lattice;
    const double workOfOne = untanglingWork(patch.hexes.rows(), samples);
    const double affordable = (limit - best.work) / workOfOne;
    if (affordable < 1.0)
    {
      break;
    }
    HexDescent::Result step = descent.descend(current.points, samples, epsilon,
      affordable < NewtonSteps ? static_cast<int>(affordable) : NewtonSteps, Settled,
      progressPart(progress, static_cast<double>(round) / MaximumRounds,
        static_cast<double>(round + 1) / MaximumRounds));
    current.points = std::move(step.points);
    Points rounded = stored(current.points, precision);
    current.quality = measure(rounded, patch.hexes);
    ++best.rounds;
    best.work += static_cast<double>(step.steps) * workOfOne;
    if (current.quality.betterThan(best.quality))
    {
      best.points = std::move(rounded);
      best.quality = current.quality;
      if (static_cast<double>(best.quality.bad) <= WorthMore * static_cast<double>(badAtLimit))
      {
        limit = best.work + budget;
        badAtLimit = best.quality.bad;
      }
    }
    const bool better = !reached || current.quality.isProgress(*reached);
    const bool progressed =
      better || step.before - step.after > LeastDecrease * std::abs(step.before);
    stagnant = progressed ? 0 : stagnant + 1;
    if (better)
    {
      reached = current.quality;
    }
    epsilon = nextEpsilon(epsilon, step.leastDeterminant, step.before, step.after, LeastRate);
  }
  return best;
}

struct BadHexes
{
  Index count = 0;
  std::vector<Index> curable;
};

BadHexes badHexes(const PointsRef& points, const HexesRef& hexes, const FixedCorners& fixed,
  const ParallelFor& parallelFor, const Progress& progress)
{
  BadHexes bad;
  const std::vector<HexQuality> qualities = hexVerdicts(points, hexes, parallelFor, progress);
  for (std::size_t h = 0; h < qualities.size(); ++h)
  {
    if (isBad(qualities[h]))
    {
      ++bad.count;
      if (!fixed.forbids(static_cast<Index>(h)))
      {
        bad.curable.push_back(static_cast<Index>(h));
      }
    }
  }
  return bad;
}

Points rowsOf(const Points& points, const std::vector<Index>& rows)
{
  Points picked(static_cast<Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    picked.row(static_cast<Index>(i)) = points.row(rows[i]);
  }
  return picked;
}
}

Points stored(const PointsRef& points, Precision precision)
{
  if (precision == Precision::Double)
  {
    return points;
  }
  checkFitsSinglePrecision(points);
  return points.cast<float>().cast<double>();
}

double untanglingWork(Index hexes, HexSamples samples)
{
  const double places = samples == HexSamples::Corners ? 1.0 : 27.0 / 8.0;
  return places * std::pow(static_cast<double>(hexes), 4.0 / 3.0);
}

double untanglingBudget(Index hexes)
{
  return WorkForAny + WorkPerHex * static_cast<double>(hexes);
}

UntangledHexes untangleHexes(const PointsRef& points, const HexesRef& hexes, const HexBoxes& boxes,
  const std::vector<bool>& fixed, const ParallelFor& parallelFor, const Progress& progress,
  Precision precision)
{
  UntangledHexes result;
  result.points = points;
  const FixedCorners corners = fixedCorners(points, hexes, fixed, parallelFor);
  BadHexes bad =
    badHexes(points, hexes, corners, parallelFor, progressPart(progress, 0.0, Judging));
  result.before = result.after = bad.count;
  if (bad.curable.empty())
  {
    return result;
  }
  const CellsAtNodes atNodes(hexes, points.rows());
  int rings = FirstRings;
  for (int attempt = 0; attempt < Attempts && !bad.curable.empty(); ++attempt, rings *= 2)
  {
    const std::vector<CellPatch> patches = cellPatches(hexes, atNodes, bad.curable, rings, fixed);
    const double begin = Judging + (1.0 - Judging) * attempt / Attempts;
    const double end = Judging + (1.0 - Judging) * (attempt + 1) / Attempts;
    const double width = (end - Judging - begin) / static_cast<double>(patches.size());
    double cellsLeft = 0.0;
    for (const CellPatch& patch : patches)
    {
      cellsLeft += static_cast<double>(patch.cells.size());
    }
    for (std::size_t p = 0; p < patches.size(); ++p)
    {
      const CellPatch& patch = patches[p];
      const double cells = static_cast<double>(patch.cells.size());
      const double share = cells / cellsLeft * (untanglingBudget(hexes.rows()) - result.work);
      cellsLeft -= cells;
      const double done = begin + static_cast<double>(p) * width;
      const PatchResult mended = untanglePatch(curable(patch, boxes, corners), patch.free,
        rowsOf(result.points, patch.nodes), share, precision,
        progressPart(progress, done, done + width));
      result.rounds += mended.rounds;
      result.work += mended.work;
      for (std::size_t i = 0; i < patch.nodes.size(); ++i)
      {
        result.points.row(patch.nodes[i]) = mended.points.row(static_cast<Index>(i));
      }
    }
    result.patches += static_cast<Index>(patches.size());
    bad = badHexes(
      result.points, hexes, corners, parallelFor, progressPart(progress, end - Judging, end));
    result.after = bad.count;
  }
  return result;
}
}
