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

TEST(EdgeHalving, RefusesMoreTrianglesThanCanBeMade)
{
  const TriangleMesh plate = test::plate(2, {});
  for (const double longest : { 1e-9, 1e-300, 0.0, std::nan("") })
  {
    test::expectInvalid([&] { halveLongEdges(plate, longest); }, "triangles");
  }
}
}
