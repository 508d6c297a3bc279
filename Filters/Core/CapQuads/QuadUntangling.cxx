// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/QuadUntangling.h"

#include "Core/CapQuads/CornerTerms.h"
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

double leastDeterminant(
  const CapCorners& cap, const std::vector<Eigen::Matrix2d>& inverse, const Points& points)
{
  const Points normals = cap.place(points).normals;
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
}

ImprovedQuads untangleQuads(
  const CapCorners& cap, const Points& points, const PointsRef& source, const Progress& progress)
{
  ImprovedQuads best{ points, cap.measure(points), 0 };
  if (best.quality.inverted == 0 || cap.freeNodes().empty())
  {
    return best;
  }
  const CapDescent descent(cap);
  for (const ReferenceShape shape :
    { ReferenceShape::Rectangle, ReferenceShape::Square, ReferenceShape::SourceQuad })
  {
    const std::vector<Eigen::Matrix2d> inverse = inverseReferences(cap, shape, source, points);
    Points current = points;
    double epsilon = FirstEpsilon;
    // Not the start's: the first descent may well invert more before it mends them.
    std::optional<CornerQuality> reached;
    int stagnant = 0;
    for (int round = 0; round < MaximumRounds && stagnant < StagnantRounds; ++round)
    {
      reportProgress(progress, static_cast<double>(round) / MaximumRounds);
      const auto term = [&](std::size_t corner, const Eigen::Matrix2d& edges) {
        return distortionTerm(edges, inverse[corner], epsilon);
      };
      CapDescent::Result step = descent.descend(current, term, NewtonSteps, Settled);
      current = std::move(step.points);
      ++best.rounds;
      const CornerQuality quality = cap.measure(current);
      if (quality.betterThan(best.quality))
      {
        best.points = current;
        best.quality = quality;
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
}
