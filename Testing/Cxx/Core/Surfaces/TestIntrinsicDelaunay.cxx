// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/IntrinsicDelaunay.h"

#include "Support/StretchedCaps.h"

#include "Core/Common/Predicates.h"
#include "Core/Solvers/SurfaceLaplacian.h"
#include "Core/Surfaces/TriangleAngles.h"

#include <set>

namespace TestIntrinsicDelaunay
{
using hexsweep::Index;
using hexsweep::IntrinsicTriangulation;
using hexsweep::SparseMatrix;
using hexsweep::TriangleMesh;

std::vector<TriangleMesh> caps()
{
  std::vector<TriangleMesh> result;
  for (const bool curved : { false, true })
  {
    for (const std::size_t holes : { 0u, 1u, 3u })
    {
      result.push_back(test::stretchedPlate(holes, curved));
    }
    for (const double height : { 1e-3, 1e-5 })
    {
      result.push_back(test::needleStrips(height, curved));
    }
  }
  return result;
}

IntrinsicTriangulation triangulate(const TriangleMesh& mesh)
{
  return hexsweep::intrinsicDelaunay(mesh.points, mesh.triangles);
}

/// The greatest sum of cotangents below zero over inner edges, relative to the two cotangents.
double worstWeight(const IntrinsicTriangulation& intrinsic)
{
  double worst = 0.0;
  for (Index half = 0; half < intrinsic.triangles.size(); ++half)
  {
    const Index twin = intrinsic.twins(half / 3, half % 3);
    if (twin >= 0)
    {
      const double p = intrinsic.cotangents(half / 3, (half % 3 + 2) % 3);
      const double q = intrinsic.cotangents(twin / 3, (twin % 3 + 2) % 3);
      worst = std::min(worst, (p + q) / (1.0 + std::abs(p) + std::abs(q)));
    }
  }
  return worst;
}

TEST(IntrinsicDelaunay, NoInnerEdgeHasANegativeWeight)
{
  for (const TriangleMesh& mesh : caps())
  {
    const IntrinsicTriangulation intrinsic = triangulate(mesh);
    EXPECT_GT(intrinsic.flips, 500);
    EXPECT_GT(worstWeight(intrinsic), -2e-10);
    const SparseMatrix laplacian = hexsweep::intrinsicLaplacian(mesh.points, mesh.triangles);
    const double size = laplacian.norm();
    EXPECT_LT((laplacian * Eigen::VectorXd::Ones(laplacian.cols())).norm(), 1e-12 * size);
    EXPECT_EQ((laplacian - SparseMatrix(laplacian.transpose())).norm() < 1e-13 * size, true);
  }
}

TEST(IntrinsicDelaunay, PlaneCapsGetTheirConstrainedDelaunayTriangulation)
{
  for (const TriangleMesh& mesh : caps())
  {
    if (mesh.points.col(2).cwiseAbs().maxCoeff() > 0.0)
    {
      continue;
    }
    const IntrinsicTriangulation intrinsic = triangulate(mesh);
    std::set<std::pair<Index, Index>> before;
    for (Index half = 0; half < intrinsic.triangles.size(); ++half)
    {
      const Index t = half / 3;
      const Index c = half % 3;
      const Index a = intrinsic.triangles(t, c);
      const Index b = intrinsic.triangles(t, (c + 1) % 3);
      const Index apex = intrinsic.triangles(t, (c + 2) % 3);
      const double length = (mesh.points.row(b) - mesh.points.row(a)).norm();
      EXPECT_NEAR(intrinsic.edgeLengths(t, c), length, 1e-11 * length);
      const Index twin = intrinsic.twins(t, c);
      if (twin >= 0)
      {
        EXPECT_EQ(intrinsic.twins(twin / 3, twin % 3), half);
        const Index other = intrinsic.triangles(twin / 3, (twin % 3 + 2) % 3);
        EXPECT_FALSE(test::isInCircle(mesh.points.row(a), mesh.points.row(b), mesh.points.row(apex),
          mesh.points.row(other), 1e-10));
      }
      EXPECT_TRUE(before.emplace(a, b).second);
    }
    // All upright, none missing: they cover the cap once.
    TriangleMesh flipped{ mesh.points, intrinsic.triangles };
    for (Index t = 0; t < intrinsic.triangles.rows(); ++t)
    {
      const auto at = [&](Index c) -> Eigen::RowVector2d {
        return mesh.points.row(intrinsic.triangles(t, c)).head<2>();
      };
      EXPECT_EQ(hexsweep::orientation(at(0), at(1), at(2)), 1);
    }
    EXPECT_NEAR(
      test::surfaceArea(flipped), test::surfaceArea(mesh), 1e-12 * test::surfaceArea(mesh));
    EXPECT_EQ(test::loopsOf(flipped), test::loopsOf(mesh));
  }
}

TEST(IntrinsicDelaunay, CrossingsAreThoseOfThePlane)
{
  const TriangleMesh mesh = test::needleStrips(1e-3, false);
  const IntrinsicTriangulation intrinsic = triangulate(mesh);
  const auto at = [&](Index i) -> Eigen::RowVector2d { return mesh.points.row(i).head<2>(); };
  const auto cross = [&](Index a, Index b, Index c, Index d) {
    return hexsweep::orientation(at(a), at(b), at(c)) * hexsweep::orientation(at(a), at(b), at(d)) <
      0 &&
      hexsweep::orientation(at(c), at(d), at(a)) * hexsweep::orientation(at(c), at(d), at(b)) < 0;
  };
  std::set<std::pair<Index, Index>> edges;
  for (Index half = 0; half < mesh.triangles.size(); ++half)
  {
    const Index a = mesh.triangles(half / 3, half % 3);
    const Index b = mesh.triangles(half / 3, (half % 3 + 1) % 3);
    edges.emplace(std::min(a, b), std::max(a, b));
  }
  Index whole = 0;
  for (Index half = 0; half < intrinsic.triangles.size(); ++half)
  {
    const Index a = intrinsic.triangles(half / 3, half % 3);
    const Index b = intrinsic.triangles(half / 3, (half % 3 + 1) % 3);
    Index count = 0;
    for (const auto& [c, d] : edges)
    {
      count += cross(a, b, c, d) ? 1 : 0;
    }
    EXPECT_EQ(intrinsic.crossings(half / 3, half % 3), count) << a << ' ' << b;
    whole += count;
  }
  EXPECT_GT(whole, 1000);
}

TEST(IntrinsicDelaunay, TheEnergyOfNoFunctionGrows)
{
  // Rippa's theorem, and its equality case: linear functions of a plane cap.
  std::mt19937 generator(7);
  std::normal_distribution<double> normal;
  for (const TriangleMesh& mesh : caps())
  {
    const SparseMatrix own = hexsweep::cotangentLaplacian(mesh.points, mesh.triangles);
    const SparseMatrix intrinsic = hexsweep::intrinsicLaplacian(mesh.points, mesh.triangles);
    for (int trial = 0; trial < 20; ++trial)
    {
      const Eigen::VectorXd f =
        Eigen::VectorXd::NullaryExpr(mesh.points.rows(), [&] { return normal(generator); });
      EXPECT_LT(f.dot(intrinsic * f), f.dot(own * f));
    }
    if (mesh.points.col(2).cwiseAbs().maxCoeff() == 0.0)
    {
      const Eigen::VectorXd x = mesh.points.col(0);
      // Twice the Dirichlet integral of x is twice the area.
      EXPECT_NEAR(x.dot(intrinsic * x), 2.0 * test::surfaceArea(mesh), 1e-6 * x.dot(own * x));
    }
  }
}

TEST(IntrinsicDelaunay, SizePlaceAndTurnDoNotMatter)
{
  const TriangleMesh mesh = test::stretchedPlate(3, true);
  const IntrinsicTriangulation plain = triangulate(mesh);
  for (const double scale : { 1e-6, 1e6 })
  {
    const test::Similarity motion{ scale, test::someTurn(), { 0.0, 0.0, 0.0 } };
    const IntrinsicTriangulation moved = triangulate({ motion(mesh.points), mesh.triangles });
    EXPECT_LT((moved.edgeLengths / scale - plain.edgeLengths).cwiseAbs().maxCoeff() *
        (moved.triangles == plain.triangles ? 1.0 : 0.0),
      1e-9);
    const SparseMatrix a = hexsweep::intrinsicLaplacian(mesh.points, mesh.triangles);
    const SparseMatrix b = hexsweep::intrinsicLaplacian(motion(mesh.points), mesh.triangles);
    EXPECT_LT((a - b).norm(), 1e-8 * a.norm());
  }
}

TEST(IntrinsicDelaunay, AConeWhoseFlipJoinsTwoVerticesTwice)
{
  // Three rays 20 degrees apart; the long one ends across from two obtuse angles.
  const double angle = test::Pi / 9.0;
  const double height = std::sqrt((1.0 + 2.0 * std::cos(angle)) / 3.0);
  const double radius = std::sqrt(1.0 - height * height);
  TriangleMesh mesh;
  mesh.points.resize(4, 3);
  mesh.points.row(0).setZero();
  for (Index i = 0; i < 3; ++i)
  {
    const double turn = 2.0 * test::Pi * static_cast<double>(i) / 3.0;
    mesh.points.row(i + 1) << radius * std::cos(turn), radius * std::sin(turn), -height;
  }
  mesh.points.row(1) *= 2.0;
  mesh.triangles = test::facesOf<hexsweep::Triangles>({ 0, 1, 2, 0, 2, 3, 0, 3, 1 });
  const IntrinsicTriangulation intrinsic = triangulate(mesh);
  EXPECT_EQ(intrinsic.flips, 1);
  EXPECT_GE(worstWeight(intrinsic), 0.0);
  std::multiset<double> lengths; // of edges between points 2 and 3
  for (Index half = 0; half < 9; ++half)
  {
    const Index a = intrinsic.triangles(half / 3, half % 3);
    const Index b = intrinsic.triangles(half / 3, (half % 3 + 1) % 3);
    if (std::minmax(a, b) == std::minmax<Index>(2, 3) && a < b)
    {
      lengths.insert(intrinsic.edgeLengths(half / 3, half % 3));
    }
  }
  ASSERT_EQ(lengths.size(), 2u);
  EXPECT_NEAR(*lengths.begin(), 2.0 * std::sin(angle / 2.0), 1e-14);
  EXPECT_NEAR(*lengths.rbegin(), 2.0 * std::sin(angle), 1e-14);
}

TEST(IntrinsicDelaunay, GoodTrianglesStay)
{
  const TriangleMesh mesh = test::disk(6, 24);
  EXPECT_EQ(triangulate(mesh).flips, 0);
  EXPECT_EQ((hexsweep::intrinsicLaplacian(mesh.points, mesh.triangles) -
              hexsweep::cotangentLaplacian(mesh.points, mesh.triangles))
              .norm() < 1e-12,
    true);
}
}
