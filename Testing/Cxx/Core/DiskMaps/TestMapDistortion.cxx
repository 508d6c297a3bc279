// SPDX-License-Identifier: BSD-3-Clause
// Distortion and energy of maps that can be worked out by hand.
#include "Core/DiskMaps/MapDistortion.h"

#include "Support/CapMeshes.h"

namespace TestMapDistortion
{
using hexsweep::CapDisk;
using hexsweep::DiskDomain;
using hexsweep::Index;
using hexsweep::MapDistortion;
using hexsweep::TriangleMesh;
using test::Pi;

constexpr double Degrees = 180.0 / Pi;

CapDisk capDisk(const TriangleMesh& mesh, const hexsweep::PlanePoints& disk,
  DiskDomain domain = DiskDomain::Circles)
{
  CapDisk cap;
  cap.mesh = mesh;
  cap.disk = disk;
  cap.domain = domain;
  return cap;
}

TEST(MapDistortion, SimilaritiesHaveNoneAndTheAreaAsEnergy)
{
  const TriangleMesh mesh = test::plate(12, test::threeHoles(), 0.3);
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    const TriangleMesh moved{ test::Similarity{ scale, test::someTurn(), { 0, 0, 0 } }(mesh.points),
      mesh.triangles };
    const MapDistortion distortion =
      hexsweep::mapDistortion(capDisk(moved, 0.5 * mesh.points.leftCols<2>()));
    EXPECT_LT(distortion.worstAngle, 1e-8);
    EXPECT_LT(distortion.meanAngle, distortion.worstAngle);
    EXPECT_NEAR(distortion.dirichletEnergy, 0.25 * test::surfaceArea(mesh), 1e-10);
  }
}

TEST(MapDistortion, OneStretchedTriangle)
{
  // Corners 90, 45, 45 degrees become 90, atan 2, 90 - atan 2; half the integral of 1 + 4.
  TriangleMesh mesh{ hexsweep::Points(3, 3), test::facesOf<hexsweep::Triangles>({ 0, 1, 2 }) };
  mesh.points << 0, 0, 0, 1, 0, 0, 0, 1, 0;
  hexsweep::PlanePoints disk(3, 2);
  disk << 0, 0, 1, 0, 0, 2;
  const double change = std::atan(2.0) * Degrees - 45.0;
  MapDistortion distortion = hexsweep::mapDistortion(capDisk(mesh, disk));
  EXPECT_NEAR(distortion.worstAngle, change, 1e-10);
  EXPECT_NEAR(distortion.meanAngle, 2.0 / 3.0 * change, 1e-10);
  EXPECT_NEAR(distortion.dirichletEnergy, 0.25 * (1.0 + 4.0), 1e-12);
  // Flipped, each angle is off by twice itself.
  disk << 0, 0, 0, 1, 1, 0;
  distortion = hexsweep::mapDistortion(capDisk(mesh, disk));
  EXPECT_NEAR(distortion.worstAngle, 180.0, 1e-10);
  EXPECT_NEAR(distortion.meanAngle, 120.0, 1e-10);
  EXPECT_NEAR(distortion.dirichletEnergy, 0.5, 1e-12);
}

TEST(MapDistortion, MapsThatAreNotConformalHaveMoreEnergyThanArea)
{
  const TriangleMesh mesh = test::plate(12, test::threeHoles(), 0.3);
  for (const double stretch : { 1.01, 1.5, 4.0 })
  {
    hexsweep::PlanePoints disk = mesh.points.leftCols<2>();
    disk.col(1) *= stretch;
    const MapDistortion distortion = hexsweep::mapDistortion(capDisk(mesh, disk));
    EXPECT_NEAR(
      distortion.dirichletEnergy, 0.5 * (1.0 + stretch * stretch) * test::surfaceArea(mesh), 1e-10);
    EXPECT_GT(distortion.dirichletEnergy, stretch * test::surfaceArea(mesh));
    // A linear map turns two directions against each other by at most this.
    const double bound = 2.0 * std::asin((stretch - 1.0) / (stretch + 1.0)) * Degrees;
    EXPECT_LT(distortion.worstAngle, bound + 1e-9);
    EXPECT_GT(distortion.worstAngle, 0.8 * bound);
    EXPECT_LT(distortion.meanAngle, distortion.worstAngle);
  }
}

TEST(MapDistortion, ACylinderIsItsAnnulus)
{
  // In (log r, angle) the map of a prism is a similarity of each triangle.
  const Index rings = 9;
  const Index around = 24;
  const double side = 2.0 * std::sin(Pi / static_cast<double>(around));
  const double step = 2.0 * Pi / static_cast<double>(around);
  const double high = 0.07;
  TriangleMesh mesh = test::annulus(1.0, 2.0, rings, around);
  hexsweep::PlanePoints disk(mesh.points.rows(), 2);
  for (Index i = 0; i < mesh.points.rows(); ++i)
  {
    const double angle = step * static_cast<double>(i % around);
    const auto k = static_cast<double>(i / around);
    mesh.points.row(i) << std::cos(angle), std::sin(angle), -high * side * k;
    const double r = std::exp(step * high * (k - static_cast<double>(rings - 1)));
    disk.row(i) << r * std::cos(angle), r * std::sin(angle);
  }
  const MapDistortion distortion =
    hexsweep::mapDistortion(capDisk(mesh, disk, DiskDomain::Annulus));
  EXPECT_LT(distortion.worstAngle, 1e-9);
  EXPECT_NEAR(distortion.dirichletEnergy, 2.0 * Pi * step * high * 8.0, 1e-10);
}
}
