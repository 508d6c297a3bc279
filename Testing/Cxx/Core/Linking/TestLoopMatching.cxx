// SPDX-License-Identifier: BSD-3-Clause
// Known motions of loops without symmetry are recovered.
#include "Core/Linking/LoopMatching.h"

#include "Support/CapMeshes.h"

namespace TestLoopMatching
{
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::MatchedLoops;
using hexsweep::Points;
using hexsweep::TriangleMesh;
using test::disordered;
using test::surfaceLoops;

/// A plate whose outline has no symmetry, with `holes` holes.
TriangleMesh lopsided(std::size_t holes)
{
  const std::vector<test::Block> blocks = test::threeHoles();
  TriangleMesh mesh = test::plate(
    12, std::vector<test::Block>(blocks.begin(), blocks.begin() + static_cast<long>(holes)));
  for (Index i = 0; i < mesh.points.rows(); ++i)
  {
    const double x = mesh.points(i, 0);
    const double y = mesh.points(i, 1);
    mesh.points.row(i) << 1.6 * x + 0.5 * y * y, y + 0.4 * x * x, 0.1 * x * y;
  }
  return mesh;
}

void expectRecovered(const MatchedLoops& matched, const Points& source, const Points& target,
  const std::vector<Loop>& loops, double size)
{
  ASSERT_EQ(matched.pairs.size(), loops.size());
  ASSERT_EQ(matched.startFractions.size(), loops.size());
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    ASSERT_EQ(matched.pairs[l].first.rows(), static_cast<Index>(loops[l].size()));
    for (std::size_t j = 0; j < loops[l].size(); ++j)
    {
      const Index row = static_cast<Index>(j);
      EXPECT_EQ(matched.pairs[l].first.row(row), source.row(loops[l][j]));
      EXPECT_LT((matched.pairs[l].second.row(row) - target.row(loops[l][j])).norm(), 1e-12 * size);
    }
  }
}

TEST(LoopMatching, RecoversMotionsWithoutTwist)
{
  // Translations, scalings, and turns about axes in the plane of the outer loop.
  for (const std::size_t holes : { 0u, 1u, 3u })
  {
    const TriangleMesh mesh = lopsided(holes);
    const std::vector<Loop> loops = surfaceLoops(mesh);
    for (const double tilt : { 0.0, 0.5, 1.2 })
    {
      for (const double scale : { 1.0, 0.3, 4.0 })
      {
        const test::Similarity motion{ scale,
          Eigen::AngleAxisd(tilt, Eigen::Vector3d(1, 2, 0).normalized()).toRotationMatrix(),
          { 3, -2, 5 } };
        const Points target = motion(mesh.points);
        for (const bool reversed : { false, true })
        {
          expectRecovered(
            hexsweep::matchLoopsByShape(mesh.points, loops, target, disordered(loops, reversed)),
            mesh.points, target, loops, scale);
        }
      }
    }
  }
}

TEST(LoopMatching, RecoversATwistOfLessThanHalfAnEdge)
{
  // Any more and another node is nearer: without linking sides a twist cannot be known.
  const TriangleMesh mesh = lopsided(3);
  const std::vector<Loop> loops = surfaceLoops(mesh);
  for (const double twist : { -0.04, 0.01, 0.04 })
  {
    const test::Similarity motion{ 1.5,
      Eigen::AngleAxisd(twist, Eigen::Vector3d::UnitZ()).toRotationMatrix(), { 0, 0, 5 } };
    const Points target = motion(mesh.points);
    expectRecovered(
      hexsweep::matchLoopsByShape(mesh.points, loops, target, disordered(loops, false)),
      mesh.points, target, loops, 1.5);
  }
}

TEST(LoopMatching, OtherNodesOnTheTarget)
{
  // The target has three times as many nodes: places are found by arc length among them.
  const TriangleMesh mesh = test::annulus(0.4, 1.0, 3, 20);
  const TriangleMesh fine = test::annulus(0.4, 1.0, 3, 60);
  Points source = mesh.points;
  Points target = fine.points;
  for (Points* points : { &source, &target })
  {
    points->col(0) *= 2.0; // no circle, so that the start is determined
    points->col(0) += 0.3 * points->col(1).cwiseProduct(points->col(1));
  }
  target.col(2).array() += 4.0;
  const std::vector<Loop> loops = surfaceLoops(mesh);
  const MatchedLoops matched =
    hexsweep::matchLoopsByShape(source, loops, target, surfaceLoops({ target, fine.triangles }));
  for (std::size_t l = 0; l < 2; ++l)
  {
    for (std::size_t j = 0; j < loops[l].size(); ++j)
    {
      const Eigen::RowVector3d expected = source.row(loops[l][j]) + Eigen::RowVector3d(0, 0, 4);
      // Arc lengths of the two polygons differ in second order of the coarse edges, 0.6 long.
      EXPECT_LT((matched.pairs[l].second.row(static_cast<Index>(j)) - expected).norm(), 0.03);
    }
  }
}

TEST(LoopMatching, StartIsReported)
{
  const TriangleMesh mesh = lopsided(0);
  const std::vector<Loop> loops = surfaceLoops(mesh);
  const double length = test::loopLength(mesh.points, loops[0]);
  for (const std::size_t shift : { 0u, 5u, 17u })
  {
    std::vector<Loop> moved = loops;
    std::rotate(moved[0].begin(), moved[0].begin() + static_cast<long>(shift), moved[0].end());
    double before = 0.0;
    for (std::size_t i = 0; i + shift < loops[0].size() && shift > 0; ++i)
    {
      const std::size_t next = (i + 1) % loops[0].size();
      before += (mesh.points.row(moved[0][next]) - mesh.points.row(moved[0][i])).norm();
    }
    const MatchedLoops matched =
      hexsweep::matchLoopsByShape(mesh.points, loops, mesh.points, moved);
    EXPECT_NEAR(matched.startFractions[0], before / length, 1e-14);
  }
}

TEST(LoopMatching, SizeAndPlaceDoNotMatter)
{
  const TriangleMesh mesh = lopsided(3);
  const std::vector<Loop> loops = surfaceLoops(mesh);
  const Points lifted = test::Similarity{ 0.7,
    Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 0).normalized()).toRotationMatrix(),
    { 1, 2, 3 } }(mesh.points);
  for (const test::Placement& placement : test::placements())
  {
    const Points source = placement.motion(mesh.points);
    const Points target = placement.motion(lifted);
    const MatchedLoops matched =
      hexsweep::matchLoopsByShape(source, loops, target, disordered(loops, false));
    for (std::size_t l = 0; l < loops.size(); ++l)
    {
      for (std::size_t j = 0; j < loops[l].size(); ++j)
      {
        EXPECT_LT(
          (matched.pairs[l].second.row(static_cast<Index>(j)) - target.row(loops[l][j])).norm(),
          1e3 * placement.relativeRounding * placement.motion.scale)
          << placement.name;
      }
    }
  }
}

TEST(LoopMatching, SweepsAlongArcs)
{
  // A lopsided section about an axis in its plane, by up to 270 degrees; half a circle turns the
  // target over in the plane of the source, which no area vector tells.
  const TriangleMesh mesh = lopsided(3);
  const std::vector<Loop> loops = surfaceLoops(mesh);
  for (const double degrees : { 30.0, 90.0, 120.0, 150.0, 180.0, 210.0, 270.0 })
  {
    Points target = mesh.points;
    const Eigen::RowVector3d onAxis(-6.0, 0.0, 0.0);
    const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(degrees * test::Pi / 180.0, Eigen::Vector3d::UnitY()).toRotationMatrix();
    target = ((target.rowwise() - onAxis) * turn.transpose()).rowwise() + onAxis;
    for (const bool reversed : { false, true })
    {
      const MatchedLoops matched =
        hexsweep::matchLoopsByShape(mesh.points, loops, target, disordered(loops, reversed));
      expectRecovered(matched, mesh.points, target, loops, 10.0);
      EXPECT_EQ(matched.doubts.size(), degrees == 180.0 ? 1u : 0u) << degrees;
    }
  }
}

TEST(LoopMatching, DifferentNumbersOfLoops)
{
  const TriangleMesh one = lopsided(1);
  const TriangleMesh three = lopsided(3);
  test::expectInvalid(
    [&] {
      hexsweep::matchLoopsByShape(one.points, surfaceLoops(one), three.points, surfaceLoops(three));
    },
    "the source has 2 boundary loop(s), the target surface 4");
}
}
