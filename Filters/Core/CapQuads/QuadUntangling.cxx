// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/QuadUntangling.h"

#include "Core/CapQuads/CornerTerms.h"
#include "Core/CapQuads/QuadPatchWork.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/FoldoverFreeEnergy.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace hexsweep
{
namespace
{
constexpr int MaximumRounds = 100;
/// Rounds in a row without progress that end the search with one wanted shape.
constexpr int StagnantRounds = 6;
constexpr double LeastGain = 0.01;     // of the least scaled Jacobian, to count as progress
constexpr double LeastDecrease = 0.05; // relative, of the energy within a round
constexpr int NewtonSteps = 6;
constexpr double Settled = 1e-3;     // relative decrease of the energy that ends a round
constexpr double FirstEpsilon = 1.0; // of the wanted corner's area
constexpr double LeastRate = 0.3;    // by which the regularisation falls in a round
constexpr int PatchRings = 2;
/// Of quads, by number, in patches: with more the whole is no dearer.
constexpr double MostInPatches = 0.5;
/// Fewer quads are cheap together, and come out more even.
constexpr Index FewQuads = 1000;
/// Scaled Jacobian below which corners that are upright are opened further.
constexpr double Thin = 0.1;
/// Newton steps times quads for each wanted shape: a few seconds.
constexpr double StepsTimesQuads = 4e5;
constexpr Index LeastSteps = 30;
/// Part of the inverted corners left that earns as many steps again.
constexpr double WorthMore = 0.5;
constexpr int OpeningRounds = 3;
constexpr double OpeningEpsilon = 0.01;

double leastDeterminant(
  const CapCorners& cap, const std::vector<Eigen::Matrix2d>& inverse, const Points& points)
{
  const Points normals = cap.normals(points);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < cap.corners().size(); ++c)
  {
    const QuadCorner& corner = cap.corners()[c];
    if (corner.movable)
    {
      const Eigen::RowVector3d a = points.row(corner.node[1]) - points.row(corner.node[0]);
      const Eigen::RowVector3d b = points.row(corner.node[2]) - points.row(corner.node[0]);
      least =
        std::min(least, a.cross(b).dot(cap.normal(corner, normals)) * inverse[c].determinant());
    }
  }
  return least;
}

/// Better by more than what a search that is stuck creeps on.
bool isProgress(const CornerQuality& quality, const CornerQuality& reached)
{
  return quality.inverted < reached.inverted ||
    (quality.inverted == reached.inverted && quality.minimum > reached.minimum + LeastGain);
}

/// Newton's descent of the distortion against wanted shapes.
CapDescent::Result descend(const CapDescent& descent, const Points& points,
  const std::vector<Eigen::Matrix2d>& inverse, double epsilon)
{
  return descent.descend(
    points,
    [&](std::size_t corner, const Eigen::Matrix2d& edges) {
      return distortionTerm(edges, inverse[corner], epsilon);
    },
    [&](std::size_t corner, const Eigen::Matrix2d& edges) {
      return distortionValueOf(edges, inverse[corner], epsilon);
    },
    NewtonSteps, Settled);
}

/// For each wanted shape, counted so that results do not depend on the machine.
Index mostSteps(const CapCorners& cap)
{
  return std::max(
    LeastSteps, static_cast<Index>(StepsTimesQuads / static_cast<double>(cap.quads().rows())));
}

/// One wanted shape after the other, until all corners are upright.
ImprovedQuads untangleTowards(const std::vector<ReferenceShape>& shapes, const CapCorners& cap,
  const Points& points, const PointsRef& source, const Progress& progress)
{
  ImprovedQuads best{ points, cap.measure(points), 0 };
  if (best.quality.inverted == 0 || cap.freeNodes().empty())
  {
    return best;
  }
  const CapDescent descent(cap);
  for (const ReferenceShape shape : shapes)
  {
    const std::vector<Eigen::Matrix2d> inverse = inverseReferences(cap, shape, source, points);
    Points current = points;
    double epsilon = FirstEpsilon;
    // Not the start's: the first descent may well invert more before it mends them.
    std::optional<CornerQuality> reached;
    int stagnant = 0;
    Index steps = 0;
    Index limit = mostSteps(cap);
    Index invertedAtLimit = best.quality.inverted;
    for (int round = 0; round < MaximumRounds && stagnant < StagnantRounds && steps < limit;
         ++round)
    {
      reportProgress(progress, static_cast<double>(round) / MaximumRounds);
      CapDescent::Result step = descend(descent, current, inverse, epsilon);
      current = std::move(step.points);
      steps += step.steps;
      ++best.rounds;
      const CornerQuality quality = cap.measure(current);
      if (quality.betterThan(best.quality))
      {
        best.points = current;
        best.quality = quality;
        if (static_cast<double>(quality.inverted) <=
          WorthMore * static_cast<double>(invertedAtLimit))
        {
          limit = steps + mostSteps(cap);
          invertedAtLimit = quality.inverted;
        }
      }
      if (quality.inverted == 0)
      {
        return best;
      }
      const bool progressed = !reached || isProgress(quality, *reached) ||
        step.before - step.after > LeastDecrease * std::abs(step.before);
      stagnant = progressed ? 0 : stagnant + 1;
      if (!reached || isProgress(quality, *reached))
      {
        reached = quality;
      }
      epsilon = nextEpsilon(
        epsilon, leastDeterminant(cap, inverse, current), step.before, step.after, LeastRate);
    }
  }
  return best;
}

/// Raises the minimum of quads that are upright.
ImprovedQuads openThinCorners(const CapCorners& cap, const Points& points, const PointsRef& source)
{
  ImprovedQuads best{ points, cap.measure(points), 0 };
  if (cap.freeNodes().empty())
  {
    return best;
  }
  const CapDescent descent(cap);
  const std::vector<Eigen::Matrix2d> inverse =
    inverseReferences(cap, ReferenceShape::Rectangle, source, points);
  Points current = points;
  for (; best.rounds < OpeningRounds; ++best.rounds)
  {
    current = descend(descent, current, inverse, OpeningEpsilon).points;
    const CornerQuality quality = cap.measure(current);
    if (quality.betterThan(best.quality))
    {
      best.points = current;
      best.quality = quality;
    }
  }
  return best;
}
}

ImprovedQuads untangleTogether(
  const CapCorners& cap, const Points& points, const PointsRef& source, const Progress& progress)
{
  return untangleTowards(
    { ReferenceShape::Rectangle, ReferenceShape::Square, ReferenceShape::SourceQuad }, cap, points,
    source, progress);
}

ImprovedQuads untangleQuads(
  const CapCorners& cap, const Points& points, const PointsRef& source, const Progress& progress)
{
  ImprovedQuads local{ points, cap.measure(points), 0 };
  if (local.quality.inverted == 0 || cap.freeNodes().empty())
  {
    return local;
  }
  if (cap.quads().rows() < FewQuads)
  {
    return untangleTogether(cap, points, source, progress);
  }
  const QuadPatchWork patches(cap, source);
  patches.run(
    local, 0.0, PatchRings, MostInPatches,
    [](const CapCorners& part, const Points& start, const PointsRef& from) {
      return untangleTowards({ ReferenceShape::Rectangle }, part, start, from, {});
    },
    progressPart(progress, 0.0, 0.2));
  if (local.quality.inverted == 0)
  {
    patches.run(local, Thin, PatchRings, 1.0, openThinCorners, progressPart(progress, 0.2, 0.4));
    return local;
  }
  ImprovedQuads whole = untangleTogether(cap, points, source, progressPart(progress, 0.4, 1.0));
  whole.rounds += local.rounds;
  return whole;
}
}
