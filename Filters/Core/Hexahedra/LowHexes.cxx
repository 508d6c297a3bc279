// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/LowHexes.h"

#include "Core/Common/CellPatches.h"
#include "Core/Common/Errors.h"
#include "Core/Hexahedra/HexUntangling.h"

#include <algorithm>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr int Rings = 3;
constexpr int MostRounds = 20;
/// Of what is wanted, that the least must rise by in a round.
constexpr double LeastPatchGain = 0.01;
constexpr double PartOfBudget = 0.15; // of untanglingBudget()
constexpr double PartOfRound = 0.5;   // of what is left of it
constexpr int MostHalvings = 8;
constexpr double LeastSide = 1e-3; // of a box, of its longest
constexpr int PatchSteps = 10;
constexpr double SettledPatch = 1e-3; // relative decrease of the energy that ends a descent
/**
 * Of the boxes' volumes. What is nearly flat is no barrier, or it alone would be seen: with less
 * the others pay for it.
 */
constexpr double Epsilon = 1e-2;

/// At the most, of a patch of so many hexahedra.
double workOf(Index hexes)
{
  return PatchSteps * untanglingWork(hexes, HexSamples::Lattice);
}

struct LowestOfPatch
{
  Index bad = 0;
  double minimum = 1.0;

  bool betterThan(const LowestOfPatch& other) const
  {
    return bad <= other.bad && minimum > other.minimum;
  }
};

LowestOfPatch lowestOf(const PointsRef& points, const HexesRef& hexes)
{
  LowestOfPatch result;
  for (const HexQuality& quality : hexVerdicts(points, hexes))
  {
    result.bad += quality.validity != Validity::Certified;
    result.minimum = std::min(result.minimum, quality.scaledJacobian);
  }
  return result;
}

/// The mean lengths of the four edges along each axis: only the shape is to change.
HexBoxes ownBoxes(const Points& points, const Hexes& hexes)
{
  constexpr int Ends[3][4][2] = { { { 0, 1 }, { 3, 2 }, { 4, 5 }, { 7, 6 } },
    { { 0, 3 }, { 1, 2 }, { 4, 7 }, { 5, 6 } }, { { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } } };
  HexBoxes boxes(hexes.rows(), 3);
  for (Index h = 0; h < hexes.rows(); ++h)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      double sum = 0.0;
      for (const int(&ends)[2] : Ends[axis])
      {
        sum += (points.row(hexes(h, ends[1])) - points.row(hexes(h, ends[0]))).norm();
      }
      boxes(h, axis) = 0.25 * sum;
    }
    boxes.row(h) = boxes.row(h).cwiseMax(LeastSide * boxes.row(h).maxCoeff());
  }
  return boxes;
}

/// @return the work.
double raisePatch(Points& points, const CellPatch& patch, const Progress& progress)
{
  const Points places = points(patch.nodes, Eigen::all);
  const Hexes hexes = patch.corners;
  const HexDescent descent(hexes, ownBoxes(places, hexes), patch.free);
  if (!descent.hasFreeNodes())
  {
    return 0.0;
  }
  const HexDescent::Result step =
    descent.descend(places, HexSamples::Lattice, Epsilon, PatchSteps, SettledPatch, progress);
  if (lowestOf(step.points, hexes).betterThan(lowestOf(places, hexes)))
  {
    for (std::size_t i = 0; i < patch.nodes.size(); ++i)
    {
      points.row(patch.nodes[i]) = step.points.row(static_cast<Index>(i));
    }
  }
  return static_cast<double>(step.steps) * untanglingWork(hexes.rows(), HexSamples::Lattice);
}

double leastOf(const std::vector<HexQuality>& qualities)
{
  double minimum = 1.0;
  for (const HexQuality& quality : qualities)
  {
    minimum = std::min(minimum, quality.scaledJacobian);
  }
  return minimum;
}

/// The patches round what is below the middle between the least and what is wanted; where these
/// cost more than there is, the middle between that and the least, and so on. None if none fits.
std::vector<CellPatch> worstPatches(const std::vector<HexQuality>& qualities, const HexesRef& hexes,
  const CellsAtNodes& atNodes, const std::vector<bool>& fixed, double wanted, double budget)
{
  const double least = leastOf(qualities);
  double part = 0.5;
  for (int halving = 0; halving < MostHalvings; ++halving, part *= 0.5)
  {
    std::vector<Index> low;
    for (std::size_t h = 0; h < qualities.size(); ++h)
    {
      if (qualities[h].scaledJacobian < least + part * (wanted - least))
      {
        low.push_back(static_cast<Index>(h));
      }
    }
    if (static_cast<double>(low.size()) * workOf(1) > budget)
    {
      continue;
    }
    std::vector<CellPatch> patches = cellPatches(hexes, atNodes, low, Rings, fixed);
    double work = 0.0;
    for (const CellPatch& patch : patches)
    {
      work += workOf(patch.corners.rows());
    }
    if (work <= budget)
    {
      return patches;
    }
  }
  return {};
}
}

RaisedLowHexes raiseLowHexes(const PointsRef& points, const HexesRef& hexes,
  const std::vector<bool>& fixed, double wanted, const ParallelFor& parallelFor,
  const Progress& progress)
{
  RaisedLowHexes result;
  result.points = points;
  std::vector<HexQuality> qualities = hexQualities(points, hexes, false, parallelFor);
  result.before = result.after = leastOf(qualities);
  const CellsAtNodes atNodes(hexes, points.rows());
  const double budget = PartOfBudget * untanglingBudget(hexes.rows());
  double gain = wanted;
  for (int round = 0;
       round < MostRounds && result.after < wanted && gain >= LeastPatchGain * wanted; ++round)
  {
    const Progress part = progressPart(progress, static_cast<double>(round) / MostRounds,
      static_cast<double>(round + 1) / MostRounds);
    const std::vector<CellPatch> patches =
      worstPatches(qualities, hexes, atNodes, fixed, wanted, PartOfRound * (budget - result.work));
    const double share = 1.0 / static_cast<double>(std::max<std::size_t>(1, patches.size()));
    for (std::size_t p = 0; p < patches.size(); ++p)
    {
      const double from = static_cast<double>(p) * share;
      result.work += raisePatch(result.points, patches[p], progressPart(part, from, from + share));
    }
    result.patches += static_cast<Index>(patches.size());
    qualities = hexQualities(result.points, hexes, false, parallelFor);
    const double before = std::exchange(result.after, leastOf(qualities));
    gain = result.after - before;
  }
  return result;
}
}
