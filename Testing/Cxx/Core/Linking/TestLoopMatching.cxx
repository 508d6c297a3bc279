// SPDX-License-Identifier: BSD-3-Clause
// Known motions of loops without symmetry are recovered.
#include "Core/Linking/LoopMatching.h"

#include "Core/Geometry/ClosedPolygon.h"
#include "Core/Linking/Assignment.h"
#include "Support/CapMeshes.h"

#include <array>
#include <numeric>
#include <random>

namespace TestLoopMatching
{
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::MatchedLoops;
using hexsweep::Points;
using hexsweep::TriangleMesh;

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

std::vector<Loop> topologyLoops(const TriangleMesh& mesh)
{
  return hexsweep::checkSurface(mesh.triangles, mesh.points.rows(), "mesh").loops;
}

/// The target's loops in another order, beginning elsewhere, perhaps running the other way.
std::vector<Loop> disordered(std::vector<Loop> loops, bool reversed)
{
  std::reverse(loops.begin(), loops.end());
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    std::rotate(loops[l].begin(), loops[l].begin() + static_cast<long>((3 + l) % loops[l].size()),
      loops[l].end());
    if (reversed)
    {
      std::reverse(loops[l].begin(), loops[l].end());
    }
  }
  return loops;
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
    const std::vector<Loop> loops = topologyLoops(mesh);
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
  const std::vector<Loop> loops = topologyLoops(mesh);
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
  const std::vector<Loop> loops = topologyLoops(mesh);
  const MatchedLoops matched =
    hexsweep::matchLoopsByShape(source, loops, target, topologyLoops({ target, fine.triangles }));
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
  const std::vector<Loop> loops = topologyLoops(mesh);
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
  const std::vector<Loop> loops = topologyLoops(mesh);
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

TEST(LoopMatching, DifferentNumbersOfLoops)
{
  const TriangleMesh one = lopsided(1);
  const TriangleMesh three = lopsided(3);
  test::expectInvalid(
    [&] {
      hexsweep::matchLoopsByShape(
        one.points, topologyLoops(one), three.points, topologyLoops(three));
    },
    "the source has 2 boundary loop(s), the target surface 4");
}

/// A closed polygon through the corners, each of its sides cut into equal edges.
Points outline(const std::vector<std::array<double, 2>>& corners, Index edgesPerSide)
{
  const Index n = static_cast<Index>(corners.size());
  Points points(n * edgesPerSide, 3);
  for (Index c = 0; c < n; ++c)
  {
    const auto& a = corners[static_cast<std::size_t>(c)];
    const auto& b = corners[static_cast<std::size_t>((c + 1) % n)];
    for (Index e = 0; e < edgesPerSide; ++e)
    {
      const double t = static_cast<double>(e) / static_cast<double>(edgesPerSide);
      points.row(c * edgesPerSide + e) << (1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1], 0.0;
    }
  }
  return points;
}

Points rectangle(double width, double height, Index edgesPerSide)
{
  const double x = 0.5 * width;
  const double y = 0.5 * height;
  return outline({ { { -x, -y } }, { { x, -y } }, { { x, y } }, { { -x, y } } }, edgesPerSide);
}

Points polygonOnCircle(Index n, double radius, double turn)
{
  Points points(n, 3);
  for (Index i = 0; i < n; ++i)
  {
    const double angle = turn + 2.0 * test::Pi * static_cast<double>(i) / static_cast<double>(n);
    points.row(i) << radius * std::cos(angle), radius * std::sin(angle), 0.0;
  }
  return points;
}

const std::vector<std::array<double, 2>> LShape{ { { 0, 0 } }, { { 3, 0 } }, { { 3, 1 } },
  { { 1, 1 } }, { { 1, 2 } }, { { 0, 2 } } };

/// Beginning at another node.
Points begunAt(const Points& points, Index first)
{
  Points result(points.rows(), 3);
  for (Index i = 0; i < points.rows(); ++i)
  {
    result.row(i) = points.row((i + first) % points.rows());
  }
  return result;
}

Points lifted(Points points, double height)
{
  points.col(2).array() += height;
  return points;
}

Points turned(const Points& points, double degrees)
{
  const double angle = degrees * test::Pi / 180.0;
  return test::Similarity{ 1.0,
    Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix(), { 0, 0, 0 } }(points);
}

Loop wholeLoop(const Points& points)
{
  Loop loop(static_cast<std::size_t>(points.rows()));
  std::iota(loop.begin(), loop.end(), Index{ 0 });
  return loop;
}

MatchedLoops matchOne(const Points& source, const Points& target)
{
  return hexsweep::matchLoopsByShape(source, { wholeLoop(source) }, target, { wholeLoop(target) });
}

/// Several loops in one array of points.
struct Plan
{
  Points points;
  std::vector<Loop> loops;

  void add(const Points& loop)
  {
    const Index before = this->points.rows();
    this->points.conservativeResize(before + loop.rows(), 3);
    this->points.bottomRows(loop.rows()) = loop;
    Loop ids = wholeLoop(loop);
    for (Index& id : ids)
    {
      id += before;
    }
    this->loops.push_back(ids);
  }
};

TEST(LoopMatching, CornersOfASquareGoToThoseOfARectangle)
{
  // Sides of the rectangle have other numbers of nodes; it begins anywhere and is turned a little.
  const Points square = rectangle(1, 1, 6);
  for (const double height : { 1.0, 1.5, 3.0, 8.0 })
  {
    for (const Index first : { 0, 5, 21 })
    {
      for (const double degrees : { 0.0, 20.0, -30.0 })
      {
        const Points target =
          lifted(turned(begunAt(rectangle(1, height, 10), first), degrees), 2.0);
        const Points expected = lifted(turned(rectangle(1, height, 6), degrees), 2.0);
        const MatchedLoops matched = matchOne(square, target);
        EXPECT_LT((matched.pairs[0].second - expected).rowwise().norm().maxCoeff(), 1e-12)
          << height << " " << first << " " << degrees;
        EXPECT_TRUE(matched.doubts.empty()) << height << " " << degrees;
      }
    }
  }
}

TEST(LoopMatching, CornersOfTurnedAndScaledL)
{
  const Points source = outline(LShape, 5);
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    for (const double degrees : { 0.0, 20.0, -40.0 })
    {
      Points target = turned(outline(LShape, 8), degrees);
      target.col(0) *= 1.3;
      Points expected = turned(source, degrees);
      expected.col(0) *= 1.3;
      const MatchedLoops matched =
        matchOne(scale * source, scale * lifted(begunAt(target, 13), 3.0));
      EXPECT_LT(
        (matched.pairs[0].second - scale * lifted(expected, 3.0)).rowwise().norm().maxCoeff(),
        1e-12 * scale)
        << scale << " " << degrees;
      EXPECT_TRUE(matched.doubts.empty());
    }
  }
}

TEST(LoopMatching, CornersThatOnlyOneLoopHasAreLeftOver)
{
  // A slot in one side of the target: the six corners of the L still find theirs.
  std::vector<std::array<double, 2>> slotted = LShape;
  slotted.insert(
    slotted.begin() + 1, { { { 1.4, 0 } }, { { 1.4, 0.3 } }, { { 1.6, 0.3 } }, { { 1.6, 0 } } });
  for (const bool swapped : { false, true })
  {
    const Points plain = outline(LShape, 8);
    const Points cut = outline(slotted, 8);
    const MatchedLoops matched =
      swapped ? matchOne(cut, lifted(plain, 1.0)) : matchOne(plain, lifted(cut, 1.0));
    const hexsweep::LoopPair& pair = matched.pairs[0];
    for (Index c = 0; c < 6; ++c)
    {
      const Eigen::RowVector3d corner(
        LShape[static_cast<std::size_t>(c)][0], LShape[static_cast<std::size_t>(c)][1], 0.0);
      Index node = 0;
      ASSERT_EQ((pair.first.rowwise() - corner).rowwise().norm().minCoeff(&node), 0.0);
      EXPECT_LT((pair.second.row(node) - corner - Eigen::RowVector3d(0, 0, 1)).norm(), 1e-12)
        << swapped << " corner " << c;
    }
  }
}

TEST(LoopMatching, SquareToCircleFollowsArcLength)
{
  const Points square = rectangle(1, 1, 8);
  const Points circle = polygonOnCircle(64, 0.7, 0.0);
  const MatchedLoops matched = matchOne(square, lifted(circle, 1.0));
  EXPECT_TRUE(matched.doubts.empty());
  for (Index i = 0; i < 32; ++i)
  {
    // The first corner lies at -135 degrees.
    const double angle = (-0.75 + static_cast<double>(i) / 16.0) * test::Pi;
    const Eigen::RowVector3d expected(0.7 * std::cos(angle), 0.7 * std::sin(angle), 1.0);
    EXPECT_LT((matched.pairs[0].second.row(i) - expected).norm(), 1e-3) << i;
  }
}

TEST(LoopMatching, GearToRoundFollowsArcLengthWithoutTwist)
{
  // Twelve teeth with square corners; the round target has no corner.
  std::vector<std::array<double, 2>> teeth;
  for (int k = 0; k < 24; ++k)
  {
    const double radius = k % 2 == 0 ? 1.0 : 0.85;
    for (const double side : { -0.5, 0.5 })
    {
      const double angle = (k + side) * test::Pi / 12.0;
      teeth.push_back({ { radius * std::cos(angle), radius * std::sin(angle) } });
    }
  }
  const Points gear = outline(teeth, 4);
  const MatchedLoops matched = matchOne(gear, lifted(polygonOnCircle(200, 1.0, 0.3), 1.0));
  EXPECT_TRUE(matched.doubts.empty());
  for (Index i = 0; i < gear.rows(); ++i)
  {
    const Eigen::RowVector3d place = matched.pairs[0].second.row(i);
    const double twist = std::remainder(
      std::atan2(place[1], place[0]) - std::atan2(gear(i, 1), gear(i, 0)), 2.0 * test::Pi);
    EXPECT_LT(std::abs(twist), 0.08) << i; // a tooth and its gap are 0.52
  }
}

TEST(LoopMatching, FinelyFacettedCurvesHaveNoCorners)
{
  const auto corners = [](const Points& points) {
    return hexsweep::loopCorners(hexsweep::ClosedPolygon(points)).size();
  };
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    EXPECT_EQ(corners(scale * polygonOnCircle(16, 1.0, 0.1)), 0u);
    EXPECT_EQ(corners(scale * polygonOnCircle(1000, 1.0, 0.1)), 0u);
    EXPECT_EQ(corners(scale * polygonOnCircle(8, 1.0, 0.1)), 8u);
    EXPECT_EQ(corners(scale * rectangle(1, 3, 7)), 4u);
    EXPECT_EQ(corners(scale * outline(LShape, 3)), 6u);
  }
  // A fillet of six facets, a fortieth of the side wide, is one corner each.
  std::vector<std::array<double, 2>> filleted;
  for (int c = 0; c < 4; ++c)
  {
    for (int f = 0; f <= 6; ++f)
    {
      const double angle = (c + f / 6.0) * test::Pi / 2.0;
      const double x = c == 0 || c == 3 ? 0.475 : -0.475;
      const double y = c < 2 ? 0.475 : -0.475;
      filleted.push_back({ { x + 0.025 * std::cos(angle), y + 0.025 * std::sin(angle) } });
    }
  }
  EXPECT_EQ(corners(outline(filleted, 1)), 4u);
}

TEST(LoopMatching, FortyHolesInAffineMotion)
{
  // Rows of holes that a square plate carries along as it becomes a long, turned rectangle.
  Plan source;
  source.add(rectangle(10, 10, 10));
  for (int k = 0; k < 40; ++k)
  {
    Points hole = rectangle(0.4, 0.3, 3).colwise().reverse();
    hole.col(0).array() += -4.0 + 8.0 / 7.0 * (k % 8) + 0.03 * (k / 8);
    hole.col(1).array() += -4.0 + 2.0 * (k / 8);
    source.add(hole);
  }
  Points moved = source.points;
  moved.col(1) *= 3.0;
  moved = lifted(turned(moved, 20.0), 5.0);
  const MatchedLoops matched =
    hexsweep::matchLoopsByShape(source.points, source.loops, moved, disordered(source.loops, true));
  for (std::size_t l = 0; l < source.loops.size(); ++l)
  {
    for (std::size_t j = 0; j < source.loops[l].size(); ++j)
    {
      EXPECT_LT(
        (matched.pairs[l].second.row(static_cast<Index>(j)) - moved.row(source.loops[l][j])).norm(),
        1e-11)
        << l;
    }
  }
  EXPECT_TRUE(matched.doubts.empty()) << matched.doubts[0];
}

TEST(LoopMatching, HolesAreAssignedTogether)
{
  // Each hole moves 0.6 of a pitch: the nearest target of all but the last is the next one's.
  Plan source;
  Plan target;
  source.add(rectangle(10, 4, 10));
  target.add(lifted(rectangle(10, 4, 10), 3.0));
  for (int k = 0; k < 5; ++k)
  {
    const Points hole = polygonOnCircle(8, 0.3, 0.0).colwise().reverse();
    Points first = hole;
    first.col(0).array() += -4.0 + 1.5 * k;
    source.add(first);
    Points second = lifted(hole, 3.0);
    second.col(0).array() += -4.0 + 1.5 * k + 0.9;
    target.add(second);
  }
  std::reverse(target.loops.begin(), target.loops.end());
  const MatchedLoops matched =
    hexsweep::matchLoopsByShape(source.points, source.loops, target.points, target.loops);
  for (std::size_t l = 1; l < 6; ++l)
  {
    const Eigen::RowVector3d shift =
      matched.pairs[l].second.colwise().mean() - matched.pairs[l].first.colwise().mean();
    EXPECT_NEAR(shift[0], 0.9, 1e-12) << l;
  }
  // And it is said that this is a guess, for each hole whose neighbour's place is nearer.
  ASSERT_EQ(matched.doubts.size(), 4u);
  EXPECT_NE(matched.doubts[0].find("which hole of the target loop 2"), std::string::npos)
    << matched.doubts[0];
}

TEST(LoopMatching, SymmetricLoopsTurnedByHalfASideAreAGuess)
{
  const Points square = rectangle(1, 1, 6);
  for (const double degrees : { 44.0, 45.0, 46.0 })
  {
    const MatchedLoops matched = matchOne(square, lifted(turned(square, degrees), 1.0));
    ASSERT_EQ(matched.doubts.size(), 1u) << degrees;
    EXPECT_NE(matched.doubts[0].find("loop 0 (the outer one, around (0, 0, 0))"), std::string::npos)
      << matched.doubts[0];
    EXPECT_NE(matched.doubts[0].find("0.25 of its length"), std::string::npos) << matched.doubts[0];
    // Corners on corners all the same.
    EXPECT_NEAR(matched.pairs[0].second.row(0).head<2>().norm(), std::sqrt(0.5), 1e-12);
  }
  EXPECT_TRUE(matchOne(square, lifted(turned(square, 30.0), 1.0)).doubts.empty());
}

TEST(LoopMatching, SweepsAlongArcs)
{
  // A lopsided section about an axis in its plane, by up to 270 degrees; half a circle turns the
  // target over in the plane of the source, which no area vector tells.
  const TriangleMesh mesh = lopsided(3);
  const std::vector<Loop> loops = topologyLoops(mesh);
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

TEST(Assignment, LeastOfAllPermutations)
{
  std::mt19937 generator(5);
  for (Index n = 1; n <= 6; ++n)
  {
    for (int round = 0; round < 20; ++round)
    {
      Eigen::MatrixXd cost(n, n);
      for (Index i = 0; i < cost.size(); ++i)
      {
        cost.data()[i] = static_cast<double>(generator() % 50) - 10.0;
      }
      std::vector<Index> order(static_cast<std::size_t>(n));
      std::iota(order.begin(), order.end(), Index{ 0 });
      const auto total = [&](const std::vector<Index>& columns) {
        double sum = 0.0;
        for (Index i = 0; i < n; ++i)
        {
          sum += cost(i, columns[static_cast<std::size_t>(i)]);
        }
        return sum;
      };
      std::vector<Index> found = hexsweep::leastCostAssignment(cost);
      double least = total(order);
      do
      {
        least = std::min(least, total(order));
      } while (std::next_permutation(order.begin(), order.end()));
      EXPECT_EQ(total(found), least);
      std::sort(found.begin(), found.end());
      std::iota(order.begin(), order.end(), Index{ 0 });
      EXPECT_EQ(found, order);
    }
  }
}
}
