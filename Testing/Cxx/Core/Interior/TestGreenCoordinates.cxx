// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/GreenCoordinates.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Errors.h"
#include "Support/CageShapes.h"
#include "Support/CageTests.h"
#include "Support/DenseTruth.h"

namespace TestGreenCoordinates
{
using hexsweep::GreenCoordinates;
using hexsweep::GreenWeights;
using hexsweep::Index;
using hexsweep::Pi;
using hexsweep::Points;
using hexsweep::TriangleMesh;
using test::Sweep;

Points green(const Sweep& sweep)
{
  return hexsweep::greenInterior(test::cageOf(sweep));
}

/// Outward unit normals.
Points normalsOf(const TriangleMesh& mesh)
{
  Points normals(mesh.triangles.rows(), 3);
  for (Index t = 0; t < normals.rows(); ++t)
  {
    const auto corner = [&](int c) { return mesh.points.row(mesh.triangles(t, c)); };
    normals.row(t) = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
  }
  return normals;
}

Eigen::Matrix3d cornersOf(const TriangleMesh& mesh, Index t)
{
  Eigen::Matrix3d corners;
  for (int c = 0; c < 3; ++c)
  {
    corners.row(c) = mesh.points.row(mesh.triangles(t, c));
  }
  return corners;
}

/// The boundary integrals of Green's third identity, by quadrature.
GreenWeights byQuadrature(const TriangleMesh& mesh, const Eigen::RowVector3d& x)
{
  GreenWeights weights{ Eigen::VectorXd::Zero(mesh.points.rows()),
    Eigen::VectorXd::Zero(mesh.triangles.rows()) };
  const Points normals = normalsOf(mesh);
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = cornersOf(mesh, t);
    weights.faces[t] =
      test::integrate(corners, x, [&](const Eigen::RowVector3d& y, const Eigen::RowVector3d&) {
        return 1 / (4 * Pi * (y - x).norm());
      });
    for (int c = 0; c < 3; ++c)
    {
      weights.vertices[mesh.triangles(t, c)] += test::integrate(
        corners, x, [&](const Eigen::RowVector3d& y, const Eigen::RowVector3d& hat) {
          return hat[c] * (y - x).dot(normals.row(t)) / (4 * Pi * std::pow((y - x).norm(), 3));
        });
    }
  }
  return weights;
}

/// The closed form that the publication gives (its appendix), for points in no special position.
class PublishedFormula
{
public:
  static GreenWeights evaluate(const TriangleMesh& mesh, const Eigen::RowVector3d& x)
  {
    GreenWeights weights{ Eigen::VectorXd::Zero(mesh.points.rows()),
      Eigen::VectorXd::Zero(mesh.triangles.rows()) };
    const Points normals = normalsOf(mesh);
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
    {
      const Eigen::Matrix3d v = cornersOf(mesh, t).rowwise() - x;
      const Eigen::RowVector3d n = normals.row(t);
      const Eigen::RowVector3d p = v.row(0).dot(n) * n;
      const Eigen::RowVector3d origin = Eigen::RowVector3d::Zero();
      double sum = 0.0;
      Eigen::RowVector3d w = Eigen::RowVector3d::Zero();
      Eigen::Matrix3d edgeNormals;
      for (int l = 0; l < 3; ++l)
      {
        const Eigen::RowVector3d a = v.row(l);
        const Eigen::RowVector3d b = v.row((l + 1) % 3);
        const double sign = std::copysign(1.0, (a - p).cross(b - p).dot(n));
        sum += sign * integral(p, a, b, origin);
        edgeNormals.row(l) = b.cross(a).normalized();
        w += edgeNormals.row(l) * integral(origin, b, a, origin);
      }
      const double I = -std::abs(sum);
      weights.faces[t] = -I;
      w += n * I;
      for (int l = 0; l < 3; ++l)
      {
        const auto opposite = edgeNormals.row((l + 1) % 3);
        weights.vertices[mesh.triangles(t, l)] += opposite.dot(w) / opposite.dot(v.row(l));
      }
    }
    return weights;
  }

private:
  static double angleAt(
    const Eigen::RowVector3d& apex, const Eigen::RowVector3d& a, const Eigen::RowVector3d& b)
  {
    return std::atan2((a - apex).cross(b - apex).norm(), (a - apex).dot(b - apex));
  }

  static double integral(const Eigen::RowVector3d& p, const Eigen::RowVector3d& v1,
    const Eigen::RowVector3d& v2, const Eigen::RowVector3d& x)
  {
    const double alpha = angleAt(v1, v2, p);
    const double beta = angleAt(p, v1, v2);
    const double lambda = (p - v1).squaredNorm() * std::pow(std::sin(alpha), 2);
    const double c = (p - x).squaredNorm();
    const auto at = [&](double theta) {
      const double S = std::sin(theta);
      const double C = std::cos(theta);
      const double root = std::sqrt(lambda);
      return -std::copysign(0.5, S) *
        (2 * std::sqrt(c) * std::atan(std::sqrt(c) * C / std::sqrt(lambda + S * S * c)) +
          root *
            std::log(2 * root * S * S / ((1 - C) * (1 - C)) *
              (1 -
                2 * c * C /
                  (c * (1 + C) + lambda + std::sqrt(lambda * lambda + lambda * c * S * S)))));
    };
    return -std::abs(at(Pi - alpha) - at(Pi - alpha - beta) - std::sqrt(c) * beta) / (4 * Pi);
  }
};

Eigen::RowVector3d placed(const Eigen::Affine3d& motion, const Eigen::RowVector3d& point)
{
  return (motion * point.transpose().eval()).transpose();
}

/// Where the cage takes a point when its vertices move.
Eigen::RowVector3d deformed(
  const TriangleMesh& rest, const Points& vertices, const Eigen::RowVector3d& x)
{
  const GreenWeights weights = GreenCoordinates(rest.points, rest.triangles).at(x);
  return weights.vertices.transpose() * vertices +
    weights.faces.transpose() * hexsweep::stretchedNormals(rest.points, vertices, rest.triangles);
}

TEST(GreenCoordinates, ReproduceTheUndeformedCage)
{
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    for (const TriangleMesh& shape : { test::tetrahedron(), test::angleBlock() })
    {
      const Eigen::Affine3d motion = test::similarity(scale);
      const TriangleMesh cage = test::moved(shape, motion);
      const GreenCoordinates coordinates(cage.points, cage.triangles);
      const Points normals = normalsOf(cage);
      const Points inside = shape.points.rows() == 4
        ? Points(Eigen::RowVector4d(0.3, 0.25, 0.25, 0.2) * shape.points)
        : test::insideAngleBlock();
      for (Index i = 0; i < inside.rows(); ++i)
      {
        const Eigen::RowVector3d x = placed(motion, inside.row(i));
        const GreenWeights weights = coordinates.at(x);
        EXPECT_NEAR(weights.vertices.sum(), 1.0, 1e-12);
        EXPECT_GT(weights.faces.minCoeff(), 0.0);
        const Eigen::RowVector3d reproduced =
          weights.vertices.transpose() * cage.points + weights.faces.transpose() * normals;
        EXPECT_LT((reproduced - x).norm(), 1e-12 * scale) << i;
      }
    }
  }
}

TEST(GreenCoordinates, AreTheIntegralsOfGreensIdentity)
{
  const Eigen::Affine3d motion = test::similarity(1.0);
  const TriangleMesh cage = test::moved(test::angleBlock(), motion);
  const GreenCoordinates coordinates(cage.points, cage.triangles);
  const Points inside = test::insideAngleBlock();
  for (const Index i : { 0, 1, 2, 3, 6, 7, 8 })
  {
    const Eigen::RowVector3d x = placed(motion, inside.row(i));
    const GreenWeights weights = coordinates.at(x);
    const GreenWeights expected = byQuadrature(cage, x);
    EXPECT_LT((weights.vertices - expected.vertices).cwiseAbs().maxCoeff(), 1e-8) << i;
    EXPECT_LT((weights.faces - expected.faces).cwiseAbs().maxCoeff(), 1e-8) << i;
  }
}

TEST(GreenCoordinates, EqualThePublishedFormula)
{
  const Eigen::Affine3d motion = test::similarity(1.0);
  const TriangleMesh cage = test::moved(test::angleBlock(), motion);
  const GreenCoordinates coordinates(cage.points, cage.triangles);
  const Points inside = test::insideAngleBlock();
  // The others have their foot on an edge or are in the plane of a triangle: 0 / 0 or infinite.
  for (const Index i : { 0, 1, 2, 4, 5 })
  {
    const Eigen::RowVector3d x = placed(motion, inside.row(i));
    const GreenWeights weights = coordinates.at(x);
    const GreenWeights expected = PublishedFormula::evaluate(cage, x);
    EXPECT_LT((weights.vertices - expected.vertices).cwiseAbs().maxCoeff(), 1e-10) << i;
    EXPECT_LT((weights.faces - expected.faces).cwiseAbs().maxCoeff(), 1e-10) << i;
  }
}

TEST(GreenCoordinates, AreAccurateUpToTheCage)
{
  const TriangleMesh cage = test::angleBlock();
  const GreenCoordinates coordinates(cage.points, cage.triangles);
  const Points normals = normalsOf(cage);
  for (const double height : { 1e-2, 1e-5, 1e-8, 1e-12 })
  {
    // Over a triangle, beside an edge, beside a corner, beside the re-entrant edge.
    for (const Eigen::RowVector3d& x : { Eigen::RowVector3d(0.3, 0.6, height),
           Eigen::RowVector3d(0.5, height, height), Eigen::RowVector3d(height, 2 * height, height),
           Eigen::RowVector3d(1 - height, 1 - height, 0.5) })
    {
      const bool overTriangle = x.x() == 0.3;
      const double tolerance = overTriangle ? 1e-14 : 1e-14 + 1e-16 / height;
      const GreenWeights weights = coordinates.at(x);
      EXPECT_NEAR(weights.vertices.sum(), 1.0, tolerance) << height;
      const Eigen::RowVector3d reproduced =
        weights.vertices.transpose() * cage.points + weights.faces.transpose() * normals;
      EXPECT_LT((reproduced - x).norm(), tolerance) << height;
    }
  }
}

TEST(GreenCoordinates, VanishOutside)
{
  // Green's identity has 0 in place of x there: no point outside is taken for one inside.
  const TriangleMesh cage = test::angleBlock();
  const GreenCoordinates coordinates(cage.points, cage.triangles);
  for (const Eigen::RowVector3d& x :
    { Eigen::RowVector3d(1.5, 1.5, 0.5), Eigen::RowVector3d(0.5, 0.5, -0.3) })
  {
    const GreenWeights weights = coordinates.at(x);
    EXPECT_NEAR(weights.vertices.sum(), 0.0, 1e-13);
    const Eigen::RowVector3d sum =
      weights.vertices.transpose() * cage.points + weights.faces.transpose() * normalsOf(cage);
    EXPECT_LT(sum.norm(), 1e-13);
  }
}

TEST(GreenCoordinates, StretchIsTheRootMeanSquareOfThePrincipalStretches)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 50; ++i)
  {
    TriangleMesh rest;
    rest.triangles = (hexsweep::Triangles(1, 3) << 0, 1, 2).finished();
    rest.points = Points::NullaryExpr(3, 3, [&]() { return uniform(generator); });
    const Eigen::Matrix3d map = Eigen::Matrix3d::NullaryExpr([&]() { return uniform(generator); });
    const Points moved = rest.points * map.transpose();
    // An orthonormal frame of the plane, and the stretches of its image.
    Eigen::Matrix<double, 3, 2> frame;
    frame << (rest.points.row(1) - rest.points.row(0)).transpose(),
      (rest.points.row(2) - rest.points.row(0)).transpose();
    frame.col(0).normalize();
    frame.col(1) -= frame.col(0).dot(frame.col(1)) * frame.col(0);
    frame.col(1).normalize();
    const Eigen::Matrix2d metric = (map * frame).transpose() * (map * frame);
    const Points normal = hexsweep::stretchedNormals(rest.points, moved, rest.triangles);
    EXPECT_NEAR(normal.row(0).norm(), std::sqrt(0.5 * metric.trace()), 1e-12);
    EXPECT_LT(
      (normal.row(0).normalized() - normalsOf({ moved, rest.triangles }).row(0)).norm(), 1e-10);
  }
}

TEST(GreenCoordinates, FollowSimilarityTransforms)
{
  const TriangleMesh rest = test::angleBlock();
  const Points inside = test::insideAngleBlock();
  for (const double scale : { 1e-6, 0.3, 1e6 })
  {
    const Eigen::Affine3d motion = test::similarity(scale);
    const Points vertices = test::moved(rest, motion).points;
    for (Index i = 0; i < inside.rows(); ++i)
    {
      EXPECT_LT((deformed(rest, vertices, inside.row(i)) - placed(motion, inside.row(i))).norm(),
        1e-12 * scale);
    }
  }
}

TEST(GreenCoordinates, StretchedCagesMissTheAffineImageByWhatTheoryGives)
{
  // Green's identity for the coordinate functions of the affine image has A n in place of the
  // normal: A x = sum phi_i A v_i + sum psi_j A n_j. Green coordinates put s_j n'_j there.
  const TriangleMesh rest = test::angleBlock();
  Eigen::Matrix3d stretch;
  stretch << 1, 0.5, 0, 0, 2, 0, 0, 0, 1;
  const Points vertices = rest.points * stretch.transpose();
  const Points missing = hexsweep::stretchedNormals(rest.points, vertices, rest.triangles) -
    normalsOf(rest) * stretch.transpose();
  const Points inside = test::insideAngleBlock();
  for (const Index i : { 0, 1, 2 })
  {
    const Eigen::RowVector3d miss =
      deformed(rest, vertices, inside.row(i)) - inside.row(i) * stretch.transpose();
    const Eigen::RowVector3d expected =
      byQuadrature(rest, inside.row(i)).faces.transpose() * missing;
    EXPECT_LT((miss - expected).norm(), 1e-7);
    EXPECT_GT(miss.norm(), 0.01);
  }
}

TEST(GreenInterior, StraightSweepsAreTheirOwnModel)
{
  // What theory denies to a cage that is stretched (above) is not asked for here: the topological
  // model of a straight sweep is the volume itself.
  test::expectStraightAffineSweepsExact(green, 1e-11);
}

TEST(GreenInterior, TurnsAndScalesWithTheVolume)
{
  // The volume turned and scaled as a whole takes its interior along.
  const Sweep bent = test::makeSweep(6, 6, true, test::evenLayers(3), test::bendingMotion);
  const Points plain = green(bent);
  for (const double scale : { 1e-6, 1e6 })
  {
    const Eigen::Affine3d motion = test::similarity(scale);
    const Sweep turned = test::makeSweep(6, 6, true, test::evenLayers(3),
      [&](double x, double y, double t) { return placed(motion, test::bendingMotion(x, y, t)); });
    const Points expected =
      (plain * motion.linear().transpose()).rowwise() + motion.translation().transpose();
    EXPECT_LT(test::greatestDistance(green(turned), expected), 1e-12 * test::sizeOf(turned));
  }
}

TEST(GreenInterior, IsTheSumOverCageAndNormals)
{
  const Sweep sweep = test::makeSweep(6, 6, true, test::evenLayers(3), test::bendingMotion);
  const test::CageModels models = test::modelsOf(sweep);
  const TriangleMesh rest{ hexsweep::cageVertices(models.cage, models.model),
    models.cage.triangles };
  const Points vertices = hexsweep::cageVertices(models.cage, models.physical);
  const Points normals = hexsweep::stretchedNormals(rest.points, vertices, rest.triangles);
  const Points swept = green(sweep);
  const std::vector<Index> inside = test::insideRows(sweep);
  for (const Index row : { inside.front(), inside[inside.size() / 2], inside.back() })
  {
    const GreenWeights weights = byQuadrature(rest, models.model.row(row));
    const Eigen::RowVector3d expected =
      weights.vertices.transpose() * vertices + weights.faces.transpose() * normals;
    EXPECT_LT((swept.row(row) - expected).norm(), 1e-6 * test::sizeOf(sweep));
  }
}

TEST(GreenInterior, KeepsTheContract)
{
  test::expectInteriorContract(hexsweep::greenInterior);
}
}
