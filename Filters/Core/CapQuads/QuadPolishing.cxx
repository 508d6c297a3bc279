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
constexpr double KeptOfMinimum = 0.6;
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
  const auto descend = [&](const std::function<CurvePoint(double)>& function) {
    reportProgress(progress, best.rounds / static_cast<double>(std::size(Sharpness) + MeanRounds));
    ++best.rounds;
    return descent
      .descend(
        best.points,
        [&](std::size_t corner, const Eigen::Matrix2d& edges) {
          return sumOfTerms(jacobianTerm(edges, function),
            distortionTerm(edges, inverse[corner], DistortionEpsilon), DistortionWeight);
        },
        NewtonSteps, Settled)
      .points;
  };

  for (const double k : Sharpness)
  {
    const double floor = best.quality.minimum;
    Points candidate = descend([=](double sj) { return softMinimum(sj, floor, k); });
    const CornerQuality quality = cap.measure(candidate);
    if (quality.betterThan(best.quality))
    {
      best.points = std::move(candidate);
      best.quality = quality;
    }
  }

  const double floor = std::max(given, KeptOfMinimum * best.quality.minimum);
  const double barrier = 0.95 * floor; // nodes that return to the surface need some room
  for (int round = 0; round < MeanRounds; ++round)
  {
    Points candidate = descend([=](double sj) { return meanLoss(sj, barrier); });
    const CornerQuality quality = cap.measure(candidate);
    const double gain = quality.mean - best.quality.mean;
    if (quality.inverted > 0 || quality.minimum < std::max(given, barrier) || !(gain > 0.0))
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
