// SPDX-License-Identifier: BSD-3-Clause
// Numbers in messages.
#include "Core/Common/Describe.h"

#include <gtest/gtest.h>

#include <limits>

namespace TestDescribe
{
TEST(Describe, NumbersAreShort)
{
  EXPECT_EQ(hexsweep::describe(0.25), "0.25");
  EXPECT_EQ(hexsweep::describe(1e-6), "1e-06");
  EXPECT_EQ(hexsweep::describe(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(Describe, WhatIsNoNumberHasNoSign)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(hexsweep::describe(nan), "nan");
  EXPECT_EQ(hexsweep::describe(-nan), "nan");
  EXPECT_EQ(hexsweep::describe(Eigen::RowVector3d(1.0, -nan, 2.0)), "(1, nan, 2)");
}
}
