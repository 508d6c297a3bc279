// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/SurfaceRegions.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

namespace TestSurfaceRegions
{
using hexsweep::Index;
using hexsweep::Points;
using hexsweep::SurfaceRegion;
using hexsweep::Triangles;

/// Two cubes on each other, the face between them there once.
struct TwoCubes
{
  Points points{ 12, 3 };
  Triangles triangles{ 22, 3 };

  TwoCubes()
  {
    for (int i = 0; i < 12; ++i)
    {
      this->points.row(i) << (i & 1), ((i >> 1) & 1), i / 4;
    }
    Index row = 0;
    const auto add = [&](Index a, Index b, Index c, Index d) {
      this->triangles.row(row++) << a, b, c;
      this->triangles.row(row++) << a, c, d;
    };
    for (const Index z : { 0, 4 })
    {
      add(z + 0, z + 1, z + 5, z + 4);
      add(z + 1, z + 3, z + 7, z + 5);
      add(z + 3, z + 2, z + 6, z + 7);
      add(z + 2, z + 0, z + 4, z + 6);
    }
    add(0, 2, 3, 1);
    add(4, 5, 7, 6);
    add(8, 9, 11, 10);
  }
};

double volumeOf(const Points& points, const Triangles& triangles)
{
  double volume = 0.0;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = points.row(triangles(t, 0));
    const Eigen::RowVector3d b = points.row(triangles(t, 1));
    volume += a.dot(b.cross(Eigen::RowVector3d(points.row(triangles(t, 2))))) / 6.0;
  }
  return volume;
}

TEST(SurfaceRegions, TwoCubesWithACommonFaceAreTwoRegions)
{
  const TwoCubes cubes;
  const std::vector<SurfaceRegion> regions =
    hexsweep::surfaceRegions(cubes.points, cubes.triangles);
  ASSERT_EQ(regions.size(), 2U);
  for (const SurfaceRegion& region : regions)
  {
    EXPECT_EQ(region.rows.size(), 12U);
    EXPECT_NEAR(volumeOf(cubes.points, region.triangles), 1.0, 1e-14);
  }
}

TEST(SurfaceRegions, OrientationOfTheTrianglesDoesNotMatter)
{
  TwoCubes cubes;
  for (Index t = 0; t < cubes.triangles.rows(); t += 3)
  {
    std::swap(cubes.triangles(t, 0), cubes.triangles(t, 1));
  }
  const std::vector<SurfaceRegion> regions =
    hexsweep::surfaceRegions(cubes.points, cubes.triangles);
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_NEAR(volumeOf(cubes.points, regions[0].triangles), 1.0, 1e-14);
  EXPECT_NEAR(volumeOf(cubes.points, regions[1].triangles), 1.0, 1e-14);
}

TEST(SurfaceRegions, ASheetInsideBoundsNothing)
{
  const TwoCubes cubes;
  Triangles triangles(cubes.triangles.rows() + 1, 3);
  triangles.topRows(cubes.triangles.rows()) = cubes.triangles;
  triangles.bottomRows(1) << 0, 1, 7; // from an edge of the lower cube into it
  const std::vector<SurfaceRegion> regions = hexsweep::surfaceRegions(cubes.points, triangles);
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[0].rows.size(), 12U);
}

TEST(SurfaceRegions, AnOpenSurfaceHasNone)
{
  const TwoCubes cubes;
  EXPECT_TRUE(hexsweep::surfaceRegions(cubes.points, cubes.triangles.topRows(8)).empty());
}
}
