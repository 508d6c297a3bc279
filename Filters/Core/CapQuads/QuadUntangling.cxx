// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/QuadUntangling.h"

#include "Core/CapQuads/CornerTerms.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/FoldoverFreeEnergy.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
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

Points rowsOf(const PointsRef& points, const std::vector<Index>& rows)
{
  Points picked(static_cast<Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    picked.row(static_cast<Index>(i)) = points.row(rows[i]);
  }
  return picked;
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
    for (int round = 0; round < MaximumRounds && stagnant < StagnantRounds; ++round)
    {
      reportProgress(progress, static_cast<double>(round) / MaximumRounds);
      CapDescent::Result step = descend(descent, current, inverse, epsilon);
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

/// What works on quads around chosen ones, patch by patch.
class PatchWork
{
public:
  /// Moves the free nodes of a patch; source points are the patch's as well.
  using Work =
    std::function<ImprovedQuads(const CapCorners&, const Points&, const PointsRef& source)>;

  PatchWork(const CapCorners& cap, const PointsRef& source)
    : Cap(cap)
    , Source(source)
    , AtNodes(cap.quads(), source.rows())
    , Fixed(static_cast<std::size_t>(source.rows()), true)
  {
    for (const Index i : cap.freeNodes())
    {
      this->Fixed[static_cast<std::size_t>(i)] = false;
    }
  }

  /// Where corners are not above the floor. @param most of the quads, or nothing is done.
  void run(ImprovedQuads& quads, double floor, double most, const Work& work,
    const Progress& progress) const
  {
    const std::vector<CellPatch> patches = cellPatches(this->Cap.quads(), this->AtNodes,
      this->Cap.quadsBelow(floor, quads.points), PatchRings, this->Fixed);
    if (sizeOf(patches) > most * static_cast<double>(this->Cap.quads().rows()))
    {
      return;
    }
    for (std::size_t p = 0; p < patches.size(); ++p)
    {
      reportProgress(progress, static_cast<double>(p) / static_cast<double>(patches.size()));
      const CellPatch& patch = patches[p];
      const ImprovedQuads mended = work(CapCorners(this->Cap, patch),
        rowsOf(quads.points, patch.nodes), rowsOf(this->Source, patch.nodes));
      quads.rounds += mended.rounds;
      for (std::size_t i = 0; i < patch.nodes.size(); ++i)
      {
        quads.points.row(patch.nodes[i]) = mended.points.row(static_cast<Index>(i));
      }
    }
    quads.quality = this->Cap.measure(quads.points);
  }

private:
  static double sizeOf(const std::vector<CellPatch>& patches)
  {
    std::size_t cells = 0;
    for (const CellPatch& patch : patches)
    {
      cells += patch.cells.size();
    }
    return static_cast<double>(cells);
  }

  const CapCorners& Cap;
  const PointsRef& Source;
  CellsAtNodes AtNodes;
  std::vector<bool> Fixed;
};

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
  const PatchWork patches(cap, source);
  patches.run(
    local, 0.0, MostInPatches,
    [](const CapCorners& part, const Points& start, const PointsRef& from) {
      return untangleTowards({ ReferenceShape::Rectangle }, part, start, from, {});
    },
    progressPart(progress, 0.0, 0.2));
  if (local.quality.inverted == 0)
  {
    patches.run(local, Thin, 1.0, openThinCorners, progressPart(progress, 0.2, 0.4));
    return local;
  }
  ImprovedQuads whole = untangleTogether(cap, points, source, progressPart(progress, 0.4, 1.0));
  whole.rounds += local.rounds;
  return whole;
}
}
