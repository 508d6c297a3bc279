// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SplitSurface.h"

#include "Support/CapMeshes.h"

#include <random>
#include <set>

namespace TestSplitSurface
{
using hexsweep::HalfEdgeTriangles;
using hexsweep::SplitSurface;
using test::Index;

/// The points of edges with v, by looking at every triangle.
std::set<Index> neighborsOf(const hexsweep::Triangles& triangles, Index v)
{
  std::set<Index> points;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    if ((triangles.row(t).array() == v).any())
    {
      points.insert(triangles.row(t).begin(), triangles.row(t).end());
    }
  }
  points.erase(v);
  return points;
}

TEST(SplitSurface, SplitsKeepTheShapeAndTheNeighbours)
{
  const test::TriangleMesh plate = test::plate(6, {}, 0.3);
  SplitSurface surface(plate);
  std::mt19937 generator(5);
  for (int k = 0; k < 200; ++k)
  {
    const HalfEdgeTriangles& triangles = surface.triangles();
    const Index half = static_cast<Index>(generator()) % triangles.numberOfHalfEdges();
    const Eigen::RowVector3d a = surface.point(triangles.from(half));
    const Eigen::RowVector3d b = surface.point(triangles.to(half));
    const Eigen::RowVector3d c = surface.point(triangles.apex(half));
    const Index v = k % 2 == 0 ? surface.splitEdge(half, 0.3 * a + 0.7 * b)
                               : surface.splitTriangle(half / 3, (a + b + c) / 3.0);
    EXPECT_EQ(v, plate.points.rows() + k);
  }
  const test::TriangleMesh mesh = surface.mesh();
  EXPECT_NEAR(test::surfaceArea(mesh), 1.0, 1e-12);
  const HalfEdgeTriangles fresh(mesh.triangles);
  for (Index half = 0; half < fresh.numberOfHalfEdges(); ++half)
  {
    ASSERT_EQ(surface.triangles().twin(half), fresh.twin(half));
  }
  for (Index v = 0; v < mesh.points.rows(); ++v)
  {
    const std::vector<Index> found = surface.neighbors(v);
    const std::set<Index> expected = neighborsOf(mesh.triangles, v);
    EXPECT_EQ(found.size(), expected.size());
    EXPECT_EQ(std::set<Index>(found.begin(), found.end()), expected);
    EXPECT_NEAR(surface.normal(v).z(), 1.0, 1e-12);
    for (const Index u : found)
    {
      const Index half = surface.edge(v, u);
      ASSERT_GE(half, 0);
      EXPECT_EQ((std::set<Index>{ fresh.from(half), fresh.to(half) }), (std::set<Index>{ u, v }));
    }
  }
}

TEST(SplitSurface, PlacesAreFoundOnThePartsOfTheirTriangle)
{
  test::TriangleMesh one{ test::Points(3, 3), test::Triangles(1, 3) };
  one.points << 0, 0, 1, 2, 0, 1, 0, 2, 1;
  one.triangles << 0, 1, 2;
  SplitSurface surface(one);
  surface.splitTriangle(0, { 0.5, 0.5, 1.0 });
  // Left of the new point, between corners 2 and 0.
  const hexsweep::TrianglePoint found = surface.locate(0, { 0.1, 0.6, 1.5 });
  EXPECT_NEAR(found.distance, 0.5, 1e-15);
  std::set<Index> corners;
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
  for (Index c = 0; c < 3; ++c)
  {
    const Index v = surface.triangles().from(3 * found.triangle + c);
    corners.insert(v);
    place += found.coordinates[c] * surface.point(v);
  }
  EXPECT_EQ(corners, (std::set<Index>{ 0, 2, 3 }));
  EXPECT_LE((place - Eigen::RowVector3d(0.1, 0.6, 1.0)).norm(), 1e-15);
  for (const Index origin : surface.origins())
  {
    EXPECT_EQ(origin, 0);
  }
}
}
