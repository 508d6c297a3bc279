// SPDX-License-Identifier: BSD-3-Clause
// Rings of prisms whose angles are known.
#include "Core/Linking/RingQuads.h"

#include <gtest/gtest.h>

#include <cmath>

namespace TestRingQuads
{
constexpr double Pi = 3.141592653589793;

/// Round the z axis, every second node higher by `leap`.
hexsweep::Points ring(double height, double leap)
{
  constexpr int N = 36;
  hexsweep::Points points(N, 3);
  for (int j = 0; j < N; ++j)
  {
    const double angle = 2.0 * Pi * j / N;
    points.row(j) << std::cos(angle), std::sin(angle), height + (j % 2 == 0 ? leap : 0.0);
  }
  return points;
}

TEST(RingQuads, UprightQuadsAreSquare)
{
  EXPECT_NEAR(hexsweep::cornerSines(ring(0.0, 0.0), ring(0.5, 0.0)).least, 1.0, 1e-14);
}

TEST(RingQuads, LeapingRingsMakeParallelograms)
{
  const double step = 2.0 * std::sin(Pi / 36.0);
  for (const double leap : { 0.1, 0.5, 2.0 })
  {
    // Angle between the upright and an edge that rises by the leap over a step.
    EXPECT_NEAR(hexsweep::cornerSines(ring(0.0, leap), ring(0.5, leap)).least,
      step / std::hypot(step, leap), 1e-12);
  }
}

TEST(RingQuads, CrossedQuadsAndQuadsWithoutLengthAreNegative)
{
  EXPECT_LT(hexsweep::cornerSines(ring(0.0, 0.3), ring(0.1, 0.0)).least, 0.0);
  EXPECT_EQ(hexsweep::cornerSines(ring(0.0, 0.0), ring(0.0, 0.0)).least, -1.0);
}
}
