// SPDX-License-Identifier: BSD-3-Clause
// Rings along curves that are known.
#include "Core/Interior/RingAdvance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace TestRingAdvance
{
using hexsweep::Points;
using hexsweep::SweepBoundary;

constexpr double Pi = 3.141592653589793;

/// Circles of a radius about the z axis at a height, moved by `place`.
SweepBoundary rings(int layers, const std::function<double(double)>& radius,
  const std::function<double(double)>& height,
  const std::function<Eigen::RowVector3d(const Eigen::RowVector3d&, double)>& place = {})
{
  constexpr int n = 32;
  SweepBoundary boundary;
  boundary.outerSize = n;
  for (int k = 0; k <= layers; ++k)
  {
    const double t = static_cast<double>(k) / layers;
    Points ring(n, 3);
    for (int j = 0; j < n; ++j)
    {
      const double angle = 2.0 * Pi * j / n;
      const Eigen::RowVector3d p(
        radius(t) * std::cos(angle), radius(t) * std::sin(angle), height(t));
      ring.row(j) = place ? place(p, t) : p;
    }
    boundary.rings.push_back(ring);
  }
  return boundary;
}

TEST(RingAdvance, StraightAndBentSweepsOnlyAdvance)
{
  const auto one = [](double t) { return 1.0 + t; };
  const auto up = [](double t) { return 3.0 * t; };
  EXPECT_EQ(backwardShare(rings(10, one, up)), 0.0);
  EXPECT_EQ(backwardShare(rings(10, one, [](double t) { return -3.0 * t; })), 0.0);
  // Round three quarters of a circle about the line x = 5, z = 0.
  const auto bend = [](const Eigen::RowVector3d& p, double t) -> Eigen::RowVector3d {
    const double turn = 1.5 * Pi * t;
    return { 5.0 + (p.x() - 5.0) * std::cos(turn), p.y(), -(p.x() - 5.0) * std::sin(turn) };
  };
  EXPECT_EQ(backwardShare(rings(
              30, [](double) { return 1.0; }, [](double) { return 0.0; }, bend)),
    0.0);
}

TEST(RingAdvance, ThroughAWallThereIsNoWayBack)
{
  // From the outside of a tube's wall to its inside, with a centre that rounding moves.
  const auto inward = [](double t) { return 3.0 - 0.2 * t; };
  EXPECT_EQ(
    backwardShare(rings(10, inward, [](double t) { return 1e-15 * std::sin(40.0 * t); })), 0.0);
}

TEST(RingAdvance, ACupTurnsBack)
{
  // Up the outside to 30, in over the rim, down the inside to 15.
  const SweepBoundary cup = rings(
    60, [](double t) { return t < 0.6 ? 10.0 : 3.0; },
    [](double t) { return t < 0.6 ? 50.0 * t : 30.0 - 15.0 * (t - 0.6) / 0.4; });
  EXPECT_NEAR(backwardShare(cup), 0.5, 0.02);
}

TEST(RingAdvance, RingsThatGrowInAPlaneDoNotTurnBack)
{
  EXPECT_EQ(backwardShare(rings(
              5, [](double t) { return 1.0 + t; }, [](double) { return 0.0; })),
    0.0);
}
}
