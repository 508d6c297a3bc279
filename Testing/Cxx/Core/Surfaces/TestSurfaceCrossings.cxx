// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SurfaceCrossings.h"

#include "Support/CoarsePlates.h"
#include "Support/DenseTruth.h"

#include <gtest/gtest.h>

namespace TestSurfaceCrossings
{
using namespace test;
using hexsweep::findCrossing;

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b)
{
  TriangleMesh both;
  both.points.resize(a.points.rows() + b.points.rows(), 3);
  both.points << a.points, b.points;
  both.triangles.resize(a.triangles.rows() + b.triangles.rows(), 3);
  both.triangles << a.triangles, (b.triangles.array() + a.points.rows()).matrix();
  return both;
}

TEST(SurfaceCrossings, CleanSurfacesHaveNone)
{
  std::mt19937 generator(7);
  for (const Placement& placement : placements())
  {
    TriangleMesh mesh = curvedPlate(3, 0.2);
    mesh.points = placement.motion(mesh.points);
    EXPECT_FALSE(findCrossing(mesh).has_value());
  }
  for (int i = 0; i < 20; ++i)
  {
    EXPECT_FALSE(findCrossing(randomCoarsePlate(generator)).has_value());
  }
  EXPECT_FALSE(findCrossing(TriangleMesh{ Points(0, 3), Triangles(0, 3) }).has_value());
}

TEST(SurfaceCrossings, TouchingIsNoCrossing)
{
  TriangleMesh flat = disk(3, 12);
  TriangleMesh upright = flat;
  upright.points.col(2) = flat.points.col(0);
  upright.points.col(0).setZero();
  upright.points.col(2).array() += 1.0; // stands on the flat one
  EXPECT_FALSE(findCrossing(joined(flat, upright)).has_value());
  TriangleMesh beside = flat;
  beside.points.col(0).array() += 2.0 * flat.points.col(0).maxCoeff();
  EXPECT_FALSE(findCrossing(joined(flat, beside)).has_value());
}

TEST(SurfaceCrossings, OneDiskThroughAnother)
{
  const TriangleMesh flat = disk(3, 12);
  for (const Placement& placement : placements())
  {
    TriangleMesh upright = flat;
    upright.points.col(2) = flat.points.col(0);
    upright.points.col(0).setConstant(0.1);
    upright.points.col(2).array() += 0.07;
    TriangleMesh both = joined(flat, upright);
    both.points = placement.motion(both.points);
    const auto crossing = findCrossing(both);
    ASSERT_TRUE(crossing.has_value());
    EXPECT_LT(crossing->first, flat.triangles.rows());
    EXPECT_GE(crossing->second, flat.triangles.rows());
  }
}

TEST(SurfaceCrossings, FoldsInOnePlane)
{
  // A node of a plate is pulled over its neighbours: the plate lies upon itself there.
  TriangleMesh mesh = plate(6, {}, 0.0);
  EXPECT_FALSE(findCrossing(mesh).has_value());
  for (Index i = 0; i < mesh.points.rows(); ++i)
  {
    if ((mesh.points.row(i) - Eigen::RowVector3d(0.5, 0.5, 0.0)).norm() < 1e-9)
    {
      mesh.points(i, 0) += 0.25;
    }
  }
  const auto crossing = findCrossing(mesh);
  ASSERT_TRUE(crossing.has_value());
  EXPECT_NEAR(crossing->place.x(), 0.65, 0.2);
  EXPECT_NEAR(crossing->place.y(), 0.5, 0.2);
}

/// By brute force: whether segments of the planes' common line overlap.
bool cross(const TriangleMesh& mesh, Index a, Index b)
{
  const auto corner = [&](Index t, Index c) -> Eigen::RowVector3d {
    return mesh.points.row(mesh.triangles(t, c % 3));
  };
  const auto pierces = [&](Index edges, Index face) {
    for (Index c = 0; c < 3; ++c)
    {
      Eigen::Matrix3d system;
      system << (corner(face, 1) - corner(face, 0)).transpose(),
        (corner(face, 2) - corner(face, 0)).transpose(),
        (corner(edges, c) - corner(edges, c + 1)).transpose();
      const Eigen::Vector3d x =
        test::denseSolution(system, (corner(edges, c) - corner(face, 0)).transpose());
      if (x[0] > 0 && x[1] > 0 && x[0] + x[1] < 1 && x[2] > 0 && x[2] < 1)
      {
        return true;
      }
    }
    return false;
  };
  return pierces(a, b) || pierces(b, a);
}

TEST(SurfaceCrossings, RandomTrianglesAgainstBruteForce)
{
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int crossed = 0;
  for (int round = 0; round < 200; ++round)
  {
    TriangleMesh mesh{ Points(30, 3), Triangles(10, 3) };
    for (Index t = 0; t < 10; ++t)
    {
      const Eigen::RowVector3d center(uniform(generator), uniform(generator), uniform(generator));
      for (Index c = 0; c < 3; ++c)
      {
        mesh.triangles(t, c) = 3 * t + c;
        mesh.points.row(3 * t + c) = center +
          0.3 * Eigen::RowVector3d(uniform(generator), uniform(generator), uniform(generator));
      }
    }
    std::pair<Index, Index> expected{ -1, -1 };
    for (Index a = 0; a < 10 && expected.first < 0; ++a)
    {
      for (Index b = a + 1; b < 10 && expected.first < 0; ++b)
      {
        if (cross(mesh, a, b))
        {
          expected = { a, b };
        }
      }
    }
    const auto found = findCrossing(mesh);
    ASSERT_EQ(found.has_value(), expected.first >= 0) << round;
    if (found)
    {
      ++crossed;
      EXPECT_EQ(std::make_pair(found->first, found->second), expected) << round;
    }
  }
  EXPECT_GT(crossed, 20);
  EXPECT_LT(crossed, 180);
}
}
