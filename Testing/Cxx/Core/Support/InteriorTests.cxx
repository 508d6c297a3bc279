// SPDX-License-Identifier: BSD-3-Clause

#include "Support/InteriorTests.h"

#include "Core/Common/Errors.h"
#include "Core/Common/ParallelFor.h"

namespace test
{
hexsweep::SweepBoundary boundaryOf(const Sweep& sweep)
{
  const auto loops = hexsweep::checkSurface(sweep.quads, sweep.source.rows(), "source quads").loops;
  const auto rings =
    hexsweep::traceLinkingRings(sweep.source, loops, sweep.linkingPoints, sweep.linkingQuads);
  return hexsweep::gatherSweepBoundary(sweep.source, sweep.target, rings);
}

hexsweep::SweepCage cageOf(const Sweep& sweep)
{
  return { sweep.source, sweep.target, sweep.quads, boundaryOf(sweep) };
}

Points run(InteriorFill interior, const Sweep& sweep)
{
  return interior(cageOf(sweep), {}, {});
}

double sizeOf(const Sweep& sweep)
{
  return (sweep.layers.colwise().maxCoeff() - sweep.layers.colwise().minCoeff()).norm();
}

void expectAffineSweepsExact(InteriorFill interior)
{
  for (const bool hole : { false, true })
  {
    for (const auto& positions :
      { evenLayers(6), std::vector<double>{ 0, 0.02, 0.1, 0.3, 0.7, 1 } })
    {
      const Sweep sweep = makeSweep(12, 9, hole, positions, affineMotion);
      EXPECT_LT(greatestDistance(run(interior, sweep), sweep.layers), 1e-12 * sizeOf(sweep));
    }
  }
}

void expectAnySizeAnywhere(InteriorFill interior)
{
  const Sweep plain = makeSweep(12, 9, true, evenLayers(5), affineMotion);
  for (const double scale : { 1e-6, 1e6 })
  {
    const Sweep sized = placed(plain, scale, Eigen::RowVector3d::Zero());
    EXPECT_LT(greatestDistance(run(interior, sized), sized.layers), 1e-12 * sizeOf(sized));
    const Sweep far = placed(plain, scale, 1e6 * scale * Eigen::RowVector3d(2, -3, 1));
    // Coordinates keep ten digits of the size there.
    EXPECT_LT(greatestDistance(run(interior, far), far.layers), 1e-8 * sizeOf(far));
  }
}

void expectSimilaritySweepOfACurvedCapExact(InteriorFill interior)
{
  const Motion motion = [](double x, double y, double t) {
    // Bulges inside, planar on the outer loop.
    const double bulge = 0.3 * x * (2 - x) * y * (1 - y) * 4;
    const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1 * t, Eigen::Vector3d(1, 2, 0.5).normalized()).toRotationMatrix();
    const Eigen::Vector3d path(2 * std::sin(t), 0, 1.5 * t);
    return Eigen::RowVector3d(
      ((1 + 0.5 * t) * (turn * Eigen::Vector3d(x, y, bulge)) + path).transpose());
  };
  const Sweep sweep = makeSweep(12, 9, false, evenLayers(6), motion);
  EXPECT_LT(greatestDistance(run(interior, sweep), sweep.layers), 1e-12 * sizeOf(sweep));
}

Eigen::RowVector3d bendingMotion(double x, double y, double t)
{
  const Eigen::RowVector3d affine = affineMotion(x, y, t);
  return affine +
    t * Eigen::RowVector3d(0.08 * std::sin(3 * y), 0.1 * x * x * (1 - t), 0.06 * std::cos(2 * x));
}

void expectBoundaryBitForBit(InteriorFill interior)
{
  const Sweep sweep = makeSweep(12, 9, true, evenLayers(6), bendingMotion);
  const Points swept = run(interior, sweep);
  const Index n = sweep.source.rows();
  ASSERT_EQ(swept.rows(), 7 * n);
  EXPECT_TRUE(swept.allFinite());
  EXPECT_EQ(swept.topRows(n), sweep.source);
  EXPECT_EQ(swept.bottomRows(n), sweep.target);
  for (Index k = 0; k <= 6; ++k)
  {
    for (const Index id : boundaryOf(sweep).nodes)
    {
      EXPECT_EQ(swept.row(k * n + id), sweep.layers.row(k * n + id));
    }
  }
}

void expectNearlyPlanarLoopsTame(InteriorFill interior)
{
  for (const double noise : { 1e-9, 1e-5, 1e-3 })
  {
    const Motion motion = [noise](double x, double y, double t) {
      const double bulge = 0.5 * x * (2 - x) * y * (1 - y) * 4;
      const double shake = noise * std::sin(97 * x + 83 * y + 71 * t);
      return Eigen::RowVector3d(x, y, bulge + shake + 2 * t);
    };
    const Sweep sweep = makeSweep(12, 9, false, evenLayers(6), motion);
    EXPECT_LT(greatestDistance(run(interior, sweep), sweep.layers), 20 * noise);
  }
}

Motion cubesMotion(int nx, int layers)
{
  return [=](double x, double y, double t) {
    // The cap's bumps are smaller than half a step.
    const double step = 2.0 / nx;
    return Eigen::RowVector3d(
      step * std::round(x / step), step * std::round(y / step), step * layers * t);
  };
}

void expectInteriorContract(InteriorFill interior, double rounding)
{
  Sweep sweep = makeSweep(12, 9, true, evenLayers(6), bendingMotion);
  const Index n = sweep.source.rows();
  const auto boundary = boundaryOf(sweep);
  const auto run = [&](
                     const hexsweep::ParallelFor& parallelFor, const hexsweep::Progress& progress) {
    return interior({ sweep.source, sweep.target, sweep.quads, boundary }, progress, parallelFor);
  };
  const Points swept = run({}, {});
  EXPECT_TRUE(swept.allFinite());
  EXPECT_EQ(swept.topRows(n), sweep.source);
  EXPECT_EQ(swept.bottomRows(n), sweep.target);
  for (Index k = 0; k <= 6; ++k)
  {
    for (const Index id : boundary.nodes)
    {
      EXPECT_EQ(swept.row(k * n + id), sweep.layers.row(k * n + id));
    }
  }

  const hexsweep::ParallelFor backwards = [](Index count, const std::function<void(Index)>& call) {
    for (Index i = count; i-- > 0;)
    {
      call(i);
    }
  };
  EXPECT_EQ(run(backwards, {}), swept);

  double last = -1.0;
  int reports = 0;
  run({}, [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return ++reports > 0;
  });
  EXPECT_EQ(last, 1.0);
  EXPECT_THROW(run({}, [](double fraction) { return fraction == 0.0; }), hexsweep::Aborted);

  sweep.source.conservativeResize(n + 1, 3);
  sweep.target.conservativeResize(n + 1, 3);
  sweep.source.row(n) << 10, 20, 30;
  sweep.target.row(n) << 14, 20, 34;
  const Points withUnused = run({}, {});
  for (Index k = 0; k <= 6; ++k)
  {
    const double t = boundary.fractions[static_cast<std::size_t>(k)];
    const Eigen::RowVector3d expected(10 + 4 * t, 20, 30 + 4 * t);
    EXPECT_LT((withUnused.row(k * (n + 1) + n) - expected).norm(), 1e-12);
    EXPECT_LE(greatestDistance(withUnused.middleRows(k * (n + 1), n), swept.middleRows(k * n, n)),
      rounding);
  }

  // An upright step across both caps: the model slides along itself there, and points inside lie
  // on its faces.
  const Sweep stair = makeSweep(12, 6, false, evenLayers(4), [](double x, double y, double t) {
    const Eigen::RowVector3d grid = cubesMotion(12, 4)(x, y, t);
    const double side = grid.x() < 0.6 ? 0.0 : 1.0;
    return Eigen::RowVector3d(grid + side * Eigen::RowVector3d(-1.0 / 6, 0, 0.5));
  });
  EXPECT_TRUE(interior(cageOf(stair), {}, {}).allFinite());

  const Sweep oneLayer = makeSweep(6, 5, false, evenLayers(1), bendingMotion);
  EXPECT_EQ(interior(cageOf(oneLayer), {}, {}), oneLayer.layers);
}
}
