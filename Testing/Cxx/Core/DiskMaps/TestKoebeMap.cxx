// SPDX-License-Identifier: BSD-3-Clause
// Circle domains that a known conformal map has warped come back; and caps of other shapes.
#include "Core/DiskMaps/KoebeMap.h"

#include "Support/CapMeshes.h"
#include "Support/CircleDomains.h"

#include "Core/DiskMaps/CanonicalDiskMap.h"
#include "Core/DiskMaps/DiskAutomorphism.h"
#include "Core/Solvers/SurfaceLaplacian.h"

#include <Eigen/Dense>

#include <limits>

namespace TestKoebeMap
{
using hexsweep::Circle;
using hexsweep::DiskAutomorphism;
using hexsweep::Index;
using hexsweep::KoebeMap;
using hexsweep::Loop;
using hexsweep::PlanePoints;
using hexsweep::Points;
using hexsweep::TriangleMesh;
using test::CircleDomain;
using test::Pi;
using Complex = std::complex<double>;

Complex complexOf(const Eigen::RowVector2d& p)
{
  return { p.x(), p.y() };
}

Complex warp(const Complex& z)
{
  return z + 0.2 * z * z + Complex(0.0, 0.05) * z * z * z;
}

/// In the order of the circles: the points of each come before those of the next one.
std::vector<Loop> domainLoops(const CircleDomain& domain)
{
  return hexsweep::checkSurface(domain.mesh.triangles, domain.mesh.points.rows(), "domain").loops;
}

std::vector<Circle> oneHole()
{
  return { { { 0.3, 0.1 }, 0.25 } };
}
std::vector<Circle> threeHoles()
{
  return { { { 0.45, 0.1 }, 0.2 }, { { -0.4, 0.35 }, 0.25 }, { { -0.1, -0.5 }, 0.15 } };
}
std::vector<Circle> eightHoles()
{
  return { { { 0.55, 0.1 }, 0.14 }, { { 0.2, 0.6 }, 0.16 }, { { -0.4, 0.5 }, 0.12 },
    { { -0.65, 0.0 }, 0.15 }, { { -0.35, -0.5 }, 0.18 }, { { 0.15, -0.65 }, 0.1 },
    { { 0.6, -0.4 }, 0.16 }, { { 0.05, 0.0 }, 0.2 } };
}

/// (d^2 - r^2 - s^2) / (2 r s), an invariant of pairs of circles under Moebius maps.
double inversiveDistance(const Circle& a, const Circle& b)
{
  return std::abs((a.center - b.center).squaredNorm() - a.radius * a.radius - b.radius * b.radius) /
    (2.0 * a.radius * b.radius);
}

double inversiveError(std::vector<Circle> found, std::vector<Circle> truth)
{
  found.push_back({ { 0.0, 0.0 }, 1.0 });
  truth.push_back({ { 0.0, 0.0 }, 1.0 });
  double worst = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      worst = std::max(worst,
        std::abs(
          inversiveDistance(found[i], found[j]) / inversiveDistance(truth[i], truth[j]) - 1.0));
    }
  }
  return worst;
}

Eigen::VectorXd coordinates(const std::vector<Circle>& circles)
{
  Eigen::VectorXd result(3 * static_cast<Index>(circles.size()));
  for (Index h = 0; 3 * h < result.size(); ++h)
  {
    const Circle& circle = circles[static_cast<std::size_t>(h)];
    result.segment<3>(3 * h) << circle.center.x(), circle.center.y(), circle.radius;
  }
  return result;
}

/// The disk automorphism that brings circles closest to others (sum of squares over centres and
/// radii), and the same points: by Gauss-Newton steps of automorphisms near the identity.
struct Fit
{
  std::vector<Circle> circles;
  std::vector<PlanePoints> points;

  void apply(const DiskAutomorphism& map)
  {
    for (Circle& circle : this->circles)
    {
      circle = map(circle);
    }
    for (PlanePoints& block : this->points)
    {
      for (Index i = 0; i < block.rows(); ++i)
      {
        const Complex z = map(complexOf(block.row(i)));
        block.row(i) << z.real(), z.imag();
      }
    }
  }

  void bringTo(const std::vector<Circle>& truth)
  {
    const auto near = [](const Eigen::Vector3d& x) {
      return DiskAutomorphism({ x[0], x[1] }, std::polar(1.0, x[2]));
    };
    const Eigen::VectorXd wanted = coordinates(truth);
    for (int step = 0; step < 40; ++step)
    {
      const Eigen::VectorXd now = coordinates(this->circles);
      Eigen::MatrixXd jacobian(now.size(), 3);
      for (Index k = 0; k < 3; ++k)
      {
        Fit moved{ this->circles, {} };
        moved.apply(near(1e-6 * Eigen::Vector3d::Unit(k)));
        jacobian.col(k) = (coordinates(moved.circles) - now) / 1e-6;
      }
      // The turns that keep a single hole are left out.
      Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
      decomposition.setThreshold(1e-3);
      Eigen::Vector3d x = decomposition.compute(jacobian).solve(wanted - now);
      x *= std::min(1.0, 0.3 / x.norm());
      this->apply(near(x));
    }
  }
};

struct Errors
{
  double circles;   ///< greatest of a centre or radius
  double places;    ///< greatest distance of a loop's node from where it came from
  double inversive; ///< greatest relative one of an inversive distance
};

Errors errorsOf(const KoebeMap& map, const CircleDomain& domain, const std::vector<Loop>& loops)
{
  // Beginning with the turn that fits the outer loop.
  Fit fit{ map.holes, map.places };
  Complex turn = 0.0;
  for (std::size_t i = 0; i < loops[0].size(); ++i)
  {
    turn += complexOf(domain.mesh.points.row(loops[0][i]).head<2>()) /
      complexOf(map.places[0].row(static_cast<Index>(i)));
  }
  fit.apply(DiskAutomorphism(0.0, turn / std::abs(turn)));
  fit.bringTo(domain.holes);
  Errors errors{ (coordinates(fit.circles) - coordinates(domain.holes)).cwiseAbs().maxCoeff(), 0.0,
    inversiveError(map.holes, domain.holes) };
  for (std::size_t p = 0; p < loops.size(); ++p)
  {
    for (std::size_t i = 0; i < loops[p].size(); ++i)
    {
      errors.places = std::max(errors.places,
        (fit.points[p].row(static_cast<Index>(i)) - domain.mesh.points.row(loops[p][i]).head<2>())
          .norm());
    }
  }
  return errors;
}

/// Four refinements; each error at most a third of the one before.
void expectSecondOrder(const std::vector<Circle>& holes, bool sphere)
{
  CircleDomain domain = test::circleDomain(holes, 0.2);
  Errors before{};
  for (int level = 0; level <= 4; ++level)
  {
    const std::vector<Loop> loops = domainLoops(domain);
    ASSERT_EQ(loops.size(), holes.size() + 1);
    Points points = test::warped(domain.mesh.points, warp);
    points = sphere ? test::onSphere(points) : points;
    const KoebeMap map = hexsweep::koebeMap(points, domain.mesh.triangles, loops);
    EXPECT_TRUE(map.converged);
    const Errors errors = errorsOf(map, domain, loops);
    if (level > 0)
    {
      EXPECT_GT(before.inversive / errors.inversive, 3.0) << level;
      EXPECT_GT(before.circles / errors.circles, 3.0) << level;
      // One hole leaves a turn free.
      EXPECT_TRUE(holes.size() == 1 || before.places / errors.places > 2.5)
        << level << ": " << before.places << ", " << errors.places;
    }
    const std::string name = std::to_string(holes.size()) + "_holes_level_" + std::to_string(level);
    testing::Test::RecordProperty(
      name + "_triangles", std::to_string(domain.mesh.triangles.rows()));
    testing::Test::RecordProperty(name + "_circles", std::to_string(1e6 * errors.circles) + "e-6");
    testing::Test::RecordProperty(
      name + "_inversive", std::to_string(1e6 * errors.inversive) + "e-6");
    testing::Test::RecordProperty(name + "_places", std::to_string(1e6 * errors.places) + "e-6");
    before = errors;
    domain = test::refined(domain);
  }
  EXPECT_LT(before.inversive, 2e-4);
}

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
      const double step = std::arg(complexOf(next) / complexOf(arm));
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
  double greatest = (coordinates(a.holes) - coordinates(b.holes)).cwiseAbs().maxCoeff();
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

TEST(KoebeMap, OneHoleComesBack)
{
  expectSecondOrder(oneHole(), false);
}

TEST(KoebeMap, ThreeHolesComeBack)
{
  expectSecondOrder(threeHoles(), false);
}

TEST(KoebeMap, ThreeHolesOnASphereComeBack)
{
  expectSecondOrder(threeHoles(), true);
}

TEST(KoebeMap, EightHolesComeBack)
{
  expectSecondOrder(eightHoles(), false);
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
      (coordinates(map.rounds[k].holes) - coordinates(map.rounds[k - 1].holes)).squaredNorm();
    EXPECT_NEAR(map.rounds[k].change, change, 1e-12 * change);
    EXPECT_EQ(map.rounds[k].change <= 1e-10, k + 1 == map.rounds.size());
  }
  EXPECT_EQ(coordinates(map.holes), coordinates(map.rounds.back().holes));
  ASSERT_EQ(map.circularity.size(), loops.size());
  for (const double circularity : map.circularity)
  {
    EXPECT_GT(circularity, 0.0);
    EXPECT_LT(circularity, 0.2);
  }
  const KoebeMap short2 = hexsweep::koebeMap(mesh.points, mesh.triangles, loops, { 1e-10, 2 });
  EXPECT_FALSE(short2.converged);
  ASSERT_EQ(short2.rounds.size(), 2u);
  EXPECT_EQ(coordinates(short2.rounds[1].holes), coordinates(map.rounds[1].holes));
  EXPECT_EQ(hexsweep::koebeMap(mesh.points, mesh.triangles, loops, { 1e-10, 0 }).rounds.size(), 1u);
}

TEST(KoebeMap, CircularityFallsWithTheEdges)
{
  CircleDomain domain = test::circleDomain(threeHoles(), 0.2);
  double before = 1.0;
  for (int level = 0; level < 4; ++level)
  {
    const KoebeMap map = hexsweep::koebeMap(
      test::warped(domain.mesh.points, warp), domain.mesh.triangles, domainLoops(domain));
    const double worst = *std::max_element(map.circularity.begin(), map.circularity.end());
    EXPECT_LT(worst, before / 2.0);
    before = worst;
    domain = test::refined(domain);
  }
}

TEST(KoebeMap, IsNormalisedAsItSays)
{
  for (const auto& holes : { threeHoles(), eightHoles() })
  {
    const CircleDomain domain = test::refined(test::circleDomain(holes, 0.2));
    const std::vector<Loop> loops = domainLoops(domain);
    const Points points = test::onSphere(test::warped(domain.mesh.points, warp));
    const KoebeMap map = hexsweep::koebeMap(points, domain.mesh.triangles, loops);
    Eigen::RowVector2d mean = Eigen::RowVector2d::Zero();
    const std::size_t m = loops[0].size();
    for (std::size_t i = 0; i < m; ++i)
    {
      const auto p = [&](std::size_t k) { return points.row(loops[0][k % m]); };
      const double length = (p(i + 1) - p(i)).norm() + (p(i + m - 1) - p(i)).norm();
      mean += 0.5 * length * map.places[0].row(static_cast<Index>(i));
    }
    EXPECT_LT(mean.norm() / test::loopLength(points, loops[0]), 1e-12);
    EXPECT_LT((map.places[0].row(0) - Eigen::RowVector2d(1.0, 0.0)).norm(), 1e-14);
  }
  const CircleDomain domain = test::circleDomain(oneHole(), 0.2);
  const KoebeMap map =
    hexsweep::koebeMap(domain.mesh.points, domain.mesh.triangles, domainLoops(domain));
  EXPECT_EQ(map.holes[0].center.norm(), 0.0);
  EXPECT_TRUE(map.converged);
  EXPECT_EQ(map.rounds.size(), 1u);
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

TEST(KoebeMap, SymmetricCapsHaveSymmetricDomains)
{
  // Four round holes that a quarter of a turn takes to each other.
  std::vector<Circle> holes;
  for (int k = 0; k < 4; ++k)
  {
    const double angle = 0.5 * Pi * k + 0.2;
    holes.push_back({ 0.55 * Eigen::RowVector2d(std::cos(angle), std::sin(angle)), 0.2 });
  }
  const CircleDomain domain = test::refined(test::refined(test::circleDomain(holes, 0.2)));
  const KoebeMap map =
    hexsweep::koebeMap(domain.mesh.points, domain.mesh.triangles, domainLoops(domain));
  for (std::size_t h = 0; h < 4; ++h)
  {
    EXPECT_NEAR(map.holes[h].radius, 0.2, 2e-3);
    EXPECT_NEAR(map.holes[h].center.norm(), 0.55, 2e-3);
    const Complex quarter =
      complexOf(map.holes[(h + 1) % 4].center) / complexOf(map.holes[h].center);
    EXPECT_NEAR(std::arg(quarter), 0.5 * Pi, 4e-3);
  }
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
  for (const auto& holes : { oneHole(), threeHoles() })
  {
    const CircleDomain domain = test::circleDomain(holes, 0.2);
    const std::vector<Loop> loops = domainLoops(domain);
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
