// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/RuledShape.h"

#include "Core/Linking/LayerSpacing.h"
#include "Core/Linking/LinkingSideColumns.h"
#include "Support/SideTubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace TestRuledShape
{
using namespace hexsweep;

constexpr Index Around = 48;
constexpr Index Along = 24;

/// Round the square from 0 to 1 in x and y.
Eigen::RowVector3d squarePlace(double v, double height)
{
  const double way = 4.0 * (v - std::floor(v));
  const double s = way - std::floor(way);
  switch (static_cast<int>(way) % 4)
  {
    case 0:
      return { s, 0.0, height };
    case 1:
      return { 1.0, s, height };
    case 2:
      return { 1.0 - s, 1.0, height };
    default:
      return { 0.0, 1.0 - s, height };
  }
}

/// A bar of height 2 with a groove of half widths `wide` (of v) and `high` (of u) in the face y =
/// 0.
test::TubePlace groovedBar(double depth, double wide = 0.05, double high = 0.1)
{
  return [=](double v, double u) {
    Eigen::RowVector3d place = squarePlace(v, 2.0 * u);
    if (std::abs(v - 0.125) < wide && std::abs(u - 0.5) < high)
    {
      place.y() += depth;
    }
    return place;
  };
}

PlacedLoop loopAt(const SideTube& side, Index row)
{
  PlacedLoop loop;
  loop.points = side.surface.points.middleRows(row * Around, Around);
  for (Index j = 0; j < Around; ++j)
  {
    loop.v.push_back(static_cast<double>(j) / Around);
  }
  return loop;
}

std::optional<RuledShape> shapeOf(const SideTube& side, double depthLeft)
{
  return ruledShape(side.surface, loopAt(side, 0), loopAt(side, Along), 1e-3, depthLeft);
}

TEST(RuledShape, LeavesAStepItsPartOfTheDepthAndAllElseAsItIs)
{
  const SideTube side = test::tube(Around, Along, groovedBar(0.2));
  const std::optional<RuledShape> shape = shapeOf(side, 0.25);
  ASSERT_TRUE(shape);
  Index inGroove = 0;
  for (Index i = 0; i < side.surface.points.rows(); ++i)
  {
    Eigen::RowVector3d expected = side.surface.points.row(i);
    const double v = static_cast<double>(i % Around) / Around;
    const bool isGroove = expected.y() == 0.2 && v < 0.25;
    inGroove += isGroove ? 1 : 0;
    expected.y() *= isGroove ? 0.25 : 1.0;
    EXPECT_LT((shape->points.row(i) - expected).norm(), 1e-14);
    EXPECT_EQ(shape->onStep[static_cast<std::size_t>(i)], isGroove);
    const double off = shape->v[static_cast<std::size_t>(i)] - v;
    EXPECT_NEAR(off - std::round(off), 0.0, 1e-12);
  }
  EXPECT_GT(inGroove, 10);
}

TEST(RuledShape, ThereIsNoneWithoutAStepNorWhereHalfIsOne)
{
  EXPECT_FALSE(shapeOf(test::tube(Around, Along, groovedBar(0.0)), 0.5));
  EXPECT_FALSE(shapeOf(test::tube(Around, Along,
                         [](double v, double u) {
                           // Thinner all round but for its ends.
                           const Eigen::RowVector3d place = squarePlace(v, 2.0 * u);
                           const double scale = std::abs(u - 0.5) < 0.4 ? 0.8 : 1.0;
                           return Eigen::RowVector3d(0.5 + scale * (place.x() - 0.5),
                             0.5 + scale * (place.y() - 0.5), place.z());
                         }),
    0.5));
  // Twisted: lines of a ruled surface need not be parallel.
  EXPECT_FALSE(shapeOf(test::tube(Around, Along,
                         [](double v, double u) {
                           const Eigen::RowVector3d a = squarePlace(v, 0.0);
                           const Eigen::RowVector3d b = 2.0 * squarePlace(v + 0.01, 1.0);
                           return Eigen::RowVector3d((1.0 - u) * a + u * b);
                         }),
    0.5));
}

TEST(RuledShape, PlacesOnALoopGoRound)
{
  const PlacedLoop loop = loopAt(test::tube(Around, Along, groovedBar(0.0)), 0);
  for (const double v : { 0.0, 0.1, 0.26, 0.5, 0.99, 1.7, -0.3 })
  {
    const LoopPlace place = placeOnLoop(loop.v, v);
    const Eigen::RowVector3d found = place.between(loop.points.row(static_cast<Index>(place.edge)),
      loop.points.row(static_cast<Index>(place.edge + 1) % Around));
    EXPECT_LT((found - squarePlace(v, 0.0)).norm(), 1e-14) << v;
  }
}

/// How far columns leave the lines that they begin on.
double greatestDrift(double stepDepth)
{
  SideTube side = test::tube(Around, Along, groovedBar(0.3));
  side.stepDepth = stepDepth;
  const PlacedLoop ring = loopAt(side, 0);
  const LinkingSideColumns columns(side, ring.points);
  EXPECT_TRUE(columns.hasSteps());
  const SideTubeMesh mesh = columns.mesh(layerFractions(24));
  double drift = 0.0;
  for (Index row = 0; row < mesh.nodes.rows(); ++row)
  {
    // On the grooved face lines differ in x.
    const Index j = row % Around;
    if (j > 0 && j < Around / 4)
    {
      drift = std::max(drift, std::abs(mesh.nodes(row, 0) - ring.points(j, 0)));
    }
  }
  return drift;
}

TEST(RuledShape, ColumnsGoOnStraighterInTheMetricOfAFlatterStep)
{
  const double own = greatestDrift(1.0);
  const double flatter = greatestDrift(0.4);
  const double flat = greatestDrift(0.05);
  EXPECT_GT(own, 0.03);
  EXPECT_LT(flatter, 0.7 * own);
  EXPECT_LT(flat, 0.2 * own);
}
}
