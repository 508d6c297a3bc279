// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/CommonDiskMap.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Errors.h"
#include "Core/DiskMaps/CylinderCap.h"
#include "Core/Linking/RingParameter.h"
#include "Core/Solvers/DirichletSolver.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hexsweep
{
namespace
{
/// Radius of a common hole over the smaller of the two caps' hole radii: small enough that
/// neither map has to shrink its hole much beyond what fits between its neighbours.
constexpr double CommonHoleShrink = 0.4;

/// log(1 / inner radius) of the annulus that is shown; the maps do not depend on it.
constexpr double LeastLogRadius = 0.2;
constexpr double GreatestLogRadius = 5.0;

/// Weights to map each cap with.
struct CapWeights
{
  Weights first;
  Weights second;
};

std::vector<double> mean(const std::vector<double>& a, const std::vector<double>& b)
{
  std::vector<double> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    result[i] = 0.5 * (a[i] + b[i]);
  }
  return result;
}

//--------------------------------------------------------------------------------------------------
// Two loops: the cylinder.

/// Harmonic angle and height with the given angles on the loops, drawn as an annulus.
PlanePoints mapToAnnulus(const CapBoundary& cap, const CylinderCap& own,
  const std::vector<std::vector<double>>& angles, double logRadius, Weights weights)
{
  const Index n = cap.mesh.points.rows();
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(n, 2); // correction of the angle; height
  for (std::size_t p = 0; p < 2; ++p)
  {
    const Loop& loop = cap.loops[p];
    const std::vector<double> before = loopAngles(own, loop);
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      values(loop[k], 0) = own.correction[loop[k]] + angles[p][k] - before[k];
      values(loop[k], 1) = static_cast<double>(p);
    }
  }
  const SparseMatrix laplacian = surfaceLaplacian(cap.mesh.points, cap.mesh.triangles, weights);
  Eigen::MatrixXd source = Eigen::MatrixXd::Zero(n, 2);
  source.col(0) = angleSource(laplacian, own.angle);
  const Eigen::MatrixXd solution =
    DirichletSolver(laplacian, boundaryFlags(n, cap.loops), cap.mesh.points).solve(values, source);
  PlanePoints disk(n, 2);
  for (Index i = 0; i < n; ++i)
  {
    const double angle = own.angle.values[i] + solution(i, 0);
    disk.row(i) =
      std::exp(-logRadius * solution(i, 1)) * Eigen::RowVector2d(std::cos(angle), std::sin(angle));
  }
  return disk;
}

/// The whole turns, as an angle, that bring an angle nearest to the one that is known.
double turnsBeyond(double angle, const std::optional<double>& known)
{
  return known ? 2.0 * Pi * std::round((*known - angle) / (2.0 * Pi)) : 0.0;
}

void mapAnnuli(CommonDisks& disks, const CapBoundaries& caps, const CapWeights& weights)
{
  const auto measure = [](const CapBoundary& cap, Weights own) {
    return measureCylinder(symmetricLaplacian(cap.mesh.points, cap.mesh.triangles, own),
      cap.mesh.points, cap.mesh.triangles, cap.loops);
  };
  const CylinderCap first = measure(caps.first, weights.first);
  const CylinderCap second = measure(caps.second, weights.second);
  const double logRadius =
    std::clamp(0.5 * (first.logRadius + second.logRadius), LeastLogRadius, GreatestLogRadius);

  // The outer loop turns counter-clockwise, the hole clockwise (the surface lies on the left).
  std::vector<std::vector<double>> firstAngles;
  std::vector<std::vector<double>> secondAngles;
  for (std::size_t p = 0; p < 2; ++p)
  {
    const double direction = p == 0 ? 1.0 : -1.0;
    firstAngles.push_back(monotoneLoopAngles(
      first, caps.first.loops[p], ringAngles(caps.pairs[p].first, caps.united[p]), direction));
    secondAngles.push_back(monotoneLoopAngles(
      second, caps.second.loops[p], ringAngles(caps.pairs[p].second, caps.united[p]), direction));
  }
  // Mismatch second - first: its mean on the outer loop is a rotation, which no map cares for;
  // on the hole it counts up to whole turns, of which the one that the sides take is meant, or,
  // where nobody knows them, the nearest to the outer one.
  const auto meanMismatch = [&](std::size_t p) {
    double sum = 0.0;
    for (std::size_t k = 0; k < firstAngles[p].size(); ++k)
    {
      sum += secondAngles[p][k] - firstAngles[p][k];
    }
    return sum / static_cast<double>(firstAngles[p].size());
  };
  const double rotation = meanMismatch(0);
  const double holeMismatch = meanMismatch(1) - rotation;
  const double wholeTurns[2] = { 0.0,
    holeMismatch - wrapAngle(holeMismatch) -
      turnsBeyond(wrapAngle(holeMismatch), caps.pairs[1].turn) };
  std::vector<std::vector<double>> forFirst;
  std::vector<std::vector<double>> forSecond;
  for (std::size_t p = 0; p < 2; ++p)
  {
    for (double& angle : secondAngles[p])
    {
      angle -= rotation + wholeTurns[p];
    }
    forFirst.push_back(mean(firstAngles[p], secondAngles[p]));
    forSecond.push_back(forFirst.back());
    // The second cap's own angle function is not turned: give its boundary values in its terms.
    for (double& angle : forSecond.back())
    {
      angle += wholeTurns[p];
    }
  }
  disks.first.domain = disks.second.domain = DiskDomain::Annulus;
  mapWithFallback(disks.first, weights.first,
    [&](Weights w) { return mapToAnnulus(caps.first, first, forFirst, logRadius, w); });
  mapWithFallback(disks.second, weights.second,
    [&](Weights w) { return mapToAnnulus(caps.second, second, forSecond, logRadius, w); });
  const std::vector<Circle> holes{ { { 0.0, 0.0 }, std::exp(-logRadius) } };
  disks.first.holes = disks.second.holes = holes;
}

//--------------------------------------------------------------------------------------------------
// One loop, and three or more: circles.

void mapCircles(CommonDisks& disks, const CapBoundaries& caps, const CapWeights& weights)
{
  std::vector<PlanePoints> places;
  const Circle unit{ { 0.0, 0.0 }, 1.0 };
  places.push_back(circlePoints(unit,
    mean(ringAngles(caps.pairs[0].first, caps.united[0]),
      ringAngles(caps.pairs[0].second, caps.united[0]))));

  std::vector<Circle> holes;
  if (caps.pairs.size() > 1)
  {
    const auto filled = [&](const CapBoundary& cap, Weights w) {
      return filledDiskMap(symmetricLaplacian(cap.mesh.points, cap.mesh.triangles, w),
        cap.mesh.points, cap.loops, places[0]);
    };
    const FilledDiskMap first = filled(caps.first, weights.first);
    const FilledDiskMap second = filled(caps.second, weights.second);
    for (std::size_t h = 0; h + 1 < caps.pairs.size(); ++h)
    {
      holes.push_back({ 0.5 * (first.holes[h].center + second.holes[h].center),
        CommonHoleShrink * std::min(first.holes[h].radius, second.holes[h].radius) });
    }
    separateCircles(holes);
    for (std::size_t p = 1; p < caps.pairs.size(); ++p)
    {
      const std::vector<double> a = holeAngles(ringAngles(caps.pairs[p].first, caps.united[p]),
        first.disk, caps.first.loops[p], first.holes[p - 1]);
      std::vector<double> b = holeAngles(ringAngles(caps.pairs[p].second, caps.united[p]),
        second.disk, caps.second.loops[p], second.holes[p - 1]);
      double difference = 0.0;
      for (std::size_t k = 0; k < a.size(); ++k)
      {
        difference += (b[k] - a[k]) / static_cast<double>(a.size());
      }
      const double wholeTurns = difference - wrapAngle(difference);
      for (double& angle : b)
      {
        angle -= wholeTurns;
      }
      places.push_back(circlePoints(holes[p - 1], mean(a, b)));
    }
  }
  disks.first.domain = disks.second.domain = holes.empty() ? DiskDomain::Disk : DiskDomain::Circles;
  disks.first.holes = disks.second.holes = holes;
  mapWithFallback(disks.first, weights.first, places);
  mapWithFallback(disks.second, weights.second, places);
}
}

CapDisk unmappedCap(const CapBoundary& cap, Index numberOfOriginalPoints)
{
  CapDisk disk;
  disk.mesh = cap.mesh;
  disk.triangleOrigin = cap.triangleOrigin;
  disk.loops = cap.loops;
  disk.numberOfOriginalPoints = numberOfOriginalPoints;
  disk.maximumBoundaryDistance = cap.maximumDistance;
  return disk;
}

namespace
{
CommonDisks mapBoth(const Cap& first, const Cap& second, const std::vector<LoopPair>& pairs,
  Weights weights, double matchTolerance, const Progress& progress, const CapNames& names,
  TriangulationImprovement improvement)
{
  reportProgress(progress, 0.0);
  CapBoundaries caps = matchCapBoundaries(first, second, pairs, matchTolerance, names);
  reportProgress(progress, 0.3);
  CommonDisks disks;
  disks.pairs = caps.pairs;
  disks.first = unmappedCap(caps.first, first.points().rows());
  disks.second = unmappedCap(caps.second, second.points().rows());
  const CapWeights capWeights{ improveCap(disks.first, first.mesh(), weights, improvement),
    improveCap(disks.second, second.mesh(), weights, improvement) };
  caps.first.mesh = disks.first.mesh;
  caps.second.mesh = disks.second.mesh;
  if (pairs.size() == 2)
  {
    mapAnnuli(disks, caps, capWeights);
  }
  else
  {
    mapCircles(disks, caps, capWeights);
  }
  reportProgress(progress, 1.0);
  return disks;
}
}

CommonDisks commonDiskMap(const Cap& first, const Cap& second, const std::vector<LoopPair>& pairs,
  Weights weights, double matchTolerance, const Progress& progress, const CapNames& names,
  TriangulationImprovement improvement)
{
  return improvedOrPlain(
    improvement,
    [&](TriangulationImprovement used) {
      return mapBoth(first, second, pairs, weights, matchTolerance, progress, names, used);
    },
    [](const CommonDisks& d) { return d.first.flipped.size() + d.second.flipped.size(); });
}
}
