// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/RemeshingMesh.h"

#include "Support/CapMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace TestRemeshingMesh
{
using hexsweep::Index;
using hexsweep::RemeshingInput;
using hexsweep::RemeshingMesh;
using hexsweep::SurfaceSearch;
using hexsweep::TriangleMesh;

/// Triangles as they are whatever the row and the corner that they begin with.
std::set<std::array<Index, 3>> trianglesOf(
  const hexsweep::Triangles& triangles, const std::vector<Index>& pointOf)
{
  std::set<std::array<Index, 3>> result;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    std::array<Index, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c)
    {
      corners[c] = pointOf[static_cast<std::size_t>(triangles(t, static_cast<Index>(c)))];
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.insert(corners);
  }
  return result;
}

/// The outer loop of a plate of 2 x 2 cells, from its lower left corner; corners stay.
RemeshingInput smallPlate()
{
  RemeshingInput input;
  input.mesh = test::plate(2, {});
  input.curves = { test::loopsOf(input.mesh).front() };
  input.curves[0].push_back(input.curves[0].front());
  input.stays.assign(9, false);
  for (Index i = 0; i < 9; ++i)
  {
    const auto p = input.mesh.points.row(i);
    input.stays[static_cast<std::size_t>(i)] = p[0] != 0.5 && p[1] != 0.5;
  }
  return input;
}

TEST(RemeshingMesh, ShapeIsAreaOverSquaredLongestEdge)
{
  const Eigen::RowVector3d a(1.0, 2.0, 3.0);
  const Eigen::RowVector3d x(0.0, 2e-3, 0.0);
  const Eigen::RowVector3d y(0.0, 0.0, 1e-3);
  const Eigen::RowVector3d up(7.0, 0.0, 0.0);
  EXPECT_NEAR(hexsweep::triangleShape(a, a + x, a + y, up), 1.0 / 5.0, 1e-12);
  EXPECT_NEAR(hexsweep::triangleShape(a + y, a + x, a, up), -1.0 / 5.0, 1e-12);
  EXPECT_NEAR(hexsweep::triangleShape(a, a + x, a + 0.5 * x + std::sqrt(3.0) * y, 1e-9 * up),
    std::sqrt(3.0) / 4.0, 1e-12);
  EXPECT_EQ(hexsweep::triangleShape(a, a, a, up), 0.0);
  EXPECT_EQ(hexsweep::triangleShape(a, a + x, a + y, 0.0 * up), 0.0);
}

TEST(RemeshingMesh, GivesBackWhatItWasGiven)
{
  TriangleMesh mesh = test::curvedPlate(2, 0.3);
  // A point that no triangle uses is left out.
  mesh.points.conservativeResize(mesh.points.rows() + 1, 3);
  mesh.points.bottomRows(1).setConstant(0.5);
  RemeshingInput input{ mesh, {},
    std::vector<bool>(static_cast<std::size_t>(mesh.points.rows()), true) };
  const SurfaceSearch surface(mesh);
  const hexsweep::RemeshedSurface result = RemeshingMesh(input, surface, 0.1).result();
  ASSERT_EQ(result.pointOf.size(), static_cast<std::size_t>(mesh.points.rows()));
  EXPECT_EQ(result.pointOf.back(), -1);
  ASSERT_EQ(result.mesh.points.rows(), mesh.points.rows() - 1);
  std::vector<Index> self;
  for (Index i = 0; i + 1 < mesh.points.rows(); ++i)
  {
    const Index point = result.pointOf[static_cast<std::size_t>(i)];
    EXPECT_EQ(result.mesh.points.row(point), mesh.points.row(i));
    self.push_back(i);
  }
  EXPECT_EQ(result.mesh.triangles.rows(), mesh.triangles.rows());
  EXPECT_EQ(trianglesOf(mesh.triangles, result.pointOf), trianglesOf(result.mesh.triangles, self));
}

TEST(RemeshingMesh, CurvesTakeShortCuts)
{
  const RemeshingInput input = smallPlate();
  const SurfaceSearch surface(input.mesh);
  RemeshingMesh mesh(input, surface, 10.0);
  const auto vertex = [](Index i) { return RemeshingMesh::Vertex(static_cast<int>(i)); };
  for (std::size_t k = 1; k + 1 < input.curves[0].size(); ++k)
  {
    const Index before = input.curves[0][k - 1];
    const Index here = input.curves[0][k];
    const Index after = input.curves[0][k + 1];
    EXPECT_TRUE(mesh.isKept(vertex(before), vertex(here)));
    EXPECT_TRUE(mesh.isKept(vertex(here), vertex(before)));
    EXPECT_FALSE(mesh.isKept(vertex(before), vertex(after)));
    EXPECT_EQ(mesh.curveNeighbors(here).before, before);
    EXPECT_EQ(mesh.curveNeighbors(here).after, after);
    EXPECT_TRUE(mesh.data(vertex(here)).onCurve);
    // Nodes are to be at the points that stay: the ends of the square's sides.
    EXPECT_EQ(mesh.data(vertex(here)).spacing, 1.0);
  }
  const Index gone = input.curves[0][1];
  const auto [before, after] = mesh.curveNeighbors(gone);
  ASSERT_TRUE(mesh.canTakeShortCut(gone));
  mesh.takeShortCut(gone);
  EXPECT_TRUE(mesh.isKept(vertex(before), vertex(after)));
  EXPECT_FALSE(mesh.isKept(vertex(before), vertex(gone)));
  EXPECT_FALSE(mesh.isKept(vertex(gone), vertex(after)));
  EXPECT_EQ(mesh.curveNeighbors(after).before, before);
}

TEST(RemeshingMesh, LoopOfThreeTakesNoShortCut)
{
  RemeshingInput input;
  input.mesh.points.resize(4, 3);
  input.mesh.points << 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, -1.0, 0.0, 0.0, 0.0, 0.0;
  input.mesh.triangles = test::facesOf<hexsweep::Triangles>({ 0, 1, 3, 1, 2, 3, 2, 0, 3 });
  input.curves = { { 0, 1, 2, 0 } };
  input.stays = { true, false, false, true };
  const SurfaceSearch surface(input.mesh);
  const RemeshingMesh mesh(input, surface, 1.0);
  EXPECT_FALSE(mesh.canTakeShortCut(1));
}

TEST(RemeshingMesh, LengthsAreRelativeToWhatIsWanted)
{
  RemeshingInput input = smallPlate();
  const SurfaceSearch surface(input.mesh);
  RemeshingMesh mesh(input, surface, 2.0);
  const auto corner = RemeshingMesh::Vertex(0);
  EXPECT_EQ(mesh.position(corner), Eigen::RowVector3d(0.0, 0.0, 0.0));
  for (const auto e : mesh.halfEdges().edges())
  {
    if (e.v0() == corner || e.v1() == corner)
    {
      const auto other = e.v0() == corner ? e.v1() : e.v0();
      mesh.data(corner).wanted = 1.0;
      mesh.data(other).wanted = 3.0;
      EXPECT_DOUBLE_EQ(mesh.relativeLength(e), mesh.position(other).norm() / 2.0);
      EXPECT_EQ(mesh.isKept(e), mesh.position(other).norm() == 0.5);
    }
  }
}
}
