// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/UsedPoints.h"

#include "Support/CapMeshes.h"

#include <gtest/gtest.h>

#include <vector>

namespace TestUsedPoints
{
TEST(UsedPoints, AreThoseOfFaces)
{
  const auto triangles = test::facesOf<hexsweep::Triangles>({ 5, 1, 2, 2, 1, 7 });
  EXPECT_EQ(hexsweep::usedPoints(triangles, 9),
    (std::vector<bool>{ false, true, true, false, false, true, false, true, false }));
  const auto quads = test::facesOf<hexsweep::Quads>({ 0, 1, 4, 3 });
  EXPECT_EQ(hexsweep::usedPoints(quads, 5), (std::vector<bool>{ true, true, false, true, true }));
  EXPECT_EQ(hexsweep::usedPoints(quads.topRows(0), 2), (std::vector<bool>{ false, false }));
}
}
