// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/CommonSubdivision.h"

#include "Support/StretchedCaps.h"

#include <numeric>

namespace TestCommonSubdivision
{
using hexsweep::CutSurface;
using hexsweep::DiskDomain;
using hexsweep::Index;
using hexsweep::IntrinsicTriangulation;
using hexsweep::PlanePoints;
using hexsweep::TriangleMesh;

CutSurface cutAll(const TriangleMesh& mesh, const PlanePoints& disk)
{
  std::vector<Index> all(static_cast<std::size_t>(mesh.triangles.rows()));
  std::iota(all.begin(), all.end(), 0);
  return hexsweep::cutAlongIntrinsicEdges(
    mesh, hexsweep::intrinsicDelaunay(mesh.points, mesh.triangles), DiskDomain::Disk, disk, all);
}

/// Crossings over all edges, each edge once (none are on the boundary).
Index numberOfCrossings(const IntrinsicTriangulation& intrinsic)
{
  return intrinsic.crossings.sum() / 2;
}

TEST(CommonSubdivision, APlaneCapComesBack)
{
  // Linear over intrinsic triangles, so that the crossings must carry their own coordinates.
  for (const TriangleMesh& mesh :
    { test::needleStrips(1e-4, false), test::stretchedPlate(3, false) })
  {
    const PlanePoints disk = mesh.points.leftCols<2>();
    const CutSurface cut = cutAll(mesh, disk);
    const IntrinsicTriangulation intrinsic =
      hexsweep::intrinsicDelaunay(mesh.points, mesh.triangles);
    EXPECT_EQ(cut.mesh.points.rows() - mesh.points.rows(), numberOfCrossings(intrinsic));
    EXPECT_LT((cut.disk - cut.mesh.points.leftCols<2>()).cwiseAbs().maxCoeff(),
      1e-11 * mesh.points.maxCoeff());
    EXPECT_TRUE(
      hexsweep::domainTriangles(DiskDomain::Disk, cut.disk, cut.mesh.triangles).flipped.empty());
  }
}

TEST(CommonSubdivision, TheSurfaceStaysAsItIs)
{
  for (const TriangleMesh& mesh : { test::needleStrips(1e-4, true), test::stretchedPlate(3, true) })
  {
    const CutSurface cut = cutAll(mesh, mesh.points.leftCols<2>());
    EXPECT_EQ(cut.mesh.points.topRows(mesh.points.rows()), mesh.points);
    const double area = test::surfaceArea(mesh);
    EXPECT_NEAR(test::surfaceArea(cut.mesh), area, 1e-12 * area);
    const auto before = hexsweep::checkSurface(mesh.triangles, mesh.points.rows(), "mesh");
    const auto after = hexsweep::checkSurface(cut.mesh.triangles, cut.mesh.points.rows(), "cut");
    EXPECT_EQ(after.loops, before.loops);
    EXPECT_EQ(after.eulerCharacteristic, before.eulerCharacteristic);
    // Pieces lie in the triangles that they name.
    std::vector<double> areas(static_cast<std::size_t>(mesh.triangles.rows()), 0.0);
    for (Index t = 0; t < cut.mesh.triangles.rows(); ++t)
    {
      const TriangleMesh piece{ cut.mesh.points, cut.mesh.triangles.row(t) };
      areas[static_cast<std::size_t>(cut.triangleOrigin[static_cast<std::size_t>(t)])] +=
        test::surfaceArea(piece);
    }
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
    {
      const double own = test::surfaceArea({ mesh.points, mesh.triangles.row(t) });
      EXPECT_NEAR(areas[static_cast<std::size_t>(t)], own, 1e-9 * own);
    }
  }
}

TEST(CommonSubdivision, NothingWantedNothingCut)
{
  const TriangleMesh mesh = test::needleStrips(1e-3, true);
  const PlanePoints disk = mesh.points.leftCols<2>();
  const CutSurface cut = hexsweep::cutAlongIntrinsicEdges(
    mesh, hexsweep::intrinsicDelaunay(mesh.points, mesh.triangles), DiskDomain::Disk, disk, {});
  EXPECT_EQ(cut.mesh.points, mesh.points);
  EXPECT_EQ(cut.mesh.triangles, mesh.triangles);
  EXPECT_EQ(cut.disk, disk);
}
}
