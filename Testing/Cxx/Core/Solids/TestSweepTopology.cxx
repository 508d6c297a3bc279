// SPDX-License-Identifier: BSD-3-Clause
// Solids made of cubes: caps, sides and loops of those that can be swept, the reason why the others
// cannot, and the target cap against a trial of all faces.
#include "Core/Solids/SolidInput.h"
#include "Core/Solids/TargetFaces.h"

#include "Support/SolidShapes.h"

#include <numeric>
#include <set>
#include <utility>

namespace TestSweepTopology
{
using hexsweep::findSweepTopology;
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::makeSolidSurface;
using hexsweep::SolidSurface;
using hexsweep::SweepSide;
using hexsweep::SweepTopology;
using test::box;
using test::Cell;
using test::cubes;
using test::expectInvalid;
using test::SolidInput;
using Ids = std::vector<Index>;

void expectNoSweep(const SolidInput& input, const Ids& source, const Ids& target,
  const std::vector<std::string>& parts)
{
  const SolidSurface solid = makeSolidSurface(input);
  for (const std::string& part : parts)
  {
    expectInvalid([&] { findSweepTopology(solid, source, target); }, part);
  }
}

using Side = std::pair<Index, Index>;

/// Directed edges of some triangles that no other of them has the other way round.
std::set<Side> boundaryOf(const SolidSurface& solid, const Ids& triangles)
{
  std::set<Side> sides;
  for (const Index t : triangles)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index a = solid.triangles(t, c);
      const Index b = solid.triangles(t, (c + 1) % 3);
      if (sides.erase({ b, a }) == 0)
      {
        sides.emplace(a, b);
      }
    }
  }
  return sides;
}

/// Removes the edges of a loop, each in its direction (or against it), from a set that must have
/// them.
void takeLoop(std::set<Side>& sides, const Loop& loop, bool forward)
{
  EXPECT_EQ(loop.front(), *std::min_element(loop.begin(), loop.end()));
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Index a = loop[i];
    const Index b = loop[(i + 1) % loop.size()];
    EXPECT_EQ(sides.erase(forward ? Side(a, b) : Side(b, a)), 1u);
  }
}

void expectConsistent(const SolidSurface& solid, const SweepTopology& topology)
{
  Ids all = topology.sourceTriangles;
  all.insert(all.end(), topology.targetTriangles.begin(), topology.targetTriangles.end());
  std::set<Side> source = boundaryOf(solid, topology.sourceTriangles);
  std::set<Side> target = boundaryOf(solid, topology.targetTriangles);
  double longest = 0.0;
  for (const SweepSide& side : topology.sides)
  {
    std::set<Side> own = boundaryOf(solid, side.triangles);
    takeLoop(source, side.sourceLoop, true);
    takeLoop(target, side.targetLoop, true);
    takeLoop(own, side.sourceLoop, false);
    takeLoop(own, side.targetLoop, false);
    EXPECT_TRUE(own.empty());
    EXPECT_EQ(side.faceIds, hexsweep::facesOfTriangles(solid, side.triangles));
    EXPECT_TRUE(std::is_sorted(side.triangles.begin(), side.triangles.end()));
    all.insert(all.end(), side.triangles.begin(), side.triangles.end());
    const double length = test::loopLength(solid.points, side.sourceLoop) +
      test::loopLength(solid.points, side.targetLoop);
    longest = longest > 0.0 ? longest : length;
    EXPECT_LE(length, longest);
  }
  EXPECT_TRUE(source.empty());
  EXPECT_TRUE(target.empty());
  std::sort(all.begin(), all.end());
  Ids rows(static_cast<std::size_t>(solid.triangles.rows()));
  std::iota(rows.begin(), rows.end(), Index(0));
  EXPECT_EQ(all, rows);
}

/// 7 x 5 x 3 with a square hole and a longish one along z.
bool twoHoles(int x, int y, int)
{
  return !((x == 1 && y == 1) || (x >= 3 && x <= 5 && y >= 2 && y <= 3));
}

/// The top of a box in columns: 7 where `first`, 8 elsewhere; other planes as usual.
test::SideLabel topLabel(int top, const std::function<bool(int, int)>& first)
{
  return [=](const Cell& cell, int direction) {
    const bool up = direction == 6 && cell[2] == top - 1;
    return up ? (first(cell[0], cell[1]) ? 7 : 8) : test::planeLabel(cell, direction);
  };
}

TEST(SweepTopology, ABoxWithTwoHoles)
{
  const SolidSurface solid = makeSolidSurface(cubes({ 7, 5, 3 }, twoHoles));
  for (const bool up : { true, false })
  {
    const SweepTopology topology =
      up ? findSweepTopology(solid, { 5 }, { 36 }) : findSweepTopology(solid, { 36 }, { 5 });
    expectConsistent(solid, topology);
    EXPECT_EQ(topology.sourceFaceIds, Ids{ up ? 5 : 36 });
    EXPECT_EQ(topology.targetFaceIds, Ids{ up ? 36 : 5 });
    ASSERT_EQ(topology.sides.size(), 3u);
    EXPECT_EQ(topology.sides[0].faceIds, (Ids{ 1, 3, 54, 72 }));
    EXPECT_EQ(topology.sides[0].sourceLoop.size(), 24u);
    EXPECT_EQ(topology.sides[0].triangles.size(), 24u * 3 * 2);
    std::set<Ids> holes = { topology.sides[1].faceIds, topology.sides[2].faceIds };
    EXPECT_EQ(holes, (std::set<Ids>{ { 12, 14, 21, 23 }, { 24, 32, 43, 61 } }));
    EXPECT_LT(topology.sides[1].sourceLoop[0], topology.sides[2].sourceLoop[0]);
  }
}

TEST(SweepTopology, CapsOfSeveralFaces)
{
  // The top is two faces, the lower half of a wall a face of its own. Ids in any order, twice.
  const SolidSurface solid =
    makeSolidSurface(box(4, 3, 4, [](const Cell& cell, int direction) -> Index {
      const auto top = topLabel(4, [](int x, int) { return x < 2; });
      return direction == 3 && cell[1] == 0 && cell[2] < 2 ? 9 : top(cell, direction);
    }));
  const SweepTopology topology = findSweepTopology(solid, { 5, 5 }, { 8, 7, 8 });
  expectConsistent(solid, topology);
  EXPECT_EQ(topology.targetFaceIds, (Ids{ 7, 8 }));
  EXPECT_EQ(topology.sides[0].faceIds, (Ids{ 1, 3, 9, 34, 42 }));

  const SweepTopology bent = findSweepTopology(solid, { 9, 5 }, { 7, 8 });
  expectConsistent(solid, bent);
  EXPECT_EQ(bent.sourceTriangles.size(), 2u * (4 * 3 + 4 * 2));
  EXPECT_EQ(bent.sides[0].faceIds, (Ids{ 1, 3, 34, 42 }));
}

TEST(SweepTopology, IdsThatAreMissingOrDoNotExist)
{
  const SolidInput input = box(1, 1, 1);
  expectNoSweep(input, {}, { 16 }, { "no source face is named", "faces 1, 3, 5, 12, 14 and 16" });
  expectNoSweep(input, { 5, 99 }, { 16 },
    { "source face id 99 does not exist", "has faces 1, 3, 5, 12, 14 and 16" });
  expectNoSweep(input, { 5 }, { 6 }, { "target face id 6 does not exist" });
  expectNoSweep(input, { 99 }, {}, { "source face id 99 does not exist" });
  expectInvalid([&] { hexsweep::findTargetFaces(makeSolidSurface(input), {}); }, "no source face");
}

TEST(SweepTopology, ManyIdsAreNotAllListed)
{
  const SolidInput input = box(4, 4, 1, [](const Cell& cell, int direction) {
    return direction == 6 ? 1000 + 4 * cell[1] + cell[0] : test::planeLabel(cell, direction);
  });
  expectNoSweep(input, { 77 }, {}, { "... (21 in all)" });
}

TEST(SweepTopology, SourceAndTargetOverlap)
{
  const SolidInput input = box(1, 1, 1);
  expectNoSweep(input, { 5 }, { 5, 5 }, { "source and target are the same face 5" });
  expectNoSweep(input, { 5, 1 }, { 16, 1 }, { "face 1 is named in the source cap and in the" });
}

TEST(SweepTopology, CapsThatTouch)
{
  expectNoSweep(box(3, 2, 1), { 5 }, { 1 },
    { "source cap (face 5) and the target cap (face 1) share 2 edges, the first one at (0, " });
  // Two cells of the top that meet in a corner.
  const SolidInput corner = box(4, 4, 1, [](const Cell& cell, int direction) {
    return direction == 6 && cell[0] == cell[1] && (cell[0] == 1 || cell[0] == 2)
      ? Index(100 + cell[0])
      : Index(3);
  });
  expectNoSweep(
    corner, { 101 }, { 102 }, { "meet in a point, at (2, 2, 1)", "covers only part of a loop" });
}

TEST(SweepTopology, ACapInPieces)
{
  expectNoSweep(box(2, 2, 3), { 5, 36 }, { 1 },
    { "source cap (faces 5 and 36) falls into 2 pieces", "face 5 at (", "; face 36 at (" });
  expectNoSweep(box(2, 2, 3), { 3 }, { 5, 36 }, { "target cap (faces 5 and 36) falls into 2" });
  // Two prongs whose tops have the same id.
  const SolidInput fork = cubes({ 3, 1, 3 }, [](int x, int, int z) { return x != 1 || z == 0; });
  expectNoSweep(fork, { 5 }, { 36 }, { "target cap (face 36) falls into 2 pieces" });
}

TEST(SweepTopology, ACapThatTouchesItselfInAPoint)
{
  const auto ring = [](int x, int y) { return (x != 1 || y != 1) && (x != 0 || y != 0); };
  expectNoSweep(box(3, 3, 2, topLabel(2, ring)), { 7 }, { 5 },
    { "source cap (face 7) touches itself in a point only, at (1, 1, 2)" });
}

TEST(SweepTopology, ACapWithAHandle)
{
  const SolidInput tunnel = cubes(
    { 3, 3, 3 }, [](int, int y, int z) { return y != 1 || z != 1; },
    [](const Cell& cell, int direction) {
      return direction == 6 && cell[2] == 2 ? (cell[0] == 1 && cell[1] == 1 ? 2 : 3) : 1;
    });
  expectNoSweep(tunnel, { 1 }, { 2 }, { "source cap (face 1) has genus 1" });
  expectNoSweep(tunnel, { 2 }, { 1 }, { "target cap (face 1) has genus 1" });
}

TEST(SweepTopology, TheWholeSolidIsNoCap)
{
  const Ids all = { 1, 3, 5, 12, 14, 16 };
  expectNoSweep(box(1, 1, 1), all, {}, { "is the whole surface", "no boundary loop" });
}

TEST(SweepTopology, DifferentNumbersOfHoles)
{
  // Two holes, one of which stops below the top.
  const SolidInput blind =
    cubes({ 7, 5, 3 }, [](int x, int y, int z) { return twoHoles(x, y, z) || (x == 1 && z == 2); });
  expectNoSweep(blind, { 5 }, { 36 },
    { "source cap (face 5) has 3 loops, the target cap (face 36) has 2 loops",
      "different numbers of holes", "The faces 12, 14, 21, 23 and 25 at", "touch the source cap" });
  expectNoSweep(blind, { 36 }, { 5 },
    { "source cap (face 36) has 2 loops, the target cap (face 5) has 3 loops",
      "touch the target cap (face 5) only and never reach the source cap (face 36)" });
}

TEST(SweepTopology, BlindHolesFromBothEnds)
{
  const SolidInput blind =
    cubes({ 3, 3, 5 }, [](int x, int y, int z) { return x != 1 || y != 1 || z == 2; });
  expectNoSweep(blind, { 5 }, { 56 },
    { "cannot be swept between these caps", "touch the source cap (face 5) only and never reach" });
}

TEST(SweepTopology, ATunnelThatComesBack)
{
  // A U below the top, and one above the bottom.
  const auto u = [](int x, int y, int z) {
    return y == 1 && ((x == 1 && z < 2) || (x == 3 && z < 2) || (x == 2 && z == 1));
  };
  const SolidInput one = cubes({ 5, 3, 4 }, [&](int x, int y, int z) { return !u(x, y, z); });
  expectNoSweep(one, { 5 }, { 46 },
    { "has 3 loops, the target cap (face 46) has 1 loop", "join 2 loops of the source cap (face 5)",
      "comes back to the same cap" });
  const SolidInput two =
    cubes({ 5, 3, 7 }, [&](int x, int y, int z) { return !u(x, y, z) && !u(x, y, 6 - z); });
  expectNoSweep(
    two, { 5 }, { 76 }, { "cannot be swept", "join 2 loops of the source cap (face 5)" });
}

TEST(SweepTopology, SidesThatBranch)
{
  // Two holes that a cross hole joins.
  const SolidInput h = cubes({ 5, 3, 3 },
    [](int x, int y, int z) { return y != 1 || (x != 1 && x != 3 && (x != 2 || z != 1)); });
  expectNoSweep(h, { 5 }, { 36 },
    { "branch: they join 2 loops of the source cap (face 5) with 2 loops of the target cap" });
  // Two holes that become one.
  const SolidInput y = cubes({ 5, 3, 2 },
    [](int x, int row, int z) { return row != 1 || x == 0 || x == 4 || (z == 0 && x == 2); });
  expectNoSweep(y, { 5 }, { 26 },
    { "different numbers of holes", "2 loops of the source cap (face 5) with 1 loop of" });
}

TEST(SweepTopology, ASideWithAHandle)
{
  const SolidInput tunnel = cubes({ 3, 3, 3 }, [](int, int y, int z) { return y != 1 || z != 1; });
  expectNoSweep(tunnel, { 5 }, { 36 }, { "no linking side: there is 1 handle" });
  const SolidInput cross =
    cubes({ 3, 3, 3 }, [](int x, int y, int z) { return z != 1 || (y != 1 && x != 1); });
  expectNoSweep(cross, { 5 }, { 36 }, { "no linking side: there are 3 handles" });
}

TEST(SweepTopology, FindsTheTarget)
{
  const SolidSurface plain = makeSolidSurface(box(2, 2, 3));
  EXPECT_EQ(findSweepTopology(plain, { 5 }).targetFaceIds, Ids{ 36 });
  EXPECT_EQ(findSweepTopology(plain, { 3 }).targetFaceIds, Ids{ 24 });
  // All walls, within and without, have one id.
  const SolidSurface holes =
    makeSolidSurface(cubes({ 7, 5, 3 }, twoHoles, [](const Cell& cell, int direction) {
      return direction < 5 ? Index(-4) : test::planeLabel(cell, direction);
    }));
  EXPECT_EQ(findSweepTopology(holes, { 36 }).targetFaceIds, Ids{ 5 });
  EXPECT_EQ(findSweepTopology(holes, { 5 }).sides.size(), 3u);
}

TEST(SweepTopology, FindsATargetOfSeveralFacesThatMeetSmoothly)
{
  const auto left = [](int x, int) { return x < 3; };
  const auto split = [&](const Cell& cell, int direction) {
    return topLabel(3, left)(cell, direction);
  };
  const SolidSurface holes = makeSolidSurface(cubes({ 7, 5, 3 }, twoHoles, split));
  EXPECT_EQ(findSweepTopology(holes, { 5 }).targetFaceIds, (Ids{ 7, 8 }));
  // A bent target hangs together under any feature angle: it is what lies across.
  SolidInput bent = cubes({ 7, 5, 3 }, twoHoles, split);
  for (Index i = 0; i < bent.points.rows(); ++i)
  {
    bent.points(i, 2) += 0.05 * bent.points(i, 2) * std::abs(bent.points(i, 0) - 3.0);
  }
  hexsweep::SolidOptions options;
  EXPECT_EQ(findSweepTopology(makeSolidSurface(bent, options), { 5 }).targetFaceIds, (Ids{ 7, 8 }));
  options.featureAngle = 0.1;
  EXPECT_EQ(findSweepTopology(makeSolidSurface(bent, options), { 5 }).targetFaceIds, (Ids{ 7, 8 }));
}

TEST(SweepTopology, OfSeveralTargetsTheBestIsTaken)
{
  // From one end of an L both walls beyond the bend fit as well as the other end.
  const SolidInput l = cubes({ 3, 3, 1 }, [](int x, int y, int) { return x == 0 || y == 0; });
  EXPECT_EQ(findSweepTopology(makeSolidSurface(l), { 32 }).targetFaceIds, Ids{ 34 });
  // Both the top and the upper band of the outer walls, each in two halves, are annuli.
  const auto halves = [](const Cell& cell, int direction) -> Index {
    const bool outer = cell[0] == 0 || cell[0] == 3 || cell[1] == 0 || cell[1] == 2;
    const bool wall = direction < 5 && outer;
    return direction == 6    ? (cell[0] < 2 ? 61 : 62)
      : wall && cell[2] == 1 ? (cell[0] < 2 ? 71 : 72)
                             : direction;
  };
  const auto hole = [](int x, int y, int) { return x == 0 || x == 3 || y != 1; };
  SolidInput tube = cubes({ 4, 3, 2 }, hole, halves);
  for (std::size_t t = 0; t < tube.faceIds.size(); ++t)
  {
    // The hole's own walls, whose cells lie beside the outer ones.
    bool within = tube.faceIds[t] < 5 || tube.faceIds[t] > 70;
    for (int c = 0; c < 3; ++c)
    {
      const Eigen::RowVector3d p = tube.points.row(tube.triangles(static_cast<Index>(t), c));
      within = within && p.x() > 0.5 && p.x() < 3.5 && p.y() > 0.5 && p.y() < 2.5;
    }
    tube.faceIds[t] = within ? 9 : tube.faceIds[t];
  }
  // The band leans inward, so that it does not meet the wall below it smoothly.
  for (Index i = 0; i < tube.points.rows(); ++i)
  {
    if (tube.points(i, 2) == 2.0)
    {
      tube.points.row(i).head<2>() =
        0.5 * (tube.points.row(i).head<2>() + Eigen::RowVector2d(2.0, 1.5));
    }
  }
  EXPECT_EQ(findSweepTopology(makeSolidSurface(tube), { 5 }).targetFaceIds, (Ids{ 61, 62 }));
}

TEST(SweepTopology, NoTargetFits)
{
  const SolidInput tetrahedron = []() {
    SolidInput input;
    input.points = hexsweep::Points(4, 3);
    input.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    input.triangles = test::facesOf<hexsweep::Triangles>({ 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2 });
    input.faceIds = { 1, 2, 3, 4 };
    return input;
  }();
  expectNoSweep(tetrahedron, { 1 }, {}, { "none fits the source cap (face 1): every other face" });
  const SolidInput blind =
    cubes({ 7, 5, 3 }, [](int x, int y, int z) { return twoHoles(x, y, z) || (x == 1 && z == 2); });
  expectNoSweep(blind, { 5 }, {},
    { "none fits the source cap (face 5). The likeliest is face 36, but: the source cap (face 5) "
      "has 3 loops",
      "12, 14, 21, 23 and 25 at" });
  const SolidInput tunnel = cubes({ 3, 3, 3 }, [](int, int y, int z) { return y != 1 || z != 1; });
  expectNoSweep(tunnel, { 5 }, {}, { "The likeliest is face 36", "there is 1 handle" });
  expectNoSweep(box(1, 1, 1), { 1, 3, 5, 12, 14, 16 }, {}, { "is the whole surface" });
}

TEST(SweepTopology, TheTargetIsAmongThoseThatATrialOfAllFacesFinds)
{
  const auto odd = [](int x, int y, int z) {
    return !(y == 1 && x == 1) && !(y == 3 && x >= 1 && z == 1);
  };
  const auto quarters = [](const Cell& cell, int direction) {
    return 100 * test::planeLabel(cell, direction) + 10 * (cell[0] / 2) + cell[1] / 2;
  };
  const std::vector<SolidInput> inputs = { box(2, 2, 3), cubes({ 7, 5, 3 }, twoHoles),
    cubes({ 3, 3, 1 }, [](int x, int y, int) { return x == 0 || y == 0; }), cubes({ 4, 5, 3 }, odd),
    box(4, 4, 2, quarters), cubes({ 3, 3, 3 }, [](int, int y, int z) { return y != 1 || z != 1; }),
    cubes({ 5, 5, 2 }, [](int x, int y, int) { return x % 2 == 0 || y % 2 == 0; }) };
  Index found = 0;
  Index several = 0;
  for (const SolidInput& input : inputs)
  {
    const SolidSurface solid = makeSolidSurface(input);
    const std::set<Index> ids(solid.faceIds.begin(), solid.faceIds.end());
    for (const Index source : ids)
    {
      Ids fitting;
      for (const Index target : ids)
      {
        try
        {
          expectConsistent(solid, findSweepTopology(solid, { source }, { target }));
          fitting.push_back(target);
        }
        catch (const hexsweep::InvalidInput&)
        {
        }
      }
      if (fitting.empty())
      {
        continue;
      }
      const Ids target = hexsweep::findTargetFaces(solid, { source });
      EXPECT_NO_THROW(expectConsistent(solid, findSweepTopology(solid, { source }, target)));
      if (target.size() == 1)
      {
        EXPECT_EQ(std::count(fitting.begin(), fitting.end(), target.front()), 1) << source;
        ++found;
      }
      several += fitting.size() > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(found, 10);
  EXPECT_GT(several, 5);
}

TEST(SweepTopology, DoesNotDependOnTheFacesOfTheSides)
{
  // Every wall triangle is a face of its own: many faces, one answer.
  Index next = 1000;
  const SolidInput input = cubes({ 7, 5, 3 }, twoHoles, [&](const Cell& cell, int direction) {
    return direction < 5 ? next++ : test::planeLabel(cell, direction);
  });
  const SolidSurface solid = makeSolidSurface(input);
  const SweepTopology topology = findSweepTopology(solid, { 5 });
  EXPECT_EQ(topology.targetFaceIds, Ids{ 36 });
  expectConsistent(solid, topology);
}
}
