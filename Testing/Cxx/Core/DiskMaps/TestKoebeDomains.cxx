// SPDX-License-Identifier: BSD-3-Clause
// Circle domains that a known conformal map has warped come back.
#include "Core/DiskMaps/KoebeMap.h"

#include "Support/CapMeshes.h"
#include "Support/CircleDomains.h"

#include "Core/DiskMaps/DiskAutomorphism.h"

#include <Eigen/Dense>

#include <string>

namespace TestKoebeDomains
{
using hexsweep::Circle;
using hexsweep::DiskAutomorphism;
using hexsweep::Index;
using hexsweep::KoebeMap;
using hexsweep::Loop;
using hexsweep::PlanePoints;
using hexsweep::Points;
using test::CircleDomain;
using test::Pi;
using Complex = std::complex<double>;

Complex warp(const Complex& z)
{
  return z + 0.2 * z * z + Complex(0.0, 0.05) * z * z * z;
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
        const Complex z = map(test::complexOf(block.row(i)));
        block.row(i) << z.real(), z.imag();
      }
    }
  }

  void bringTo(const std::vector<Circle>& truth)
  {
    const auto near = [](const Eigen::Vector3d& x) {
      return DiskAutomorphism({ x[0], x[1] }, std::polar(1.0, x[2]));
    };
    const Eigen::VectorXd wanted = test::coordinatesOf(truth);
    for (int step = 0; step < 40; ++step)
    {
      const Eigen::VectorXd now = test::coordinatesOf(this->circles);
      Eigen::MatrixXd jacobian(now.size(), 3);
      for (Index k = 0; k < 3; ++k)
      {
        Fit moved{ this->circles, {} };
        moved.apply(near(1e-6 * Eigen::Vector3d::Unit(k)));
        jacobian.col(k) = (test::coordinatesOf(moved.circles) - now) / 1e-6;
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
    turn += test::complexOf(domain.mesh.points.row(loops[0][i]).head<2>()) /
      test::complexOf(map.places[0].row(static_cast<Index>(i)));
  }
  fit.apply(DiskAutomorphism(0.0, turn / std::abs(turn)));
  fit.bringTo(domain.holes);
  Errors errors{
    (test::coordinatesOf(fit.circles) - test::coordinatesOf(domain.holes)).cwiseAbs().maxCoeff(),
    0.0, inversiveError(map.holes, domain.holes)
  };
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
    const std::vector<Loop> loops = test::surfaceLoops(domain.mesh);
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

TEST(KoebeMap, OneHoleComesBack)
{
  expectSecondOrder(test::oneRoundHole(), false);
}

TEST(KoebeMap, ThreeHolesComeBack)
{
  expectSecondOrder(test::threeRoundHoles(), false);
}

TEST(KoebeMap, ThreeHolesOnASphereComeBack)
{
  expectSecondOrder(test::threeRoundHoles(), true);
}

TEST(KoebeMap, EightHolesComeBack)
{
  expectSecondOrder(test::eightRoundHoles(), false);
}

TEST(KoebeMap, CircularityFallsWithTheEdges)
{
  CircleDomain domain = test::circleDomain(test::threeRoundHoles(), 0.2);
  double before = 1.0;
  for (int level = 0; level < 4; ++level)
  {
    const KoebeMap map = hexsweep::koebeMap(test::warped(domain.mesh.points, warp),
      domain.mesh.triangles, test::surfaceLoops(domain.mesh));
    const double worst = *std::max_element(map.circularity.begin(), map.circularity.end());
    EXPECT_LT(worst, before / 2.0);
    before = worst;
    domain = test::refined(domain);
  }
}

TEST(KoebeMap, IsNormalisedAsItSays)
{
  for (const auto& holes : { test::threeRoundHoles(), test::eightRoundHoles() })
  {
    const CircleDomain domain = test::refined(test::circleDomain(holes, 0.2));
    const std::vector<Loop> loops = test::surfaceLoops(domain.mesh);
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
  const CircleDomain domain = test::circleDomain(test::oneRoundHole(), 0.2);
  const KoebeMap map =
    hexsweep::koebeMap(domain.mesh.points, domain.mesh.triangles, test::surfaceLoops(domain.mesh));
  EXPECT_EQ(map.holes[0].center.norm(), 0.0);
  EXPECT_TRUE(map.converged);
  EXPECT_EQ(map.rounds.size(), 1u);
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
    hexsweep::koebeMap(domain.mesh.points, domain.mesh.triangles, test::surfaceLoops(domain.mesh));
  for (std::size_t h = 0; h < 4; ++h)
  {
    EXPECT_NEAR(map.holes[h].radius, 0.2, 2e-3);
    EXPECT_NEAR(map.holes[h].center.norm(), 0.55, 2e-3);
    const Complex quarter =
      test::complexOf(map.holes[(h + 1) % 4].center) / test::complexOf(map.holes[h].center);
    EXPECT_NEAR(std::arg(quarter), 0.5 * Pi, 4e-3);
  }
}
}
