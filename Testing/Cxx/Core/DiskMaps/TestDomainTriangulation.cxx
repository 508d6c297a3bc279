// SPDX-License-Identifier: BSD-3-Clause
// The strip of an annulus as one mesh: it is tiled exactly, and triangles share their edges.
#include "Core/DiskMaps/DomainTriangulation.h"

#include "Support/CapMeshes.h"

#include <set>

namespace TestDomainTriangulation
{
using hexsweep::DiskDomain;
using hexsweep::DomainTriangulation;
using hexsweep::Index;
using hexsweep::PlanePoints;
using hexsweep::TriangleMesh;

double areaOf(const DomainTriangulation& mesh, Index t)
{
  const Eigen::RowVector2d a = mesh.points.row(mesh.triangles(t, 0));
  const Eigen::RowVector2d u = mesh.points.row(mesh.triangles(t, 1)) - a;
  const Eigen::RowVector2d v = mesh.points.row(mesh.triangles(t, 2)) - a;
  return 0.5 * (u.x() * v.y() - u.y() * v.x());
}

TEST(DomainTriangulation, DisksAreTakenAsTheyAre)
{
  const TriangleMesh mesh = test::disk(4, 12);
  const PlanePoints disk = mesh.points.leftCols<2>();
  for (const DiskDomain domain : { DiskDomain::Disk, DiskDomain::Circles })
  {
    const DomainTriangulation plane = hexsweep::domainTriangulation(domain, disk, mesh.triangles);
    EXPECT_EQ(plane.points, disk);
    EXPECT_EQ(plane.triangles, mesh.triangles);
    EXPECT_EQ(plane.origin.size(), static_cast<std::size_t>(mesh.triangles.rows()));
    EXPECT_EQ(plane.origin.back(), mesh.triangles.rows() - 1);
  }
}

TEST(DomainTriangulation, StripOfAnAnnulus)
{
  const double inner = 0.2;
  const Index rings = 7;
  std::mt19937 generator(1);
  for (const Index around : { 3, 4, 11 })
  {
    for (const double turn : { 0.0, 0.01, 1.0, test::Pi, 4.0 })
    {
      const TriangleMesh mesh = test::annulus(inner, 1.0, rings, around, &generator);
      const PlanePoints disk =
        mesh.points.leftCols<2>() * Eigen::Rotation2Dd(turn).toRotationMatrix().transpose();
      const DomainTriangulation strip =
        hexsweep::domainTriangulation(DiskDomain::Annulus, disk, mesh.triangles);
      ASSERT_EQ(strip.triangles.rows(), static_cast<Index>(strip.origin.size()));
      EXPECT_TRUE(std::is_sorted(strip.origin.begin(), strip.origin.end()));

      // Every corner is one of its own triangle, and the logarithm is its place.
      for (Index t = 0; t < strip.triangles.rows(); ++t)
      {
        for (Index c = 0; c < 3; ++c)
        {
          const Eigen::RowVector2d place = strip.points.row(strip.triangles(t, c));
          const Eigen::RowVector2d back =
            std::exp(place.x()) * Eigen::RowVector2d(std::cos(place.y()), std::sin(place.y()));
          const Index v = mesh.triangles(strip.origin[static_cast<std::size_t>(t)], c);
          EXPECT_LT((back - disk.row(v)).norm(), 1e-14);
        }
        EXPECT_GT(areaOf(strip, t), 0.0);
      }

      // Copies of a triangle are one turn apart; together they cover the strip once: what lies
      // above 2 pi in one copy is what lies above 0 in the other.
      std::vector<double> area(static_cast<std::size_t>(mesh.triangles.rows()), 0.0);
      for (std::size_t t = 0; t < strip.origin.size(); ++t)
      {
        area[static_cast<std::size_t>(strip.origin[t])] = areaOf(strip, static_cast<Index>(t));
      }
      double sum = 0.0;
      for (const double a : area)
      {
        EXPECT_GT(a, 0.0);
        sum += a;
      }
      EXPECT_NEAR(sum, 2.0 * test::Pi * std::log(1.0 / inner), 1e-12);
      EXPECT_GE(strip.points.col(1).maxCoeff(), 2.0 * test::Pi - 1e-15);
      EXPECT_LE(strip.points.col(1).minCoeff(), 0.0);

      // One piece with one loop, whose nodes on both sides of the strip are those of the annulus.
      const hexsweep::SurfaceTopology topology =
        hexsweep::checkSurface(strip.triangles, strip.points.rows(), "strip");
      EXPECT_EQ(topology.numberOfComponents, 1);
      EXPECT_EQ(topology.loops.size(), 1u);
      EXPECT_EQ(topology.eulerCharacteristic, 1);
    }
  }
}

TEST(DomainTriangulation, FlippedTrianglesStayFlipped)
{
  const TriangleMesh ring = test::annulus(0.3, 1.0, 4, 9);
  PlanePoints mirrored = ring.points.leftCols<2>();
  mirrored.col(1) *= -1.0;
  for (const DiskDomain domain : { DiskDomain::Disk, DiskDomain::Annulus })
  {
    const DomainTriangulation mesh =
      hexsweep::domainTriangulation(domain, mirrored, ring.triangles);
    ASSERT_GE(mesh.triangles.rows(), ring.triangles.rows()); // an annulus is cut open
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
    {
      EXPECT_LT(areaOf(mesh, t), 0.0);
    }
  }
}
}
