// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Common/Describe.h"
#include "Core/Geometry/Reflection.h"

#include <gtest/gtest.h>

#include <cmath>

namespace TestReflection
{
using hexsweep::Points;
using hexsweep::reflected;
using hexsweep::reflectedPlaces;
using hexsweep::Reflection;

TEST(Reflection, IsExactAndItsOwnInverse)
{
  Points points(3, 3);
  points << 0.1, -2.0 / 3.0, 1e300, 1e-300, 0.0, -7.25, 3.0, -0.0, 0.3;
  const Reflection reflection{ { -1.0, 1.0, -1.0 } };
  const Points image = reflected(points, reflection);
  EXPECT_EQ(image(0, 0), -0.1);
  EXPECT_EQ(image(0, 1), -2.0 / 3.0);
  EXPECT_EQ(image(0, 2), -1e300);
  EXPECT_EQ(reflected(image, reflection), points);
  EXPECT_FALSE(std::signbit(reflected(points, { { 1.0, -1.0, 1.0 } })(1, 1)));
  EXPECT_FALSE(std::signbit(image(2, 1)));
}

TEST(Reflection, TurnsOverWithAnOddNumberOfSigns)
{
  EXPECT_FALSE(Reflection().turnsOver());
  EXPECT_TRUE((Reflection{ { 1.0, -1.0, 1.0 } }.turnsOver()));
  EXPECT_FALSE((Reflection{ { -1.0, -1.0, 1.0 } }.turnsOver()));
  EXPECT_TRUE((Reflection{ { -1.0, -1.0, -1.0 } }.turnsOver()));
}

TEST(Reflection, FindsThePlacesInMessages)
{
  const Reflection reflection{ { -1.0, 1.0, -1.0 } };
  const Eigen::RowVector3d place(0.25, -1e-7, -3.5);
  const Eigen::RowVector3d image(-0.25, -1e-7, 3.5);
  const auto message = [](const Eigen::RowVector3d& p) {
    return "loop 1 (a hole, 32 nodes) at " + hexsweep::describe(p) +
      " (cell 3 of face (2)), and (" + hexsweep::describe(p) + ") again";
  };
  EXPECT_EQ(reflectedPlaces(message(place), reflection), message(image));
  EXPECT_EQ(reflectedPlaces(message(place), {}), message(place));
}

TEST(Reflection, LeavesOtherNumbersAlone)
{
  const Reflection reflection{ { -1.0, -1.0, -1.0 } };
  for (const std::string text : { "", "(", "(1, 2)", "(1, 2, 3, 4)", "faces 1, 2 and 3", "(1, 2, 3",
         "( 1, 2, 3)", "(a, b, c)", "f(x, 2, 3)" })
  {
    EXPECT_EQ(reflectedPlaces(text, reflection), text);
  }
  EXPECT_EQ(reflectedPlaces("(0, -0, 0)", reflection), "(0, 0, 0)");
}
}
