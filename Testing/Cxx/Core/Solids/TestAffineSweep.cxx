// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/AffineSweep.h"

#include "Support/SweptSolids.h"

#include <gtest/gtest.h>

namespace TestAffineSweep
{
using namespace test;
using hexsweep::AffineSweep;
using hexsweep::SolidInput;
using Place = std::function<Eigen::RowVector3d(double, double, double)>;

std::optional<AffineSweep> sweepOf(const SolidInput& input)
{
  const hexsweep::SolidSurface solid = hexsweep::makeSolidSurface(input);
  return hexsweep::findAffineSweep(solid, hexsweep::sweepBetween(solid, { 1 }, { 2 }));
}

std::vector<Section> flange()
{
  std::vector<Section> sections{ circleSection(0, 0, 50, 64), holeSection(0, 0, 16, 32) };
  for (int h = 0; h < 6; ++h)
  {
    sections.push_back(holeSection(35 * std::cos(h), 35 * std::sin(h), 5, 16));
  }
  return sections;
}

Section polygonL()
{
  return { { 0, 0 }, { 3, 0 }, { 3, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } };
}

Place affinePlace(const Eigen::Matrix3d& linear, const Eigen::RowVector3d& move)
{
  return [=](double x, double y, double h) -> Eigen::RowVector3d {
    const Eigen::RowVector3d p(x, y, 0.0);
    return (1.0 - h) * p + h * (p * linear.transpose() + move);
  };
}

/// Each point (x, y) of the source plane arrives where the sweep takes it.
void expectMap(const std::optional<AffineSweep>& sweep, const Place& place, double size)
{
  ASSERT_TRUE(sweep.has_value());
  for (const double x : { -1.0, 0.3, 2.0 })
  {
    for (const double y : { -0.5, 0.1, 1.0 })
    {
      Points from(1, 3);
      from.row(0) = place(size * x, size * y, 0.0);
      EXPECT_LE(
        (sweep->map.apply(from).row(0) - place(size * x, size * y, 1.0)).norm(), 1e-12 * size);
    }
  }
}

TEST(AffineSweep, TranslationsAreExact)
{
  for (const Eigen::RowVector3d& way :
    { Eigen::RowVector3d(0, 0, 15), Eigen::RowVector3d(20, -7, 15), Eigen::RowVector3d(0, 0, 0.1) })
  {
    const Place place = affinePlace(Eigen::Matrix3d::Identity(), way);
    const std::optional<AffineSweep> sweep = sweepOf(sweptSolid(flange(), place, 3));
    expectMap(sweep, place, 50.0);
    EXPECT_TRUE(sweep->isTranslation);
  }
}

TEST(AffineSweep, RegularPolygonsAreNotTurned)
{
  for (const Index corners : { 3, 4, 7, 35, 120 })
  {
    const Place place = affinePlace(Eigen::Matrix3d::Identity(), { 0.2, 0.1, 3.0 });
    const auto sweep = sweepOf(sweptSolid({ circleSection(0, 0, 1, corners) }, place));
    expectMap(sweep, place, 1.0);
    EXPECT_TRUE(sweep->isTranslation);
  }
}

TEST(AffineSweep, FrustaAndTiltedTargets)
{
  Eigen::Matrix3d linear;
  linear << 0.6, 0.2, 0, 0.1, 0.8, 0, 0.2, -0.1, 1; // tilts the target plane
  for (const Section& section : { polygonL(), circleSection(1, 1, 2, 48) })
  {
    const Place place = affinePlace(linear, { 0.5, 0.5, 4.0 });
    const auto sweep = sweepOf(sweptSolid({ section }, place, 2));
    expectMap(sweep, place, 2.0);
    EXPECT_FALSE(sweep->isTranslation);
  }
}

TEST(AffineSweep, RuledTwistIsFollowed)
{
  for (const double angle : { 0.3, 0.8, 1.3 })
  {
    Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
    linear.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(angle).toRotationMatrix();
    const Place place = affinePlace(linear, { 0, 0, 6 });
    expectMap(sweepOf(sweptSolid({ circleSection(0, 0, 1, 4) }, place, 24)), place, 1.0);
  }
}

TEST(AffineSweep, OtherNodesOnTheSameCurves)
{
  // The target circle is the source circle with nodes half an edge further on; the sides join them.
  SolidInput solid = sweptSolid(
    { circleSection(0, 0, 1, 40) }, affinePlace(Eigen::Matrix3d::Identity(), { 0, 0, 2 }));
  const double step = 2.0 * Pi / 40.0;
  for (Index j = 0; j < 40; ++j)
  {
    const double angle = (static_cast<double>(j) + 0.5) * step;
    solid.points.row(40 + j) << std::cos(angle), std::sin(angle), 2.0;
  }
  const auto sweep = sweepOf(solid);
  ASSERT_TRUE(sweep.has_value());
  const double sagitta = 1.0 - std::cos(0.5 * step);
  EXPECT_TRUE(sweep->isTranslation);
  EXPECT_LE(
    (sweep->map.targetCenter - sweep->map.sourceCenter - Eigen::RowVector3d(0, 0, 2)).norm(),
    sagitta);
}

TEST(AffineSweep, PlacementDoesNotMatter)
{
  const Place place = affinePlace(Eigen::Matrix3d::Identity(), { 0.3, 0, 1.0 });
  for (const double scale : { 1e-6, 1e6 })
  {
    SolidInput solid = sweptSolid({ polygonL(), holeSection(0.5, 0.5, 0.2, 12) }, place);
    solid.points = (scale * solid.points * someTurn().transpose()).eval();
    solid.points.rowwise() += Eigen::RowVector3d(1e3, -2e3, 5e2) * scale;
    const auto sweep = sweepOf(solid);
    ASSERT_TRUE(sweep.has_value());
    EXPECT_TRUE(sweep->isTranslation);
  }
}

TEST(AffineSweep, SinglePrecisionWillDo)
{
  SolidInput solid =
    sweptSolid(flange(), affinePlace(Eigen::Matrix3d::Identity(), { 3.0, 0.7, 11.0 }));
  solid.points = solid.points.cast<float>().cast<double>().eval();
  EXPECT_TRUE(sweepOf(solid).has_value());
}

TEST(AffineSweep, OtherSweepsAreNone)
{
  const Place straight = affinePlace(Eigen::Matrix3d::Identity(), { 0, 0, 2 });
  const auto none = [&](const std::vector<Section>& sections, const Place& place) {
    return !sweepOf(sweptSolid(sections, place, 16)).has_value();
  };
  const std::vector<Section> ring{ circleSection(0, 0, 1, 48), holeSection(0.2, 0, 0.3, 24) };
  EXPECT_FALSE(none(ring, straight));
  // A bulge, a bend, a full twist by 90 degrees on the way, a hole that moves or grows, a corner
  // that moves, a drafted loop beside straight ones.
  EXPECT_TRUE(none(ring, [&](double x, double y, double h) -> Eigen::RowVector3d {
    const double bulge = 1.0 + 0.1 * std::sin(Pi * h);
    return straight(bulge * x, bulge * y, h);
  }));
  EXPECT_TRUE(none(ring, [](double x, double y, double h) -> Eigen::RowVector3d {
    return { (3.0 + x) * std::cos(h), y, (3.0 + x) * std::sin(h) };
  }));
  EXPECT_TRUE(
    none({ circleSection(0, 0, 1, 4) }, [](double x, double y, double h) -> Eigen::RowVector3d {
      const double c = std::cos(0.5 * Pi * h);
      const double s = std::sin(0.5 * Pi * h);
      return { c * x - s * y, s * x + c * y, 2.0 * h };
    }));
  const auto changed = [&](const Place& hole) {
    return [=](double x, double y, double h) -> Eigen::RowVector3d {
      return std::hypot(x - 0.2, y) < 0.5 ? hole(x, y, h) : straight(x, y, h);
    };
  };
  EXPECT_TRUE(none(ring, changed([&](double x, double y, double h) -> Eigen::RowVector3d {
    return straight(x + 0.05 * h, y, h);
  })));
  EXPECT_TRUE(none(ring, changed([&](double x, double y, double h) -> Eigen::RowVector3d {
    return straight(0.2 + (1.0 + 0.1 * h) * (x - 0.2), (1.0 + 0.1 * h) * y, h);
  })));
  EXPECT_TRUE(none({ polygonL() }, [&](double x, double y, double h) -> Eigen::RowVector3d {
    return straight(x == 1.0 && y == 1.0 ? 1.0 + 0.1 * h : x, y, h);
  }));
}

TEST(AffineSweep, TheWallOfATubeIsCrossedTheShortestWay)
{
  // Through the wall from outside to inside: its ends are flat rings, on which lines lie however
  // they turn.
  for (const Index around : { 48, 60 })
  {
    constexpr double Radius = 20.0;
    constexpr double Wall = 0.6;
    const Place place = [](double x, double y, double h) -> Eigen::RowVector3d {
      const double r = std::hypot(x, y);
      const double radius = Radius - Wall * h;
      return { radius * x / r, radius * y / r, 20.0 * (r - 1.0) };
    };
    const std::vector<Section> sections{ circleSection(0, 0, 2, around, 0.1),
      holeSection(0, 0, 1, around) };
    const std::optional<AffineSweep> sweep = sweepOf(sweptSolid(sections, place));
    ASSERT_TRUE(sweep);
    for (const Eigen::RowVector2d& node : sections[0])
    {
      const Eigen::RowVector3d p = place(node.x(), node.y(), 0.0);
      EXPECT_LT((sweep->map.apply(p) - p).norm(), 1.01 * Wall);
    }
  }
}
}
