// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/TriangulationImprovement.h"

#include "Core/DiskMaps/CanonicalDiskMap.h"
#include "Core/DiskMaps/CommonDiskMap.h"
#include "Core/Geometry/TriangleSearch.h"
#include "Core/Solvers/SurfaceLaplacian.h"

#include "Support/CoarsePlates.h"
#include "Support/StretchedCaps.h"

namespace TestTriangulationImprovement
{
using hexsweep::CapDisk;
using hexsweep::HoleTreatment;
using hexsweep::ImprovedTriangulation;
using hexsweep::Index;
using hexsweep::Points;
using hexsweep::TriangleMesh;
using hexsweep::TriangulationImprovement;
using hexsweep::Weights;

CapDisk mapAlone(const TriangleMesh& mesh, TriangulationImprovement improvement)
{
  return hexsweep::canonicalDiskMap(
    mesh, HoleTreatment::ArcLength, Weights::Cotangent, improvement);
}

/// The given points come first, on the same loops, and nothing is flipped.
void expectGood(const CapDisk& cap, const TriangleMesh& mesh, const std::string& what)
{
  EXPECT_TRUE(cap.flipped.empty()) << what;
  EXPECT_EQ(cap.mesh.points.topRows(mesh.points.rows()), mesh.points) << what;
  EXPECT_EQ(test::loopsOf(cap.mesh), test::loopsOf(mesh)) << what;
  const double area = test::surfaceArea(mesh);
  EXPECT_NEAR(test::surfaceArea(cap.mesh), area, 1e-10 * area) << what;
}

/// An ellipse with a regular mesh.
TriangleMesh fineDisk(Index rings, Index around)
{
  TriangleMesh mesh = test::disk(rings, around);
  mesh.points.col(0) *= 2.0;
  return mesh;
}

/// A fan of the outer loop about its first node: no inner node, chords only.
TriangleMesh fanOf(const Points& polygon)
{
  TriangleMesh mesh;
  mesh.points = polygon;
  std::vector<Index> ids;
  for (Index i = 1; i + 1 < polygon.rows(); ++i)
  {
    ids.insert(ids.end(), { 0, i, i + 1 });
  }
  mesh.triangles = test::facesOf<hexsweep::Triangles>(ids);
  return mesh;
}

/// Least height over longest edge of the thinnest triangle.
double leastShape(const TriangleMesh& mesh)
{
  double least = 1.0;
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = mesh.points.row(mesh.triangles(t, 0));
    const Eigen::RowVector3d u = mesh.points.row(mesh.triangles(t, 1)) - a;
    const Eigen::RowVector3d v = mesh.points.row(mesh.triangles(t, 2)) - a;
    const double longest = std::max({ u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm() });
    least = std::min(least, u.cross(v).norm() / longest);
  }
  return least;
}

/// Random plates of few nodes, every other one lifted.
std::vector<TriangleMesh> coarsePlates(int number)
{
  std::mt19937 generator(7);
  std::vector<TriangleMesh> plates;
  for (int k = 0; k < number; ++k)
  {
    plates.push_back(test::randomCoarsePlate(generator));
    if (k % 2 == 1)
    {
      plates.back().points = test::lifted(plates.back().points,
        [](double x, double y) { return 0.3 * std::sin(1.3 * x) + 0.5 * y * (1.0 - y); });
    }
  }
  return plates;
}

TEST(TriangulationImprovement, GoodCapsAreNotTouched)
{
  for (const std::size_t holes : { 0u, 1u, 3u })
  {
    std::vector<test::Block> blocks = test::threeHoles();
    blocks.resize(holes);
    TriangleMesh mesh = test::plate(12, blocks, 0.2);
    mesh.points = test::lifted(mesh.points, test::bump);
    const CapDisk off = mapAlone(mesh, TriangulationImprovement::Off);
    const CapDisk automatic = mapAlone(mesh, TriangulationImprovement::Automatic);
    EXPECT_EQ(off.disk, automatic.disk);
    EXPECT_EQ(off.mesh.triangles, automatic.mesh.triangles);
    EXPECT_EQ(automatic.weights, Weights::Cotangent);
    EXPECT_EQ(automatic.edgeFlips, 0);
    EXPECT_EQ(automatic.addedPoints, 0);
  }
}

TEST(TriangulationImprovement, FlatFlipsGiveTheDelaunayTriangulation)
{
  for (const test::Placement& placement : test::placements())
  {
    if (placement.relativeRounding > 1e-12)
    {
      continue;
    }
    const TriangleMesh plane = test::stretchedPlate(3, false);
    const TriangleMesh mesh{ placement.motion(plane.points), plane.triangles };
    const ImprovedTriangulation improved = hexsweep::improveTriangulation(mesh, { true, false });
    EXPECT_EQ(improved.mesh.points, mesh.points);
    EXPECT_EQ(improved.addedPoints, 0);
    EXPECT_GT(improved.flips, 1000);
    const auto& triangles = improved.mesh.triangles;
    const hexsweep::Triangles neighbors = hexsweep::triangleNeighbors(triangles);
    for (Index t = 0; t < triangles.rows(); ++t)
    {
      const auto corner = [&](Index row, Index c) { return plane.points.row(triangles(row, c)); };
      for (Index c = 0; c < 3 && neighbors(t, c) >= 0; ++c)
      {
        for (Index k = 0; k < 3; ++k)
        {
          EXPECT_FALSE(test::isInCircle(
            corner(t, 0), corner(t, 1), corner(t, 2), corner(neighbors(t, c), k), 1e-8))
            << placement.name;
        }
      }
      // The middle of each lies in the triangle that it names.
      const Eigen::RowVector3d middle = (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3.0;
      const auto origin = plane.triangles.row(improved.triangleOrigin[static_cast<std::size_t>(t)]);
      for (Index c = 0; c < 3; ++c)
      {
        const Eigen::RowVector3d a = plane.points.row(origin[c]);
        const Eigen::RowVector3d side = plane.points.row(origin[(c + 1) % 3]) - a;
        const Eigen::RowVector3d arm = middle - a;
        EXPECT_GT(side.x() * arm.y() - side.y() * arm.x(), -1e-9 * side.norm());
      }
    }
  }
}

TEST(TriangulationImprovement, NoFlipsAreLeftInStretchedCaps)
{
  Index before = 0;
  for (const bool curved : { false, true })
  {
    for (const std::size_t holes : { 0u, 1u, 3u })
    {
      const TriangleMesh mesh = test::stretchedPlate(holes, curved);
      before += mapAlone(mesh, TriangulationImprovement::Off).flipsBefore;
      for (const auto improvement :
        { TriangulationImprovement::Automatic, TriangulationImprovement::On })
      {
        const CapDisk cap = mapAlone(mesh, improvement);
        expectGood(cap, mesh, std::to_string(holes) + " holes, curved " + std::to_string(curved));
      }
    }
  }
  EXPECT_GT(before, 30);
}

TEST(TriangulationImprovement, NoFlipsAreLeftInStripsOfNeedles)
{
  for (const bool curved : { false, true })
  {
    for (const double height : { 1e-3, 1e-4, 1e-5 })
    {
      const TriangleMesh mesh = test::needleStrips(height, curved);
      EXPECT_GT(mapAlone(mesh, TriangulationImprovement::Off).flipsBefore, 10);
      for (const auto improvement :
        { TriangulationImprovement::Automatic, TriangulationImprovement::On })
      {
        const CapDisk cap = mapAlone(mesh, improvement);
        expectGood(cap, mesh, "height " + std::to_string(height));
        // Where all is flat, no point is needed.
        EXPECT_TRUE(curved || cap.addedPoints == 0);
      }
    }
  }
}

TEST(TriangulationImprovement, NoFlipsAreLeftInCommonMaps)
{
  for (const std::size_t holes : { 0u, 1u, 3u })
  {
    const TriangleMesh first = test::stretchedPlate(holes, true);
    const TriangleMesh second = test::stretchedPlate(holes, false);
    const hexsweep::CommonDisks disks = hexsweep::commonDiskMap(hexsweep::makeCap(first, "first"),
      hexsweep::makeCap(second, "second"),
      test::pairsOf(first.points, second.points, test::loopsOf(first)), Weights::Cotangent, 1e-6,
      {}, {}, TriangulationImprovement::Automatic);
    expectGood(disks.first, first, std::to_string(holes) + " holes, first");
    expectGood(disks.second, second, std::to_string(holes) + " holes, second");
  }
}

TEST(TriangulationImprovement, CapsWithoutInnerNodesAreRefined)
{
  // An ellipse as a fan, against the same ellipse with a fine mesh.
  const TriangleMesh fine = fineDisk(60, 200);
  const TriangleMesh fan = fanOf(fine.points.middleRows(59 * 200, 200));
  EXPECT_TRUE(hexsweep::planImprovement(fan, TriangulationImprovement::Automatic).refine);
  EXPECT_FALSE(hexsweep::planImprovement(fine, TriangulationImprovement::Automatic).refine);
  const CapDisk truth = mapAlone(fine, TriangulationImprovement::Off);
  const CapDisk cap = mapAlone(fan, TriangulationImprovement::Automatic);
  EXPECT_TRUE(cap.flipped.empty());
  EXPECT_GT(cap.addedPoints, 200);
  EXPECT_LT(cap.addedPoints, 2000);
  EXPECT_EQ(cap.mesh.points.topRows(200), fan.points);

  const hexsweep::TriangleSearch search(fine.points, fine.triangles);
  const auto error = [&](const CapDisk& map) {
    double greatest = 0.0;
    for (Index i = 0; i < map.mesh.points.rows(); ++i)
    {
      const hexsweep::TrianglePoint place = search.closest(map.mesh.points.row(i));
      Eigen::RowVector2d expected = Eigen::RowVector2d::Zero();
      for (Index c = 0; c < 3; ++c)
      {
        expected += place.coordinates[c] * truth.disk.row(fine.triangles(place.triangle, c));
      }
      greatest = std::max(greatest, (expected - map.disk.row(i)).norm());
    }
    return greatest;
  };
  EXPECT_LT(error(cap), 0.01);
  EXPECT_GT(error(mapAlone(fan, TriangulationImprovement::Off)), 0.025);
}

TEST(TriangulationImprovement, SizesDoNotMatter)
{
  const TriangleMesh mesh = test::stretchedPlate(3, true);
  const CapDisk plain = mapAlone(mesh, TriangulationImprovement::Automatic);
  for (const double scale : { 0x1p-20, 0x1p20 })
  {
    const CapDisk scaled =
      mapAlone({ scale * mesh.points, mesh.triangles }, TriangulationImprovement::Automatic);
    EXPECT_EQ(scaled.mesh.triangles, plain.mesh.triangles);
    EXPECT_EQ(scaled.disk, plain.disk);
  }
}

TEST(TriangulationImprovement, LongBoundaryEdgesBesideAHole)
{
  // Sides of one edge each, a tenth of the height away from a hole of short ones.
  const TriangleMesh mesh = test::coarsePlate(2.0, { { 1.0, 0.5, 0.4, 12 } });
  const TriangleMesh refined = hexsweep::improveTriangulation(mesh, { true, true }).mesh;
  EXPECT_GE(leastShape(refined), 0.5 * leastShape(mesh));
  EXPECT_LT(refined.points.rows(), 5 * mesh.points.rows());
  for (const HoleTreatment treatment : { HoleTreatment::Filled, HoleTreatment::ArcLength })
  {
    const CapDisk cap = hexsweep::canonicalDiskMap(
      mesh, treatment, Weights::Cotangent, TriangulationImprovement::Automatic);
    expectGood(cap, mesh, "treatment " + std::to_string(static_cast<int>(treatment)));
  }
}

TEST(TriangulationImprovement, CoarsePlatesWithRoundHoles)
{
  Index refined = 0;
  int number = 0;
  for (const TriangleMesh& mesh : coarsePlates(150))
  {
    const std::string what = "plate " + std::to_string(number++);
    CapDisk cap;
    ASSERT_NO_THROW(cap = mapAlone(mesh, TriangulationImprovement::Automatic)) << what;
    const CapDisk off = mapAlone(mesh, TriangulationImprovement::Off);
    EXPECT_LE(cap.flipped.size(), off.flipped.size()) << what;
    // Halving the chords, which comes first, costs less than the rest of the 1e-3.
    EXPECT_GT(leastShape(cap.mesh), 1e-3 * leastShape(mesh)) << what;
    EXPECT_LE(cap.addedPoints, 11 * off.mesh.points.rows()) << what;
    refined += cap.addedPoints > 0;
    const ImprovedTriangulation improved = hexsweep::improveTriangulation(mesh, { true, true });
    EXPECT_GE(leastShape(improved.mesh), 0.5 * std::min(0.1, leastShape(mesh))) << what;
  }
  EXPECT_GT(refined, 100);
}

TEST(TriangulationImprovement, CoarsePlatesOfAllSizesAreRefinedAlike)
{
  for (const TriangleMesh& mesh : coarsePlates(30))
  {
    const ImprovedTriangulation plain = hexsweep::improveTriangulation(mesh, { true, true });
    for (const double scale : { 1e-6, 1e6 })
    {
      const ImprovedTriangulation scaled =
        hexsweep::improveTriangulation({ scale * mesh.points, mesh.triangles }, { true, true });
      EXPECT_EQ(scaled.mesh.triangles, plain.mesh.triangles);
    }
  }
}
}
