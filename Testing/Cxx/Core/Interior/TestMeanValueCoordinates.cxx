// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/MeanValueCoordinates.h"

#include "Core/Common/Errors.h"
#include "Support/CageShapes.h"
#include "Support/CageTests.h"

namespace TestMeanValueCoordinates
{
using hexsweep::Index;
using hexsweep::MeanValueCoordinates;
using hexsweep::Points;
using hexsweep::TriangleMesh;
using test::Sweep;

Points meanValue(const Sweep& sweep)
{
  return hexsweep::meanValueInterior(test::cageOf(sweep));
}

/// The pseudo-code of Ju, Schaefer, Warren (2005), figure 4, for points in no plane of a triangle.
Eigen::VectorXd publishedFormula(const TriangleMesh& cage, const Eigen::RowVector3d& x)
{
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(cage.points.rows());
  for (Index t = 0; t < cage.triangles.rows(); ++t)
  {
    Eigen::Matrix3d u;
    double d[3];
    for (int i = 0; i < 3; ++i)
    {
      const Eigen::RowVector3d arm = cage.points.row(cage.triangles(t, i)) - x;
      d[i] = arm.norm();
      u.row(i) = arm / d[i];
    }
    double theta[3];
    for (int i = 0; i < 3; ++i)
    {
      theta[i] = 2 * std::asin((u.row((i + 1) % 3) - u.row((i + 2) % 3)).norm() / 2);
    }
    const double h = (theta[0] + theta[1] + theta[2]) / 2;
    double c[3];
    double s[3];
    for (int i = 0; i < 3; ++i)
    {
      c[i] = 2 * std::sin(h) * std::sin(h - theta[i]) /
          (std::sin(theta[(i + 1) % 3]) * std::sin(theta[(i + 2) % 3])) -
        1;
      s[i] = std::copysign(std::sqrt(1 - c[i] * c[i]), u.determinant());
    }
    for (int i = 0; i < 3; ++i)
    {
      const int next = (i + 1) % 3;
      const int previous = (i + 2) % 3;
      weights[cage.triangles(t, i)] +=
        (theta[i] - c[next] * theta[previous] - c[previous] * theta[next]) /
        (d[i] * std::sin(theta[next]) * s[previous]);
    }
  }
  return weights / weights.sum();
}

/// The definition: a hat function over the distance, integrated over the unit sphere.
Eigen::VectorXd byQuadrature(const TriangleMesh& cage, const Eigen::RowVector3d& x)
{
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(cage.points.rows());
  for (Index t = 0; t < cage.triangles.rows(); ++t)
  {
    Eigen::Matrix3d corners;
    for (int i = 0; i < 3; ++i)
    {
      corners.row(i) = cage.points.row(cage.triangles(t, i));
    }
    const Eigen::RowVector3d normal =
      (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0)).normalized();
    for (int i = 0; i < 3; ++i)
    {
      weights[cage.triangles(t, i)] += test::integrate(
        corners, x, [&](const Eigen::RowVector3d& y, const Eigen::RowVector3d& hat) {
          const double r2 = (y - x).squaredNorm();
          return hat[i] * (y - x).dot(normal) / (r2 * r2);
        });
    }
  }
  return weights / weights.sum();
}

TEST(MeanValueCoordinates, AreBarycentricOnATetrahedron)
{
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    const TriangleMesh cage = test::moved(test::tetrahedron(), test::similarity(scale));
    const MeanValueCoordinates coordinates(cage.points, cage.triangles);
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < 200; ++i)
    {
      Eigen::Vector4d barycentric;
      for (int c = 0; c < 4; ++c)
      {
        // Every tenth point is close to a face.
        barycentric[c] = uniform(generator) * (i % 10 == c ? 1e-5 : 1.0);
      }
      barycentric /= barycentric.sum();
      const Eigen::VectorXd found = coordinates.at(barycentric.transpose() * cage.points);
      EXPECT_LT((found - barycentric).cwiseAbs().maxCoeff(), 1e-10);
    }
  }
}

TEST(MeanValueCoordinates, EqualThePublishedFormula)
{
  const TriangleMesh cage = test::moved(test::angleBlock(), test::similarity(1.0));
  const MeanValueCoordinates coordinates(cage.points, cage.triangles);
  const Points points = test::insideAngleBlock();
  // The last three are in planes of walls, where the formula is 0 / 0.
  for (Index i = 0; i < 6; ++i)
  {
    const Eigen::RowVector3d x =
      (test::similarity(1.0) * points.row(i).transpose().eval()).transpose();
    EXPECT_LT((coordinates.at(x) - publishedFormula(cage, x)).cwiseAbs().maxCoeff(), 1e-10) << i;
  }
}

TEST(MeanValueCoordinates, EqualTheirDefinitionByQuadrature)
{
  const TriangleMesh cage = test::moved(test::angleBlock(), test::similarity(1.0));
  const MeanValueCoordinates coordinates(cage.points, cage.triangles);
  const Points points = test::insideAngleBlock();
  for (const Index i : { 0, 1, 2, 3, 6, 7, 8 })
  {
    const Eigen::RowVector3d x =
      (test::similarity(1.0) * points.row(i).transpose().eval()).transpose();
    EXPECT_LT((coordinates.at(x) - byQuadrature(cage, x)).cwiseAbs().maxCoeff(), 1e-7) << i;
  }
}

TEST(MeanValueCoordinates, ReproduceLinearFunctionsAtAnyScale)
{
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    const TriangleMesh cage = test::moved(test::angleBlock(), test::similarity(scale));
    const MeanValueCoordinates coordinates(cage.points, cage.triangles);
    const MeanValueCoordinates plain(test::angleBlock().points, cage.triangles);
    const Points points = test::insideAngleBlock();
    for (Index i = 0; i < points.rows(); ++i)
    {
      const Eigen::RowVector3d x =
        (test::similarity(scale) * points.row(i).transpose().eval()).transpose();
      const Eigen::VectorXd found = coordinates.at(x);
      EXPECT_NEAR(found.sum(), 1.0, 1e-14);
      EXPECT_LT((found.transpose() * cage.points - x).norm(), 1e-13 * scale) << i;
      EXPECT_LT((found - plain.at(points.row(i))).cwiseAbs().maxCoeff(), 1e-7) << i;
    }
  }
}

TEST(MeanValueCoordinates, AreContinuousUpToTheCage)
{
  const TriangleMesh cage = test::angleBlock();
  const MeanValueCoordinates coordinates(cage.points, cage.triangles);
  for (const double height : { 1e-3, 1e-5, 1e-6, 1e-7, 1e-9, 1e-12 })
  {
    // Over a triangle, beside an edge, beside a corner, beside the re-entrant edge.
    for (const Eigen::RowVector3d& x : { Eigen::RowVector3d(0.3, 0.6, height),
           Eigen::RowVector3d(0.5, height, height), Eigen::RowVector3d(height, 2 * height, height),
           Eigen::RowVector3d(1 - height, 1 - height, 0.5) })
    {
      const Eigen::VectorXd found = coordinates.at(x);
      EXPECT_TRUE(found.allFinite());
      EXPECT_LT((found.transpose() * cage.points - x).norm(), 1e-8) << height;
    }
  }
  // On a triangle, an edge and a vertex: barycentric in the triangle 0, 4, 1.
  const auto at = [&](double x, double y) { return coordinates.at(Eigen::RowVector3d(x, y, 0)); };
  EXPECT_LT((at(0.7, 0.3) -
              (0.3 * Eigen::VectorXd::Unit(16, 0) + 0.4 * Eigen::VectorXd::Unit(16, 1) +
                0.3 * Eigen::VectorXd::Unit(16, 4)))
              .norm(),
    1e-14);
  EXPECT_LT(
    (at(0.7, 0) - (0.3 * Eigen::VectorXd::Unit(16, 0) + 0.7 * Eigen::VectorXd::Unit(16, 1))).norm(),
    1e-14);
  EXPECT_EQ(at(1, 0), Eigen::VectorXd(Eigen::VectorXd::Unit(16, 1)));
}

TEST(MeanValueInterior, StraightAffineSweepsAreExact)
{
  test::expectStraightAffineSweepsExact(meanValue, 1e-12);
}

TEST(MeanValueInterior, AffineSweepsOfACurvedCapAreExact)
{
  const Sweep sweep =
    test::makeSweep(8, 6, false, test::evenLayers(4), [](double x, double y, double t) {
      return Eigen::RowVector3d(
        x + 0.5 * t, 0.3 * x + y, 0.4 * x * (2 - x) * y * (1 - y) + 0.2 * x + 1.5 * t);
    });
  EXPECT_LT(test::greatestDistance(meanValue(sweep), sweep.layers), 1e-12 * test::sizeOf(sweep));
}

TEST(MeanValueInterior, IsTheSumOverTheCage)
{
  const Sweep sweep = test::makeSweep(6, 6, true, test::evenLayers(4), test::bendingMotion);
  const test::CageModels models = test::modelsOf(sweep);
  const TriangleMesh rest{ hexsweep::cageVertices(models.cage, models.model),
    models.cage.triangles };
  const Points swept = meanValue(sweep);
  for (const Index row : test::insideRows(sweep))
  {
    const Eigen::RowVector3d expected = publishedFormula(rest, models.model.row(row)).transpose() *
      hexsweep::cageVertices(models.cage, models.physical);
    ASSERT_LT((swept.row(row) - expected).norm(), 1e-10 * test::sizeOf(sweep));
  }
}

TEST(MeanValueInterior, KeepsTheContract)
{
  test::expectInteriorContract(hexsweep::meanValueInterior);
}
}
