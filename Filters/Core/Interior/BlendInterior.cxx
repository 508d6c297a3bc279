// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/BlendInterior.h"

#include "Core/Common/Errors.h"
#include "Core/Common/StoppablePieces.h"
#include "Core/Solvers/DirichletSolver.h"
#include "Core/Solvers/PrismSolver.h"
#include "Core/Solvers/QuadLaplacian.h"

#include <algorithm>
#include <utility>

namespace hexsweep
{
namespace
{
/// Height of a layer of the prism in which bulges fade, over the mean height of a layer.
constexpr double FadingHeight = 0.25;
/// A bulge that counts, over the mean height of a layer.
constexpr double LeastBulge = 1e-3;

/// What a cap has on top of the harmonic surface in its loops.
Points bulgeOf(const PointsRef& points, const QuadLaplacian& laplacian, const SweepBoundary& cage)
{
  std::vector<bool> fixed(static_cast<std::size_t>(points.rows()), false);
  for (const Index i : cage.nodes)
  {
    fixed[static_cast<std::size_t>(i)] = true;
  }
  // About its middle: far from the origin the solver's rounding would be larger than the cap.
  const Eigen::RowVector3d middle = points.colwise().mean();
  const Points centered = points.rowwise() - middle;
  return centered - DirichletSolver(laplacian.stiffness, fixed, centered).solve(centered);
}

/// The part of two bulges that they have in common: b where a = b, the shorter where they are
/// parallel, nothing where they are opposite.
Points commonBulge(const Points& a, const Points& b)
{
  Points common = Points::Zero(a.rows(), 3);
  for (Index i = 0; i < a.rows(); ++i)
  {
    const double dot = a.row(i).dot(b.row(i));
    if (dot > 0.0)
    {
      const double lengths[2] = { a.row(i).norm(), b.row(i).norm() };
      common.row(i) = (a.row(i) + b.row(i)) *
        (dot / (std::max(lengths[0], lengths[1]) * (lengths[0] + lengths[1])));
    }
  }
  return common;
}

/// What the bulges of both caps do not share.
struct OwnBulges
{
  Points onSource; ///< n x 3, in the frame of the source
  Points onTarget; ///< in that of the target
};

OwnBulges ownBulges(const SweepCage& cage, const QuadLaplacian& onTarget)
{
  const SweepBoundary& boundary = cage.boundary;
  const Index layers = boundary.numberOfLayers();
  const Points source = bulgeOf(cage.source, quadLaplacian(cage.source, cage.quads), boundary);
  const Points target = bulgeOf(cage.target, onTarget, boundary);
  const auto carried = [&](const Points& bulge, Index from, Index to) -> Points {
    return bulge * fitLayerMap(boundary, from, to).linear.transpose();
  };
  return { source - commonBulge(source, carried(target, layers, 0)),
    target - commonBulge(target, carried(source, 0, layers)) };
}

/// The same on all layers, fading into the volume from either end: (L + 1) n x 3.
struct FadingBulges
{
  Points fromSource;
  Points fromTarget;
};

FadingBulges fadingBulges(const SweepCage& cage, const QuadLaplacian& onTarget,
  const Progress& progress, const ParallelFor& parallelFor)
{
  const SweepBoundary& boundary = cage.boundary;
  const Index n = cage.source.rows();
  const Index layers = boundary.numberOfLayers();
  const OwnBulges own = ownBulges(cage, onTarget);
  FadingBulges fading{ Points::Zero((layers + 1) * n, 3), Points::Zero((layers + 1) * n, 3) };
  fading.fromSource.topRows(n) = own.onSource;
  fading.fromTarget.bottomRows(n) = own.onTarget;
  const PrismSolver prism(onTarget, layers,
    FadingHeight * boundary.meanColumnLength / static_cast<double>(layers), boundary.nodes);
  fading.fromSource =
    prism.extend(std::move(fading.fromSource), progressPart(progress, 0.0, 0.5), parallelFor);
  fading.fromTarget =
    prism.extend(std::move(fading.fromTarget), progressPart(progress, 0.5, 1.0), parallelFor);
  return fading;
}

enum class CapBulges
{
  Blended,
  Fading
};

Points blend(
  const SweepCage& cage, CapBulges bulges, const Progress& progress, const ParallelFor& parallelFor)
{
  const Points& sourcePoints = cage.source;
  const Points& targetPoints = cage.target;
  const Quads& quads = cage.quads;
  const SweepBoundary& boundary = cage.boundary;
  const Index n = sourcePoints.rows();
  const Index layers = boundary.numberOfLayers();
  reportProgress(progress, 0.0);
  const QuadLaplacian onTarget = quadLaplacian(targetPoints, quads);
  Points source = sourcePoints;
  Points target = targetPoints;
  FadingBulges fading;
  const bool fade = bulges == CapBulges::Fading;
  const double fadeEnd = fade ? 0.55 : 0.0;
  const double blendEnd = fadeEnd + 0.2 * (1.0 - fadeEnd);
  if (fade)
  {
    fading = fadingBulges(cage, onTarget, progressPart(progress, 0.0, fadeEnd), parallelFor);
    source -= fading.fromSource.topRows(n);
    target -= fading.fromTarget.bottomRows(n);
  }

  // On the caps the blend is exact, so the correction is zero there.
  Points swept((layers + 1) * n, 3);
  Points correction((layers + 1) * n, 3);
  const auto blendLayer = [&](Index k, Index) {
    correction.middleRows(k * n, n).setZero();
    if (k == 0 || k == layers)
    {
      return;
    }
    const double t = boundary.fractions[k];
    const AffineMap fromSource = fitLayerMap(boundary, 0, k);
    const AffineMap fromTarget = fitLayerMap(boundary, layers, k);
    constexpr Index RowsAtOnce = 512; // so many stay in the cache
    for (Index first = 0; first < n; first += RowsAtOnce)
    {
      const Index count = std::min(RowsAtOnce, n - first);
      swept.middleRows(k * n + first, count) =
        (1.0 - t) * fromSource.apply(source.middleRows(first, count)) +
        t * fromTarget.apply(target.middleRows(first, count));
    }
    for (std::size_t j = 0; j < boundary.nodes.size(); ++j)
    {
      const Index row = k * n + boundary.nodes[j];
      correction.row(row) = boundary.rings[k].row(static_cast<Index>(j)) - swept.row(row);
    }
    if (fade)
    {
      swept.middleRows(k * n, n) +=
        fading.fromSource.middleRows(k * n, n) * fromSource.linear.transpose() +
        fading.fromTarget.middleRows(k * n, n) * fromTarget.linear.transpose();
    }
  };
  forStoppablePieces(
    parallelFor, progressPart(progress, fadeEnd, blendEnd), layers + 1, 1, blendLayer);
  fading = {};
  const double layerHeight = boundary.meanColumnLength / static_cast<double>(layers);
  correction =
    PrismSolver(onTarget, layers, layerHeight, boundary.nodes)
      .extend(std::move(correction), progressPart(progress, blendEnd, 0.95), parallelFor);
  forStoppablePieces(
    parallelFor, progressPart(progress, 0.95, 1.0), layers - 1, 1, [&](Index inner, Index) {
      const Index begin = (inner + 1) * n;
      swept.middleRows(begin, n) += correction.middleRows(begin, n);
    });
  reportProgress(progress, 1.0);
  setGivenPoints(sourcePoints, targetPoints, quads, boundary, swept);
  return swept;
}
}

Points blendInterior(
  const SweepCage& cage, const Progress& progress, const ParallelFor& parallelFor)
{
  return blend(cage, CapBulges::Blended, progress, parallelFor);
}

Points fadingBlendInterior(
  const SweepCage& cage, const Progress& progress, const ParallelFor& parallelFor)
{
  return blend(cage, CapBulges::Fading, progress, parallelFor);
}

bool capsBulgeApart(const SweepCage& cage)
{
  const OwnBulges own = ownBulges(cage, quadLaplacian(cage.target, cage.quads));
  const double least = LeastBulge * cage.boundary.meanColumnLength /
    static_cast<double>(cage.boundary.numberOfLayers());
  return own.onSource.rowwise().norm().maxCoeff() > least ||
    own.onTarget.rowwise().norm().maxCoeff() > least;
}
}
