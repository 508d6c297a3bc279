// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/FlatFlips.h"

#include "Support/CapMeshes.h"

namespace TestFlatFlips
{
using test::Index;

double signedArea(const test::TriangleMesh& mesh)
{
  double area = 0.0;
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = mesh.points.row(mesh.triangles(t, 0));
    const Eigen::RowVector3d u = mesh.points.row(mesh.triangles(t, 1)) - a;
    const Eigen::RowVector3d v = mesh.points.row(mesh.triangles(t, 2)) - a;
    area += 0.5 * u.cross(v).z();
  }
  return area;
}

TEST(FlatFlips, APlaneEndsUpDelaunayWithTheSameArea)
{
  const test::TriangleMesh plate = test::plate(12, test::threeHoles(), 0.24);
  hexsweep::FlatFlips flips(plate);
  flips.flipAll();
  EXPECT_GT(flips.flips(), 0);
  const hexsweep::HalfEdgeTriangles& mesh = flips.connectivity();
  for (Index half = 0; half < mesh.numberOfHalfEdges(); ++half)
  {
    if (mesh.twin(half) < 0)
    {
      continue;
    }
    // The in-circle determinant of a triangle and the apex across is not positive.
    const Eigen::RowVector3d d = flips.point(mesh.apex(mesh.twin(half)));
    const Index corners[3] = { mesh.from(half), mesh.to(half), mesh.apex(half) };
    Eigen::Matrix3d circle;
    for (int i = 0; i < 3; ++i)
    {
      const Eigen::RowVector3d arm = flips.point(corners[i]) - d;
      circle.row(i) << arm.x(), arm.y(), arm.squaredNorm();
    }
    const double size = circle.leftCols<2>().rowwise().norm().maxCoeff();
    EXPECT_LE(circle.determinant(), 1e-9 * std::pow(size, 4.0));
  }
  EXPECT_NEAR(signedArea(flips.mesh()), signedArea(plate), 1e-12);
}

TEST(FlatFlips, AddedPointsKeepTheArea)
{
  const test::TriangleMesh plate = test::plate(12, test::threeHoles(), 0.24);
  hexsweep::FlatFlips flips(plate);
  std::mt19937 generator(6);
  for (int step = 0; step < 100; ++step)
  {
    const hexsweep::HalfEdgeTriangles& mesh = flips.connectivity();
    const Index half = static_cast<Index>(generator()) % mesh.numberOfHalfEdges();
    const Index points = flips.numberOfPoints();
    const bool inner = mesh.twin(half) >= 0;
    const Eigen::RowVector3d ends = flips.point(mesh.from(half)) + flips.point(mesh.to(half));
    const Eigen::RowVector3d all = ends + flips.point(mesh.apex(half));
    const Index added = inner ? flips.halve(half) : flips.insertCentroid(half / 3);
    ASSERT_EQ(added, points);
    const Eigen::RowVector3d place = inner ? ends / 2.0 : all / 3.0;
    EXPECT_LT((flips.point(added) - place).norm(), 1e-15);
  }
  EXPECT_NEAR(signedArea(flips.mesh()), signedArea(plate), 1e-12);
  // No triangle has turned over.
  EXPECT_NEAR(test::surfaceArea(flips.mesh()), signedArea(plate), 1e-12);
}

TEST(FlatFlips, AFoldStays)
{
  test::TriangleMesh two;
  two.points.resize(4, 3);
  two.points << 0, 0, 0, 4, 0, 0, 2, 0.5, 0, 2, -0.5, 0;
  two.triangles.resize(2, 3);
  two.triangles << 0, 1, 2, 1, 0, 3;
  hexsweep::FlatFlips flat(two);
  EXPECT_TRUE(flat.isFlat(0));
  // At both apexes u = (-2, -1/2), v = (2, -1/2): u . v = -15/4, |u x v| = 2.
  EXPECT_NEAR(flat.weight(0), -3.75, 1e-14);
  flat.flipAll();
  EXPECT_EQ(flat.flips(), 1);

  two.points(2, 2) = 0.1;
  hexsweep::FlatFlips bent(two);
  EXPECT_FALSE(bent.isCoplanar(0));
  bent.flipAll();
  EXPECT_EQ(bent.flips(), 0);
}
}
