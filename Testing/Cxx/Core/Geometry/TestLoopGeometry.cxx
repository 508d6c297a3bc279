// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/LoopGeometry.h"

#include "Core/Geometry/Circle.h"
#include "Support/CapMeshes.h"

namespace TestLoopGeometry
{
using hexsweep::PlanePoints;
using hexsweep::Points;

/// A rectangle of 3 by 1 in the plane z = 5.
Points rectangle()
{
  Points polygon(4, 3);
  polygon << 0, 0, 5, 3, 0, 5, 3, 1, 5, 0, 1, 5;
  return polygon;
}

TEST(LoopGeometry, LengthsOfARectangle)
{
  EXPECT_EQ(hexsweep::reachedLengths(rectangle()), (std::vector<double>{ 0, 3, 4, 7, 8 }));
  EXPECT_EQ(hexsweep::closedLength(rectangle()), 8.0);
}

TEST(LoopGeometry, AnglesByArcLength)
{
  const std::vector<double> angles = hexsweep::arcLengthAngles(rectangle());
  ASSERT_EQ(angles.size(), 4u);
  const double expected[4] = { 0.0, 3.0 / 8.0, 4.0 / 8.0, 7.0 / 8.0 };
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(angles[i], 2.0 * test::Pi * expected[i], 1e-15);
  }
}

TEST(LoopGeometry, TheNearestPlaceOfAChainIsOnItsSegmentsAndEnds)
{
  Points chain(3, 3);
  chain << 0, 0, 0, 2, 0, 0, 2, 1, 0;
  const auto nearest = [&](double x, double y) {
    return hexsweep::nearestOnChain(chain, Eigen::RowVector3d(x, y, 5.0));
  };
  EXPECT_EQ(nearest(-1.0, -1.0), Eigen::RowVector3d(0, 0, 0));
  EXPECT_EQ(nearest(0.5, -1.0), Eigen::RowVector3d(0.5, 0, 0));
  EXPECT_EQ(nearest(3.0, 0.25), Eigen::RowVector3d(2, 0.25, 0));
  // The chain is open: nothing leads back.
  EXPECT_EQ(nearest(1.9, 4.0), Eigen::RowVector3d(2, 1, 0));
  EXPECT_EQ(nearest(0.5, 0.4), Eigen::RowVector3d(0.5, 0, 0));
  EXPECT_EQ(hexsweep::nearestOnChain(chain.topRows(1), Eigen::RowVector3d(7, 8, 9)),
    Eigen::RowVector3d(0, 0, 0));
}

TEST(LoopGeometry, TheLongestLoopCountsItsClosingEdge)
{
  Points points(6, 3);
  points << 0, 0, 0, 4, 0, 0, 4, 3, 0, 10, 0, 0, 14, 0, 0, 17, 0, 0;
  // 3-4-5 is 12 long; the flat triangle 14, of which 7 are the way back.
  EXPECT_EQ(hexsweep::longestLoop(points, { { 0, 1, 2 }, { 3, 4, 5 } }), 1u);
  EXPECT_EQ(hexsweep::longestLoop(points, { { 3, 4, 5 }, { 0, 1, 2 } }), 0u);
  EXPECT_EQ(hexsweep::longestLoop(points, { { 0, 1, 2 }, { 1, 2, 0 } }), 0u);
}

TEST(LoopGeometry, OneTurnNeitherStandsStillNorGoesBeyond)
{
  EXPECT_TRUE(hexsweep::turnsOnce({ 1.0, 3.0, 7.0 }, 1.0));
  EXPECT_FALSE(hexsweep::turnsOnce({ 1.0, 3.0, 7.0 }, -1.0));
  EXPECT_TRUE(hexsweep::turnsOnce({ 1.0, -1.0, -5.0 }, -1.0));
  EXPECT_FALSE(hexsweep::turnsOnce({ 1.0, 1.0, 7.0 }, 1.0));
  EXPECT_FALSE(hexsweep::turnsOnce({ 1.0, 3.0, 2.0 }, 1.0));
  // 7.3 - 1 is more than 2 pi.
  EXPECT_FALSE(hexsweep::turnsOnce({ 1.0, 3.0, 7.3 }, 1.0));
}

TEST(Circle, PointsAtAngles)
{
  const PlanePoints points =
    hexsweep::circlePoints({ { 1.0, 2.0 }, 3.0 }, { 0.0, test::Pi / 2.0, test::Pi });
  EXPECT_LT((points.row(0) - Eigen::RowVector2d(4, 2)).norm(), 1e-15);
  EXPECT_LT((points.row(1) - Eigen::RowVector2d(1, 5)).norm(), 1e-15);
  EXPECT_LT((points.row(2) - Eigen::RowVector2d(-2, 2)).norm(), 1e-15);
}
}
