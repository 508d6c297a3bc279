// SPDX-License-Identifier: BSD-3-Clause
// The strip of an annulus is tiled exactly, wherever the cut falls.
#include "Core/DiskMaps/DiskDomain.h"

#include "Core/Geometry/TriangleSearch.h"
#include "Support/CapMeshes.h"

namespace TestDiskDomain
{
using hexsweep::DiskDomain;
using hexsweep::DomainTriangles;
using hexsweep::Index;
using hexsweep::PlanePoints;
using hexsweep::Points;
using hexsweep::TriangleMesh;

double areaOf(const Points& corners, Index t)
{
  const Eigen::RowVector3d u = corners.row(3 * t + 1) - corners.row(3 * t);
  const Eigen::RowVector3d v = corners.row(3 * t + 2) - corners.row(3 * t);
  return 0.5 * (u.x() * v.y() - u.y() * v.x());
}

TEST(DiskDomain, WrapAngle)
{
  for (double angle = -20.0; angle < 20.0; angle += 0.37)
  {
    const double wrapped = hexsweep::wrapAngle(angle);
    EXPECT_GT(wrapped, -test::Pi);
    EXPECT_LE(wrapped, test::Pi);
    EXPECT_NEAR(std::cos(wrapped), std::cos(angle), 1e-14);
    EXPECT_NEAR(std::sin(wrapped), std::sin(angle), 1e-14);
  }
  EXPECT_EQ(hexsweep::wrapAngle(test::Pi), test::Pi);
  EXPECT_EQ(hexsweep::wrapAngle(-test::Pi), test::Pi);
  EXPECT_EQ(hexsweep::wrapAngle(0.0), 0.0);
}

TEST(DiskDomain, WrapPoint)
{
  for (double angle = -20.0; angle < 20.0; angle += 0.37)
  {
    const Eigen::RowVector2d p = hexsweep::wrapDomainPoint(DiskDomain::Annulus, { -0.5, angle });
    EXPECT_EQ(p.x(), -0.5);
    EXPECT_GE(p.y(), 0.0);
    EXPECT_LE(p.y(), 2.0 * test::Pi);
    EXPECT_NEAR(std::remainder(p.y() - angle, 2.0 * test::Pi), 0.0, 1e-14);
    EXPECT_EQ(hexsweep::wrapDomainPoint(DiskDomain::Disk, { -0.5, angle }).y(), angle);
    EXPECT_EQ(hexsweep::wrapDomainPoint(DiskDomain::Circles, { -0.5, angle }).y(), angle);
  }
}

TEST(DiskDomain, AnnulusTrianglesTileTheStrip)
{
  const double inner = 0.2;
  std::mt19937 generator(1);
  for (const double turn : { 0.0, 0.01, 1.0, test::Pi, 4.0 })
  {
    TriangleMesh mesh = test::annulus(inner, 1.0, 7, 11, &generator);
    const Eigen::Rotation2Dd rotation(turn);
    const PlanePoints disk = mesh.points.leftCols<2>() * rotation.toRotationMatrix().transpose();
    const DomainTriangles tiles =
      hexsweep::domainTriangles(DiskDomain::Annulus, disk, mesh.triangles);
    EXPECT_TRUE(tiles.flipped.empty());
    ASSERT_EQ(tiles.corners.rows(), 3 * static_cast<Index>(tiles.triangle.size()));
    std::vector<double> area(static_cast<std::size_t>(mesh.triangles.rows()), 0.0);
    for (std::size_t t = 0; t < tiles.triangle.size(); ++t)
    {
      double& own = area[static_cast<std::size_t>(tiles.triangle[t])];
      const double found = areaOf(tiles.corners, static_cast<Index>(t));
      EXPECT_GT(found, 0.0);
      EXPECT_TRUE(own == 0.0 || std::abs(own - found) < 1e-14); // a second copy
      own = found;
    }
    double sum = 0.0;
    for (const double a : area)
    {
      sum += a;
    }
    EXPECT_NEAR(sum, 2.0 * test::Pi * std::log(1.0 / inner), 1e-12);

    // Every place of the strip, its edges included, lies in a tile.
    const hexsweep::TriangleSearch search(tiles.corners);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int i = 0; i < 2000; ++i)
    {
      const double angle = i % 50 == 0 ? 0.0 : 2.0 * test::Pi * uniform(generator);
      const double radius = i % 40 == 0 ? 0.0 : std::log(inner) * uniform(generator);
      EXPECT_LT(search.closest({ radius, angle, 0.0 }).distance, 1e-14);
    }
  }
}

TEST(DiskDomain, CornersAreTheLogarithm)
{
  PlanePoints disk(3, 2);
  disk << std::cos(-0.1), std::sin(-0.1), 0.5 * std::cos(0.1), 0.5 * std::sin(0.1), 0.5, 0.0;
  const Eigen::Matrix<Index, 1, 3> triangle(0, 1, 2);
  const auto corners = hexsweep::domainCorners(DiskDomain::Annulus, disk, triangle);
  EXPECT_NEAR(corners(0, 0), 0.0, 1e-15);
  EXPECT_NEAR(corners(0, 1), 2.0 * test::Pi - 0.1, 1e-15);
  EXPECT_NEAR(corners(1, 0), std::log(0.5), 1e-15);
  // Unwrapped from the first corner, across the cut.
  EXPECT_NEAR(corners(1, 1), 2.0 * test::Pi + 0.1, 1e-14);
  EXPECT_NEAR(corners(2, 1), 2.0 * test::Pi, 1e-14);
  const auto plain = hexsweep::domainCorners(DiskDomain::Circles, disk, triangle);
  EXPECT_EQ(PlanePoints(plain), disk);
}

TEST(DiskDomain, FlipsAreFoundAndLeftOut)
{
  const TriangleMesh mesh = test::disk(4, 12);
  PlanePoints disk = mesh.points.leftCols<2>();
  EXPECT_TRUE(hexsweep::domainTriangles(DiskDomain::Disk, disk, mesh.triangles).flipped.empty());

  // One inner node moved beyond its neighbours.
  const Index moved = 2 * 12;
  disk.row(moved) << 0.1, 0.9;
  std::vector<Index> expected;
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    const Eigen::RowVector2d u = disk.row(mesh.triangles(t, 1)) - disk.row(mesh.triangles(t, 0));
    const Eigen::RowVector2d v = disk.row(mesh.triangles(t, 2)) - disk.row(mesh.triangles(t, 0));
    if (u.x() * v.y() - u.y() * v.x() <= 0.0)
    {
      expected.push_back(t);
    }
  }
  ASSERT_FALSE(expected.empty());
  const auto found = hexsweep::domainTriangles(DiskDomain::Disk, disk, mesh.triangles);
  EXPECT_EQ(found.flipped, expected);
  EXPECT_EQ(static_cast<Index>(found.triangle.size() + expected.size()), mesh.triangles.rows());
  for (const Index t : expected)
  {
    EXPECT_EQ(std::count(found.triangle.begin(), found.triangle.end(), t), 0);
  }

  // A mirrored map flips everything, in every kind of domain.
  const TriangleMesh ring = test::annulus(0.3, 1.0, 4, 9);
  PlanePoints mirrored = ring.points.leftCols<2>();
  mirrored.col(1) *= -1.0;
  for (const DiskDomain domain : { DiskDomain::Disk, DiskDomain::Annulus, DiskDomain::Circles })
  {
    const auto all = hexsweep::domainTriangles(domain, mirrored, ring.triangles);
    EXPECT_EQ(static_cast<Index>(all.flipped.size()), ring.triangles.rows());
    EXPECT_EQ(all.corners.rows(), 0);
  }
}

TEST(DiskDomain, ATriangleWithoutAreaIsFlipped)
{
  PlanePoints disk(3, 2);
  disk << 0.1, 0.1, 0.2, 0.2, 0.3, 0.3;
  disk.row(2) = 2.0 * disk.row(1);
  disk.row(0) = 0.5 * disk.row(1);
  const auto one = test::facesOf<hexsweep::Triangles>({ 0, 1, 2 });
  EXPECT_EQ(hexsweep::domainTriangles(DiskDomain::Disk, disk, one).flipped.size(), 1u);
}
}
