// SPDX-License-Identifier: BSD-3-Clause
// Halving ends: with short edges, or with words where an edge cannot be halved.
#include "Core/Surfaces/EdgeHalving.h"

#include "Support/CapMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace TestEdgeHalving
{
using hexsweep::HalvedSurface;
using hexsweep::halveLongEdges;
using hexsweep::Index;
using hexsweep::longestEdgeFor;
using hexsweep::TriangleMesh;

double longestEdge(const TriangleMesh& mesh)
{
  double longest = 0.0;
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      longest = std::max(longest,
        (mesh.points.row(mesh.triangles(t, c)) - mesh.points.row(mesh.triangles(t, (c + 1) % 3)))
          .norm());
    }
  }
  return longest;
}

TEST(EdgeHalving, LeavesTheShapeAndNoLongEdge)
{
  const TriangleMesh plate = test::curvedPlate(2, 0.2);
  const double longest = 0.3 * longestEdge(plate);
  const HalvedSurface halved = halveLongEdges(plate, longest);
  EXPECT_LE(longestEdge(halved.mesh), longest);
  EXPECT_NEAR(
    test::surfaceArea(halved.mesh), test::surfaceArea(plate), 1e-12 * test::surfaceArea(plate));
}

TEST(EdgeHalving, StopsWhereNumbersEnd)
{
  TriangleMesh far = test::plate(2, {});
  far.points = (4.0 * far.points).array() + 0x1p53; // where numbers are whole and even
  far.points.col(2).setZero();
  test::expectInvalid([&] { halveLongEdges(far, 0.3); }, "cannot be halved");
}

TEST(EdgeHalving, FindsTheLengthForSomeTriangles)
{
  const TriangleMesh plate = test::plate(2, {});
  const double longest = longestEdgeFor(plate, 100.0);
  EXPECT_EQ(longest, std::sqrt(2.0 * test::surfaceArea(plate) / 100.0));
  const Index made = halveLongEdges(plate, longest).mesh.triangles.rows();
  EXPECT_GE(made, 100);
  EXPECT_LE(made, 400);
}

TEST(EdgeHalving, DoesNotCutSlenderTrianglesEndlessly)
{
  for (const double stretch : { 1e6, 1e12, 1e40 })
  {
    TriangleMesh slender = test::plate(2, {});
    slender.points.col(0) *= stretch;
    slender.points.col(1) /= stretch;
    const double byArea = std::sqrt(2.0 * test::surfaceArea(slender) / 10.0);
    if (stretch > 1e9)
    {
      test::expectInvalid([&] { halveLongEdges(slender, byArea); }, "triangles");
    }
    const HalvedSurface halved = halveLongEdges(slender, longestEdgeFor(slender, 10.0));
    EXPECT_LE(halved.mesh.triangles.rows(), 1500);
  }
  TriangleMesh line = test::plate(2, {});
  line.points.col(1).setZero();
  test::expectInvalid([&] { longestEdgeFor(line, 10.0); }, "no area");
}

TEST(EdgeHalving, RefusesMoreTrianglesThanCanBeMade)
{
  const TriangleMesh plate = test::plate(2, {});
  for (const double longest : { 1e-9, 1e-300, 0.0, std::nan("") })
  {
    test::expectInvalid([&] { halveLongEdges(plate, longest); }, "triangles");
  }
}
}
