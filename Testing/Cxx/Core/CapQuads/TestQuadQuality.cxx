// SPDX-License-Identifier: BSD-3-Clause
// Closed forms of the scaled Jacobian.
#include "Core/CapQuads/QuadQuality.h"

#include "Support/CapMeshes.h"

#include <array>

namespace TestQuadQuality
{
using hexsweep::Index;
using hexsweep::Points;
using hexsweep::QuadQuality;
using hexsweep::Quads;

Quads oneQuad()
{
  return test::facesOf<Quads>({ 0, 1, 2, 3 });
}

Points up(Index n)
{
  return Eigen::RowVector3d(0, 0, 1).replicate(n, 1);
}

Points corners(std::initializer_list<std::array<double, 2>> xy)
{
  Points points(static_cast<Index>(xy.size()), 3);
  Index i = 0;
  for (const auto& p : xy)
  {
    points.row(i++) << p[0], p[1], 0.0;
  }
  return points;
}

double scaledJacobian(const Points& points)
{
  return hexsweep::quadQuality(points, oneQuad(), up(4)).scaledJacobian[0];
}

TEST(QuadQuality, SquareAndRectangleAreOne)
{
  EXPECT_NEAR(scaledJacobian(corners({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } })), 1.0, 1e-15);
  EXPECT_NEAR(scaledJacobian(corners({ { 0, 0 }, { 9, 0 }, { 9, 1 }, { 0, 1 } })), 1.0, 1e-15);
}

TEST(QuadQuality, ParallelogramIsTheSineOfItsAngle)
{
  for (double angle = 0.1; angle < 3.1; angle += 0.1)
  {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    EXPECT_NEAR(scaledJacobian(corners({ { 0, 0 }, { 2, 0 }, { 2 + c, s }, { c, s } })),
      std::sin(angle), 1e-14);
  }
}

TEST(QuadQuality, DartIsInverted)
{
  // The reflex corner at (0.25, 0.25): edges to (1, 0) and (0, 1).
  const double expected = -(0.75 * 0.75 - 0.25 * 0.25) / (0.75 * 0.75 + 0.25 * 0.25);
  EXPECT_NEAR(
    scaledJacobian(corners({ { 0, 0 }, { 1, 0 }, { 0.25, 0.25 }, { 0, 1 } })), expected, 1e-15);
  const QuadQuality quality = hexsweep::quadQuality(
    corners({ { 0, 0 }, { 1, 0 }, { 0.25, 0.25 }, { 0, 1 } }), oneQuad(), up(4));
  EXPECT_EQ(quality.inverted, 1);
}

TEST(QuadQuality, TriangleIsNotValid)
{
  // Three corners in a line: zero, and counted.
  const QuadQuality quality = hexsweep::quadQuality(
    corners({ { 0, 0 }, { 1, 0 }, { 0.5, 0.5 }, { 0, 1 } }), oneQuad(), up(4));
  EXPECT_EQ(quality.scaledJacobian[0], 0.0);
  EXPECT_EQ(quality.inverted, 1);
}

TEST(QuadQuality, AnEdgeWithoutLengthIsNotANumberAndCounts)
{
  const Quads quads = test::facesOf<Quads>({ 0, 1, 2, 3, 1, 4, 5, 2 });
  const Points points = corners({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 2, 0 }, { 2, 0 } });
  const QuadQuality quality = hexsweep::quadQuality(points, quads, up(6));
  EXPECT_NEAR(quality.scaledJacobian[0], 1.0, 1e-15);
  EXPECT_TRUE(std::isnan(quality.scaledJacobian[1]));
  EXPECT_EQ(quality.inverted, 1);
  EXPECT_EQ(quality.minimum, -1.0);
}

TEST(QuadQuality, MeanMinimumAndCount)
{
  // A square, a parallelogram of 30 degrees, a dart, side by side.
  const Quads quads = test::facesOf<Quads>({ 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 });
  const double c = std::cos(test::Pi / 6);
  const Points points = corners({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 5, 0 }, { 6, 0 },
    { 6 + c, 0.5 }, { 5 + c, 0.5 }, { 9, 0 }, { 10, 0 }, { 9.25, 0.25 }, { 9, 1 } });
  const QuadQuality quality = hexsweep::quadQuality(points, quads, up(12));
  EXPECT_EQ(quality.inverted, 1);
  EXPECT_NEAR(quality.minimum, -0.8, 1e-14);
  EXPECT_NEAR(quality.mean, (1.0 + 0.5 - 0.8) / 3.0, 1e-14);
}

TEST(QuadQuality, TheSideOfTheNormalsDoesNotMatter)
{
  const hexsweep::QuadMesh mesh = test::quadPlate(8, { { 3, 3, 2, 1 } }, 0.35);
  const Points normals = up(mesh.points.rows());
  const QuadQuality plain = hexsweep::quadQuality(mesh.points, mesh.quads, normals);
  EXPECT_EQ(plain.inverted, 0);
  const QuadQuality down = hexsweep::quadQuality(mesh.points, mesh.quads, -normals);
  EXPECT_EQ(down.scaledJacobian, plain.scaledJacobian);
  const QuadQuality over =
    hexsweep::quadQuality(mesh.points, test::turnedOver(mesh.quads), normals);
  EXPECT_LT((over.scaledJacobian - plain.scaledJacobian).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(QuadQuality, MostQuadsInvertedInsideIsNotTheOtherSide)
{
  // One inner node dragged far out: the mesh's area depends on its boundary alone.
  hexsweep::QuadMesh mesh = test::quadPlate(2, {});
  Index center = 0;
  for (Index i = 0; i < mesh.points.rows(); ++i)
  {
    center = (mesh.points.row(i) - Eigen::RowVector3d(0.5, 0.5, 0)).norm() < 0.1 ? i : center;
  }
  mesh.points.row(center) << 5, 5, 0;
  const QuadQuality quality = hexsweep::quadQuality(mesh.points, mesh.quads, up(9));
  EXPECT_GE(quality.inverted, 3);
  EXPECT_LT(quality.minimum, 0.0);
}

TEST(QuadQuality, SizePlaceAndTurnDoNotMatter)
{
  hexsweep::QuadMesh mesh = test::quadPlate(8, { { 3, 3, 2, 1 } }, 0.35);
  const Points normals = up(mesh.points.rows());
  const QuadQuality plain = hexsweep::quadQuality(mesh.points, mesh.quads, normals);
  for (const test::Placement& placement : test::placements())
  {
    const test::Similarity turn{ 1.0, placement.motion.turn, { 0, 0, 0 } };
    const QuadQuality moved =
      hexsweep::quadQuality(placement.motion(mesh.points), mesh.quads, turn(normals));
    // Rounding over the shortest edge, about 0.04 of the size.
    EXPECT_LT((moved.scaledJacobian - plain.scaledJacobian).cwiseAbs().maxCoeff(),
      100 * placement.relativeRounding)
      << placement.name;
  }
}
}
