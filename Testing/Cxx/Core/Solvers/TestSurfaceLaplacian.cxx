// SPDX-License-Identifier: BSD-3-Clause
// Equations (1) to (3): the Laplacian is div grad, assembled here from gradients and areas.
#include "Core/Solvers/SurfaceLaplacian.h"

#include "Core/Solvers/DirichletSolver.h"
#include "Core/Surfaces/TriangleAngles.h"
#include "Support/CapMeshes.h"

#include <Eigen/Dense>

namespace TestSurfaceLaplacian
{
using hexsweep::Index;
using hexsweep::Points;
using hexsweep::SparseMatrix;
using hexsweep::TriangleMesh;
using hexsweep::Weights;

/// The gradient of each piecewise linear function, 3 t x n: of the hat function at a corner it is
/// the opposite edge turned by 90 degrees about the normal, over twice the area.
Eigen::MatrixXd gradientOperator(const TriangleMesh& mesh)
{
  Eigen::MatrixXd gradient = Eigen::MatrixXd::Zero(3 * mesh.triangles.rows(), mesh.points.rows());
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    const auto corner = [&](Index c) {
      return Eigen::Vector3d(mesh.points.row(mesh.triangles(t, c % 3)).transpose());
    };
    const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    for (Index c = 0; c < 3; ++c)
    {
      gradient.block<3, 1>(3 * t, mesh.triangles(t, c)) =
        normal.cross(corner(c + 2) - corner(c + 1)) / normal.squaredNorm();
    }
  }
  return gradient;
}

/// Areas, each three times, by Heron's formula.
Eigen::VectorXd areas(const TriangleMesh& mesh)
{
  Eigen::VectorXd result(3 * mesh.triangles.rows());
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    double side[3];
    for (Index c = 0; c < 3; ++c)
    {
      side[c] =
        (mesh.points.row(mesh.triangles(t, c)) - mesh.points.row(mesh.triangles(t, (c + 1) % 3)))
          .norm();
    }
    const double s = (side[0] + side[1] + side[2]) / 2.0;
    result.segment<3>(3 * t).setConstant(
      std::sqrt(s * (s - side[0]) * (s - side[1]) * (s - side[2])));
  }
  return result;
}

double greatestRowSum(const SparseMatrix& matrix)
{
  return (matrix * Eigen::VectorXd::Ones(matrix.cols())).cwiseAbs().maxCoeff();
}

TEST(SurfaceLaplacian, CotangentLaplacianIsDivGrad)
{
  const TriangleMesh mesh = test::curvedPlate(3, 0.3);
  const Eigen::MatrixXd gradient = gradientOperator(mesh);
  // Equation (1) sums two cotangents without the factor 1/2 of the Dirichlet integral.
  const Eigen::MatrixXd divGrad = 2.0 * gradient.transpose() * areas(mesh).asDiagonal() * gradient;
  const Eigen::MatrixXd laplacian(hexsweep::cotangentLaplacian(mesh.points, mesh.triangles));
  EXPECT_LT((laplacian - divGrad).cwiseAbs().maxCoeff(), 1e-11 * divGrad.cwiseAbs().maxCoeff());
  EXPECT_GT((laplacian - Eigen::MatrixXd(laplacian.diagonal().asDiagonal())).maxCoeff(), 0.0)
    << "no obtuse angles: the mesh is too easy";
}

TEST(SurfaceLaplacian, RowsSumToZero)
{
  const TriangleMesh mesh = test::curvedPlate(3, 0.3);
  for (const Weights weights : { Weights::Cotangent, Weights::MeanValue })
  {
    const SparseMatrix laplacian = hexsweep::surfaceLaplacian(mesh.points, mesh.triangles, weights);
    const Eigen::VectorXd diagonal = laplacian.diagonal();
    EXPECT_LT(greatestRowSum(laplacian), 1e-13 * diagonal.cwiseAbs().maxCoeff());
  }
}

TEST(SurfaceLaplacian, MeanValueWeightsArePositiveWhereCotangentsAreNot)
{
  const TriangleMesh mesh = test::curvedPlate(3, 0.3);
  const SparseMatrix laplacian = hexsweep::meanValueLaplacian(mesh.points, mesh.triangles);
  ASSERT_GT(laplacian.nonZeros(), 4 * mesh.points.rows()); // a node and its neighbours
  for (Index j = 0; j < laplacian.outerSize(); ++j)
  {
    for (SparseMatrix::InnerIterator it(laplacian, j); it; ++it)
    {
      EXPECT_TRUE(it.row() == j ? it.value() > 0.0 : it.value() < 0.0);
    }
  }
}

TEST(SurfaceLaplacian, MeanValueWeightsAreFloaters)
{
  // Angles here by the law of cosines, tangents by the library.
  const TriangleMesh mesh = test::curvedPlate(3, 0.3);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(mesh.points.rows(), mesh.points.rows());
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index i = mesh.triangles(t, c);
      const Index j = mesh.triangles(t, (c + 1) % 3);
      const Index k = mesh.triangles(t, (c + 2) % 3);
      const double ij = (mesh.points.row(i) - mesh.points.row(j)).norm();
      const double ik = (mesh.points.row(i) - mesh.points.row(k)).norm();
      const double jk = (mesh.points.row(j) - mesh.points.row(k)).norm();
      const double angle = std::acos((ij * ij + ik * ik - jk * jk) / (2.0 * ij * ik));
      expected(i, j) -= std::tan(angle / 2.0) / ij;
      expected(i, k) -= std::tan(angle / 2.0) / ik;
    }
  }
  expected.diagonal() = -expected.rowwise().sum();
  const Eigen::MatrixXd laplacian(hexsweep::meanValueLaplacian(mesh.points, mesh.triangles));
  EXPECT_LT((laplacian - expected).cwiseAbs().maxCoeff(), 1e-11 * expected.cwiseAbs().maxCoeff());
}

TEST(SurfaceLaplacian, LinearFunctionsAreReproducedOnPlanarMeshes)
{
  TriangleMesh mesh = test::plate(12, test::threeHoles(), 0.3);
  const Eigen::VectorXd linear = mesh.points * Eigen::Vector3d(2.0, -3.0, 0.0);
  // Any plane of space will do.
  mesh.points = test::Similarity{ 1.0, test::someTurn(), { 1, 2, 3 } }(mesh.points);
  const std::vector<bool> boundary = test::boundaryFlags(mesh);
  for (const Weights weights : { Weights::Cotangent, Weights::MeanValue })
  {
    const SparseMatrix laplacian = hexsweep::surfaceLaplacian(mesh.points, mesh.triangles, weights);
    const Eigen::VectorXd residual = laplacian * linear;
    const double size = laplacian.diagonal().cwiseAbs().maxCoeff();
    for (Index i = 0; i < residual.size(); ++i)
    {
      if (!boundary[static_cast<std::size_t>(i)])
      {
        EXPECT_LT(std::abs(residual[i]), 1e-12 * size);
      }
    }
    const Eigen::VectorXd solved = hexsweep::DirichletSolver(laplacian, boundary).solve(linear);
    EXPECT_LT((solved - linear).cwiseAbs().maxCoeff(), 1e-13 * linear.cwiseAbs().maxCoeff());
  }
}

TEST(SurfaceLaplacian, EnergyOfALinearFunctionIsTwiceItsDirichletIntegral)
{
  const TriangleMesh mesh = test::plate(12, test::threeHoles(), 0.3);
  const Eigen::VectorXd linear = mesh.points * Eigen::Vector3d(2.0, -3.0, 0.0);
  const double energy =
    linear.dot(hexsweep::cotangentLaplacian(mesh.points, mesh.triangles) * linear);
  EXPECT_NEAR(energy, 2.0 * (2.0 * 2.0 + 3.0 * 3.0) * (1.0 - 16.0 / 144.0), 1e-11);
}

TEST(SurfaceLaplacian, EnergyIsLeastForTheHarmonicFunction)
{
  const TriangleMesh mesh = test::curvedPlate(3, 0.3);
  const SparseMatrix laplacian = hexsweep::cotangentLaplacian(mesh.points, mesh.triangles);
  const std::vector<bool> boundary = test::boundaryFlags(mesh);
  const auto energy = [&](const Eigen::VectorXd& f) {
    // Equation (2), a sum over edges with their weights.
    double sum = 0.0;
    for (Index j = 0; j < laplacian.outerSize(); ++j)
    {
      for (SparseMatrix::InnerIterator it(laplacian, j); it && it.row() < j; ++it)
      {
        const double difference = f[it.row()] - f[j];
        sum -= it.value() * difference * difference;
      }
    }
    return sum;
  };
  Eigen::VectorXd given(mesh.points.rows());
  for (Index i = 0; i < given.size(); ++i)
  {
    given[i] = std::sin(5.0 * mesh.points(i, 0)) + mesh.points(i, 1) * mesh.points(i, 1);
  }
  const Eigen::VectorXd harmonic = hexsweep::DirichletSolver(laplacian, boundary).solve(given);
  const double least = energy(harmonic);
  EXPECT_NEAR(least, harmonic.dot(laplacian * harmonic), 1e-12 * least);

  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  for (const double size : { 1e-4, 1e-2, 1.0 })
  {
    for (int trial = 0; trial < 50; ++trial)
    {
      Eigen::VectorXd change = Eigen::VectorXd::Zero(given.size());
      for (Index i = 0; i < given.size(); ++i)
      {
        change[i] = boundary[static_cast<std::size_t>(i)] ? 0.0 : size * normal(generator);
      }
      const double raised = energy(harmonic + change);
      EXPECT_GT(raised, least);
      // The two are orthogonal in the energy.
      EXPECT_NEAR(raised, least + energy(change), 1e-10 * raised);
    }
  }
}

TEST(SurfaceLaplacian, SizePlaceAndTurnDoNotMatter)
{
  const TriangleMesh mesh = test::curvedPlate(3, 0.3);
  for (const Weights weights : { Weights::Cotangent, Weights::MeanValue })
  {
    const Eigen::MatrixXd plain(hexsweep::surfaceLaplacian(mesh.points, mesh.triangles, weights));
    for (const test::Placement& placement : test::placements())
    {
      Eigen::MatrixXd moved(
        hexsweep::surfaceLaplacian(placement.motion(mesh.points), mesh.triangles, weights));
      // Cotangents have no unit, mean value weights are one over a length.
      moved *= weights == Weights::MeanValue ? placement.motion.scale : 1.0;
      // Rounding of coordinates over the shortest edge, about 0.02, and a sliver's angles.
      EXPECT_LT((moved - plain).cwiseAbs().maxCoeff(),
        1e4 * placement.relativeRounding * plain.cwiseAbs().maxCoeff())
        << placement.name;
    }
  }
}

TEST(SurfaceLaplacian, UnusedPointsHaveEmptyRows)
{
  TriangleMesh mesh = test::plate(4, {});
  mesh.points.conservativeResize(mesh.points.rows() + 1, 3);
  mesh.points.bottomRows<1>() << 5, 5, 5;
  for (const Weights weights : { Weights::Cotangent, Weights::MeanValue })
  {
    const Eigen::MatrixXd laplacian(
      hexsweep::surfaceLaplacian(mesh.points, mesh.triangles, weights));
    EXPECT_EQ(laplacian.rows(), mesh.points.rows());
    EXPECT_TRUE(laplacian.bottomRows<1>().isZero(0.0));
    EXPECT_TRUE(laplacian.rightCols<1>().isZero(0.0));
  }
}

TEST(SurfaceLaplacian, TrianglesWithoutAreaAreNamed)
{
  TriangleMesh mesh = test::plate(2, {});
  mesh.points.row(mesh.triangles(3, 0)) = mesh.points.row(mesh.triangles(3, 1));
  test::expectInvalid(
    [&] { hexsweep::cotangentLaplacian(mesh.points, mesh.triangles); }, "no area");
  test::expectInvalid(
    [&] { hexsweep::meanValueLaplacian(mesh.points, mesh.triangles); }, "no area");

  Points line(3, 3);
  line << 0, 0, 0, 1, 0, 0, 2, 0, 0;
  const auto one = test::facesOf<hexsweep::Triangles>({ 0, 1, 2 });
  EXPECT_FALSE(hexsweep::hasWeights(line, one.row(0)));
  EXPECT_FALSE(hexsweep::hasWeights(Points(0.0 * line), one.row(0)));
  line.row(2) << 1, 1e-6, 0;
  EXPECT_TRUE(hexsweep::hasWeights(1e-6 * line, one.row(0)));
  line.row(2) << 2, 0, 0;
  test::expectInvalid([&] { hexsweep::cotangentLaplacian(line, one); },
    "corners (0, 0, 0), (1, 0, 0) and (2, 0, 0) has no area");
  test::expectInvalid([&] { hexsweep::meanValueLaplacian(line, one); },
    "corners (0, 0, 0), (1, 0, 0) and (2, 0, 0) has no area");
}
}
