// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/QuadPolishing.h"

#include "Core/CapQuads/CornerTerms.h"
#include "Core/Common/Errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
namespace
{
constexpr int NewtonSteps = 8;
constexpr double Settled = 1e-3; // relative decrease of the sum that ends a descent
/// Less of it gives higher scaled Jacobians and long thin quads that twist the hexes on them.
constexpr double DistortionWeight = 0.05;
constexpr double DistortionEpsilon = 1e-3;
constexpr double Sharpness[] = { 10.0, 20.0, 40.0, 80.0 };
constexpr int MeanRounds = 6;
constexpr double BarrierWeight = 0.002;
/// Measured on the sweep cases: 0.6 leaves the mean as it is and costs a third of the minimum.
constexpr double KeptOfMinimum = 0.9;
/// Of what is kept, to the barrier: nodes that return to the surface need some room.
constexpr double NodesReturn = 0.95;
constexpr double LeastGain = 1e-3; // of the mean, for another round

/// exp(k (floor - x)) above the floor, continued as a parabola below it.
CurvePoint softMinimum(double x, double floor, double k)
{
  const double t = k * (floor - x);
  if (t > 0.0)
  {
    return { 1.0 + t + 0.5 * t * t, -k * (1.0 + t), k * k };
  }
  const double value = std::exp(t);
  return { value, -k * value, k * k * value };
}

using Curve = std::function<CurvePoint(double)>;

CurvePoint meanLoss(double x, double barrier)
{
  const double room = x - barrier;
  if (!(room > 0.0))
  {
    return { std::numeric_limits<double>::infinity(), 0.0, 0.0 };
  }
  const double loss = 1.0 - x;
  return { loss * loss - BarrierWeight * std::log(room), -2.0 * loss - BarrierWeight / room,
    2.0 + BarrierWeight / (room * room) };
}

/// Of the corners at columns, above what each is to keep.
double leastRoom(
  const CapCorners& cap, const Points& points, const std::function<double(Index)>& kept)
{
  double least = 1.0;
  for (const QuadCorner& corner : cap.corners())
  {
    if (corner.movable && corner.column >= 0)
    {
      const double jacobian =
        cornerScaledJacobian(points.row(corner.node[1]) - points.row(corner.node[0]),
          points.row(corner.node[2]) - points.row(corner.node[0]), cap.normal(corner, points));
      least = std::min(least, jacobian - kept(corner.column));
    }
  }
  return least;
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
  const CapDescent descent(cap);
  const std::vector<Eigen::Matrix2d> inverse =
    inverseReferences(cap, ReferenceShape::Rectangle, source, points);
  const auto descend = [&](const Curve& onSurface, const std::function<Curve(Index)>& atColumn) {
    reportProgress(progress, best.rounds / static_cast<double>(std::size(Sharpness) + MeanRounds));
    ++best.rounds;
    return descent
      .descend(
        best.points,
        [&](std::size_t corner, const Eigen::Matrix2d& edges) {
          return sumOfTerms(jacobianTerm(edges, onSurface),
            distortionTerm(edges, inverse[corner], DistortionEpsilon), DistortionWeight);
        },
        NewtonSteps, Settled,
        [&](std::size_t corner, const CornerEdges& edges) {
          return hexJacobianTerm(edges, atColumn(cap.corners()[corner].column));
        })
      .points;
  };

  for (const double k : Sharpness)
  {
    const double floor = best.quality.minimum;
    const Curve curve = [=](double sj) { return softMinimum(sj, floor, k); };
    Points candidate = descend(curve, [&](Index) { return Curve(curve); });
    const CornerQuality quality = cap.measure(candidate);
    if (quality.betterThan(best.quality))
    {
      best.points = std::move(candidate);
      best.quality = quality;
    }
  }

  const double kept = best.quality.minimum;
  const auto barrier = [=](double part) { return NodesReturn * std::max(given, part * kept); };
  const auto atColumn = [&](Index column) {
    return barrier(1.0 - (1.0 - KeptOfMinimum) * cap.columnHeight(column));
  };
  for (int round = 0; round < MeanRounds; ++round)
  {
    Points candidate = descend([=](double sj) { return meanLoss(sj, barrier(KeptOfMinimum)); },
      [&](Index column) {
        return [barrier = atColumn(column)](double sj) { return meanLoss(sj, barrier); };
      });
    const CornerQuality quality = cap.measure(candidate);
    const double gain = quality.mean - best.quality.mean;
    if (quality.inverted > 0 || quality.minimum < std::max(given, barrier(KeptOfMinimum)) ||
      !(leastRoom(cap, candidate, atColumn) >= 0.0) || !(gain > 0.0))
    {
      break;
    }
    best.points = std::move(candidate);
    best.quality = quality;
    if (gain < LeastGain)
    {
      break;
    }
  }
  return best;
}
}
