// SPDX-License-Identifier: BSD-3-Clause
// Both caps in one domain: the same boundary nodes, and nothing flipped.
#include "Core/DiskMaps/CommonDiskMap.h"

#include "Core/CapQuads/SweepProjection.h"
#include "Core/Solvers/SurfaceLaplacian.h"
#include "Support/CapMeshes.h"

#include <set>

namespace TestCommonDiskMap
{
using hexsweep::CapDisk;
using hexsweep::CommonDisks;
using hexsweep::DiskDomain;
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::LoopPair;
using hexsweep::PlanePoints;
using hexsweep::Points;
using hexsweep::TriangleMesh;
using hexsweep::Weights;

CommonDisks map(const TriangleMesh& first, const TriangleMesh& second,
  const std::vector<LoopPair>& pairs, Weights weights = Weights::Cotangent)
{
  return hexsweep::commonDiskMap(
    hexsweep::makeCap(first, "first"), hexsweep::makeCap(second, "second"), pairs, weights, 1e-6);
}

/// The two caps share their loops' nodes in the disk, and the loops are all of the boundary.
void expectSharedBoundary(const CommonDisks& disks, double tolerance)
{
  EXPECT_EQ(disks.first.domain, disks.second.domain);
  ASSERT_EQ(disks.first.loops.size(), disks.second.loops.size());
  for (std::size_t p = 0; p < disks.first.loops.size(); ++p)
  {
    const Loop& a = disks.first.loops[p];
    const Loop& b = disks.second.loops[p];
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k)
    {
      EXPECT_LE((disks.first.disk.row(a[k]) - disks.second.disk.row(b[k])).norm(), tolerance);
    }
  }
  for (const CapDisk* cap : { &disks.first, &disks.second })
  {
    std::set<Index> nodes;
    std::set<Index> boundary;
    for (const Loop& loop : cap->loops)
    {
      nodes.insert(loop.begin(), loop.end());
    }
    for (const Loop& loop : test::loopsOf(cap->mesh))
    {
      boundary.insert(loop.begin(), loop.end());
    }
    EXPECT_EQ(nodes, boundary);
    EXPECT_TRUE(cap->disk.allFinite());
    EXPECT_LE(cap->disk.rowwise().norm().maxCoeff(), 1.0 + 1e-15);
  }
}

void expectNoFlips(const CommonDisks& disks)
{
  for (const CapDisk* cap : { &disks.first, &disks.second })
  {
    EXPECT_TRUE(cap->flipped.empty());
    EXPECT_TRUE(
      hexsweep::domainTriangles(cap->domain, cap->disk, cap->mesh.triangles).flipped.empty());
  }
}

/// Loop nodes on the rim and on the circles of the holes.
void expectCircles(const CapDisk& cap)
{
  ASSERT_EQ(cap.holes.size() + 1, cap.loops.size());
  for (std::size_t p = 0; p < cap.loops.size(); ++p)
  {
    const hexsweep::Circle circle =
      p == 0 ? hexsweep::Circle{ { 0.0, 0.0 }, 1.0 } : cap.holes[p - 1];
    for (const Index v : cap.loops[p])
    {
      EXPECT_NEAR((cap.disk.row(v) - circle.center).norm(), circle.radius, 1e-14);
    }
  }
}

/// Two annuli: the hole of the second is `growth` times as large and turned by `steps` places.
struct TurnedAnnuli
{
  TriangleMesh first;
  TriangleMesh second;
  std::vector<LoopPair> pairs;
};

TurnedAnnuli turnedAnnuli(Index around, Index steps, double inner, double growth)
{
  std::mt19937 generator(2);
  TurnedAnnuli annuli;
  annuli.first = test::annulus(inner, 1.0, 8, around, &generator);
  annuli.second = test::annulus(growth * inner, 1.0, 6, around, &generator);
  annuli.second.points.col(2).array() += 3.0;
  for (const Loop& loop : test::loopsOf(annuli.first))
  {
    LoopPair pair;
    pair.first.resize(static_cast<Index>(loop.size()), 3);
    pair.second.resize(pair.first.rows(), 3);
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      const bool hole = loop[k] < around;
      const Index j = loop[k] % around;
      pair.first.row(static_cast<Index>(k)) = annuli.first.points.row(loop[k]);
      pair.second.row(static_cast<Index>(k)) = annuli.second.points.row(
        hole ? (j + steps) % around : annuli.second.points.rows() - around + j);
    }
    annuli.pairs.push_back(pair);
  }
  return annuli;
}

TEST(CommonDiskMap, OneLoopGoesToTheDisk)
{
  const TriangleMesh first = test::curvedPlate(0, 0.25, 1.0, 1);
  const TriangleMesh second = test::curvedPlate(0, 0.25, -0.5, 2);
  const auto loops = test::loopsOf(first);
  for (const Weights weights : { Weights::Cotangent, Weights::MeanValue })
  {
    const CommonDisks disks =
      map(first, second, test::pairsOf(first.points, second.points, loops), weights);
    EXPECT_EQ(disks.first.domain, DiskDomain::Disk);
    EXPECT_EQ(disks.first.numberOfOriginalPoints, first.points.rows());
    expectSharedBoundary(disks, 0.0);
    expectNoFlips(disks);
    expectCircles(disks.first);
    expectCircles(disks.second);
  }
}

TEST(CommonDiskMap, TwoLoopsGoToAnAnnulus)
{
  const TriangleMesh first = test::curvedPlate(1, 0.25, 1.0, 1);
  const TriangleMesh second = test::curvedPlate(1, 0.25, -0.5, 2);
  const auto loops = test::loopsOf(first);
  for (const Weights weights : { Weights::Cotangent, Weights::MeanValue })
  {
    const CommonDisks disks =
      map(first, second, test::pairsOf(first.points, second.points, loops), weights);
    EXPECT_EQ(disks.first.domain, DiskDomain::Annulus);
    expectSharedBoundary(disks, 1e-13);
    expectNoFlips(disks);
    expectCircles(disks.first);
    EXPECT_EQ(disks.first.holes[0].center, Eigen::RowVector2d(0, 0));
  }
}

TEST(CommonDiskMap, MoreLoopsGoToCircles)
{
  const TriangleMesh first = test::curvedPlate(3, 0.25, 0.4, 1);
  const TriangleMesh second = test::curvedPlate(3, 0.25, -0.2, 2);
  const auto loops = test::loopsOf(first);
  for (const Weights weights : { Weights::Cotangent, Weights::MeanValue })
  {
    const CommonDisks disks =
      map(first, second, test::pairsOf(first.points, second.points, loops), weights);
    EXPECT_EQ(disks.first.domain, DiskDomain::Circles);
    expectSharedBoundary(disks, 0.0);
    expectNoFlips(disks);
    expectCircles(disks.first);
    expectCircles(disks.second);
  }
}

TEST(CommonDiskMap, MismatchedCirclesShareTheirBoundaryAllTheSame)
{
  // 36, 25 and 24 nodes on the same circles: arcs against chords.
  for (const Index around : { 25, 100, 12 })
  {
    const TriangleMesh first = test::annulus(0.4, 1.0, 5, 36);
    TriangleMesh second = test::annulus(0.4, 1.0, 5, around);
    second.points.col(2).array() += 2.0;
    std::vector<LoopPair> pairs;
    for (const double radius : { 1.0, 0.4 })
    {
      LoopPair pair;
      pair.first.resize(24, 3);
      for (Index j = 0; j < 24; ++j)
      {
        const double angle = (radius < 1.0 ? -1.0 : 1.0) * test::Pi * static_cast<double>(j) / 12.0;
        pair.first.row(j) << radius * std::cos(angle), radius * std::sin(angle), 0.0;
      }
      pair.second = pair.first;
      pair.second.col(2).array() += 2.0;
      pairs.push_back(pair);
    }
    const CommonDisks disks = map(first, second, pairs);
    expectSharedBoundary(disks, 1e-13);
    expectNoFlips(disks);
    // A concentric annulus is its own image: radii by the modulus, angles as they are.
    EXPECT_NEAR(disks.first.holes[0].radius, 0.4, 0.02);
    for (Index i = 0; i < first.points.rows(); ++i)
    {
      const double r = first.points.row(i).norm();
      EXPECT_NEAR(disks.first.disk.row(i).norm(), r, 0.03);
    }
  }
}

TEST(CommonDiskMap, RadiusOfTheAnnulusConvergesToTheConformalOne)
{
  double last = 0.0;
  for (const Index rings : { 5, 9, 17 })
  {
    const TurnedAnnuli annuli = turnedAnnuli(6 * (rings - 1), 0, 0.35, 1.0);
    TurnedAnnuli same = annuli;
    std::mt19937 generator(1);
    same.first = test::annulus(0.35, 1.0, rings, 6 * (rings - 1), &generator);
    same.second = same.first;
    same.second.points.col(2).array() += 3.0;
    const CommonDisks disks = map(same.first, same.second, same.pairs);
    const double error = std::abs(std::log(disks.first.holes[0].radius / 0.35));
    if (last > 0.0)
    {
      EXPECT_GT(last / error, 3.3);
    }
    last = error;
  }
  EXPECT_LT(last, 0.01);
}

TEST(CommonDiskMap, HolesThatTurnByAnyAngleAndGrowDoNotFold)
{
  // The Nitsche bound forbids a harmonic map of one annulus onto the other: r = 0.25 grown to
  // 0.75 > 2 r / (1 + r^2) = 0.47 even without a turn.
  const Index around = 36;
  for (const Index steps : { 0, 5, 9, 17, 19, 30 })
  {
    for (const double growth : { 1.0, 3.0 })
    {
      const TurnedAnnuli annuli = turnedAnnuli(around, steps, 0.25, growth);
      for (const Weights weights : { Weights::Cotangent, Weights::MeanValue })
      {
        const CommonDisks disks = map(annuli.first, annuli.second, annuli.pairs, weights);
        EXPECT_EQ(disks.first.domain, DiskDomain::Annulus);
        expectSharedBoundary(disks, 1e-13);
        expectNoFlips(disks);
        // Half of the turn is taken by each map, the short way round.
        const double turn = 10.0 * static_cast<double>(steps > 18 ? steps - 36 : steps);
        const double half = turn / 2.0 * test::Pi / 180.0;
        const auto angleOf = [](const PlanePoints& disk, Index v) {
          return std::atan2(disk(v, 1), disk(v, 0));
        };
        const double first = angleOf(disks.first.disk, 0) -
          angleOf(disks.first.disk, annuli.first.points.rows() - around);
        EXPECT_NEAR(hexsweep::wrapAngle(first - half), 0.0, 1e-9) << steps;
      }
    }
  }
}

TEST(CommonDiskMap, HolesThatTurnOnCurvedCaps)
{
  TurnedAnnuli annuli = turnedAnnuli(36, 17, 0.25, 3.0);
  const auto dome = [](double x, double y) { return 1.5 * (1.0 - x * x - y * y); };
  annuli.first.points = test::lifted(annuli.first.points, dome);
  for (LoopPair& pair : annuli.pairs)
  {
    pair.first = test::lifted(pair.first, dome);
  }
  const CommonDisks disks = map(annuli.first, annuli.second, annuli.pairs);
  expectSharedBoundary(disks, 1e-13);
  expectNoFlips(disks);
}

TEST(CommonDiskMap, ASimilarCapHasTheSameMap)
{
  for (const std::size_t holes : { 0u, 1u, 3u })
  {
    const TriangleMesh first = test::curvedPlate(holes, 0.25, 1.0, 1);
    const test::Similarity motion{ 2.5, test::someTurn(), { 3, 4, 5 } };
    const TriangleMesh second{ motion(first.points), first.triangles };
    const auto loops = test::loopsOf(first);
    const CommonDisks disks = map(first, second, test::pairsOf(first.points, second.points, loops));
    EXPECT_EQ(disks.first.mesh.triangles, disks.second.mesh.triangles);
    EXPECT_LT((disks.first.disk - disks.second.disk).cwiseAbs().maxCoeff(), 1e-11);
  }
}

TEST(CommonDiskMap, SwappedCapsHaveTheSameMaps)
{
  for (const std::size_t holes : { 0u, 1u, 3u })
  {
    const TriangleMesh first = test::curvedPlate(holes, 0.25, 1.0, 1);
    TriangleMesh second = test::curvedPlate(holes, 0.25, -0.5, 2);
    second.points.col(2).array() += 3.0;
    const hexsweep::QuadMesh linking =
      test::linkingSides(first.points, second.points, test::loopsOf(first));
    const CommonDisks plain =
      hexsweep::mapLinkedCaps(first, second, linking, Weights::Cotangent, 1e-6);
    const CommonDisks swapped =
      hexsweep::mapLinkedCaps(second, first, linking, Weights::Cotangent, 1e-6);
    EXPECT_EQ(plain.first.disk, swapped.second.disk);
    EXPECT_EQ(plain.second.disk, swapped.first.disk);
    EXPECT_EQ(plain.first.mesh.triangles, swapped.second.mesh.triangles);
    EXPECT_EQ(plain.first.mesh.points, swapped.second.mesh.points);
    expectNoFlips(plain);
  }
}

TEST(CommonDiskMap, SizePlaceAndTurnDoNotMatter)
{
  for (const std::size_t holes : { 0u, 1u, 3u })
  {
    const TriangleMesh first = test::curvedPlate(holes, 0.25, 1.0, 1);
    TriangleMesh second = test::curvedPlate(holes, 0.25, -0.5, 2);
    second.points.col(2).array() += 3.0;
    const auto loops = test::loopsOf(first);
    const CommonDisks plain = map(first, second, test::pairsOf(first.points, second.points, loops));
    for (const test::Placement& placement : test::placements())
    {
      const TriangleMesh a{ placement.motion(first.points), first.triangles };
      const TriangleMesh b{ placement.motion(second.points), second.triangles };
      const CommonDisks moved = map(a, b, test::pairsOf(a.points, b.points, loops));
      // Weights feel the rounding of coordinates over edges and slivers' heights, 1e-2 of the
      // size, and the boundary of a thin hole's map magnifies it.
      const double tolerance = 1e5 * placement.relativeRounding;
      ASSERT_EQ(moved.first.disk.rows(), plain.first.disk.rows());
      EXPECT_LT((moved.first.disk - plain.first.disk).cwiseAbs().maxCoeff(), tolerance)
        << placement.name;
      EXPECT_LT((moved.second.disk - plain.second.disk).cwiseAbs().maxCoeff(), tolerance)
        << placement.name;
    }
  }
}

TEST(CommonDiskMap, FacetsWithoutInnerNodes)
{
  // A square of two triangles against a fine one: chords are split, nothing collapses.
  const TriangleMesh first = test::plate(1, {});
  TriangleMesh second = test::plate(8, {}, 0.2);
  second.points.col(2).array() += 1.0;
  const Loop loop = test::loopsOf(first)[0];
  std::vector<LoopPair> pairs = test::pairsOf(first.points, first.points, { loop });
  pairs[0].second.col(2).array() += 1.0;
  const CommonDisks disks = map(first, second, pairs);
  expectSharedBoundary(disks, 0.0);
  expectNoFlips(disks);
  EXPECT_EQ(disks.first.numberOfOriginalPoints, 4);
  EXPECT_EQ(disks.first.mesh.points.topRows(4), first.points);
}

TEST(CommonDiskMap, CanBeAborted)
{
  const TriangleMesh first = test::curvedPlate(1, 0.25, 1.0, 1);
  const auto pairs = test::pairsOf(first.points, first.points, test::loopsOf(first));
  int calls = 0;
  EXPECT_THROW(
    hexsweep::commonDiskMap(hexsweep::makeCap(first, "first"), hexsweep::makeCap(first, "second"),
      pairs, Weights::Cotangent, 1e-6, [&](double) { return ++calls < 2; }),
    hexsweep::Aborted);
  std::vector<double> seen;
  hexsweep::commonDiskMap(hexsweep::makeCap(first, "first"), hexsweep::makeCap(first, "second"),
    pairs, Weights::Cotangent, 1e-6, [&](double fraction) {
      seen.push_back(fraction);
      return true;
    });
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1.0);
}
}
