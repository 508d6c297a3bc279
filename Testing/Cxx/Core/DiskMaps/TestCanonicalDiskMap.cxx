// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/CanonicalDiskMap.h"
#include "Core/Solvers/SurfaceLaplacian.h"

#include "Support/CapMeshes.h"

namespace TestCanonicalDiskMap
{
using hexsweep::CapDisk;
using hexsweep::Circle;
using hexsweep::DiskDomain;
using hexsweep::HoleTreatment;
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::Points;
using hexsweep::TriangleMesh;
using hexsweep::Weights;

/// The rim by arc length, from angle 0 at the smallest id.
void expectRim(const CapDisk& cap)
{
  const Loop& rim = cap.loops[0];
  EXPECT_EQ(rim[0], *std::min_element(rim.begin(), rim.end()));
  const double whole = test::loopLength(cap.mesh.points, rim);
  double length = 0.0;
  for (std::size_t k = 0; k < rim.size(); ++k)
  {
    const double angle = 2.0 * test::Pi * length / whole;
    EXPECT_NEAR(cap.disk(rim[k], 0), std::cos(angle), 1e-13);
    EXPECT_NEAR(cap.disk(rim[k], 1), std::sin(angle), 1e-13);
    length += (cap.mesh.points.row(rim[(k + 1) % rim.size()]) - cap.mesh.points.row(rim[k])).norm();
  }
}

TEST(CanonicalDiskMap, APlaneDiskIsItsOwnMap)
{
  // The smallest id of the rim lies at angle 0.
  const TriangleMesh plane = test::disk(6, 36);
  const TriangleMesh mesh{ test::Similarity{ 3.0, test::someTurn(), { 1, 2, 3 } }(plane.points),
    plane.triangles };
  for (const Weights weights : { Weights::Cotangent, Weights::MeanValue })
  {
    const CapDisk cap = hexsweep::canonicalDiskMap(mesh, HoleTreatment::ArcLength, weights);
    EXPECT_LT((cap.disk - plane.points.leftCols<2>()).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_EQ(cap.domain, DiskDomain::Disk);
    EXPECT_EQ(cap.weights, weights);
    EXPECT_TRUE(cap.flipped.empty());
    EXPECT_TRUE(cap.holes.empty());
    EXPECT_EQ(cap.mesh.points, mesh.points);
    expectRim(cap);
  }
}

TEST(CanonicalDiskMap, TreatmentsAgreeWithOneLoop)
{
  const TriangleMesh mesh = test::curvedPlate(0, 0.25);
  const CapDisk a = hexsweep::canonicalDiskMap(mesh, HoleTreatment::ArcLength, Weights::Cotangent);
  const CapDisk b = hexsweep::canonicalDiskMap(mesh, HoleTreatment::Filled, Weights::Cotangent);
  EXPECT_EQ(a.disk, b.disk);
  expectRim(a);
  EXPECT_TRUE(a.flipped.empty());
}

TEST(CanonicalDiskMap, HolesAreCirclesByArcLength)
{
  for (const std::size_t holes : { 1u, 2u, 3u })
  {
    for (const Weights weights : { Weights::Cotangent, Weights::MeanValue })
    {
      const TriangleMesh mesh = test::curvedPlate(holes, 0.25, 0.5);
      const CapDisk cap = hexsweep::canonicalDiskMap(mesh, HoleTreatment::ArcLength, weights);
      EXPECT_EQ(cap.domain, DiskDomain::Circles);
      ASSERT_EQ(cap.holes.size(), holes);
      ASSERT_EQ(cap.loops.size(), holes + 1);
      expectRim(cap);
      EXPECT_TRUE(cap.flipped.empty());
      for (std::size_t h = 0; h < holes; ++h)
      {
        const Circle& hole = cap.holes[h];
        const Loop& loop = cap.loops[h + 1];
        const double whole = test::loopLength(cap.mesh.points, loop);
        EXPECT_LT(hole.center.norm() + hole.radius, 1.0);
        for (std::size_t other = 0; other < h; ++other)
        {
          EXPECT_GT(
            (hole.center - cap.holes[other].center).norm(), hole.radius + cap.holes[other].radius);
        }
        for (std::size_t k = 0; k < loop.size(); ++k)
        {
          const Index v = loop[k];
          const Index next = loop[(k + 1) % loop.size()];
          const Eigen::RowVector2d p = cap.disk.row(v) - hole.center;
          const Eigen::RowVector2d q = cap.disk.row(next) - hole.center;
          EXPECT_NEAR(p.norm(), hole.radius, 1e-14);
          // Clockwise, since the surface lies on the left.
          const double step = std::atan2(p.x() * q.y() - p.y() * q.x(), p.dot(q));
          const double edge = (cap.mesh.points.row(next) - cap.mesh.points.row(v)).norm();
          EXPECT_NEAR(step, -2.0 * test::Pi * edge / whole, 1e-12);
        }
      }
    }
  }
}

TEST(CanonicalDiskMap, FilledMapIsHarmonicAcrossTheHoles)
{
  // A plane annulus with its hole filled is a plane disk: the identity.
  const TriangleMesh mesh = test::annulus(0.3, 1.0, 5, 30);
  const CapDisk cap = hexsweep::canonicalDiskMap(mesh, HoleTreatment::Filled, Weights::Cotangent);
  EXPECT_EQ(cap.domain, DiskDomain::Disk);
  EXPECT_LT((cap.disk - mesh.points.leftCols<2>()).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_TRUE(cap.flipped.empty());
}

TEST(CanonicalDiskMap, TheLongestLoopIsTheRim)
{
  // A funnel whose hole has the smaller ids, then one whose hole is longer than its rim was.
  const TriangleMesh mesh = test::annulus(0.3, 1.0, 5, 30);
  const CapDisk cap =
    hexsweep::canonicalDiskMap(mesh, HoleTreatment::ArcLength, Weights::Cotangent);
  EXPECT_GE(cap.loops[0][0], 4 * 30);
  EXPECT_LT(cap.loops[1][0], 30);
  TriangleMesh inverted = mesh;
  for (Index i = 0; i < mesh.points.rows(); ++i)
  {
    inverted.points.row(i) /= mesh.points.row(i).squaredNorm();
  }
  const CapDisk other =
    hexsweep::canonicalDiskMap(inverted, HoleTreatment::ArcLength, Weights::Cotangent);
  EXPECT_LT(other.loops[0][0], 30);
  EXPECT_TRUE(other.flipped.empty());
}

TEST(CanonicalDiskMap, FacetsWithoutInnerNodes)
{
  // A regular polygon as a fan from one corner: chords only, which would collapse.
  TriangleMesh mesh;
  mesh.points.resize(40, 3);
  std::vector<Index> ids;
  for (Index i = 0; i < 40; ++i)
  {
    const double angle = 2.0 * test::Pi * static_cast<double>(i) / 40.0;
    mesh.points.row(i) << 2.0 * std::cos(angle), std::sin(angle), 0.0;
    if (i > 1)
    {
      ids.insert(ids.end(), { 0, i - 1, i });
    }
  }
  mesh.triangles = test::facesOf<hexsweep::Triangles>(ids);
  const CapDisk cap =
    hexsweep::canonicalDiskMap(mesh, HoleTreatment::ArcLength, Weights::Cotangent);
  EXPECT_EQ(cap.numberOfOriginalPoints, 40);
  EXPECT_EQ(cap.mesh.points.topRows(40), mesh.points);
  EXPECT_EQ(cap.mesh.points.rows(), 40 + 37);
  EXPECT_TRUE(cap.flipped.empty());
  for (const Index origin : cap.triangleOrigin)
  {
    EXPECT_GE(origin, 0);
    EXPECT_LT(origin, mesh.triangles.rows());
  }
}

TEST(CanonicalDiskMap, SizePlaceAndTurnDoNotMatter)
{
  for (const HoleTreatment treatment : { HoleTreatment::ArcLength, HoleTreatment::Filled })
  {
    const TriangleMesh mesh = test::curvedPlate(3, 0.25);
    const CapDisk plain = hexsweep::canonicalDiskMap(mesh, treatment, Weights::Cotangent);
    for (const test::Placement& placement : test::placements())
    {
      const CapDisk moved = hexsweep::canonicalDiskMap(
        { placement.motion(mesh.points), mesh.triangles }, treatment, Weights::Cotangent);
      // Weights feel the rounding of coordinates over slivers' heights, 1e-2 of the size.
      EXPECT_LT((moved.disk - plain.disk).cwiseAbs().maxCoeff(), 1e5 * placement.relativeRounding)
        << placement.name;
    }
  }
}

TEST(CanonicalDiskMap, WhatIsNoCap)
{
  const auto map = [](const hexsweep::Triangles& triangles, Index points) {
    hexsweep::canonicalDiskMap(
      { Points::Random(points, 3), triangles }, HoleTreatment::ArcLength, Weights::Cotangent);
  };
  using hexsweep::Triangles;
  using test::facesOf;
  test::expectInvalid(
    [&] {
      map(facesOf<Triangles>({ 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2 }), 4);
    },
    "closed surface");
  test::expectInvalid([&] { map(facesOf<Triangles>({ 0, 1, 2, 3, 4, 5 }), 6); }, "2 pieces");
  test::expectInvalid(
    [&] {
      map(facesOf<Triangles>({ 0, 1, 2, 1, 2, 3 }), 4);
    },
    "opposite orientation");
  test::expectInvalid([&] { map(Triangles(0, 3), 0); }, "no faces");
  TriangleMesh flat = test::plate(3, {});
  flat.points.col(1).setZero();
  test::expectInvalid(
    [&] { hexsweep::canonicalDiskMap(flat, HoleTreatment::ArcLength, Weights::Cotangent); },
    "no area");
}
}
