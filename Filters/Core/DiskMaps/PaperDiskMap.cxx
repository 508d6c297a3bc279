// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/PaperDiskMap.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Errors.h"
#include "Core/Linking/RingParameter.h"

#include <cmath>
#include <utility>

namespace hexsweep
{
namespace
{
const Circle UnitCircle{ { 0.0, 0.0 }, 1.0 };

/// The outer loop turns counter-clockwise, holes clockwise (the surface lies on the left).
double direction(std::size_t loop)
{
  return loop == 0 ? 1.0 : -1.0;
}

CanonicalBoundary annulusBoundary(CylinderCap cylinder, const std::vector<Loop>& loops,
  const std::vector<std::vector<double>>& angles)
{
  CanonicalBoundary boundary;
  boundary.domain = DiskDomain::Circles;
  boundary.holes = { { { 0.0, 0.0 }, std::exp(-cylinder.logRadius) } };
  for (std::size_t p = 0; p < 2; ++p)
  {
    boundary.places.push_back(circlePoints(p == 0 ? UnitCircle : boundary.holes[0],
      monotoneLoopAngles(cylinder, loops[p], angles[p], direction(p))));
  }
  boundary.cylinder = std::move(cylinder);
  return boundary;
}

/**
 * Mean of second - first over a loop. Each node counts for the piece of the loop about it, as both
 * caps see it, so that nodes that crowd somewhere do not pull the mean their way.
 */
double meanTurn(const std::vector<double>& first, const std::vector<double>& second, double sense)
{
  const std::size_t n = first.size();
  double sum = 0.0;
  for (std::size_t k = 0; k < n; ++k)
  {
    const std::size_t next = (k + 1) % n;
    const double whole = next == 0 ? sense * 4.0 * Pi : 0.0;
    const double width = 0.5 * (first[next] + second[next] - first[k] - second[k] + whole);
    sum += 0.5 * sense * width * (second[k] - first[k] + second[next] - first[next]);
  }
  return sum / (2.0 * Pi);
}

NitscheCondition nitscheCondition(const CylinderCap& source, const std::vector<Loop>& onSource,
  const CylinderCap& target, const std::vector<Loop>& onTarget)
{
  double turns[2];
  for (std::size_t p = 0; p < 2; ++p)
  {
    turns[p] =
      meanTurn(loopAngles(source, onSource[p]), loopAngles(target, onTarget[p]), direction(p));
  }
  return { std::exp(-source.logRadius), std::exp(-target.logRadius),
    wrapAngle(turns[1] - turns[0]) };
}

std::vector<std::vector<double>> targetAngles(const CapBoundaries& caps)
{
  std::vector<std::vector<double>> angles;
  for (std::size_t p = 0; p < caps.pairs.size(); ++p)
  {
    angles.push_back(ringAngles(caps.pairs[p].second, caps.united[p]));
  }
  return angles;
}

void mapInto(CapDisk& cap, const CanonicalBoundary& boundary, Weights weights)
{
  cap.domain = boundary.domain;
  cap.holes = boundary.holes;
  mapWithFallback(cap, weights, boundary.places);
}
}

double NitscheCondition::greatestTargetRadius() const
{
  return 2.0 * this->sourceRadius * std::cos(this->turn) /
    (1.0 + this->sourceRadius * this->sourceRadius);
}

CanonicalBoundary canonicalBoundary(const TriangleMesh& mesh, const std::vector<Loop>& loops,
  const std::vector<std::vector<double>>& angles)
{
  if (loops.size() == 2)
  {
    return annulusBoundary(measureCylinder(cotangentLaplacian(mesh.points, mesh.triangles),
                             mesh.points, mesh.triangles, loops),
      loops, angles);
  }
  CanonicalBoundary boundary;
  boundary.places.push_back(circlePoints(UnitCircle, angles[0]));
  if (loops.size() == 1)
  {
    return boundary;
  }
  KoebeMap circles = koebeMap(mesh.points, mesh.triangles, loops);
  boundary.domain = DiskDomain::Circles;
  boundary.holes = std::move(circles.holes);
  boundary.places = std::move(circles.places);
  return boundary;
}

PaperDisks paperDiskMap(const Cap& source, const Cap& target, const std::vector<LoopPair>& pairs,
  Weights weights, double matchTolerance, const Progress& progress, const CapNames& names)
{
  reportProgress(progress, 0.0);
  const CapBoundaries caps = matchCapBoundaries(source, target, pairs, matchTolerance, names);
  reportProgress(progress, 0.3);
  PaperDisks result;
  result.disks.pairs = caps.pairs;
  result.disks.first = unmappedCap(caps.first, source.points().rows());
  result.disks.second = unmappedCap(caps.second, target.points().rows());
  const CanonicalBoundary boundary =
    canonicalBoundary(caps.second.mesh, caps.second.loops, targetAngles(caps));
  if (boundary.cylinder)
  {
    const CylinderCap ofSource =
      measureCylinder(cotangentLaplacian(caps.first.mesh.points, caps.first.mesh.triangles),
        caps.first.mesh.points, caps.first.mesh.triangles, caps.first.loops);
    result.nitsche =
      nitscheCondition(ofSource, caps.first.loops, *boundary.cylinder, caps.second.loops);
  }
  reportProgress(progress, 0.6);
  mapInto(result.disks.second, boundary, weights);
  mapInto(result.disks.first, boundary, weights);
  reportProgress(progress, 1.0);
  return result;
}
}
