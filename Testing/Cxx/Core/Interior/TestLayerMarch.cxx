// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/LayerMarch.h"

#include "Core/Common/Errors.h"
#include "Core/Hexahedra/HexQuality.h"
#include "Core/Interior/BlendInterior.h"
#include "Core/Interior/SweptHexes.h"
#include "Core/Solvers/DirichletSolver.h"
#include "Core/Solvers/QuadLaplacian.h"
#include "Support/InteriorTests.h"

#include <algorithm>
#include <limits>
#include <string>

namespace TestLayerMarch
{
using hexsweep::blendInterior;
using hexsweep::Index;
using hexsweep::layerMarchInterior;
using hexsweep::Points;
using test::Sweep;

const double Pi = std::acos(-1.0);

hexsweep::HexQualitySummary judge(const Sweep& sweep, const Points& points)
{
  return hexsweep::summarize(hexsweep::hexQualities(
    points, hexsweep::sweptHexes(sweep.quads, points, sweep.numberOfLayers)));
}

/// A round plate with a round hole that turns against the rim: columns are logarithmic spirals.
/// @param turn angle of the hole at t; @param sag height of a saddle that turns over on the way.
Sweep turningHole(
  int around, int across, int layers, const std::function<double(double)>& turn, double sag = 0.0)
{
  hexsweep::PlanePoints cap(around * (across + 1), 2);
  hexsweep::Quads quads(around * across, 4);
  for (int j = 0; j <= across; ++j)
  {
    for (int i = 0; i < around; ++i)
    {
      cap.row(j * around + i) << 2.0 * Pi * i / around, 1.0 * j / across;
      if (j < across)
      {
        const int next = (i + 1) % around;
        quads.row(j * around + i) << j * around + i, (j + 1) * around + i, (j + 1) * around + next,
          j * around + next;
      }
    }
  }
  return test::sweepCap(
    cap, quads, test::evenLayers(layers), [=](double angle, double outward, double t) {
      const double at = angle + turn(t) * (1.0 - outward);
      const double radius = 0.3 * std::pow(1.0 / 0.3, outward);
      const double x = radius * std::cos(at);
      const double y = radius * std::sin(at);
      return Eigen::RowVector3d(x, y, 2.0 * t + sag * (1.0 - 2.0 * t) * (x * x - y * y));
    });
}

TEST(LayerMarch, AffineSweepsAreExact)
{
  test::expectAffineSweepsExact(layerMarchInterior);
}

TEST(LayerMarch, AnySizeAnywhere)
{
  test::expectAnySizeAnywhere(layerMarchInterior);
}

TEST(LayerMarch, SimilaritySweepsOfACurvedCapAreExact)
{
  test::expectSimilaritySweepOfACurvedCapExact(layerMarchInterior);
}

TEST(LayerMarch, AffineSweepsOfACapWithCurvedLoopsAreExact)
{
  const auto motion = [](double x, double y, double t) -> Eigen::RowVector3d {
    const Eigen::Vector3d point(
      x, y, 0.4 * (x - 1) * (x - 1) - 0.6 * (y - 0.5) * (y - 0.5) + 0.1 * std::sin(3 * x + 5 * y));
    Eigen::Matrix3d shape;
    shape << 1 + 0.5 * t, 0.4 * t, 0.3 * t, -0.2 * t, 1 - 0.3 * t, 0.2 * t, 0.1 * t, -0.3 * t,
      1 + 0.4 * t;
    const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.2 * t, Eigen::Vector3d(0.3, 1, 0.2).normalized()).toRotationMatrix();
    return Eigen::RowVector3d((turn * shape * point).transpose()) +
      Eigen::RowVector3d(std::sin(t), 0.3 * t * t, 6 * t);
  };
  for (const bool hole : { false, true })
  {
    const Sweep sweep = test::makeSweep(12, 9, hole, test::evenLayers(6), motion);
    EXPECT_LT(test::greatestDistance(test::run(layerMarchInterior, sweep), sweep.layers),
      1e-12 * test::sizeOf(sweep));
  }
}

TEST(LayerMarch, BoundaryIsKeptBitForBit)
{
  test::expectBoundaryBitForBit(layerMarchInterior);
}

TEST(LayerMarch, NearlyPlanarLoopsAreTame)
{
  test::expectNearlyPlanarLoopsTame(layerMarchInterior);
}

TEST(LayerMarch, KeepsTheContract)
{
  test::expectInteriorContract(layerMarchInterior);
}

TEST(LayerMarch, HalfWayItIsTheMeanOfOneStepFromEitherCap)
{
  const Sweep sweep =
    test::makeSweep(12, 9, true, test::evenLayers(2), [](double x, double y, double t) {
      return Eigen::RowVector3d(
        x + 0.04 * t * std::sin(3 * y), y + 0.05 * t * x * x, 3 * t + 0.1 * t * std::cos(2 * x));
    });
  auto boundary = test::boundaryOf(sweep);
  boundary.fractions[1] = 0.5;
  const auto stepFrom = [&](const Points& cap, Index layer) -> Points {
    Points next = hexsweep::fitLayerMap(boundary, layer, 1).apply(cap);
    std::vector<bool> fixed(static_cast<std::size_t>(cap.rows()), false);
    Points error = Points::Zero(cap.rows(), 3);
    for (std::size_t j = 0; j < boundary.nodes.size(); ++j)
    {
      fixed[static_cast<std::size_t>(boundary.nodes[j])] = true;
      error.row(boundary.nodes[j]) =
        boundary.rings[1].row(static_cast<Index>(j)) - next.row(boundary.nodes[j]);
    }
    return next +
      hexsweep::DirichletSolver(hexsweep::quadLaplacian(cap, sweep.quads).stiffness, fixed)
        .solve(error);
  };
  const Points expected = 0.5 * (stepFrom(sweep.source, 0) + stepFrom(sweep.target, 2));
  const Points swept = layerMarchInterior({ sweep.source, sweep.target, sweep.quads, boundary });
  const Index n = sweep.source.rows();
  EXPECT_LT(test::greatestDistance(swept.middleRows(n, n), expected), 1e-13);
}

TEST(LayerMarch, SweptBackwardsItIsTheSame)
{
  const Sweep sweep = test::makeSweep(12, 9, true, test::evenLayers(6), test::bendingMotion);
  const Sweep back = test::makeSweep(12, 9, true, test::evenLayers(6),
    [](double x, double y, double t) { return test::bendingMotion(x, y, 1 - t); });
  const Points forth = test::run(layerMarchInterior, sweep);
  const Points reversed = test::run(layerMarchInterior, back);
  const Index n = sweep.source.rows();
  for (Index k = 0; k <= 6; ++k)
  {
    EXPECT_LT(
      test::greatestDistance(forth.middleRows(k * n, n), reversed.middleRows((6 - k) * n, n)),
      1e-12);
  }
}

TEST(LayerMarch, MirroredInputGivesTheMirroredMesh)
{
  const Sweep sweep = test::makeSweep(12, 9, true, test::evenLayers(6), test::bendingMotion);
  Sweep mirrored = sweep;
  for (Points* points : { &mirrored.source, &mirrored.target, &mirrored.linkingPoints })
  {
    points->col(1) *= -1;
  }
  Points expected = test::run(layerMarchInterior, sweep);
  expected.col(1) *= -1;
  EXPECT_LT(test::greatestDistance(test::run(layerMarchInterior, mirrored), expected), 1e-12);
}

TEST(LayerMarch, AHoleMayTurnHalfRound)
{
  // The spirals are valid and nothing between the given caps needs to be worse than they are.
  for (const double sag : { 0.0, 0.3 })
  {
    const Sweep sweep = turningHole(
      48, 12, 12, [](double t) { return Pi * t; }, sag);
    const auto truth = judge(sweep, sweep.layers);
    ASSERT_EQ(truth.notCertified, 0);
    EXPECT_GT(judge(sweep, test::run(blendInterior, sweep)).inverted, 0);
    const auto marched = judge(sweep, test::run(layerMarchInterior, sweep));
    EXPECT_EQ(marched.notCertified, 0);
    EXPECT_GT(marched.minScaledJacobian, 0.95 * truth.minScaledJacobian);
  }
}

TEST(LayerMarch, AHoleMayTurnAndComeBack)
{
  // The caps are the same; all of the turn is between them.
  const Sweep sweep =
    turningHole(48, 12, 12, [](double t) { return 7.0 / 18.0 * Pi * std::sin(Pi * t); });
  ASSERT_EQ(judge(sweep, sweep.layers).notCertified, 0);
  EXPECT_GT(judge(sweep, test::run(blendInterior, sweep)).inverted, 0);
  EXPECT_EQ(judge(sweep, test::run(layerMarchInterior, sweep)).notCertified, 0);
}

TEST(LayerMarch, FewLayersAreMarchedInParts)
{
  // 60 degrees a layer: one step each way would fold.
  const Sweep sweep = turningHole(48, 12, 3, [](double t) { return Pi * t; });
  EXPECT_EQ(judge(sweep, test::run(layerMarchInterior, sweep)).notCertified, 0);
}

TEST(LayerMarch, ReportsProgressAndAborts)
{
  const Sweep sweep = test::makeSweep(6, 5, false, test::evenLayers(8), test::bendingMotion);
  const auto boundary = test::boundaryOf(sweep);
  std::vector<double> reported;
  layerMarchInterior({ sweep.source, sweep.target, sweep.quads, boundary }, [&](double fraction) {
    reported.push_back(fraction);
    return true;
  });
  EXPECT_GE(reported.size(), 14U);
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_GE(reported.front(), 0.0);
  EXPECT_EQ(reported.back(), 1.0);
  EXPECT_THROW(layerMarchInterior({ sweep.source, sweep.target, sweep.quads, boundary },
                 [](double fraction) { return fraction < 0.5; }),
    hexsweep::Aborted);
}

TEST(LayerMarch, NamesTheLayerThatCannotBeCarriedOn)
{
  const Sweep sweep = test::makeSweep(6, 5, false, test::evenLayers(4), test::bendingMotion);
  const auto boundary = test::boundaryOf(sweep);
  Points broken = sweep.target;
  std::vector<bool> onLoop(static_cast<std::size_t>(broken.rows()), false);
  for (const Index i : boundary.nodes)
  {
    onLoop[static_cast<std::size_t>(i)] = true;
  }
  const auto inner = std::find(onLoop.begin(), onLoop.end(), false) - onLoop.begin();
  broken(inner, 1) = std::numeric_limits<double>::quiet_NaN();
  try
  {
    layerMarchInterior({ sweep.source, broken, sweep.quads, boundary });
    FAIL() << "a cap that is not finite was carried on";
  }
  catch (const hexsweep::SolverFailure& failure)
  {
    EXPECT_NE(std::string(failure.what()).find("layer 4"), std::string::npos) << failure.what();
  }
}
}
