// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/CanonicalDiskMap.h"

#include "Core/Common/Errors.h"
#include "Core/DiskMaps/ConformalAnnulus.h"
#include "Core/Surfaces/SurfaceRefinement.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace hexsweep
{
namespace
{
/// Circles about the centres that the filled cap gives; the nodes on them by arc length.
KoebeMap arcLengthCircles(const TriangleMesh& mesh, const std::vector<Loop>& loops, Weights weights)
{
  KoebeMap map;
  map.places.push_back(
    circlePoints({ { 0.0, 0.0 }, 1.0 }, arcLengthAngles(loopPoints(mesh.points, loops[0]))));
  const FilledDiskMap filled = filledDiskMap(surfaceLaplacian(mesh.points, mesh.triangles, weights),
    mesh.points, loops, map.places[0], weights);
  map.holes = filled.holes;
  separateCircles(map.holes);
  for (std::size_t h = 0; h < map.holes.size(); ++h)
  {
    const Loop& loop = loops[h + 1];
    map.places.push_back(circlePoints(map.holes[h],
      holeAngles(arcLengthAngles(loopPoints(mesh.points, loop)), filled.disk, loop, map.holes[h])));
  }
  map.converged = true;
  return map;
}

/// The annulus that a cap is conformal to with (log r, angle) linear, where that flips nothing: a
/// small hole crowds the triangles beside it, which straight edges in the plane then cut.
bool useCylinder(CapDisk& cap)
{
  const ConformalAnnulus annulus = conformalAnnulus(cap.mesh.points, cap.mesh.triangles, cap.loops);
  const double start = annulus.angle[cap.loops[0][0]];
  PlanePoints disk(cap.mesh.points.rows(), 2);
  for (Index i = 0; i < disk.rows(); ++i)
  {
    const double angle = annulus.angle[i] - start;
    disk.row(i) = std::pow(annulus.innerRadius, annulus.height[i]) *
      Eigen::RowVector2d(std::cos(angle), std::sin(angle));
  }
  if (!domainTriangles(DiskDomain::Annulus, disk, cap.mesh.triangles).flipped.empty())
  {
    return false;
  }
  cap.domain = DiskDomain::Annulus;
  cap.disk = std::move(disk);
  cap.weights = Weights::Cotangent;
  cap.flipped.clear();
  return true;
}

CapDisk mapOnce(const TriangleMesh& mesh, HoleTreatment treatment, Weights weights,
  TriangulationImprovement improvement, const KoebeLimits& limits, const Progress& progress)
{
  reportProgress(progress, 0.0);
  SurfaceTopology topology = checkSurface(mesh.triangles, mesh.points.rows(), "input surface");
  checkCap(topology, "input surface");

  CapDisk cap;
  cap.numberOfOriginalPoints = mesh.points.rows();
  const bool chords = hasChords(mesh.triangles, mesh.points.rows(), topology.loops);
  if (chords)
  {
    RefinedSurface refined = refineSurface(mesh, {}, true);
    cap.mesh = std::move(refined.mesh);
    cap.triangleOrigin = std::move(refined.triangleOrigin);
  }
  else
  {
    cap.mesh = mesh;
    cap.triangleOrigin.resize(static_cast<std::size_t>(mesh.triangles.rows()));
    std::iota(cap.triangleOrigin.begin(), cap.triangleOrigin.end(), Index(0));
  }
  weights = improveCap(cap, mesh, weights, improvement);
  if (chords || cap.edgeFlips + cap.addedPoints > 0)
  {
    topology = checkSurface(cap.mesh.triangles, cap.mesh.points.rows(), "input surface");
  }
  cap.loops = std::move(topology.loops);
  const Points& points = cap.mesh.points;
  const auto outer =
    cap.loops.begin() + static_cast<std::ptrdiff_t>(longestLoop(points, cap.loops));
  std::rotate(cap.loops.begin(), outer, outer + 1);

  reportProgress(progress, 0.2);
  if (treatment == HoleTreatment::Filled || cap.loops.size() == 1)
  {
    const PlanePoints outerPlaces =
      circlePoints({ { 0.0, 0.0 }, 1.0 }, arcLengthAngles(loopPoints(points, cap.loops[0])));
    mapWithFallback(cap, weights, [&](Weights w) {
      return filledDiskMap(
        surfaceLaplacian(points, cap.mesh.triangles, w), points, cap.loops, outerPlaces, w)
        .disk;
    });
    return cap;
  }
  KoebeMap map;
  if (treatment == HoleTreatment::Koebe)
  {
    const Progress part = progressPart(progress, 0.2, 0.8);
    std::vector<Weights> tried{ weights };
    if (improvement != TriangulationImprovement::Off && weights != Weights::Intrinsic)
    {
      tried.push_back(Weights::Intrinsic);
    }
    for (std::size_t k = 0; k < tried.size() && map.places.empty(); ++k)
    {
      try
      {
        map = koebeMap(points, cap.mesh.triangles, cap.loops, limits, part, tried[k]);
        cap.koebeFailure.clear();
      }
      catch (const InvalidInput& error)
      {
        cap.koebeFailure = error.what();
      }
      catch (const SolverFailure& error)
      {
        cap.koebeFailure = error.what();
      }
    }
  }
  if (map.places.empty())
  {
    map = arcLengthCircles(cap.mesh, cap.loops, weights);
  }
  cap.domain = DiskDomain::Circles;
  cap.holes = std::move(map.holes);
  cap.rounds = std::move(map.rounds);
  cap.circularity = std::move(map.circularity);
  cap.converged = map.converged;
  if (treatment == HoleTreatment::Koebe && cap.loops.size() == 2 && cap.koebeFailure.empty())
  {
    cap.weights = weights;
    cap.disk = mapToPlane(cap.mesh, cap.loops, map.places, weights);
    cap.flipped = domainTriangles(cap.domain, cap.disk, cap.mesh.triangles).flipped;
    cap.flipsBefore = static_cast<Index>(cap.flipped.size());
    if (cap.flipped.empty() || useCylinder(cap))
    {
      return cap;
    }
  }
  mapWithFallback(cap, weights, map.places);
  reportProgress(progress, 1.0);
  return cap;
}
}

CapDisk canonicalDiskMap(const TriangleMesh& mesh, HoleTreatment treatment, Weights weights,
  TriangulationImprovement improvement, const KoebeLimits& limits, const Progress& progress)
{
  return improvedOrPlain(
    improvement,
    [&](TriangulationImprovement used) {
      return mapOnce(mesh, treatment, weights, used, limits, progress);
    },
    [](const CapDisk& cap) { return cap.flipped.size(); });
}
}
