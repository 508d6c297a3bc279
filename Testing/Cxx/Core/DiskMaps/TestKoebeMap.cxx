// SPDX-License-Identifier: BSD-3-Clause
// Caps of many shapes become circle domains, in few rounds.
#include "Core/DiskMaps/KoebeMap.h"

#include "Support/CapMeshes.h"
#include "Support/CircleDomains.h"

#include "Core/DiskMaps/CanonicalDiskMap.h"

#include <limits>

namespace TestKoebeMap
{
using hexsweep::Circle;
using hexsweep::Index;
using hexsweep::KoebeMap;
using hexsweep::Loop;
using hexsweep::Points;
using hexsweep::TriangleMesh;
using test::CircleDomain;
using test::Pi;

/// What is true of every result: nodes on their circles, circles clear of each other, rounds in
/// order, no triangle of the harmonic map flipped.
void expectCircleDomain(
  const TriangleMesh& mesh, const std::vector<Loop>& loops, const KoebeMap& map)
{
  ASSERT_EQ(map.holes.size() + 1, loops.size());
  ASSERT_EQ(map.places.size(), loops.size());
  for (std::size_t p = 0; p < loops.size(); ++p)
  {
    const Circle circle = p == 0 ? Circle{ { 0.0, 0.0 }, 1.0 } : map.holes[p - 1];
    ASSERT_EQ(map.places[p].rows(), static_cast<Index>(loops[p].size()));
    double turn = 0.0;
    for (Index i = 0; i < map.places[p].rows(); ++i)
    {
      const Eigen::RowVector2d arm = map.places[p].row(i) - circle.center;
      EXPECT_NEAR(arm.norm(), circle.radius, 1e-14);
      const Eigen::RowVector2d next =
        map.places[p].row((i + 1) % map.places[p].rows()) - circle.center;
      const double step = std::arg(test::complexOf(next) / test::complexOf(arm));
      EXPECT_GT(p == 0 ? step : -step, 0.0);
      turn += step;
    }
    EXPECT_NEAR(turn, p == 0 ? 2.0 * Pi : -2.0 * Pi, 1e-9);
    EXPECT_LT(circle.center.norm() + circle.radius, 1.0 + 1e-14);
    for (std::size_t q = 1; q < p; ++q)
    {
      EXPECT_GT(
        (circle.center - map.holes[q - 1].center).norm(), circle.radius + map.holes[q - 1].radius);
    }
  }
  hexsweep::CapDisk cap;
  cap.mesh = mesh;
  cap.loops = loops;
  cap.domain = hexsweep::DiskDomain::Circles;
  cap.holes = map.holes;
  hexsweep::mapWithFallback(cap, hexsweep::Weights::Cotangent, [&](hexsweep::Weights weights) {
    return hexsweep::mapToPlane(mesh, loops, map.places, weights);
  });
  EXPECT_TRUE(cap.flipped.empty());
}

TriangleMesh fortyHoles(double spacing)
{
  // Warped by a map that is not conformal: no hole stays round.
  TriangleMesh mesh = test::circleDomain(test::scatteredHoles(40, 0.03, 0.08), spacing).mesh;
  for (Index i = 0; i < mesh.points.rows(); ++i)
  {
    const double x = mesh.points(i, 0);
    const double y = mesh.points(i, 1);
    mesh.points.row(i) << 1.5 * x + 0.2 * std::sin(3.0 * y), y + 0.1 * std::sin(4.0 * x),
      0.3 * std::cos(2.0 * x + y);
  }
  return mesh;
}

double greatestDifference(const KoebeMap& a, const KoebeMap& b)
{
  double greatest =
    (test::coordinatesOf(a.holes) - test::coordinatesOf(b.holes)).cwiseAbs().maxCoeff();
  for (std::size_t p = 0; p < a.places.size(); ++p)
  {
    greatest = std::max(greatest, (a.places[p] - b.places[p]).cwiseAbs().maxCoeff());
  }
  return greatest;
}

KoebeMap expectSixRounds(const TriangleMesh& mesh, const std::vector<hexsweep::Loop>& loops)
{
  KoebeMap map = hexsweep::koebeMap(mesh.points, mesh.triangles, loops);
  EXPECT_TRUE(map.converged);
  EXPECT_LE(map.rounds.size(), 6u);
  testing::Test::RecordProperty("rounds", static_cast<int>(map.rounds.size()));
  EXPECT_LE(map.rounds.back().change, 1e-10);
  expectCircleDomain(mesh, loops, map);
  return map;
}

TEST(KoebeMap, FortyHolesConvergeInSixRounds)
{
  const TriangleMesh mesh = fortyHoles(0.08);
  const auto loops = test::loopsOf(mesh);
  ASSERT_EQ(loops.size(), 41u);
  const KoebeMap map = expectSixRounds(mesh, loops);
  // The iteration has come to its end, not to a halt: more rounds change little.
  const KoebeMap more = hexsweep::koebeMap(mesh.points, mesh.triangles, loops, { 1e-24, 30 });
  EXPECT_LT(greatestDifference(map, more), 1e-4);
}

TEST(KoebeMap, FortySquareHoles)
{
  std::vector<test::Block> holes;
  for (int k = 0; k < 40; ++k)
  {
    holes.push_back({ 3 + 7 * (k % 8), 4 + 11 * (k / 8), 2 + k % 3, 3 + k % 4 });
  }
  TriangleMesh mesh = test::plate(60, holes, 0.2);
  mesh.points = test::lifted(mesh.points, test::bump);
  const auto loops = test::loopsOf(mesh);
  ASSERT_EQ(loops.size(), 41u);
  expectSixRounds(mesh, loops);
}

TEST(KoebeMap, TheRecordOfTheRounds)
{
  const TriangleMesh mesh = fortyHoles(0.08);
  const auto loops = test::loopsOf(mesh);
  const KoebeMap map = hexsweep::koebeMap(mesh.points, mesh.triangles, loops);
  ASSERT_GE(map.rounds.size(), 2u);
  EXPECT_EQ(map.rounds[0].change, std::numeric_limits<double>::infinity());
  for (std::size_t k = 1; k < map.rounds.size(); ++k)
  {
    const double change =
      (test::coordinatesOf(map.rounds[k].holes) - test::coordinatesOf(map.rounds[k - 1].holes))
        .squaredNorm();
    EXPECT_NEAR(map.rounds[k].change, change, 1e-12 * change);
    EXPECT_EQ(map.rounds[k].change <= 1e-10, k + 1 == map.rounds.size());
  }
  EXPECT_EQ(test::coordinatesOf(map.holes), test::coordinatesOf(map.rounds.back().holes));
  ASSERT_EQ(map.circularity.size(), loops.size());
  for (const double circularity : map.circularity)
  {
    EXPECT_GT(circularity, 0.0);
    EXPECT_LT(circularity, 0.2);
  }
  const KoebeMap short2 = hexsweep::koebeMap(mesh.points, mesh.triangles, loops, { 1e-10, 2 });
  EXPECT_FALSE(short2.converged);
  ASSERT_EQ(short2.rounds.size(), 2u);
  EXPECT_EQ(test::coordinatesOf(short2.rounds[1].holes), test::coordinatesOf(map.rounds[1].holes));
  EXPECT_EQ(hexsweep::koebeMap(mesh.points, mesh.triangles, loops, { 1e-10, 0 }).rounds.size(), 1u);
}

TEST(KoebeMap, AnLWithSquareHoles)
{
  // The corner of the plate is cut away: a hole that reaches the rim.
  TriangleMesh mesh =
    test::plate(24, { { 12, 12, 12, 12 }, { 3, 3, 4, 4 }, { 15, 4, 5, 3 }, { 4, 15, 3, 5 } }, 0.2);
  mesh.points = test::lifted(mesh.points, test::bump);
  const auto loops = test::loopsOf(mesh);
  ASSERT_EQ(loops.size(), 4u);
  const KoebeMap map = hexsweep::koebeMap(mesh.points, mesh.triangles, loops);
  EXPECT_TRUE(map.converged);
  EXPECT_LE(map.rounds.size(), 6u);
  expectCircleDomain(mesh, loops, map);
}

TEST(KoebeMap, HolesCloseToEachOtherAndToTheRim)
{
  // Bridges of two cells between holes of eight.
  const TriangleMesh mesh =
    test::plate(30, { { 2, 11, 8, 8 }, { 12, 11, 8, 8 }, { 22, 11, 6, 8 } }, 0.2);
  const auto loops = test::loopsOf(mesh);
  const KoebeMap map = hexsweep::koebeMap(mesh.points, mesh.triangles, loops);
  EXPECT_TRUE(map.converged);
  expectCircleDomain(mesh, loops, map);
}

TEST(KoebeMap, HolesOfThreeNodes)
{
  // The smallest hole there is: one triangle out of a fine plate, twice.
  TriangleMesh mesh = test::plate(16, { { 10, 10, 3, 3 } }, 0.2);
  const Index rows = mesh.triangles.rows();
  std::vector<Index> ids;
  for (Index t = 0; t < rows; ++t)
  {
    if (t != 2 * (5 * 16 + 5) && t != 2 * (4 * 16 + 11))
    {
      ids.insert(ids.end(), { mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2) });
    }
  }
  mesh.triangles = test::facesOf<hexsweep::Triangles>(ids);
  const auto loops = test::loopsOf(mesh);
  ASSERT_EQ(loops.size(), 4u);
  ASSERT_EQ(loops[3].size(), 3u);
  const KoebeMap map = hexsweep::koebeMap(mesh.points, mesh.triangles, loops);
  EXPECT_TRUE(map.converged);
  expectCircleDomain(mesh, loops, map);
}

TEST(KoebeMap, UnitsAndTurnsDoNotMatter)
{
  const TriangleMesh mesh = fortyHoles(0.12);
  const auto loops = test::loopsOf(mesh);
  const KoebeMap plain = hexsweep::koebeMap(mesh.points, mesh.triangles, loops);
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    const Points points = test::Similarity{ scale, test::someTurn(), { 0, 0, 0 } }(mesh.points);
    const KoebeMap other = hexsweep::koebeMap(points, mesh.triangles, loops);
    EXPECT_EQ(other.rounds.size(), plain.rounds.size());
    EXPECT_LT(greatestDifference(other, plain), 1e-9) << scale;
  }
  EXPECT_EQ(greatestDifference(plain, hexsweep::koebeMap(mesh.points, mesh.triangles, loops)), 0.0);
}

TEST(KoebeMap, UnusedPointsAreIgnored)
{
  for (const auto& holes : { test::oneRoundHole(), test::threeRoundHoles() })
  {
    const CircleDomain domain = test::circleDomain(holes, 0.2);
    const std::vector<Loop> loops = test::surfaceLoops(domain.mesh);
    const Points& points = domain.mesh.points;
    const KoebeMap plain = hexsweep::koebeMap(points, domain.mesh.triangles, loops);
    // One unused point before all others, and some after.
    Points more(points.rows() + 4, 3);
    more << Eigen::RowVector3d(9, 9, 9), points, Points::Constant(3, 3, std::nan(""));
    std::vector<Loop> shifted = loops;
    for (Loop& loop : shifted)
    {
      for (Index& v : loop)
      {
        ++v;
      }
    }
    const hexsweep::Triangles triangles = domain.mesh.triangles.array() + 1;
    EXPECT_LT(greatestDifference(hexsweep::koebeMap(more, triangles, shifted), plain), 1e-9);
  }
}

TEST(KoebeMap, FlatTrianglesAreAnError)
{
  TriangleMesh mesh = test::plate(12, test::threeHoles());
  const auto loops = test::loopsOf(mesh);
  mesh.points.row(mesh.triangles(20, 0)) = mesh.points.row(mesh.triangles(20, 1));
  test::expectInvalid(
    [&] { hexsweep::koebeMap(mesh.points, mesh.triangles, loops); }, "has no area");
}

TEST(KoebeMap, ProgressRisesAndAborts)
{
  const TriangleMesh mesh = fortyHoles(0.12);
  const auto loops = test::loopsOf(mesh);
  std::vector<double> fractions;
  hexsweep::koebeMap(mesh.points, mesh.triangles, loops, {}, [&](double done) {
    fractions.push_back(done);
    return true;
  });
  ASSERT_GE(fractions.size(), 3u);
  EXPECT_EQ(fractions.front(), 0.0);
  for (std::size_t k = 1; k < fractions.size(); ++k)
  {
    EXPECT_GT(fractions[k], fractions[k - 1]);
    EXPECT_LE(fractions[k], 1.0);
  }
  for (std::size_t stop = 1; stop <= fractions.size(); ++stop)
  {
    std::size_t calls = 0;
    EXPECT_THROW(hexsweep::koebeMap(
                   mesh.points, mesh.triangles, loops, {}, [&](double) { return ++calls < stop; }),
      hexsweep::Aborted);
    EXPECT_EQ(calls, stop);
  }
}
}
