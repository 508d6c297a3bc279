// SPDX-License-Identifier: BSD-3-Clause
// Loops of two caps tied together: pairs from analytic sweeps, unions on circles.
#include "Core/Linking/CapBoundary.h"

#include "Core/CapQuads/SweepProjection.h"
#include "Support/CapMeshes.h"
#include "Support/SweepMeshes.h"

#include <set>

namespace TestCapBoundary
{
using hexsweep::CapBoundaries;
using hexsweep::CapBoundary;
using hexsweep::Index;
using hexsweep::LinkedLoops;
using hexsweep::Loop;
using hexsweep::LoopPair;
using hexsweep::makeCap;
using hexsweep::Points;
using hexsweep::TriangleMesh;

test::Sweep holedSweep()
{
  return test::makeSweep(12, 9, true, test::evenLayers(4), test::affineMotion);
}

LinkedLoops link(const test::Sweep& sweep, bool swapped)
{
  const auto loops = hexsweep::checkSurface(sweep.quads, sweep.source.rows(), "quads").loops;
  const Points& first = swapped ? sweep.target : sweep.source;
  const Points& second = swapped ? sweep.source : sweep.target;
  return hexsweep::linkLoops(
    first, loops, second, loops, sweep.linkingPoints, sweep.linkingQuads, 1e-6);
}

/// The sweep's pairs as sets of corresponding nodes, whatever their order.
void expectCorresponding(const LinkedLoops& linked, const test::Sweep& sweep, bool swapped)
{
  ASSERT_EQ(linked.pairs.size(), 2u);
  const bool firstIsSource = swapped == linked.swapped;
  std::set<Index> seen;
  for (const LoopPair& pair : linked.pairs)
  {
    ASSERT_EQ(pair.first.rows(), pair.second.rows());
    for (Index j = 0; j < pair.first.rows(); ++j)
    {
      const Points& own = firstIsSource ? sweep.source : sweep.target;
      const Points& other = firstIsSource ? sweep.target : sweep.source;
      Index id = 0;
      EXPECT_EQ((own.rowwise() - pair.first.row(j)).rowwise().norm().minCoeff(&id), 0.0);
      EXPECT_EQ(pair.second.row(j), other.row(id));
      seen.insert(id);
    }
  }
  EXPECT_EQ(
    static_cast<Index>(seen.size()), linked.pairs[0].first.rows() + linked.pairs[1].first.rows());
  // The outer loop is the longer one: 2 x (12 + 9) nodes.
  EXPECT_EQ(linked.pairs[0].first.rows(), 42);
  EXPECT_EQ(linked.pairs[1].first.rows(), 14);
}

/// Nodes of a circle as a ring.
Points ringOf(Index n, double start, double radius, double z)
{
  Points ring(n, 3);
  for (Index i = 0; i < n; ++i)
  {
    const double angle = start + 2.0 * test::Pi * static_cast<double>(i) / static_cast<double>(n);
    ring.row(i) << radius * std::cos(angle), radius * std::sin(angle), z;
  }
  return ring;
}

/// Each loop is a boundary loop of the mesh, node for node.
void expectLoopsAreTheBoundary(const CapBoundary& cap)
{
  const auto topology = hexsweep::checkSurface(cap.mesh.triangles, cap.mesh.points.rows(), "cap");
  ASSERT_EQ(topology.loops.size(), cap.loops.size());
  for (Loop loop : cap.loops)
  {
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    EXPECT_EQ(std::count(topology.loops.begin(), topology.loops.end(), loop), 1);
  }
}

TriangleMesh moved(TriangleMesh mesh, double z)
{
  mesh.points.col(2).array() += z;
  return mesh;
}

std::vector<LoopPair> circlePairs(Index outer, Index inner)
{
  // Holes run clockwise, as boundary loops do.
  const Points hole = ringOf(inner, 0.0, 0.4, 0.0).colwise().reverse();
  LoopPair rim{ ringOf(outer, 0.0, 1.0, 0.0), ringOf(outer, 0.0, 1.0, 2.0) };
  LoopPair pair{ hole, hole };
  pair.second.col(2).array() += 2.0;
  return { rim, pair };
}

TEST(CapBoundary, LinkedLoopsFollowTheColumns)
{
  for (const bool disorder : { false, true })
  {
    for (const bool cut : { false, true })
    {
      test::Sweep sweep = holedSweep();
      if (cut)
      {
        test::cutLinkingSides(sweep);
      }
      if (disorder)
      {
        test::disorderLinkingSides(sweep);
      }
      expectCorresponding(link(sweep, false), sweep, false);
      expectCorresponding(link(sweep, true), sweep, true);
    }
  }
}

TEST(CapBoundary, EitherOrderOfTheCapsGivesTheSamePairs)
{
  test::Sweep sweep = holedSweep();
  test::disorderLinkingSides(sweep);
  const LinkedLoops plain = link(sweep, false);
  const LinkedLoops swapped = link(sweep, true);
  EXPECT_NE(plain.swapped, swapped.swapped);
  ASSERT_EQ(plain.pairs.size(), swapped.pairs.size());
  for (std::size_t p = 0; p < plain.pairs.size(); ++p)
  {
    EXPECT_EQ(plain.pairs[p].first, swapped.pairs[p].first);
    EXPECT_EQ(plain.pairs[p].second, swapped.pairs[p].second);
  }
}

TEST(CapBoundary, SameBoundaryNodesNeedNoRefinement)
{
  const TriangleMesh first = test::plate(12, test::threeHoles(), 0.3, 1);
  const TriangleMesh second = moved(test::plate(12, test::threeHoles(), 0.3, 2), 2.0);
  const auto loops = test::loopsOf(first);
  const CapBoundaries caps = hexsweep::matchCapBoundaries(makeCap(first, "first"),
    makeCap(second, "second"), test::pairsOf(first.points, second.points, loops), 1e-6);
  EXPECT_EQ(caps.first.loops, loops);
  EXPECT_EQ(caps.second.loops, loops);
  EXPECT_EQ(caps.first.maximumDistance, 0.0);
  for (std::size_t p = 0; p < loops.size(); ++p)
  {
    EXPECT_EQ(caps.united[p].size(), loops[p].size());
  }
  expectLoopsAreTheBoundary(caps.first);
  expectLoopsAreTheBoundary(caps.second);
}

TEST(CapBoundary, UnionOfMismatchedCircles)
{
  // Rings of 24 and 12 nodes; boundary polygons of other counts, with chords between.
  const TriangleMesh first = test::annulus(0.4, 1.0, 4, 36);
  const TriangleMesh second = moved(test::annulus(0.4, 1.0, 3, 25), 2.0);
  const CapBoundaries caps = hexsweep::matchCapBoundaries(
    makeCap(first, "first"), makeCap(second, "second"), circlePairs(24, 12), 1e-6);
  for (const CapBoundary* cap : { &caps.first, &caps.second })
  {
    expectLoopsAreTheBoundary(*cap);
    ASSERT_EQ(cap->loops.size(), 2u);
    // Sagitta of the coarser of the two polygons.
    EXPECT_LT(cap->maximumDistance, 1.0 - std::cos(test::Pi / 24.0));
    for (std::size_t p = 0; p < 2; ++p)
    {
      ASSERT_EQ(cap->loops[p].size(), caps.united[p].size());
      const Points& ring = cap == &caps.first ? caps.pairs[p].first : caps.pairs[p].second;
      for (std::size_t k = 0; k < caps.united[p].size(); ++k)
      {
        const double s = caps.united[p][k];
        const Index edge = static_cast<Index>(s);
        const double f = s - static_cast<double>(edge);
        const Eigen::RowVector3d place =
          (1.0 - f) * ring.row(edge) + f * ring.row((edge + 1) % ring.rows());
        EXPECT_LT((cap->mesh.points.row(cap->loops[p][k]) - place).norm(), p == 0 ? 0.03 : 0.05);
      }
    }
  }
  // Every boundary vertex of either cap has a place, most have their own.
  EXPECT_GE(caps.united[0].size(), 36u + 24u);
  EXPECT_EQ(caps.first.mesh.points.topRows(first.points.rows()), first.points);
  EXPECT_EQ(caps.second.mesh.points.topRows(second.points.rows()), second.points);
}

TEST(CapBoundary, CapsOfAnyOrientation)
{
  const TriangleMesh first = test::annulus(0.4, 1.0, 4, 36);
  const TriangleMesh second = moved(test::annulus(0.4, 1.0, 3, 25), 2.0);
  for (const bool turnFirst : { false, true })
  {
    for (const bool turnSecond : { false, true })
    {
      TriangleMesh a = first;
      TriangleMesh b = second;
      a.triangles = turnFirst ? test::turnedOver(first.triangles) : first.triangles;
      b.triangles = turnSecond ? test::turnedOver(second.triangles) : second.triangles;
      const CapBoundaries caps = hexsweep::matchCapBoundaries(
        makeCap(a, "first"), makeCap(b, "second"), circlePairs(24, 12), 1e-6);
      // Loops run as the faces do, and the rings say which side is up.
      expectLoopsAreTheBoundary(caps.first);
      expectLoopsAreTheBoundary(caps.second);
      EXPECT_EQ(caps.pairs[0].first, circlePairs(24, 12)[0].first);
      const CapBoundaries plain = hexsweep::matchCapBoundaries(
        makeCap(first, "first"), makeCap(second, "second"), circlePairs(24, 12), 1e-6);
      for (const auto& [one, other] :
        { std::make_pair(&caps.first, &plain.first), std::make_pair(&caps.second, &plain.second) })
      {
        EXPECT_EQ(one->mesh.points, other->mesh.points);
        EXPECT_EQ(one->loops, other->loops);
      }
    }
  }
}

TEST(CapBoundary, ChordsAreSplit)
{
  const TriangleMesh first = test::plate(1, {});
  const TriangleMesh second = moved(test::plate(3, {}, 0.2), 1.0);
  LoopPair pair;
  const Loop loop = test::loopsOf(first)[0];
  pair = test::pairsOf(first.points, first.points, { loop })[0];
  pair.second.col(2).array() += 1.0;
  const CapBoundaries caps = hexsweep::matchCapBoundaries(
    makeCap(first, "first"), makeCap(second, "second"), { pair }, 1e-6);
  EXPECT_EQ(caps.united[0].size(), 12u);
  std::vector<bool> boundary(static_cast<std::size_t>(caps.first.mesh.points.rows()), false);
  for (const Index v : caps.first.loops[0])
  {
    boundary[static_cast<std::size_t>(v)] = true;
  }
  for (Index t = 0; t < caps.first.mesh.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index a = caps.first.mesh.triangles(t, c);
      const Index b = caps.first.mesh.triangles(t, (c + 1) % 3);
      if (boundary[static_cast<std::size_t>(a)] && boundary[static_cast<std::size_t>(b)])
      {
        const Loop& ring = caps.first.loops[0];
        const auto at =
          static_cast<std::size_t>(std::find(ring.begin(), ring.end(), a) - ring.begin());
        EXPECT_TRUE(
          ring[(at + 1) % ring.size()] == b || ring[(at + ring.size() - 1) % ring.size()] == b);
      }
    }
  }
}

TEST(CapBoundary, LoopsThatDoNotBelong)
{
  const TriangleMesh first = test::annulus(0.4, 1.0, 4, 36);
  const TriangleMesh second = moved(test::annulus(0.4, 1.0, 3, 25), 2.0);
  const auto match = [&](const std::vector<LoopPair>& pairs) {
    hexsweep::matchCapBoundaries(makeCap(first, "first"), makeCap(second, "second"), pairs, 1e-6);
  };
  std::vector<LoopPair> pairs = circlePairs(24, 12);
  test::expectInvalid(
    [&] { match({ pairs[0] }); }, "2 boundary loop(s), but the linking sides have 1");

  pairs[1].second.col(0).array() += 0.2;
  test::expectInvalid([&] { match(pairs); }, "does not lie on the boundary of the second cap");

  pairs = circlePairs(24, 12);
  pairs[1] = pairs[0];
  test::expectInvalid([&] { match(pairs); }, "same loop of the first cap");

  pairs = circlePairs(24, 12);
  pairs[1].second = pairs[1].second.colwise().reverse().eval();
  test::expectInvalid([&] { match(pairs); }, "inside out");

  // Runs twice round.
  pairs = circlePairs(24, 12);
  Points twice(48, 3);
  twice << pairs[0].first, pairs[0].first;
  pairs[0].first = twice;
  twice << pairs[0].second, pairs[0].second;
  pairs[0].second = twice;
  test::expectInvalid([&] { match(pairs); }, "does not run once round");
}

TEST(CapBoundary, MessagesUseTheNamesThatTheUserKnows)
{
  const TriangleMesh first = test::annulus(0.4, 1.0, 4, 36);
  const TriangleMesh second = moved(test::annulus(0.4, 1.0, 3, 25), 2.0);
  const hexsweep::CapNames names{ "source surface", "target surface", "source quads" };
  std::vector<LoopPair> pairs = circlePairs(24, 12);
  test::expectInvalid(
    [&] {
      hexsweep::matchCapBoundaries(
        makeCap(first, "first"), makeCap(second, "second"), { pairs[0] }, 1e-6, names);
    },
    "the source surface has 2 boundary loop(s), but the source quads have 1");
  pairs[1].second.col(0).array() += 0.2;
  test::expectInvalid(
    [&] {
      hexsweep::matchCapBoundaries(
        makeCap(first, "first"), makeCap(second, "second"), pairs, 1e-6, names);
    },
    "a loop of the source quads does not lie on the boundary of the target surface");
}

TEST(CapBoundary, LinkingSidesThatEndElsewhere)
{
  // Both ends are nearer to the first cap, which is far below the second one.
  const test::Sweep sweep = holedSweep();
  const auto loops = hexsweep::checkSurface(sweep.quads, sweep.source.rows(), "quads").loops;
  const Points far = sweep.target.rowwise() + Eigen::RowVector3d(0, 0, 100);
  test::expectInvalid(
    [&] {
      hexsweep::linkLoops(
        sweep.source, loops, far, loops, sweep.linkingPoints, sweep.linkingQuads, 1e-6);
    },
    "of the 4 boundary loops of the linking sides, 4 lie at one cap and 0 at the other");
}

TEST(CapBoundary, LinkingSidesOfAnotherVolume)
{
  const test::Sweep sweep = holedSweep();
  const auto loops = hexsweep::checkSurface(sweep.quads, sweep.source.rows(), "quads").loops;
  // A hole in the linking sides.
  EXPECT_THROW(hexsweep::linkLoops(sweep.source, loops, sweep.target, loops, sweep.linkingPoints,
                 sweep.linkingQuads.topRows(sweep.linkingQuads.rows() - 1), 1e-6),
    hexsweep::InvalidInput);
  // A closed surface has no loop that could lie on a cap.
  const auto box = test::facesOf<hexsweep::Quads>(
    { 0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7 });
  Points corners(8, 3);
  corners << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1;
  EXPECT_THROW(hexsweep::linkLoops(sweep.source, loops, sweep.target, loops, corners, box, 1e-6),
    hexsweep::InvalidInput);
}
}
