// SPDX-License-Identifier: BSD-3-Clause
#include "QuadUntangling.h"

#include "CornerTerms.h"
#include "Errors.h"
#include "FoldoverFreeEnergy.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace hexsweep
{
namespace
{
constexpr int MaximumRounds = 100;
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
    for (int round = 0; round < MaximumRounds; ++round)
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
      epsilon = nextEpsilon(
        epsilon, leastDeterminant(cap, inverse, current), step.before, step.after, LeastRate);
    }
  }
  return best;
}
}
