// SPDX-License-Identifier: BSD-3-Clause
// What cannot be computed with is refused by name, and nothing else is.
#include "Core/Geometry/CoordinateRange.h"

#include "Support/CapMeshes.h"

#include <gtest/gtest.h>

#include <limits>

namespace TestCoordinateRange
{
using hexsweep::checkCoordinates;
using hexsweep::Points;
using hexsweep::TriangleMesh;

TriangleMesh scaled(double factor, double offset)
{
  TriangleMesh mesh = test::plate(3, {});
  mesh.points = (mesh.points * factor).array() + offset;
  return mesh;
}

void check(const TriangleMesh& mesh)
{
  checkCoordinates(mesh.points, mesh.triangles, "target surface");
}

TEST(CoordinateRange, LengthsWhoseVolumesAreNumbersPass)
{
  for (const double factor : { 1e-49, 1e-10, 1.0, 1e10, 1e49 })
  {
    EXPECT_NO_THROW(check(scaled(factor, 0.0))) << factor;
  }
  for (const double factor : { 1e-49, 1e-10, 1.0, 1e10, 1e39 })
  {
    // As far away as a survey in millimetres.
    EXPECT_NO_THROW(check(scaled(factor, 1e10 * factor))) << factor;
  }
}

TEST(CoordinateRange, OthersAreRefusedByName)
{
  test::expectInvalid([] { check(scaled(1e51, 0.0)); }, "the target surface: point ");
  test::expectInvalid([] { check(scaled(1e155, 0.0)); }, "is too far out");
  test::expectInvalid([] { check(scaled(1e-52, 0.0)); }, "it has a size of 1e-52 at (");
  test::expectInvalid([] { check(scaled(1.0, 1e15)); }, "Move the mesh nearer to the origin");
  for (const double bad :
    { std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
  {
    TriangleMesh mesh = scaled(1.0, 0.0);
    mesh.points(5, 1) = bad;
    test::expectInvalid([&] { check(mesh); }, "point 5 has a coordinate that is not a finite");
  }
}

TEST(CoordinateRange, PointsOfNoFaceMayBeAnything)
{
  TriangleMesh mesh = scaled(1.0, 0.0);
  mesh.points.conservativeResize(mesh.points.rows() + 1, Eigen::NoChange);
  mesh.points.bottomRows<1>().setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_NO_THROW(check(mesh));
}
}
