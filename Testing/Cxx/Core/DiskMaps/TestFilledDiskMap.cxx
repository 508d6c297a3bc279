// SPDX-License-Identifier: BSD-3-Clause
// A regular hole in a plane disk is filled by plane triangles: the map is then the identity.
#include "Core/DiskMaps/FilledDiskMap.h"

#include "Core/Common/Predicates.h"
#include "Core/Solvers/SurfaceLaplacian.h"
#include "Support/CapMeshes.h"

namespace TestFilledDiskMap
{
using hexsweep::FilledDiskMap;
using hexsweep::Index;
using hexsweep::PlanePoints;
using hexsweep::TriangleMesh;
using hexsweep::Weights;

FilledDiskMap mapOf(const TriangleMesh& mesh, const hexsweep::SparseMatrix& laplacian)
{
  const auto loops = test::loopsOf(mesh);
  return hexsweep::filledDiskMap(laplacian, mesh.points, loops,
    hexsweep::circlePoints({ { 0.0, 0.0 }, 1.0 },
      hexsweep::arcLengthAngles(hexsweep::loopPoints(mesh.points, loops[0]))));
}

Index flips(const PlanePoints& disk, const hexsweep::Triangles& triangles)
{
  Index count = 0;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    count += hexsweep::orientation(disk.row(triangles(t, 0)), disk.row(triangles(t, 1)),
               disk.row(triangles(t, 2))) <= 0;
  }
  return count;
}

TEST(FilledDiskMap, IsTheIdentityOnAPlaneAnnulus)
{
  // Node 0 of the outer ring lies at angle 0, where arc length begins.
  const Index around = 30;
  const TriangleMesh mesh = test::annulus(0.4, 1.0, 6, around);
  const FilledDiskMap map = mapOf(mesh, hexsweep::cotangentLaplacian(mesh.points, mesh.triangles));
  EXPECT_LT((map.disk - mesh.points.leftCols<2>()).cwiseAbs().maxCoeff(), 1e-13);
  ASSERT_EQ(map.holes.size(), 1u);
  EXPECT_LT(map.holes[0].center.norm(), 1e-13);
  const double step = 2.0 * test::Pi / around;
  EXPECT_NEAR(map.holes[0].radius, 0.4 * std::sqrt(std::sin(step) / step), 1e-13);
}

TEST(FilledDiskMap, CrookedHolesGiveAnEmbedding)
{
  // Holes that are bent out of the plane: positive weights all the same (Tutte's theorem).
  TriangleMesh mesh = test::plate(12, test::threeHoles(), 0.2);
  mesh.points = test::lifted(
    mesh.points, [](double x, double y) { return 0.6 * std::sin(9.0 * x) * std::cos(11.0 * y); });
  const auto loops = test::loopsOf(mesh);
  const FilledDiskMap map = mapOf(mesh, hexsweep::meanValueLaplacian(mesh.points, mesh.triangles));
  EXPECT_EQ(flips(map.disk, mesh.triangles), 0);
  ASSERT_EQ(map.holes.size(), 3u);
  for (std::size_t h = 0; h < 3; ++h)
  {
    // The centre lies in its hole: the loop winds once about it.
    double turns = 0.0;
    const auto& loop = loops[h + 1];
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Eigen::RowVector2d p = map.disk.row(loop[i]) - map.holes[h].center;
      const Eigen::RowVector2d q = map.disk.row(loop[(i + 1) % loop.size()]) - map.holes[h].center;
      turns += std::atan2(p.x() * q.y() - p.y() * q.x(), p.dot(q));
    }
    EXPECT_NEAR(turns, -2.0 * test::Pi, 1e-9);
    EXPECT_GT(map.holes[h].radius, 0.0);
  }
  EXPECT_LE(map.disk.rowwise().norm().maxCoeff(), 1.0 + 1e-15);
}

TEST(FilledDiskMap, OuterNodesAreWhereTheyWereGiven)
{
  const TriangleMesh mesh = test::plate(6, { { 2, 2, 2, 1 } });
  const auto loops = test::loopsOf(mesh);
  const PlanePoints outer = hexsweep::circlePoints(
    { { 0.0, 0.0 }, 1.0 }, hexsweep::arcLengthAngles(hexsweep::loopPoints(mesh.points, loops[0])));
  const FilledDiskMap map = mapOf(mesh, hexsweep::cotangentLaplacian(mesh.points, mesh.triangles));
  for (std::size_t i = 0; i < loops[0].size(); ++i)
  {
    EXPECT_EQ(map.disk.row(loops[0][i]), outer.row(static_cast<Index>(i)));
  }
}

TEST(FilledDiskMap, SizePlaceAndTurnDoNotMatter)
{
  TriangleMesh mesh = test::plate(12, test::threeHoles(), 0.2);
  mesh.points = test::lifted(mesh.points, test::bump);
  const FilledDiskMap plain =
    mapOf(mesh, hexsweep::cotangentLaplacian(mesh.points, mesh.triangles));
  for (const test::Placement& placement : test::placements())
  {
    const TriangleMesh moved{ placement.motion(mesh.points), mesh.triangles };
    const FilledDiskMap map =
      mapOf(moved, hexsweep::cotangentLaplacian(moved.points, moved.triangles));
    EXPECT_LT((map.disk - plain.disk).cwiseAbs().maxCoeff(), 1e4 * placement.relativeRounding)
      << placement.name;
  }
}
}
