// SPDX-License-Identifier: BSD-3-Clause
// Annuli of known modulus: plane ones, conformally warped ones, surfaces of revolution.
#include "Core/DiskMaps/ConformalAnnulus.h"

#include "Support/CapMeshes.h"
#include "Support/CircleDomains.h"

#include "Core/DiskMaps/DiskDomain.h"

namespace TestConformalAnnulus
{
using hexsweep::ConformalAnnulus;
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::TriangleMesh;
using test::Pi;
using Complex = std::complex<double>;

/// The hole is point row 0, the rim the last one, `around` nodes each.
std::vector<Loop> gridLoops(const TriangleMesh& mesh, Index around)
{
  std::vector<Loop> loops =
    hexsweep::checkSurface(mesh.triangles, mesh.points.rows(), "annulus").loops;
  std::sort(loops.begin(), loops.end(), [](const Loop& a, const Loop& b) { return a[0] > b[0]; });
  EXPECT_GE(loops[0][0], around);
  return loops;
}

ConformalAnnulus mapped(const TriangleMesh& mesh, Index around)
{
  return hexsweep::conformalAnnulus(mesh.points, mesh.triangles, gridLoops(mesh, around));
}

/// place(t, angle): t = 0 on the hole and 1 on the outer loop; diagonals by chance.
TriangleMesh polarMesh(
  Index rings, Index around, const std::function<Eigen::RowVector3d(double, double)>& place)
{
  std::mt19937 generator(6);
  TriangleMesh mesh{ hexsweep::Points(rings * around, 3),
    test::polarTriangles(rings, around, &generator) };
  for (Index k = 0; k < rings; ++k)
  {
    for (Index j = 0; j < around; ++j)
    {
      mesh.points.row(k * around + j) =
        place(static_cast<double>(k) / static_cast<double>(rings - 1),
          2.0 * Pi * static_cast<double>(j) / static_cast<double>(around));
    }
  }
  return mesh;
}

/**
 * Moduli log(1 / r) over four refinements: errors relative to the truth, each at most a third of
 * the one before, and periods that come as close to 1.
 *
 * @param cells from loop to loop on the coarsest mesh; three times as many around.
 */
void expectSecondOrder(const std::string& name, double modulus,
  const std::function<Eigen::RowVector3d(double, double)>& place, Index cells = 4)
{
  SCOPED_TRACE(name);
  double before = 0.0;
  double periodBefore = 0.0;
  for (int level = 0; level <= 4; ++level)
  {
    const Index rings = (cells << level) + 1;
    const Index around = (3 * cells) << level;
    const ConformalAnnulus annulus = mapped(polarMesh(rings, around, place), around);
    const double error = std::abs(std::log(1.0 / annulus.innerRadius) / modulus - 1.0);
    // What is this close is so by symmetry.
    const double exact = 1e-9;
    if (level > 0)
    {
      EXPECT_TRUE(error < exact || before / error > 3.0)
        << level << ": " << before << ", " << error;
      EXPECT_TRUE(
        annulus.period - 1.0 < exact || (periodBefore - 1.0) / (annulus.period - 1.0) > 3.0)
        << level << ": " << periodBefore << ", " << annulus.period;
    }
    EXPECT_GT(annulus.period, 1.0 - exact);
    testing::Test::RecordProperty(
      name + "_" + std::to_string(level), std::to_string(1e6 * error) + "e-6");
    before = error;
    periodBefore = annulus.period;
  }
  EXPECT_LT(before, 1e-3);
  EXPECT_LT(periodBefore, 1.01);
}

Eigen::RowVector3d onPlane(const Complex& z)
{
  return { z.real(), z.imag(), 0.0 };
}

/// Length over radius along a profile (radius, height), by Simpson's rule.
double modulusOfProfile(const std::function<Eigen::RowVector2d(double)>& profile)
{
  const int n = 20000;
  const auto integrand = [&](double t) {
    const double h = 1e-5;
    return (profile(t + h) - profile(t - h)).norm() / (2.0 * h) / profile(t).x();
  };
  double sum = 0.0;
  for (int k = 0; k <= n; ++k)
  {
    sum += (k == 0 || k == n ? 1.0
               : k % 2 == 1  ? 4.0
                             : 2.0) *
      integrand(static_cast<double>(k) / n);
  }
  return sum / (3.0 * n);
}

TEST(ConformalAnnulus, PlaneAnnuli)
{
  for (int tenths = 1; tenths <= 9; ++tenths)
  {
    const double inner = 0.1 * tenths;
    expectSecondOrder(
      "r_0." + std::to_string(tenths), std::log(1.0 / inner), [&](double t, double angle) {
        return onPlane(std::polar(inner + t * (1.0 - inner), angle));
      });
  }
}

TEST(ConformalAnnulus, ConformallyWarpedAnnuli)
{
  const double inner = 0.3;
  const std::vector<std::pair<std::string, std::function<Complex(Complex)>>> maps{
    { "square", [](const Complex& z) { return z + 0.1 * z * z; } },
    { "exponential", [](const Complex& z) { return std::exp(z); } },
    { "moebius", [](const Complex& z) { return (z + 0.4) / (1.0 + 0.4 * z); } }
  };
  for (const auto& [name, map] : maps)
  {
    const auto& warp = map;
    expectSecondOrder(name, std::log(1.0 / inner), [&](double t, double angle) {
      return onPlane(warp(std::polar(inner + t * (1.0 - inner), angle)));
    });
  }
  // Turned inside out by 1 / z, the hole becomes the outer loop.
  expectSecondOrder("inversion", std::log(1.0 / inner), [&](double t, double angle) {
    return onPlane(1.0 / std::polar(1.0 + t * (inner - 1.0), -angle));
  });
}

TEST(ConformalAnnulus, EccentricAnnuli)
{
  // Between circles of radii 1 and r whose centres are d apart: cosh of the modulus is
  // (1 + r^2 - d^2) / (2 r). The columns of this mesh are no images of radii.
  for (const auto& [r, d] : std::vector<std::pair<double, double>>{ { 0.3, 0.2 }, { 0.4, 0.3 } })
  {
    const double radius = r;
    const double offset = d;
    expectSecondOrder(
      "eccentric_" + std::to_string(offset), std::acosh((1.0 + r * r - d * d) / (2.0 * r)),
      [&](double t, double angle) {
        return onPlane(
          (1.0 - t) * (offset + std::polar(radius, angle)) + t * std::polar(1.0, angle));
      },
      6);
  }
}

TEST(ConformalAnnulus, SurfacesOfRevolution)
{
  const auto revolve = [](const std::string& name, double modulus,
                         const std::function<Eigen::RowVector2d(double)>& profile) {
    ASSERT_NEAR(modulusOfProfile(profile), modulus, 1e-6 * modulus);
    expectSecondOrder(name, modulus, [&](double t, double angle) {
      const Eigen::RowVector2d p = profile(t);
      return Eigen::RowVector3d(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y());
    });
  };
  // Seen from above, the outer loop runs counter-clockwise: upwards inwards.
  revolve("cylinder", 1.7 / 0.8, [](double t) { return Eigen::RowVector2d(0.8, 1.7 * (1.0 - t)); });
  revolve("cone", std::sqrt(1.0 + 0.49) / 0.7 * std::log(0.9 / 0.2),
    [](double t) { return Eigen::RowVector2d(0.2 + 0.7 * t, 1.0 - t); });
  // The Mercator projection.
  const auto mercator = [](double latitude) { return std::asinh(std::tan(latitude)); };
  revolve("zone of a sphere", mercator(1.3) - mercator(-0.5),
    [](double t) { return Eigen::RowVector2d(std::cos(1.3 - 1.8 * t), std::sin(1.3 - 1.8 * t)); });
  revolve("catenoid", 1.4,
    [](double t) { return Eigen::RowVector2d(std::cosh(1.0 - 1.4 * t), 1.0 - 1.4 * t); });
}

TEST(ConformalAnnulus, HeightAndAngleAreThoseOfTheMap)
{
  const double inner = 0.3;
  std::vector<double> heightErrors;
  std::vector<double> angleErrors;
  for (int level = 0; level < 4; ++level)
  {
    const Index around = 16 << level;
    const auto mesh = polarMesh((5 << level) + 1, around, [&](double t, double angle) {
      const Complex z = std::polar(inner + t * (1.0 - inner), angle);
      return onPlane(z + 0.1 * z * z);
    });
    const ConformalAnnulus annulus = mapped(mesh, around);
    double height = 0.0;
    Complex turn = 0.0;
    std::vector<Complex> turns;
    for (Index i = 0; i < mesh.points.rows(); ++i)
    {
      const double angle = 2.0 * Pi * static_cast<double>(i % around) / static_cast<double>(around);
      const double t = static_cast<double>(i / around) / static_cast<double>(5 << level);
      height = std::max(height,
        std::abs(annulus.height[i] - std::log(inner + t * (1.0 - inner)) / std::log(inner)));
      turns.push_back(std::polar(1.0, annulus.angle[i] - angle));
      turn += turns.back();
    }
    double worst = 0.0;
    for (const Complex& t : turns)
    {
      worst = std::max(worst, std::abs(std::arg(t / turn)));
    }
    heightErrors.push_back(height);
    angleErrors.push_back(worst);
    for (Index i = 0; i < around; ++i)
    {
      EXPECT_EQ(annulus.height[i], 1.0);
      EXPECT_EQ(annulus.height[mesh.points.rows() - 1 - i], 0.0);
    }
  }
  for (std::size_t level = 1; level < 4; ++level)
  {
    EXPECT_GT(heightErrors[level - 1] / heightErrors[level], 3.0);
    EXPECT_GT(angleErrors[level - 1] / angleErrors[level], 3.0);
  }
  EXPECT_LT(heightErrors[3], 1e-3);
  EXPECT_LT(angleErrors[3], 1e-3);
}

TEST(ConformalAnnulus, AngleTurnsOnceRoundEachLoop)
{
  TriangleMesh mesh = test::plate(12, { { 1, 2, 3, 7 } }, 0.3);
  mesh.points = test::lifted(mesh.points, test::bump);
  const auto loops = test::loopsOf(mesh);
  const ConformalAnnulus annulus = hexsweep::conformalAnnulus(mesh.points, mesh.triangles, loops);
  for (std::size_t p = 0; p < 2; ++p)
  {
    double turn = 0.0;
    for (std::size_t i = 0; i < loops[p].size(); ++i)
    {
      turn += hexsweep::wrapAngle(
        annulus.angle[loops[p][(i + 1) % loops[p].size()]] - annulus.angle[loops[p][i]]);
    }
    EXPECT_NEAR(turn, p == 0 ? 2.0 * Pi : -2.0 * Pi, 1e-10);
  }
}

TEST(ConformalAnnulus, UnitsTurnsAndUnusedPointsDoNotMatter)
{
  TriangleMesh mesh = test::plate(12, { { 1, 2, 3, 7 } }, 0.3);
  mesh.points = test::lifted(mesh.points, test::bump);
  const auto loops = test::loopsOf(mesh);
  const ConformalAnnulus plain = hexsweep::conformalAnnulus(mesh.points, mesh.triangles, loops);
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    hexsweep::Points points = test::Similarity{ scale, test::someTurn(), { 0, 0, 0 } }(mesh.points);
    points.conservativeResize(points.rows() + 3, 3);
    points.bottomRows<3>().setConstant(7.0);
    const ConformalAnnulus other = hexsweep::conformalAnnulus(points, mesh.triangles, loops);
    EXPECT_NEAR(other.innerRadius, plain.innerRadius, 1e-9 * plain.innerRadius);
    EXPECT_NEAR(other.period, plain.period, 1e-9);
    EXPECT_LT((other.angle.head(plain.angle.size()) - plain.angle).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((other.height.head(plain.height.size()) - plain.height).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(ConformalAnnulus, ThePeriodTellsACoarseMesh)
{
  // No node between a loop and another one a thousand times as long: the bounds are far apart, and
  // the radius lies between them.
  const auto annulus = mapped(test::annulus(1e-3, 1.0, 2, 12), 12);
  EXPECT_GT(annulus.period, 2.0);
  EXPECT_GT(annulus.innerRadius, 0.0);
  EXPECT_LT(annulus.innerRadius, 1.0);
}
}
