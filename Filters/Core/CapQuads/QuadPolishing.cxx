// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/QuadPolishing.h"

#include "Core/CapQuads/CapDescent.h"
#include "Core/CapQuads/QuadNodeMoves.h"
#include "Core/CapQuads/QuadPatchWork.h"
#include "Core/Common/Errors.h"

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
/// Of all nodes at once.
constexpr int PolishingSteps = 8;
constexpr double SettledSum = 1e-3; // relative decrease of the sum that ends a descent
constexpr int RelaxingSteps = 4;
constexpr double Relaxed = 5e-3;
/// Free nodes from which on equations of all are solved roughly. With fewer a factorisation is
/// cheap, and where the descent ends does not depend on rounding.
constexpr std::size_t ManyNodes = 8000;
constexpr double DistortionEpsilon = 1e-3;
constexpr double SharpnessTogether[] = { 10.0, 20.0, 40.0, 80.0 };
constexpr int MeanRounds = 6;
constexpr double LeastMeanGain = 2e-3; // of the mean, for another round

/// Of single nodes.
constexpr double Sharpness[] = { 20.0, 40.0, 80.0 };
constexpr int FloorsRaised = 3; // with one sharpness
constexpr int SweepsPerFloor = 6;
constexpr double Noticed = 3.0;     // widths of a soft minimum that a corner's loss is seen from
constexpr double LeastRaise = 1e-3; // of the minimum, for another floor
constexpr int MeanSweeps = 20;
/// Below it single nodes may be in each other's way: of the sweep cases hole_moves ends at 0.07
/// instead of 0.15 without the descents together.
constexpr double LowMinimum = 0.35;
constexpr double LowRange = 0.1; // above the minimum, of corners that are raised together
constexpr int LowPatchRings = 4; // around them
/// Up to here the same is done where it is little work: a disk of 98 000 quads ended at 0.68 with
/// two corners at nodes of three quads that nothing else moved.
constexpr double FairMinimum = 0.75;
constexpr double LittleWork = 0.05; // of the quads, in patches

/// Measured on the sweep cases: 0.6 leaves the mean as it is and costs a third of the minimum.
constexpr double KeptOfMinimum = 0.9;
constexpr double KeptOfLow = 0.97;
/// Of what is kept, to the barrier: nodes that return to the surface need some room.
constexpr double Room = 0.95;
/// Least gain of the mean for what the minimum loses, of a mesh that stands well: of an even one
/// the mean rises by 0.0002 where the minimum falls by 0.1.
constexpr double LeastTrade = 0.005;

using Losses = QuadNodeMoves::Losses;

Losses sameLoss(const CapCorners& cap, const CornerLoss& loss, double floor)
{
  return { loss, std::vector<CornerLoss>(static_cast<std::size_t>(cap.numberOfColumns()), loss),
    floor };
}

/// Newton's descents of all nodes together.
class Together
{
public:
  Together(const CapCorners& cap, const PointsRef& source, const Points& points,
    NewtonEquations equations = NewtonEquations::Exactly)
    : Cap(cap)
    , Descent(cap, equations)
    , Inverse(inverseReferences(cap, ReferenceShape::Rectangle, source, points))
  {
  }

  Points descend(const Points& points, const Losses& losses, int steps = PolishingSteps,
    double settled = SettledSum)
  {
    const auto onSurface = [&](double jacobian) { return losses.onSurface.at(jacobian); };
    return this->Descent
      .descend(
        points,
        [&](std::size_t corner, const Eigen::Matrix2d& edges) {
          return sumOfTerms(jacobianTerm(edges, onSurface),
            distortionTerm(edges, this->Inverse[corner], DistortionEpsilon),
            QuadNodeMoves::DistortionWeight);
        },
        [&](std::size_t corner, const Eigen::Matrix2d& edges) {
          const double jacobian = edges.determinant() / (edges.col(0).norm() * edges.col(1).norm());
          return onSurface(jacobian).value +
            QuadNodeMoves::DistortionWeight *
            distortionValueOf(edges, this->Inverse[corner], DistortionEpsilon);
        },
        steps, settled,
        [&](std::size_t corner, const CornerEdges& edges) {
          const CornerLoss& loss =
            losses.atColumns[static_cast<std::size_t>(this->Cap.corners()[corner].column)];
          return hexJacobianTerm(edges, [&](double jacobian) { return loss.at(jacobian); });
        })
      .points;
  }

private:
  const CapCorners& Cap;
  CapDescent Descent;
  std::vector<Eigen::Matrix2d> Inverse;
};

/// Of the corners at columns, above what each is to keep.
double leastRoom(const CapCorners& cap, const Points& points, const Losses& losses)
{
  double least = 1.0;
  for (const QuadCorner& corner : cap.corners())
  {
    if (corner.movable && corner.column >= 0)
    {
      const double jacobian =
        cornerScaledJacobian(points.row(corner.node[1]) - points.row(corner.node[0]),
          points.row(corner.node[2]) - points.row(corner.node[0]), cap.normal(corner, points));
      least =
        std::min(least, jacobian - losses.atColumns[static_cast<std::size_t>(corner.column)].least);
    }
  }
  return least;
}

void take(Points candidate, const CornerQuality& quality, ImprovedQuads& best)
{
  best.points = std::move(candidate);
  best.quality = quality;
}

/// For the mean, before anything else. @return whether it was of use. What single nodes do to a
/// mesh takes as many sweeps to go round it as there are nodes along its way.
bool relax(const CapCorners& cap, Together& together, ImprovedQuads& best)
{
  const Losses losses = sameLoss(cap, { 0.0, Room * best.quality.minimum }, 0.0);
  Points candidate = together.descend(best.points, losses, RelaxingSteps, Relaxed);
  ++best.rounds;
  const CornerQuality quality = cap.measure(candidate);
  if (quality.inverted > 0 || quality.minimum < Room * best.quality.minimum ||
    !(quality.mean > best.quality.mean))
  {
    return false;
  }
  take(std::move(candidate), quality, best);
  return true;
}

ImprovedQuads raiseMinimumTogether(
  const CapCorners& cap, const Points& points, const PointsRef& source)
{
  ImprovedQuads best{ points, cap.measure(points), 0 };
  if (cap.freeNodes().empty())
  {
    return best;
  }
  Together together(cap, source, points);
  for (const double k : SharpnessTogether)
  {
    ++best.rounds;
    Points candidate =
      together.descend(best.points, sameLoss(cap, { k, best.quality.minimum }, 0.0));
    const CornerQuality quality = cap.measure(candidate);
    if (quality.betterThan(best.quality))
    {
      take(std::move(candidate), quality, best);
    }
  }
  return best;
}

/// A smooth minimum ever sharper, of single nodes.
void raiseMinimum(
  const CapCorners& cap, QuadNodeMoves& moves, const Progress& progress, ImprovedQuads& best)
{
  moves.reset(best.points);
  double least = moves.least();
  int floors = 0;
  for (const double k : Sharpness)
  {
    for (int raised = 0; raised < FloorsRaised; ++raised)
    {
      reportProgress(progress, floors++ / static_cast<double>(std::size(Sharpness) * FloorsRaised));
      moves.wake(least + Noticed / k);
      const Losses losses = sameLoss(cap, { k, least }, least);
      for (int sweep = 0; sweep < SweepsPerFloor && moves.sweep(losses) > 0; ++sweep)
      {
      }
      const double before = least;
      least = moves.least();
      if (!(least > before + LeastRaise))
      {
        break;
      }
    }
  }
  ++best.rounds;
  const CornerQuality quality = cap.measure(moves.points());
  if (quality.betterThan(best.quality))
  {
    take(moves.points(), quality, best);
  }
}

void raiseMeanTogether(const CapCorners& cap, Together& together, const Losses& losses,
  const Progress& progress, ImprovedQuads& best)
{
  for (int round = 0; round < MeanRounds; ++round)
  {
    reportProgress(progress, static_cast<double>(round) / MeanRounds);
    ++best.rounds;
    Points candidate = together.descend(best.points, losses);
    const CornerQuality quality = cap.measure(candidate);
    const double gain = quality.mean - best.quality.mean;
    if (quality.inverted > 0 ||
      quality.minimum < std::max(losses.floor, Room * losses.onSurface.least) ||
      !(leastRoom(cap, candidate, losses) >= 0.0) || !(gain > 0.0))
    {
      break;
    }
    take(std::move(candidate), quality, best);
    if (gain < LeastMeanGain)
    {
      break;
    }
  }
}

/// Of single nodes.
void raiseMean(const CapCorners& cap, QuadNodeMoves& moves, const Losses& losses,
  const Progress& progress, ImprovedQuads& best)
{
  moves.reset(best.points);
  moves.wake(2.0);
  for (int sweep = 0; sweep < MeanSweeps && moves.sweep(losses) > 0; ++sweep)
  {
    reportProgress(progress, static_cast<double>(sweep) / MeanSweeps);
  }
  ++best.rounds;
  const CornerQuality quality = cap.measure(moves.points());
  const double lost = std::max(0.0, best.quality.minimum - quality.minimum);
  const double wanted = cap.freeNodes().size() < ManyNodes ? 0.0 : LeastTrade * lost;
  if (quality.inverted == 0 && quality.minimum >= losses.floor &&
    quality.mean > best.quality.mean + wanted)
  {
    take(moves.points(), quality, best);
  }
}
}

ImprovedQuads polishQuads(
  const CapCorners& cap, const Points& points, const PointsRef& source, const Progress& progress)
{
  ImprovedQuads best{ points, cap.measure(points), 0 };
  if (best.quality.inverted > 0 || cap.freeNodes().empty())
  {
    return best;
  }
  const double given = best.quality.minimum;
  reportProgress(progress, 0.0);
  Together together(cap, source, points,
    cap.freeNodes().size() < ManyNodes ? NewtonEquations::Exactly : NewtonEquations::Roughly);
  QuadNodeMoves moves(cap, points, source);
  reportProgress(progress, 0.1);
  const ImprovedQuads unrelaxed = best;
  bool relaxed = relax(cap, together, best);
  raiseMinimum(cap, moves, progressPart(progress, 0.3, 0.4), best);
  if (best.quality.minimum < given)
  {
    best = unrelaxed;
    relaxed = false;
    raiseMinimum(cap, moves, progressPart(progress, 0.4, 0.4), best);
  }
  const double least = best.quality.minimum;
  const bool low = least < LowMinimum;
  if (least < FairMinimum)
  {
    const double floor = least + (low ? std::max(LowRange, least) : LowRange);
    const bool raised = QuadPatchWork(cap, source)
                          .run(best, floor, LowPatchRings, low ? 1.0 : LittleWork,
                            raiseMinimumTogether, progressPart(progress, 0.4, 0.65));
    if (raised)
    {
      raiseMinimum(cap, moves, progressPart(progress, 0.65, 0.7), best);
    }
  }

  const double kept = best.quality.minimum;
  const double part = kept < LowMinimum ? KeptOfLow : KeptOfMinimum;
  const auto barrier = [=](double share) { return Room * std::max(given, share * kept); };
  Losses losses = sameLoss(cap, { 0.0, barrier(part) }, given);
  for (std::size_t c = 0; c < losses.atColumns.size(); ++c)
  {
    losses.atColumns[c].least =
      barrier(1.0 - (1.0 - part) * cap.columnHeight(static_cast<Index>(c)));
  }
  if (low || !relaxed)
  {
    raiseMeanTogether(cap, together, losses, progressPart(progress, 0.7, 0.9), best);
  }
  raiseMean(cap, moves, losses, progressPart(progress, 0.9, 1.0), best);
  return best;
}
}
