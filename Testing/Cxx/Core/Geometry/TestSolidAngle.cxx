// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/SolidAngle.h"

#include "Support/SolidShapes.h"

#include <gtest/gtest.h>

namespace TestSolidAngle
{
double angleOf(const test::SolidInput& solid, const Eigen::RowVector3d& eye)
{
  double sum = 0.0;
  for (hexsweep::Index t = 0; t < solid.triangles.rows(); ++t)
  {
    sum += hexsweep::solidAngle(solid.points.row(solid.triangles(t, 0)),
      solid.points.row(solid.triangles(t, 1)), solid.points.row(solid.triangles(t, 2)), eye);
  }
  return sum;
}

TEST(SolidAngle, OfAnOctantIsAnEighthOfTheSphere)
{
  EXPECT_NEAR(hexsweep::solidAngle(
                { 1.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 }, { 0.0, 0.0, 3.0 }, { 0.0, 0.0, 0.0 }),
    0.5 * hexsweep::Pi, 1e-14);
}

TEST(SolidAngle, OfAClosedSurfaceTellsInsideFromOutside)
{
  const test::SolidInput box = test::box(2, 3, 4);
  EXPECT_NEAR(angleOf(box, { 0.3, 1.1, 2.9 }), 4.0 * hexsweep::Pi, 1e-12);
  EXPECT_NEAR(angleOf(box, { 0.3, 1.1, 4.1 }), 0.0, 1e-12);
  EXPECT_NEAR(angleOf(box, { 0.3, 1.1, 4.0 }), 2.0 * hexsweep::Pi, 1e-12);
}
}
