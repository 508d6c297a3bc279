// SPDX-License-Identifier: BSD-3-Clause
#include "HexUntangling.h"

#include "Errors.h"
#include "FixedCorners.h"
#include "FoldoverFreeEnergy.h"
#include "HexPatches.h"

#include <algorithm>
#include <iterator>
#include <limits>
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

std::vector<bool> fixedNodes(const HexPatch& patch)
{
  std::vector<bool> fixed = patch.free;
  fixed.flip();
  return fixed;
}

/// Of the hexahedra that can be cured.
PatchQuality measure(
  const PointsRef& points, const HexesRef& hexes, const std::vector<Index>& conflicts)
{
  PatchQuality result;
  const std::vector<HexQuality> qualities = hexQualities(points, hexes);
  for (std::size_t h = 0; h < qualities.size(); ++h)
  {
    if (std::binary_search(conflicts.begin(), conflicts.end(), static_cast<Index>(h)))
    {
      continue;
    }
    const HexQuality& quality = qualities[h];
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
};

PatchResult untanglePatch(
  const HexPatch& patch, const Points& points, const HexBoxes& boxes, const Progress& progress)
{
  const std::vector<Index> conflicts =
    fixedCorners(points, patch.hexes, fixedNodes(patch)).conflicts;
  PatchResult best{ points, measure(points, patch.hexes, conflicts), 0 };
  const HexDescent descent(points, patch.hexes, boxes, patch.free);
  if (!descent.hasFreeNodes())
  {
    return best;
  }
  PatchResult current = best;
  std::optional<PatchQuality> reached;
  double epsilon = FirstEpsilon;
  int stagnant = 0;
  for (int round = 0; round < MaximumRounds && stagnant < StagnantRounds && best.quality.bad > 0;
       ++round)
  {
    const HexSamples samples =
      current.quality.invertedCorners > 0 ? HexSamples::Corners : HexSamples::Lattice;
    HexDescent::Result step =
      descent.descend(current.points, samples, epsilon, NewtonSteps, Settled,
        progressPart(progress, static_cast<double>(round) / MaximumRounds,
          static_cast<double>(round + 1) / MaximumRounds));
    current.points = std::move(step.points);
    current.quality = measure(current.points, patch.hexes, conflicts);
    ++best.rounds;
    if (current.quality.betterThan(best.quality))
    {
      best.points = current.points;
      best.quality = current.quality;
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

std::vector<Index> badHexes(const PointsRef& points, const HexesRef& hexes,
  const ParallelFor& parallelFor, const Progress& progress)
{
  std::vector<Index> bad;
  const std::vector<HexQuality> qualities =
    hexQualities(points, hexes, true, parallelFor, progress);
  for (std::size_t h = 0; h < qualities.size(); ++h)
  {
    if (isBad(qualities[h]))
    {
      bad.push_back(static_cast<Index>(h));
    }
  }
  return bad;
}

/// Both sorted.
std::vector<Index> without(const std::vector<Index>& all, const std::vector<Index>& some)
{
  std::vector<Index> rest;
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(rest));
  return rest;
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

UntangledHexes untangleHexes(const PointsRef& points, const HexesRef& hexes, const HexBoxes& boxes,
  const std::vector<bool>& fixed, const ParallelFor& parallelFor, const Progress& progress)
{
  UntangledHexes result;
  result.points = points;
  std::vector<Index> bad =
    badHexes(points, hexes, parallelFor, progressPart(progress, 0.0, Judging));
  result.before = result.after = static_cast<Index>(bad.size());
  const std::vector<Index> conflicts = fixedCorners(points, hexes, fixed).conflicts;
  bad = without(bad, conflicts);
  if (bad.empty())
  {
    return result;
  }
  const HexesAtNodes atNodes(hexes, points.rows());
  int rings = FirstRings;
  for (int attempt = 0; attempt < Attempts && !bad.empty(); ++attempt, rings *= 2)
  {
    const std::vector<HexPatch> patches = hexPatches(hexes, atNodes, bad, rings, fixed);
    const double begin = Judging + (1.0 - Judging) * attempt / Attempts;
    const double end = Judging + (1.0 - Judging) * (attempt + 1) / Attempts;
    const double width = (end - Judging - begin) / static_cast<double>(patches.size());
    for (std::size_t p = 0; p < patches.size(); ++p)
    {
      const HexPatch& patch = patches[p];
      HexBoxes wanted(static_cast<Index>(patch.cells.size()), 3);
      for (std::size_t c = 0; c < patch.cells.size(); ++c)
      {
        wanted.row(static_cast<Index>(c)) = boxes.row(patch.cells[c]);
      }
      const double done = begin + static_cast<double>(p) * width;
      const PatchResult mended = untanglePatch(patch, rowsOf(result.points, patch.nodes), wanted,
        progressPart(progress, done, done + width));
      result.rounds += mended.rounds;
      for (std::size_t i = 0; i < patch.nodes.size(); ++i)
      {
        result.points.row(patch.nodes[i]) = mended.points.row(static_cast<Index>(i));
      }
    }
    result.patches += static_cast<Index>(patches.size());
    bad = badHexes(result.points, hexes, parallelFor, progressPart(progress, end - Judging, end));
    result.after = static_cast<Index>(bad.size());
    bad = without(bad, conflicts);
  }
  return result;
}
}
