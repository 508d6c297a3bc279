// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/CapDisk.h"

#include "Core/Common/Errors.h"
#include "Core/DiskMaps/CommonSubdivision.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Solvers/DirichletSolver.h"
#include "Core/Surfaces/IntrinsicEdgeMiddles.h"
#include "Core/Surfaces/SurfaceArea.h"
#include "Core/Surfaces/SurfaceRefinement.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace hexsweep
{
PlanePoints mapToPlane(const TriangleMesh& mesh, const std::vector<Loop>& loops,
  const std::vector<PlanePoints>& places, Weights weights)
{
  const Index n = mesh.points.rows();
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(n, 2);
  for (std::size_t p = 0; p < loops.size(); ++p)
  {
    for (std::size_t k = 0; k < loops[p].size(); ++k)
    {
      values.row(loops[p][k]) = places[p].row(static_cast<Index>(k));
    }
  }
  const DirichletSolver solver(
    surfaceLaplacian(mesh.points, mesh.triangles, weights), boundaryFlags(n, loops), mesh.points);
  return solver.solve(values);
}

void separateCircles(std::vector<Circle>& circles)
{
  for (std::size_t i = 0; i < circles.size(); ++i)
  {
    double room = 0.5 * (1.0 - circles[i].center.norm());
    for (std::size_t j = 0; j < circles.size(); ++j)
    {
      if (j != i)
      {
        room = std::min(room, 0.4 * (circles[i].center - circles[j].center).norm());
      }
    }
    if (!(room > 0.0))
    {
      throw InvalidInput("two holes fall on one point of the disk: the triangulation between them "
                         "is too coarse or too distorted. Refine it, or smooth it first.");
    }
    circles[i].radius = std::min(circles[i].radius, room);
  }
}

std::vector<double> holeAngles(
  const std::vector<double>& lengths, const PlanePoints& disk, const Loop& loop, const Circle& hole)
{
  double cosine = 0.0;
  double sine = 0.0;
  for (std::size_t k = 0; k < lengths.size(); ++k)
  {
    const Eigen::RowVector2d arm = disk.row(loop[k]) - hole.center;
    const double turn = std::atan2(arm.y(), arm.x()) + lengths[k];
    cosine += std::cos(turn);
    sine += std::sin(turn);
  }
  const double turn = std::atan2(sine, cosine);
  std::vector<double> angles;
  for (const double length : lengths)
  {
    angles.push_back(turn - length);
  }
  return angles;
}

namespace
{
/// How often triangles that are flipped beside a hole are split at most.
constexpr int RefinementRounds = 8;
/// Rounds in a row that leave as much area turned over end it: each may double the triangles.
constexpr int VainRounds = 3;
constexpr double AsMuch = 0.9;

/// On the surface.
double flippedArea(const CapDisk& cap)
{
  return surfaceArea({ cap.mesh.points, cap.mesh.triangles(cap.flipped, Eigen::all) });
}

struct Candidate
{
  Weights weights;
  bool cut;
};

/// What to try, from cheap to dear.
std::vector<Candidate> candidates(Weights wanted, TriangulationImprovement improvement)
{
  const Candidate intrinsic{ Weights::Intrinsic, false };
  const Candidate meanValue{ Weights::MeanValue, false };
  const Candidate cut{ Weights::Intrinsic, true };
  std::vector<Candidate> rest{ meanValue };
  if (improvement == TriangulationImprovement::Automatic)
  {
    rest = { intrinsic, meanValue, cut };
  }
  else if (improvement == TriangulationImprovement::On)
  {
    rest = { intrinsic, cut, meanValue };
  }
  std::vector<Candidate> all{ { wanted, false } };
  for (const Candidate& candidate : rest)
  {
    if (candidate.cut || candidate.weights != wanted)
    {
      all.push_back(candidate);
    }
  }
  return all;
}

/// Puts a changed triangulation of the cap's mesh in its place.
void install(CapDisk& cap, ImprovedTriangulation improved)
{
  for (Index& origin : improved.triangleOrigin)
  {
    origin = cap.triangleOrigin[static_cast<std::size_t>(origin)];
  }
  cap.mesh = std::move(improved.mesh);
  cap.triangleOrigin = std::move(improved.triangleOrigin);
  cap.edgeFlips += improved.flips;
  cap.addedPoints += improved.addedPoints;
}
}

Weights improveCap(
  CapDisk& cap, const TriangleMesh& asked, Weights weights, TriangulationImprovement improvement)
{
  cap.improvement = improvement;
  const ImprovementPlan plan = planImprovement(asked, improvement);
  if (!plan.flip && !plan.refine)
  {
    return weights;
  }
  install(cap, improveTriangulation(cap.mesh, plan));
  const bool intrinsic = weights == Weights::Cotangent &&
    (improvement == TriangulationImprovement::On || isStretched(cap.mesh));
  return intrinsic ? Weights::Intrinsic : weights;
}

void mapWithFallback(CapDisk& cap, Weights weights, const std::function<PlanePoints(Weights)>& map)
{
  const auto flips = [&cap](const PlanePoints& disk, const Triangles& triangles) {
    return domainTriangles(cap.domain, disk, triangles).flipped;
  };
  const std::vector<Candidate> all = candidates(weights, cap.improvement);
  PlanePoints intrinsicDisk;
  std::optional<CutSurface> kept; // if the best is a cut one
  for (std::size_t i = 0; i < all.size() && (i == 0 || !cap.flipped.empty()); ++i)
  {
    CutSurface cut;
    PlanePoints disk;
    std::vector<Index> flipped;
    if (all[i].cut)
    {
      const IntrinsicTriangulation intrinsic =
        intrinsicDelaunay(cap.mesh.points, cap.mesh.triangles);
      if (!flips(intrinsicDisk, intrinsic.triangles).empty())
      {
        continue; // their pieces would be flipped as well
      }
      cut = cutAlongIntrinsicEdges(
        cap.mesh, intrinsic, cap.domain, intrinsicDisk, flips(intrinsicDisk, cap.mesh.triangles));
      disk = cut.disk;
      flipped = flips(disk, cut.mesh.triangles);
    }
    else
    {
      disk = map(all[i].weights);
      flipped = flips(disk, cap.mesh.triangles);
      intrinsicDisk = all[i].weights == Weights::Intrinsic ? disk : intrinsicDisk;
    }
    cap.flipsBefore = i == 0 ? static_cast<Index>(flipped.size()) : cap.flipsBefore;
    if (i == 0 || flipped.size() < cap.flipped.size())
    {
      cap.disk = std::move(disk);
      cap.flipped = std::move(flipped);
      cap.weights = all[i].weights;
      kept.reset();
      if (all[i].cut)
      {
        kept = std::move(cut);
      }
    }
  }
  if (kept)
  {
    const Index added = kept->mesh.points.rows() - cap.mesh.points.rows();
    install(cap, { std::move(kept->mesh), std::move(kept->triangleOrigin), 0, added });
  }
}

void mapWithFallback(CapDisk& cap, Weights weights, const std::vector<PlanePoints>& places)
{
  const auto mapped = [&](CapDisk result) {
    mapWithFallback(
      result, weights, [&](Weights w) { return mapToPlane(result.mesh, result.loops, places, w); });
    return result;
  };
  CapDisk uncut = cap;
  cap = mapped(std::move(cap));
  int vain = 0;
  double area = flippedArea(cap);
  for (int round = 0; round < RefinementRounds && vain < VainRounds && !cap.flipped.empty() &&
       cap.improvement != TriangulationImprovement::Off;
       ++round)
  {
    const IntrinsicTriangulation intrinsic =
      intrinsicDelaunay(uncut.mesh.points, uncut.mesh.triangles);
    const PlanePoints disk = mapToPlane(uncut.mesh, uncut.loops, places, Weights::Intrinsic);
    const std::vector<EdgeSubdivision> subdivisions = middlesOfIntrinsicEdges(
      intrinsic, domainTriangles(cap.domain, disk, intrinsic.triangles).flipped);
    if (subdivisions.empty())
    {
      break;
    }
    RefinedSurface refined = refineSurface(uncut.mesh, subdivisions, false);
    const Index added = refined.mesh.points.rows() - uncut.mesh.points.rows();
    install(uncut, { std::move(refined.mesh), std::move(refined.triangleOrigin), 0, added });
    CapDisk finer = uncut;
    install(finer, improveTriangulation(finer.mesh, { true, false }));
    finer = mapped(std::move(finer));
    finer.flipsBefore = cap.flipsBefore;
    const double left = flippedArea(finer);
    vain = left < AsMuch * area ? 0 : vain + 1;
    area = std::min(area, left);
    if (finer.flipped.size() < cap.flipped.size())
    {
      cap = std::move(finer);
    }
  }
}
}
