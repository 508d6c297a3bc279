// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Cap.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include "Support/CapMeshes.h"

#include <gtest/gtest.h>

namespace TestCap
{
using hexsweep::Cap;
using hexsweep::makeCap;
using hexsweep::TriangleMesh;

TEST(Cap, IsOrientedLikeItsFirstTriangleAndKnowsItsLoops)
{
  const TriangleMesh mesh = test::annulus(0.4, 1.0, 3, 12);
  TriangleMesh mixed = mesh;
  for (hexsweep::Index t = 1; t < mixed.triangles.rows(); t += 3)
  {
    std::swap(mixed.triangles(t, 1), mixed.triangles(t, 2));
  }
  const Cap cap = makeCap(mixed, "cap");
  EXPECT_EQ(cap.triangles(), mesh.triangles);
  EXPECT_EQ(cap.points(), mesh.points);
  EXPECT_EQ(cap.loops(), hexsweep::checkSurface(mesh.triangles, mesh.points.rows(), "mesh").loops);
  EXPECT_EQ(cap.loops().size(), 2u);
}

TEST(Cap, IsNothingElse)
{
  TriangleMesh tetrahedron;
  tetrahedron.points = hexsweep::Points::Random(4, 3);
  tetrahedron.triangles.resize(4, 3);
  tetrahedron.triangles << 0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0;
  test::expectInvalid([&] { makeCap(tetrahedron, "my surface"); }, "my surface");
  const TriangleMesh disk = test::plate(2, {});
  TriangleMesh two = disk;
  two.points.conservativeResize(2 * disk.points.rows(), 3);
  two.points.bottomRows(disk.points.rows()) = disk.points;
  two.triangles.conservativeResize(2 * disk.triangles.rows(), 3);
  two.triangles.bottomRows(disk.triangles.rows()) =
    (disk.triangles.array() + disk.points.rows()).matrix();
  test::expectInvalid([&] { makeCap(two, "my surface"); }, "my surface");
}
}
