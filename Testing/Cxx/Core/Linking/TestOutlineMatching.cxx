// SPDX-License-Identifier: BSD-3-Clause
// Outlines with corners, round ones and rows of holes: which corner goes to which, which hole to
// which, and where that is a guess.
#include "Core/Linking/LoopMatching.h"

#include "Support/CapMeshes.h"

#include "Core/Geometry/ClosedPolygon.h"

#include <array>
#include <numeric>

namespace TestOutlineMatching
{
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::MatchedLoops;
using hexsweep::Points;
using test::disordered;

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
}
