// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SurfaceFolds.h"

#include "Support/CapMeshes.h"
#include "Support/DenseTruth.h"

#include <gtest/gtest.h>

namespace TestSurfaceFolds
{
using namespace test;
using hexsweep::findFold;

/// Bent over a circle: from end to end by `angle`, so that it is steep at both.
TriangleMesh archOf(double angle)
{
  TriangleMesh mesh = plate(12, {});
  for (Index i = 0; i < mesh.points.rows(); ++i)
  {
    const double along = angle * (mesh.points(i, 0) - 0.5);
    mesh.points.row(i) << std::sin(along), mesh.points(i, 1), std::cos(along);
  }
  return mesh;
}

TEST(SurfaceFolds, SurfacesThatAreBentHaveNone)
{
  for (const Placement& placement : placements())
  {
    for (const double angle : { 0.5, 3.0, 6.0 })
    {
      TriangleMesh mesh = archOf(angle);
      mesh.points = placement.motion(mesh.points);
      EXPECT_FALSE(findFold(mesh).has_value());
    }
  }
  // A groove with walls that make an angle of a degree.
  TriangleMesh groove = plate(20, {});
  for (Index i = 0; i < groove.points.rows(); ++i)
  {
    groove.points(i, 2) = std::abs(groove.points(i, 0) - 0.5) < 0.01 ? -6.0 : 0.0;
  }
  EXPECT_FALSE(findFold(groove).has_value());
}

TEST(SurfaceFolds, ATriangleOnItsBackIsFound)
{
  for (const Placement& placement : placements())
  {
    for (const double rise : { 0.0, 0.02, -0.02 })
    {
      TriangleMesh mesh = plate(6, {});
      // An inner node beyond its neighbours, and a little above or below them.
      Index node = 0;
      (mesh.points.rowwise() - Eigen::RowVector3d(0.5, 0.5, 0.0)).rowwise().norm().minCoeff(&node);
      mesh.points.row(node) += Eigen::RowVector3d(0.3, 0.0, rise);
      mesh.points = placement.motion(mesh.points);
      const auto fold = findFold(mesh);
      ASSERT_TRUE(fold.has_value());
      const auto has = [&](Index t) { return (mesh.triangles.row(t).array() == node).any(); };
      EXPECT_TRUE(has(fold->turnedOver));
      // They have an edge in common, whose middle it is.
      Index shared = 0;
      Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
      for (const Index i : mesh.triangles.row(fold->turnedOver))
      {
        if ((mesh.triangles.row(fold->upright).array() == i).any())
        {
          ++shared;
          middle += 0.5 * mesh.points.row(i);
        }
      }
      EXPECT_EQ(shared, 2);
      EXPECT_LT((middle - fold->place).norm(), 1e-12 * mesh.points.cwiseAbs().maxCoeff());
    }
  }
}
}
