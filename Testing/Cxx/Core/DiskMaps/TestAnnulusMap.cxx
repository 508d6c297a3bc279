// SPDX-License-Identifier: BSD-3-Clause
// Angle and modulus of annuli whose conformal map to a concentric one is known.
#include "Core/DiskMaps/AnnulusMap.h"

#include "Core/DiskMaps/DiskDomain.h"
#include "Core/Solvers/DirichletSolver.h"
#include "Core/Solvers/SurfaceLaplacian.h"
#include "Support/CapMeshes.h"

#include <complex>

namespace TestAnnulusMap
{
using hexsweep::AngleFunction;
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::SparseMatrix;
using hexsweep::TriangleMesh;

constexpr double Inner = 0.35;

/// The Moebius map of the unit disk onto itself that takes 0 to 0.4.
std::complex<double> moebius(std::complex<double> z)
{
  return (z + 0.4) / (1.0 + 0.4 * z);
}

/// A concentric annulus whose hole was moved out of the middle; its angles are known.
struct KnownAnnulus
{
  TriangleMesh mesh;
  Eigen::VectorXd angle;
};

KnownAnnulus knownAnnulus(Index rings, bool eccentric)
{
  std::mt19937 generator(3);
  KnownAnnulus known{ test::annulus(Inner, 1.0, rings, 6 * (rings - 1), &generator), {} };
  known.angle.resize(known.mesh.points.rows());
  for (Index i = 0; i < known.angle.size(); ++i)
  {
    const std::complex<double> z(known.mesh.points(i, 0), known.mesh.points(i, 1));
    known.angle[i] = std::arg(z);
    const std::complex<double> w = eccentric ? moebius(z) : z;
    known.mesh.points.row(i) << w.real(), w.imag(), 0.0;
  }
  known.mesh.points = test::Similarity{ 2.0, test::someTurn(), { 1, 2, 3 } }(known.mesh.points);
  return known;
}

struct Measured
{
  double modulusByHeight;
  double modulusByAngle;
  double angleError; ///< greatest, after turning the whole
};

Measured measure(const KnownAnnulus& known)
{
  const TriangleMesh& mesh = known.mesh;
  const auto loops = test::loopsOf(mesh);
  const SparseMatrix laplacian = hexsweep::cotangentLaplacian(mesh.points, mesh.triangles);
  const AngleFunction angle = hexsweep::windingAngle(mesh.points, mesh.triangles, laplacian, loops);
  const Eigen::VectorXd correction = hexsweep::conformalCorrection(laplacian, angle, loops[0][0]);
  EXPECT_EQ(correction[loops[0][0]], 0.0);

  // The angle's energy, over edges with their steps: twice 2 pi log(R / r).
  double angleEnergy = 0.0;
  for (Index j = 0; j < laplacian.outerSize(); ++j)
  {
    for (SparseMatrix::InnerIterator it(laplacian, j); it && it.row() < j; ++it)
    {
      const double step = hexsweep::wrapAngle(angle.values[j] - angle.values[it.row()]) +
        correction[j] - correction[it.row()];
      angleEnergy -= it.value() * step * step;
    }
  }
  Eigen::VectorXd height = Eigen::VectorXd::Zero(mesh.points.rows());
  std::vector<bool> fixed(static_cast<std::size_t>(mesh.points.rows()), false);
  for (std::size_t l = 0; l < 2; ++l)
  {
    for (const Index v : loops[l])
    {
      fixed[static_cast<std::size_t>(v)] = true;
      height[v] = static_cast<double>(l);
    }
  }
  height = hexsweep::DirichletSolver(laplacian, fixed).solve(height);

  double cosine = 0.0;
  double sine = 0.0;
  const Eigen::VectorXd difference = angle.values + correction - known.angle;
  for (Index i = 0; i < difference.size(); ++i)
  {
    cosine += std::cos(difference[i]);
    sine += std::sin(difference[i]);
  }
  const double turn = std::atan2(sine, cosine);
  Measured measured{ 4.0 * test::Pi / height.dot(laplacian * height),
    angleEnergy / (4.0 * test::Pi), 0.0 };
  for (Index i = 0; i < difference.size(); ++i)
  {
    measured.angleError =
      std::max(measured.angleError, std::abs(hexsweep::wrapAngle(difference[i] - turn)));
  }
  return measured;
}

TEST(AnnulusMap, AngleWindsOnceAboutTheHole)
{
  TriangleMesh mesh = test::plate(12, { { 1, 2, 3, 7 } }, 0.3);
  mesh.points = test::lifted(mesh.points, test::bump);
  const auto loops = test::loopsOf(mesh);
  const AngleFunction angle = hexsweep::windingAngle(
    mesh.points, mesh.triangles, hexsweep::cotangentLaplacian(mesh.points, mesh.triangles), loops);
  const auto turns = [&](const Loop& loop) {
    double sum = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      sum += hexsweep::wrapAngle(angle.values[loop[(i + 1) % loop.size()]] - angle.values[loop[i]]);
    }
    return sum / (2.0 * test::Pi);
  };
  // Loops run with the surface on their left.
  EXPECT_NEAR(turns(loops[0]), 1.0, 1e-12);
  EXPECT_NEAR(turns(loops[1]), -1.0, 1e-12);
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    const auto row = mesh.triangles.row(t);
    EXPECT_NEAR(turns({ row[0], row[1], row[2] }), 0.0, 1e-12);
  }
}

TEST(AnnulusMap, CorrectedAngleIsHarmonicWithFreeBoundaries)
{
  TriangleMesh mesh = test::plate(12, { { 1, 2, 3, 7 } }, 0.3);
  mesh.points = test::lifted(mesh.points, test::bump);
  const auto loops = test::loopsOf(mesh);
  const SparseMatrix laplacian = hexsweep::cotangentLaplacian(mesh.points, mesh.triangles);
  const AngleFunction angle = hexsweep::windingAngle(mesh.points, mesh.triangles, laplacian, loops);
  const Eigen::VectorXd correction = hexsweep::conformalCorrection(laplacian, angle, loops[0][3]);
  // The flow into every vertex, boundary ones included, is zero.
  Eigen::VectorXd flow = Eigen::VectorXd::Zero(mesh.points.rows());
  for (Index j = 0; j < laplacian.outerSize(); ++j)
  {
    for (SparseMatrix::InnerIterator it(laplacian, j); it; ++it)
    {
      const Index i = it.row();
      if (i != j)
      {
        flow[i] -= it.value() *
          (hexsweep::wrapAngle(angle.values[j] - angle.values[i]) + correction[j] - correction[i]);
      }
    }
  }
  EXPECT_LT(flow.cwiseAbs().maxCoeff(), 1e-11);
}

TEST(AnnulusMap, ModulusConvergesToTheLogarithm)
{
  const double exact = std::log(1.0 / Inner);
  for (const bool eccentric : { false, true })
  {
    const Measured coarse = measure(knownAnnulus(9, eccentric));
    const Measured fine = measure(knownAnnulus(17, eccentric));
    const Measured finest = measure(knownAnnulus(33, eccentric));
    EXPECT_LT(std::abs(finest.modulusByHeight - exact), 3e-3);
    EXPECT_LT(std::abs(finest.modulusByAngle - exact), 3e-3);
    // Halving the edges divides the error by four.
    EXPECT_GT(
      std::abs(coarse.modulusByHeight - exact), 3.3 * std::abs(fine.modulusByHeight - exact));
    EXPECT_GT(
      std::abs(fine.modulusByHeight - exact), 3.3 * std::abs(finest.modulusByHeight - exact));
    EXPECT_GT(std::abs(coarse.modulusByAngle - exact), 3.3 * std::abs(fine.modulusByAngle - exact));
    EXPECT_GT(std::abs(fine.modulusByAngle - exact), 3.3 * std::abs(finest.modulusByAngle - exact));
  }
}

TEST(AnnulusMap, AngleConvergesToTheConformalOne)
{
  for (const bool eccentric : { false, true })
  {
    const double coarse = measure(knownAnnulus(9, eccentric)).angleError;
    const double fine = measure(knownAnnulus(17, eccentric)).angleError;
    const double finest = measure(knownAnnulus(33, eccentric)).angleError;
    if (!eccentric)
    {
      EXPECT_LT(finest, 1e-12); // by symmetry
      continue;
    }
    EXPECT_LT(finest, 4e-3);
    EXPECT_GT(coarse, 3.0 * fine);
    EXPECT_GT(fine, 3.0 * finest);
  }
}

TEST(AnnulusMap, SourceOfAnAngleThatIsHarmonicIsZero)
{
  // A regular annulus is its own cylinder: each node has the same flow in as out.
  const TriangleMesh mesh = test::annulus(Inner, 1.0, 5, 24);
  AngleFunction angle;
  angle.values.resize(mesh.points.rows());
  for (Index i = 0; i < angle.values.size(); ++i)
  {
    angle.values[i] = std::atan2(mesh.points(i, 1), mesh.points(i, 0)) +
      2.0 * test::Pi * static_cast<double>(i % 5);
  }
  const Eigen::VectorXd source =
    hexsweep::angleSource(hexsweep::cotangentLaplacian(mesh.points, mesh.triangles), angle);
  EXPECT_LT(source.cwiseAbs().maxCoeff(), 1e-12);
}
}
