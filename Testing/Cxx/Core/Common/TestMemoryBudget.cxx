// SPDX-License-Identifier: BSD-3-Clause
// Meshes that are too large are refused with their numbers before memory is taken.
#include "Core/Common/MemoryBudget.h"

#include "Support/CapMeshes.h"

#include <gtest/gtest.h>

#include <limits>

namespace TestMemoryBudget
{
TEST(MemoryBudget, WhatFitsIsNotRefused)
{
  EXPECT_TRUE(hexsweep::fitsIntoMemory(0.0));
  EXPECT_TRUE(hexsweep::fitsIntoMemory(1e6));
  EXPECT_NO_THROW(hexsweep::checkHexBudget(0.0, "Mend it."));
  EXPECT_NO_THROW(hexsweep::checkHexBudget(1e5, "Mend it."));
}

TEST(MemoryBudget, WhatDoesNotIsToldWithItsNumbers)
{
  EXPECT_FALSE(hexsweep::fitsIntoMemory(1e18));
  EXPECT_FALSE(hexsweep::fitsIntoMemory(1e300));
  EXPECT_FALSE(hexsweep::fitsIntoMemory(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(hexsweep::fitsIntoMemory(std::numeric_limits<double>::quiet_NaN()));
  test::expectInvalid([] { hexsweep::checkHexBudget(1.23456e15, "Ask for fewer."); },
    "about 1.23e+15 hexahedra, which take 494000000 gigabytes: more than there are. Ask for "
    "fewer.");
  for (const double hexes : { 1e300, std::numeric_limits<double>::infinity() })
  {
    test::expectInvalid([&] { hexsweep::checkHexBudget(hexes, "Ask for fewer."); }, " hexahedra");
  }
}
}
