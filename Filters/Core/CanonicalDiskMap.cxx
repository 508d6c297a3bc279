// SPDX-License-Identifier: BSD-3-Clause
#include "CanonicalDiskMap.h"

#include "SurfaceRefinement.h"
#include "SurfaceTopology.h"

#include <algorithm>

namespace hexsweep
{
CapDisk canonicalDiskMap(const TriangleMesh& mesh, HoleTreatment treatment, Weights weights)
{
  checkCap(checkSurface(mesh.triangles, mesh.points.rows(), "triangles of the cap"),
    "triangles of the cap");
  RefinedSurface refined = refineSurface(mesh, {}, true);

  CapDisk cap;
  cap.mesh = std::move(refined.mesh);
  cap.triangleOrigin = std::move(refined.triangleOrigin);
  cap.numberOfOriginalPoints = mesh.points.rows();
  cap.loops =
    checkSurface(cap.mesh.triangles, cap.mesh.points.rows(), "triangles of the cap").loops;
  const Points& points = cap.mesh.points;
  const auto outer =
    std::max_element(cap.loops.begin(), cap.loops.end(), [&](const Loop& a, const Loop& b) {
      return closedLength(loopPoints(points, a)) < closedLength(loopPoints(points, b));
    });
  std::rotate(cap.loops.begin(), outer, outer + 1);

  std::vector<PlanePoints> places{ circlePoints(
    { { 0.0, 0.0 }, 1.0 }, arcLengthAngles(loopPoints(points, cap.loops[0]))) };
  const auto filled = [&](Weights w) {
    return filledDiskMap(
      surfaceLaplacian(points, cap.mesh.triangles, w), points, cap.loops, places[0]);
  };
  if (treatment == HoleTreatment::Filled || cap.loops.size() == 1)
  {
    mapWithFallback(cap, weights, [&](Weights w) { return filled(w).disk; });
    return cap;
  }

  const FilledDiskMap first = filled(weights);
  cap.domain = DiskDomain::Circles;
  cap.holes = first.holes;
  separateCircles(cap.holes);
  for (std::size_t h = 0; h < cap.holes.size(); ++h)
  {
    const Loop& loop = cap.loops[h + 1];
    places.push_back(circlePoints(cap.holes[h],
      holeAngles(arcLengthAngles(loopPoints(points, loop)), first.disk, loop, cap.holes[h])));
  }
  mapWithFallback(
    cap, weights, [&](Weights w) { return mapToPlane(cap.mesh, cap.loops, places, w); });
  return cap;
}
}
