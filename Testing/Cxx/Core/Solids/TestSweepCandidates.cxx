// SPDX-License-Identifier: BSD-3-Clause
// The ways to sweep a solid: the first one against what an engineer would take, the list against a
// trial of all pairs, and its time.
#include "Core/Solids/SweepCandidates.h"
#include "Core/Solids/TargetFaces.h"

#include "Support/SolidShapes.h"
#include "Support/SweptShapes.h"

#include <Eigen/Geometry>

#include <ctime>
#include <set>
#include <utility>

namespace TestSweepCandidates
{
using hexsweep::findSweepCandidates;
using hexsweep::Index;
using hexsweep::makeSolidSurface;
using hexsweep::Pi;
using hexsweep::SolidSurface;
using hexsweep::SweepCandidate;
using hexsweep::SweepCandidates;
using test::BottomFace;
using test::box;
using test::cubes;
using test::SolidInput;
using test::sweptSolid;
using test::TopFace;
using Ids = std::vector<Index>;
using Caps = std::pair<Ids, Ids>;

/// Both caps, the lower ids first.
Caps capsOf(const SweepCandidate& candidate)
{
  Caps caps(candidate.sourceFaceIds, candidate.targetFaceIds);
  if (caps.second < caps.first)
  {
    std::swap(caps.first, caps.second);
  }
  return caps;
}

/// Those of the best candidate; none where nothing fits.
Caps bestCaps(const SolidInput& input)
{
  const SweepCandidates candidates = findSweepCandidates(makeSolidSurface(input));
  if (candidates.list.empty() || !candidates.list.front().fits)
  {
    return {};
  }
  return capsOf(candidates.list.front());
}

const Caps Ends({ BottomFace }, { TopFace });

Index oneSide(int, int)
{
  return 3;
}

Index sideOfItsOwn(int j, int)
{
  return 3 + j;
}

Ids sortedIds(Ids ids)
{
  std::sort(ids.begin(), ids.end());
  return ids;
}

TEST(SweepCandidates, Profiles)
{
  EXPECT_EQ(bestCaps(cubes({ 4, 4, 3 }, [](int x, int y, int) { return x == 0 || y == 0; })),
    Caps({ 5 }, { 36 }))
    << "L";
  EXPECT_EQ(bestCaps(cubes({ 5, 3, 9 }, [](int x, int y, int) { return x == 2 || y == 2; })),
    Caps({ 5 }, { 96 }))
    << "T, three times as long as wide";
  EXPECT_EQ(
    bestCaps(cubes({ 5, 4, 2 }, [](int x, int y, int) { return x == 0 || x == 4 || y == 0; })),
    Caps({ 5 }, { 26 }))
    << "U";
  EXPECT_EQ(
    bestCaps(cubes({ 9, 9, 1 }, [](int x, int y, int) { return x % 2 == 0 || y % 2 == 0; })),
    Caps({ 5 }, { 16 }))
    << "a plate with 16 holes";
}

TEST(SweepCandidates, BlocksFitInAllThreeDirections)
{
  const SweepCandidates cube = findSweepCandidates(makeSolidSurface(box(2, 2, 2)));
  ASSERT_EQ(cube.list.size(), 3u);
  EXPECT_FALSE(cube.cut);
  for (const SweepCandidate& candidate : cube.list)
  {
    EXPECT_TRUE(candidate.fits);
    EXPECT_NEAR(candidate.score, cube.list.front().score, 1e-12);
    EXPECT_EQ(candidate.reasons, "straight prism");
  }
  // Of a plate the large faces are taken, so that the way is short; of a bar, too.
  EXPECT_EQ(bestCaps(box(8, 8, 1)), Caps({ 5 }, { 16 }));
  EXPECT_EQ(bestCaps(box(1, 8, 2)), Caps({ 1 }, { 12 }));
}

TEST(SweepCandidates, RoundSolids)
{
  const auto halves = [](int j, int) -> Index { return j < 12 ? 3 : 4; };
  EXPECT_EQ(bestCaps(sweptSolid(test::circle(24, 1.0), 8, test::upward(4.0), halves)), Ends)
    << "a cylinder whose side has two halves";
  EXPECT_EQ(bestCaps(sweptSolid(test::circle(24, 1.0), 8, test::upward(4.0), oneSide)), Ends)
    << "a cylinder";
  EXPECT_EQ(bestCaps(sweptSolid(test::circle(24, 1.0), 4,
              test::upward(2.0, [](double t) { return 1.0 - 0.5 * t; }), oneSide)),
    Ends)
    << "a frustum";
  EXPECT_EQ(
    bestCaps(sweptSolid(test::circle(24, 1.0), 12, test::roundBend(3.0, Pi / 2.0), sideOfItsOwn)),
    Ends)
    << "an elbow";
  EXPECT_EQ(bestCaps(sweptSolid(test::polygon(60, [](int j) { return j / 3 % 2 == 0 ? 1.0 : 0.8; }),
              2, test::upward(0.7), sideOfItsOwn)),
    Ends)
    << "a gear";
  EXPECT_EQ(bestCaps(sweptSolid(
              test::polygon(4, [](int j) { return j % 2 == 0 ? 2.0 : 1.0; }), 3,
              [](double x, double y, double t) {
                return Eigen::RowVector3d(x, y, (1.0 + 0.2 * x) * (t - 0.5));
              },
              sideOfItsOwn)),
    Ends)
    << "a wedge";
}

TEST(SweepCandidates, WideRevolutionsAreSweptRoundTheirAxis)
{
  // Ways along the edges are shorter by the inner side than along the outer one.
  const std::vector<std::vector<Eigen::RowVector2d>> sections = { test::circle(24, 1.0),
    { { -0.9, -0.4 }, { 0.9, -0.5 }, { 0.4, 0.7 } },
    { { -0.7, -0.5 }, { 0.6, -0.8 }, { 0.9, 0.3 }, { 0.1, 0.9 }, { -0.8, 0.4 } } };
  for (const auto& section : sections)
  {
    for (const double degrees : { 90.0, 250.0, 320.0 })
    {
      EXPECT_EQ(bestCaps(sweptSolid(section, static_cast<int>(degrees / 15.0),
                  test::roundBend(1.4, degrees * Pi / 180.0), sideOfItsOwn)),
        Ends)
        << section.size() << " corners, " << degrees << " degrees";
    }
  }
}

TEST(SweepCandidates, AHalfPipeIsSweptAlongOrThroughItsWall)
{
  // A thin wall, bent by 180 degrees: inner and outer face are sides 4 and 2 of the rectangle.
  const SolidInput pipe = sweptSolid(test::rectangle(0.2, 3.0), 36, test::roundBend(2.0, Pi),
    [](int j, int) -> Index { return 3 + j; });
  const Caps best = bestCaps(pipe);
  const std::set<Caps> good = { Caps({ 4 }, { 6 }), Caps({ 3 }, { 5 }) };
  EXPECT_TRUE(good.count(best)) << best.first.at(0);
}

TEST(SweepCandidates, CapsOfSeveralFaces)
{
  // Both caps and the sides in tiles.
  const SolidInput tiles = box(6, 6, 2, [](const test::Cell& cell, int direction) -> Index {
    return 1000 * direction + 100 * (cell[0] / 3) + 10 * (cell[1] / 3) + cell[2];
  });
  const Caps best = bestCaps(tiles);
  EXPECT_EQ(best.first, sortedIds({ 5000, 5010, 5100, 5110 }));
  EXPECT_EQ(best.second, sortedIds({ 6001, 6011, 6101, 6111 }));
  // A roof of two slopes: they meet at 40 degrees, under no feature angle.
  SolidInput roof = box(4, 3, 2, [](const test::Cell& cell, int direction) -> Index {
    return direction == 6 ? (cell[0] < 2 ? 7 : 8) : direction;
  });
  for (Index i = 0; i < roof.points.rows(); ++i)
  {
    if (roof.points(i, 2) == 2.0)
    {
      roof.points(i, 2) += 0.36 * (2.0 - std::abs(roof.points(i, 0) - 2.0));
    }
  }
  EXPECT_EQ(hexsweep::findTargetFaces(makeSolidSurface(roof), { 5 }), (Ids{ 7, 8 }));
}

TEST(SweepCandidates, FilletsOnTheRimOfACapBelongToTheSides)
{
  // The upper fifth is a quarter of a circle, split from the wall and from the cap.
  const auto radius = [](double t) {
    const double s = std::max(0.0, 5.0 * t - 4.0);
    return 1.0 - 0.2 * (1.0 - std::sqrt(std::max(0.0, 1.0 - s * s)));
  };
  const SolidInput input = sweptSolid(test::circle(48, 1.0), 50, test::upward(1.0, radius),
    [](int, int k) -> Index { return k < 40 ? 3 : 4; });
  const SweepCandidates candidates = findSweepCandidates(makeSolidSurface(input));
  ASSERT_FALSE(candidates.list.empty());
  const SweepCandidate& best = candidates.list.front();
  EXPECT_EQ(capsOf(best), Ends);
}

TEST(SweepCandidates, RingsAreSweptAlongTheAxisOrAcross)
{
  const auto ring = [](int x, int y, int) { return x == 0 || x == 5 || y == 0 || y == 5; };
  const auto walls = [](const test::Cell& cell, int direction) -> Index {
    const std::array<int, 2> inner = { direction == 1 || direction == 2 ? cell[0] : cell[1],
      direction };
    return direction > 4 ? direction : (inner[0] == 0) == (direction % 2 == 1) ? 7 : 8;
  };
  const SweepCandidates flat =
    findSweepCandidates(makeSolidSurface(cubes({ 6, 6, 2 }, ring, walls)));
  ASSERT_GE(flat.list.size(), 2u);
  EXPECT_EQ(flat.list[0].sourceFaceIds, Ids{ 5 });
  EXPECT_EQ(flat.list[0].targetFaceIds, Ids{ 6 });
  EXPECT_EQ(capsOf(flat.list[1]), Caps({ 7 }, { 8 }));
}

TEST(SweepCandidates, StepsAreRefusedWithTheFaceInTheWay)
{
  // A shaft of three thicknesses; ids of the rings by place along it.
  const SolidInput shaft = sweptSolid(
    test::circle(24, 1.0), 12,
    [](double x, double y, double t) {
      // Rings 4 and 8 stand in for the outer edges of the steps at rings 3 and 7.
      const auto k = static_cast<int>(std::lround(12.0 * t));
      const double height = k == 4 ? 3.0 : k == 8 ? 7.0 : k;
      const double s = k <= 3 ? 1.0 : k <= 7 ? 1.6 : 0.8;
      return Eigen::RowVector3d(s * x, s * y, height);
    },
    [](int, int k) -> Index {
      return k < 3 ? 3 : k == 3 ? 4 : k < 7 ? 5 : k == 7 ? 6 : 7;
    });
  const SolidSurface solid = makeSolidSurface(shaft);
  const SweepCandidates candidates = findSweepCandidates(solid);
  ASSERT_FALSE(candidates.list.empty());
  for (const SweepCandidate& candidate : candidates.list)
  {
    EXPECT_FALSE(candidate.fits);
  }
  const std::string reasons = candidates.list.front().reasons;
  EXPECT_NE(reasons.find("face 4"), std::string::npos) << reasons;
  EXPECT_NE(reasons.find("runs across the sweep all round"), std::string::npos) << reasons;
  // A source that was chosen is swept all the same.
  EXPECT_EQ(hexsweep::findTargetFaces(solid, { BottomFace }), Ids{ TopFace });
}

TEST(SweepCandidates, SolidsThatBranchAreRefusedInWords)
{
  const SweepCandidates blind = findSweepCandidates(makeSolidSurface(cubes(
    { 5, 5, 4 }, [](int x, int y, int z) { return x != 2 || y != 2 || (z != 3 && z != 0); })));
  for (const SweepCandidate& candidate : blind.list)
  {
    EXPECT_FALSE(candidate.reasons.empty());
  }
  const SweepCandidates cross = findSweepCandidates(makeSolidSurface(
    cubes({ 3, 3, 3 }, [](int x, int y, int z) { return (x == 1) + (y == 1) + (z == 1) < 2; })));
  ASSERT_FALSE(cross.list.empty());
  EXPECT_FALSE(cross.list.front().fits);
  EXPECT_NE(cross.list.front().reasons.find("branch: they join 2 loops"), std::string::npos)
    << cross.list.front().reasons;
}

TEST(SweepCandidates, AllThatFitCanBeSweptAndAreListedOnce)
{
  const std::vector<SolidInput> inputs = { box(2, 2, 3),
    cubes({ 4, 4, 3 }, [](int x, int y, int) { return x == 0 || y == 0; }),
    cubes({ 6, 6, 2 }, [](int x, int y, int) { return x == 0 || x == 5 || y == 0 || y == 5; }) };
  for (const SolidInput& input : inputs)
  {
    const SolidSurface solid = makeSolidSurface(input);
    std::set<Caps> listed;
    double last = 1.0;
    for (const SweepCandidate& candidate : findSweepCandidates(solid).list)
    {
      if (candidate.score == 0.0)
      {
        continue; // says why it cannot be swept
      }
      EXPECT_TRUE(!candidate.fits || candidate.score <= last);
      last = candidate.fits ? candidate.score : 0.0; // wide shoulders come after the others
      EXPECT_NO_THROW(
        hexsweep::sweepBetween(solid, candidate.sourceFaceIds, candidate.targetFaceIds));
      EXPECT_TRUE(listed.insert(capsOf(candidate)).second);
    }
    EXPECT_FALSE(listed.empty());
    // Every pair of single faces that can be swept is there.
    const std::set<Index> ids(solid.faceIds.begin(), solid.faceIds.end());
    for (const Index a : ids)
    {
      for (const Index b : ids)
      {
        bool fits = a < b;
        try
        {
          hexsweep::sweepBetween(solid, { a }, { b });
        }
        catch (const hexsweep::InvalidInput&)
        {
          fits = false;
        }
        EXPECT_TRUE(!fits || listed.count(Caps({ a }, { b }))) << a << " " << b;
      }
    }
  }
}

TEST(SweepCandidates, DoNotDependOnSizePlaceAndTurn)
{
  const SolidInput input = sweptSolid(test::circle(24, 1.0), 12, test::roundBend(3.0, Pi / 2.0),
    [](int j, int) -> Index { return 3 + j / 6; });
  const SweepCandidates expected = findSweepCandidates(makeSolidSurface(input));
  const Eigen::Matrix3d turn =
    (Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -0.5).normalized())).toRotationMatrix();
  for (const double size : { 1e-6, 1e6 })
  {
    SolidInput moved = input;
    moved.points = size * (input.points * turn.transpose());
    moved.points.rowwise() += size * Eigen::RowVector3d(100.0, -50.0, 3.0);
    const SweepCandidates found = findSweepCandidates(makeSolidSurface(moved));
    ASSERT_EQ(found.list.size(), expected.list.size());
    EXPECT_EQ(found.list[0].sourceFaceIds, expected.list[0].sourceFaceIds);
    EXPECT_EQ(found.list[0].targetFaceIds, expected.list[0].targetFaceIds);
    EXPECT_NEAR(found.list[0].score, expected.list[0].score, 1e-6);
  }
}

#ifdef __SANITIZE_ADDRESS__
constexpr double MostSeconds = 60.0; // a program that is watched takes its time
#else
constexpr double MostSeconds = 1.0;
#endif

TEST(SweepCandidates, AThousandFacesTakeLessThanASecond)
{
  const auto secondsOf = [](const SolidSurface& solid, bool& cut) {
    const std::clock_t start = std::clock();
    cut = findSweepCandidates(solid).cut;
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  };
  bool cut = false;
  const SolidInput gear =
    sweptSolid(test::polygon(998, [](int j) { return j / 2 % 2 == 0 ? 1.0 : 0.95; }), 12,
      test::upward(0.5), sideOfItsOwn);
  EXPECT_EQ(bestCaps(gear), Ends);
  EXPECT_LT(secondsOf(makeSolidSurface(gear), cut), MostSeconds);
  EXPECT_TRUE(cut);
  const SolidInput plate = cubes(
    { 31, 31, 1 }, [](int x, int y, int) { return x % 2 == 0 || y % 2 == 0; },
    [](const test::Cell& cell, int direction) -> Index {
      return direction > 4 ? direction : 10 + 4 * (31 * cell[0] + cell[1]) + direction;
    });
  EXPECT_EQ(bestCaps(plate), Caps({ 5 }, { 6 }));
  EXPECT_LT(secondsOf(makeSolidSurface(plate), cut), MostSeconds);
  // Every quad a face of its own, all much alike.
  const SolidInput ball = sweptSolid(test::circle(40, 1.0), 25,
    test::upward(2.0, [](double t) { return 0.2 + std::sin(Pi * t); }),
    [](int j, int k) -> Index { return 3 + 40 * k + j; });
  EXPECT_LT(secondsOf(makeSolidSurface(ball), cut), MostSeconds);
  EXPECT_TRUE(cut);
  const SolidInput tiles = box(13, 13, 13, [](const test::Cell& cell, int direction) -> Index {
    return 10000 * direction + 400 * cell[0] + 20 * cell[1] + cell[2];
  });
  EXPECT_LT(secondsOf(makeSolidSurface(tiles), cut), MostSeconds);
  const Caps best = bestCaps(tiles);
  EXPECT_EQ(best.first.size(), 169u);
  EXPECT_EQ(best.second.size(), 169u);
}
}
