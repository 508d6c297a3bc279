// SPDX-License-Identifier: BSD-3-Clause
// Solids that touch themselves along edges and in points are parted there.
#include "Core/Solids/TouchingSheets.h"

#include "Core/Solids/SolidInput.h"
#include "Support/SolidShapes.h"

namespace TestTouchingSheets
{
using hexsweep::makeSolidSurface;
using hexsweep::SolidOptions;
using hexsweep::SolidSurface;
using test::cubes;
using test::expectInvalid;

/// Two posts on a plate whose edges touch.
bool inTouchingPosts(int x, int y, int z)
{
  return z == 0 || (x == 0 && y == 0) || (x == 1 && y == 1);
}

TEST(TouchingSheets, PostsThatTouchInALineArePartedAboveThePlate)
{
  const test::SolidInput input = cubes({ 2, 2, 3 }, inTouchingPosts);
  expectInvalid([&] { makeSolidSurface(input); }, "4 triangles meet at one edge");
  SolidOptions options;
  options.partTouching = true;
  const SolidSurface parted = makeSolidSurface(input, options);
  // The line from the plate's top to the posts': one point stays, two are there twice.
  EXPECT_EQ(parted.points.rows(), 2 * 9 + 2 * 7 + 2);
  EXPECT_EQ(parted.triangles.rows(), input.triangles.rows());
}

TEST(TouchingSheets, CubesThatTouchInAPointArePartedThere)
{
  const test::SolidInput input = cubes({ 2, 2, 3 }, [](int x, int y, int z) {
    return (z == 0) || (z == 1 && x + y < 2) || (z == 2 && x == 1 && y == 0);
  });
  SolidOptions options;
  options.partTouching = true;
  EXPECT_EQ(makeSolidSurface(input, options).points.rows(), makeSolidSurface(input).points.rows());
}
}
