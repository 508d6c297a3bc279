// SPDX-License-Identifier: BSD-3-Clause
// Which sweeps are tried, and how fine they are where nobody says so.
#include "Core/Solids/SweepChoice.h"
#include "Core/Solids/SweepSize.h"

#include "Support/SolidShapes.h"
#include "Support/SweptShapes.h"

namespace TestSweepChoice
{
using hexsweep::chooseSweeps;
using hexsweep::Index;
using hexsweep::makeSolidSurface;
using hexsweep::QuadMesh;
using hexsweep::SolidSurface;
using hexsweep::SweepChoice;
using test::box;
using test::expectInvalid;
using Ids = std::vector<Index>;

TEST(SweepChoice, NamedCapsAreTaken)
{
  const SolidSurface solid = makeSolidSurface(box(2, 3, 4));
  const SweepChoice both = chooseSweeps(solid, { 1 }, { 22 });
  ASSERT_EQ(both.sweeps.size(), 1u);
  EXPECT_EQ(both.sweeps[0].sourceFaceIds, Ids{ 1 });
  EXPECT_TRUE(both.ranking.list.empty());
  const SweepChoice source = chooseSweeps(solid, { 1 }, {});
  ASSERT_EQ(source.sweeps.size(), 1u);
  EXPECT_EQ(source.sweeps[0].targetFaceIds, Ids{ 22 });
  EXPECT_EQ(source.ranking.list.front().targetFaceIds, Ids{ 22 });
  const SweepChoice target = chooseSweeps(solid, {}, { 1 });
  ASSERT_EQ(target.sweeps.size(), 1u);
  EXPECT_EQ(target.sweeps[0].sourceFaceIds, Ids{ 22 });
  EXPECT_EQ(target.sweeps[0].targetFaceIds, Ids{ 1 });
  EXPECT_EQ(target.ranking.list.front().targetFaceIds, Ids{ 1 });
  expectInvalid([&] { chooseSweeps(solid, {}, { 99 }); }, "target face id 99 does not exist");
  expectInvalid(
    [&] {
      chooseSweeps(solid, {}, { 1, 3, 5 });
    },
    "no source face is named, and none fits the target cap (faces 1, 3 and 5)");
}

TEST(SweepChoice, AtMostThreeAreTried)
{
  const SweepChoice choice = chooseSweeps(makeSolidSurface(box(2, 3, 4)), {}, {});
  ASSERT_EQ(choice.sweeps.size(), 3u);
  EXPECT_EQ(choice.sweeps[0].sourceFaceIds, Ids{ 1 }); // the shortest way
  const std::vector<std::string> lines = hexsweep::describeRanking(choice.ranking);
  ASSERT_EQ(lines.size(), choice.ranking.list.size());
  EXPECT_EQ(lines[0].rfind("1: from face 1 to face 22, score 0.9", 0), 0u) << lines[0];
  EXPECT_NE(lines[0].find("fits: straight prism"), std::string::npos) << lines[0];
}

TEST(SweepChoice, SteppedShaftsAreRefusedInWords)
{
  const test::SolidInput shaft = test::sweptSolid(
    test::circle(24, 1.0), 7,
    [](double x, double y, double t) {
      const auto k = static_cast<int>(std::lround(7.0 * t));
      const double s = k <= 3 ? 1.0 : 2.0;
      return Eigen::RowVector3d(s * x, s * y, k <= 3 ? k : k - 1);
    },
    [](int, int k) -> Index { return k < 3 ? 3
                                : k == 3   ? 4
                                           : 5; });
  const SolidSurface solid = makeSolidSurface(shaft);
  expectInvalid([&] { chooseSweeps(solid, {}, {}); }, "no way to sweep the solid fits");
  expectInvalid([&] { chooseSweeps(solid, {}, {}); }, "face 4 runs across the sweep all round");
  EXPECT_EQ(chooseSweeps(solid, { 1 }, {}).sweeps.size(), 1u);
}

TEST(SweepChoice, TooFewFacesAreSaid)
{
  const SolidSurface solid = makeSolidSurface(test::sweptSolid(
    test::circle(24, 1.0), 2, test::upward(1.0), [](int, int) -> Index { return test::TopFace; }));
  expectInvalid([&] { chooseSweeps(solid, {}, {}); }, "it has 2 faces, of which no two are caps");
}

TEST(SweepChoice, FacesUnderQuads)
{
  const SolidSurface solid = makeSolidSurface(box(2, 2, 1));
  QuadMesh quads;
  quads.points.resize(4, 3);
  quads.points << 0, 0, 1, 2, 0, 1, 2, 2, 1, 0, 2, 1;
  quads.quads.resize(1, 4);
  quads.quads << 0, 1, 2, 3;
  EXPECT_EQ(hexsweep::facesUnder(solid, quads), Ids{ 16 });
}

TEST(SweepSize, LengthOfSidesAndWidthOfQuads)
{
  const SolidSurface block = makeSolidSurface(box(2, 3, 4));
  EXPECT_NEAR(
    hexsweep::sideLength(block, hexsweep::sweepBetween(block, { 5 }, { 46 })), 4.0, 1e-12);
  const SolidSurface holes = makeSolidSurface(
    test::cubes({ 5, 5, 3 }, [](int x, int y, int) { return x % 2 == 0 || y % 2 == 0; }));
  EXPECT_NEAR(
    hexsweep::sideLength(holes, hexsweep::sweepBetween(holes, { 5 }, { 36 })), 3.0, 1e-12);
  QuadMesh quads;
  quads.points.resize(6, 3);
  quads.points << 0, 0, 0, 2, 0, 0, 4, 0, 0, 0, 8, 0, 2, 8, 0, 4, 8, 0;
  quads.quads.resize(2, 4);
  quads.quads << 0, 1, 4, 3, 1, 2, 5, 4;
  EXPECT_NEAR(hexsweep::meanQuadWidth(quads), 4.0, 1e-12);
  EXPECT_NEAR(
    hexsweep::meanHexWidth(block, hexsweep::sweepBetween(block, { 5 }, { 46 }), quads), 4.0, 1e-12);
  // The target's edges are half as long.
  const SolidSurface frustum = makeSolidSurface(test::sweptSolid(test::circle(24, 1.0), 1,
    test::upward(2.0, [](double t) { return 1.0 - 0.5 * t; }),
    [](int, int) -> Index { return 3; }));
  EXPECT_NEAR(hexsweep::meanHexWidth(frustum, hexsweep::sweepBetween(frustum, { 1 }, { 2 }), quads),
    3.0, 1e-12);
}

TEST(SweepSize, Coarsening)
{
  EXPECT_EQ(hexsweep::coarseningFor(10.0, 1000, 0.1), 1.0); // 100000
  EXPECT_EQ(hexsweep::coarseningFor(0.001, 1000, 0.1), 1.0);
  EXPECT_NEAR(hexsweep::coarseningFor(200.0, 1000, 0.1), 2.0, 1e-12);
  // What is twice as coarse stays within it: a quarter of the quads, half the layers.
  EXPECT_EQ(hexsweep::coarseningFor(200.0, 250, 0.2), 1.0);
}
}
