// SPDX-License-Identifier: BSD-3-Clause
// Location by walking against all triangles one by one, in exact integers.
#include "Core/Geometry/TriangleWalk.h"

#include "Support/CapMeshes.h"
#include "Support/PlaneMeshes.h"

#include "Core/Geometry/TriangleSearch.h"

#include <cstdint>
#include <limits>
#include <numeric>

namespace TestTriangleWalk
{
using hexsweep::Index;
using hexsweep::LocatedPoints;
using hexsweep::OutsidePoint;
using hexsweep::PlanePoints;
using hexsweep::Points;
using hexsweep::TriangleMesh;
using hexsweep::Triangles;
using hexsweep::TriangleWalk;
using test::GridSteps;
using test::onGrid;
using test::PlaneMesh;
using test::rounded;
using test::shuffled;

/// Twice the area of a, b, c in units of the grid, exactly.
std::int64_t areaOf(
  const Eigen::RowVector2d& a, const Eigen::RowVector2d& b, const Eigen::RowVector2d& c)
{
  const auto whole = [](double value) { return static_cast<std::int64_t>(value * GridSteps); };
  return (whole(b.x()) - whole(a.x())) * (whole(c.y()) - whole(a.y())) -
    (whole(b.y()) - whole(a.y())) * (whole(c.x()) - whole(a.x()));
}

bool holds(const PlaneMesh& mesh, Index t, const Eigen::RowVector2d& p)
{
  const Eigen::RowVector2d a = mesh.points.row(mesh.triangles(t, 0));
  const Eigen::RowVector2d b = mesh.points.row(mesh.triangles(t, 1));
  const Eigen::RowVector2d c = mesh.points.row(mesh.triangles(t, 2));
  return areaOf(a, b, c) > 0 && areaOf(a, b, p) >= 0 && areaOf(b, c, p) >= 0 &&
    areaOf(c, a, p) >= 0;
}

/// The lowest positive triangle that holds a point, or -1.
Index lowestThatHolds(const PlaneMesh& mesh, const Eigen::RowVector2d& p)
{
  Index t = 0;
  while (t < mesh.triangles.rows() && !holds(mesh, t, p))
  {
    ++t;
  }
  return t < mesh.triangles.rows() ? t : -1;
}

double distanceTo(const PlaneMesh& mesh, Index t, const Eigen::RowVector2d& p)
{
  const auto corner = [&](Index c) {
    const Eigen::RowVector2d q = mesh.points.row(mesh.triangles(t, c));
    return Eigen::RowVector3d(q.x(), q.y(), 0.0);
  };
  return hexsweep::closestPointOnTriangle({ p.x(), p.y(), 0.0 }, corner(0), corner(1), corner(2))
    .distance;
}

/// Points all over the mesh and round it, vertices, and middles of edges.
PlanePoints pointsFor(const PlaneMesh& mesh, int count, unsigned seed = 2)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-0.1, 1.1);
  const Eigen::RowVector2d low = mesh.points.colwise().minCoeff();
  const Eigen::RowVector2d size = mesh.points.colwise().maxCoeff() - low;
  PlanePoints points(3 * count, 2);
  for (Index i = 0; i < count; ++i)
  {
    points.row(3 * i) << low.x() + size.x() * uniform(generator),
      low.y() + size.y() * uniform(generator);
    const Index t = static_cast<Index>(generator() % mesh.triangles.rows());
    const Index c = static_cast<Index>(generator() % 3);
    const Eigen::RowVector2d a = mesh.points.row(mesh.triangles(t, c));
    const Eigen::RowVector2d b = mesh.points.row(mesh.triangles(t, (c + 1) % 3));
    points.row(3 * i + 1) = a;
    points.row(3 * i + 2) = 0.5 * (a + b);
  }
  return rounded(points, 1 / GridSteps);
}

PlanePoints placesOf(const PlaneMesh& mesh, const LocatedPoints& found)
{
  PlanePoints places = PlanePoints::Zero(found.coordinates.rows(), 2);
  for (Index i = 0; i < places.rows(); ++i)
  {
    for (Index c = 0; c < 3; ++c)
    {
      places.row(i) += found.coordinates(i, c) *
        mesh.points.row(mesh.triangles(found.triangles[static_cast<std::size_t>(i)], c));
    }
  }
  return places;
}

/// Everything that locate() promises.
void compare(const PlaneMesh& mesh, const PlanePoints& points, double tolerance = 1e-14)
{
  const LocatedPoints found = TriangleWalk(mesh.points, mesh.triangles).locate(points);
  ASSERT_EQ(found.triangles.size(), static_cast<std::size_t>(points.rows()));
  const PlanePoints places = placesOf(mesh, found);
  std::size_t outside = 0;
  for (Index i = 0; i < points.rows(); ++i)
  {
    const Eigen::RowVector2d p = points.row(i);
    const Index t = found.triangles[static_cast<std::size_t>(i)];
    EXPECT_GE(found.coordinates.row(i).minCoeff(), 0.0);
    EXPECT_NEAR(found.coordinates.row(i).sum(), 1.0, 1e-15);
    const Index expected = lowestThatHolds(mesh, p);
    double distance = 0.0;
    if (expected >= 0)
    {
      ASSERT_EQ(t, expected) << "point " << i;
    }
    else
    {
      distance = std::numeric_limits<double>::infinity();
      for (Index other = 0; other < mesh.triangles.rows(); ++other)
      {
        const Eigen::RowVector2d a = mesh.points.row(mesh.triangles(other, 0));
        if (areaOf(a, mesh.points.row(mesh.triangles(other, 1)),
              mesh.points.row(mesh.triangles(other, 2))) > 0)
        {
          distance = std::min(distance, distanceTo(mesh, other, p));
        }
      }
      ASSERT_LT(outside, found.outside.size());
      EXPECT_EQ(found.outside[outside].point, i);
      EXPECT_EQ(found.outside[outside].distance, distance);
      EXPECT_EQ(distanceTo(mesh, t, p), distance);
      ++outside;
    }
    EXPECT_NEAR((places.row(i) - p).norm(), distance, tolerance);
  }
  EXPECT_EQ(outside, found.outside.size());
}

/// Triangles that wind about a disk so that walks to its middle go round and round.
PlaneMesh whirl(Index around)
{
  TriangleMesh mesh = test::annulus(1.0, 6.0, 2, around);
  for (Index j = 0; j < around; ++j)
  {
    // The outer ring turned as far as the triangles allow.
    const double angle = 2.0 * test::Pi * static_cast<double>(j) / static_cast<double>(around);
    mesh.points.row(around + j) << 6.0 * std::cos(angle + 1.2), 6.0 * std::sin(angle + 1.2), 0.0;
  }
  mesh.points.conservativeResize(2 * around + 1, 3);
  mesh.points.row(2 * around).setZero();
  const Index old = mesh.triangles.rows();
  mesh.triangles.conservativeResize(old + around, 3);
  for (Index j = 0; j < around; ++j)
  {
    mesh.triangles.row(old + j) << 2 * around, j, (j + 1) % around;
  }
  return onGrid(mesh);
}

TEST(TriangleWalk, RandomMeshesWithHoles)
{
  for (const unsigned seed : { 1u, 2u, 3u })
  {
    const PlaneMesh mesh = onGrid(test::plate(12, test::threeHoles(), 0.2, seed));
    EXPECT_TRUE(TriangleWalk(mesh.points, mesh.triangles).flipped().empty());
    compare(mesh, pointsFor(mesh, 500));
    compare(shuffled(mesh, seed).mesh, pointsFor(mesh, 500));
  }
}

TEST(TriangleWalk, Needles)
{
  for (const double aspect : { 1.0 / 64, 1.0 / 1024 })
  {
    for (const double shear : { 0.0, 0.7 })
    {
      TriangleMesh plate = test::plate(12, test::threeHoles(), 0.2);
      plate.points.col(1) *= aspect;
      plate.points.col(0) += shear * plate.points.col(1) / aspect;
      plate.points.col(1) += shear * plate.points.col(0);
      const PlaneMesh mesh = onGrid(plate);
      compare(mesh, pointsFor(mesh, 300), 1e-10);
    }
  }
}

TEST(TriangleWalk, WalksInCirclesEnd)
{
  for (const Index around : { 5, 12, 60 })
  {
    const PlaneMesh mesh = whirl(around);
    compare(mesh, pointsFor(mesh, 200), 1e-13);
    PlanePoints middle = pointsFor(mesh, 200, 4) / 64;
    compare(mesh, rounded(middle, 1 / GridSteps), 1e-13);
  }
}

TEST(TriangleWalk, FoldsLeaveGapsAndLieTwice)
{
  // Nodes shaken by more than a cell: triangles are flipped, others lie over each other.
  for (const double shake : { 0.4, 0.9 })
  {
    const PlaneMesh mesh = onGrid(test::plate(12, test::threeHoles(), shake, 5));
    TriangleWalk walk(mesh.points, mesh.triangles);
    std::vector<Index> expected;
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
    {
      if (areaOf(mesh.points.row(mesh.triangles(t, 0)), mesh.points.row(mesh.triangles(t, 1)),
            mesh.points.row(mesh.triangles(t, 2))) < 0)
      {
        expected.push_back(t);
      }
    }
    std::vector<Index> flipped = walk.flipped();
    std::sort(flipped.begin(), flipped.end());
    ASSERT_FALSE(expected.empty());
    EXPECT_EQ(flipped, expected);
    compare(mesh, pointsFor(mesh, 500));
    compare(shuffled(mesh, 5).mesh, pointsFor(mesh, 500));
  }

  // Gaps that nothing covers: triangles turned over that were not.
  PlaneMesh mesh = onGrid(test::plate(12, {}, 0.2));
  for (const Index t : { 3, 100, 101, 150 })
  {
    std::swap(mesh.triangles(t, 0), mesh.triangles(t, 1));
  }
  compare(mesh, pointsFor(mesh, 500));
}

TEST(TriangleWalk, TrianglesWithoutAreaAreLeftOut)
{
  // The middle of an edge is a vertex of one side only: a triangle without area lies between.
  PlaneMesh mesh;
  mesh.points.resize(5, 2);
  mesh.points << 0, 0, 2, 0, 1, 0, 1, 1, 1, -1;
  mesh.triangles = test::facesOf<Triangles>({ 0, 1, 2, 0, 1, 3, 0, 4, 2, 2, 4, 1 });
  TriangleWalk walk(mesh.points, mesh.triangles);
  EXPECT_TRUE(walk.flipped().empty());
  compare(mesh, pointsFor(mesh, 100));
  PlanePoints edge(3, 2);
  edge << 0.5, 0, 1, 0, 1.5, 0;
  EXPECT_EQ(walk.locate(edge).triangles, (std::vector<Index>{ 1, 1, 1 }));
}

TEST(TriangleWalk, NumberingAndCompanyDoNotMatter)
{
  const PlaneMesh mesh = onGrid(test::plate(12, test::threeHoles(), 0.2));
  const PlanePoints points = pointsFor(mesh, 700);
  TriangleWalk walk(mesh.points, mesh.triangles);
  const LocatedPoints found = walk.locate(points);
  const PlanePoints places = placesOf(mesh, found);

  // The points by chance, and each alone: the same bits.
  std::vector<Index> order(static_cast<std::size_t>(points.rows()));
  std::iota(order.begin(), order.end(), Index(0));
  std::shuffle(order.begin(), order.end(), std::mt19937(4));
  PlanePoints mixed(points.rows(), 2);
  for (Index i = 0; i < points.rows(); ++i)
  {
    mixed.row(i) = points.row(order[static_cast<std::size_t>(i)]);
  }
  const LocatedPoints again = walk.locate(mixed);
  for (Index i = 0; i < points.rows(); ++i)
  {
    const Index row = order[static_cast<std::size_t>(i)];
    EXPECT_EQ(
      again.triangles[static_cast<std::size_t>(i)], found.triangles[static_cast<std::size_t>(row)]);
    EXPECT_EQ(again.coordinates.row(i), found.coordinates.row(row));
    const LocatedPoints alone = walk.locate(points.row(row));
    EXPECT_EQ(alone.triangles[0], found.triangles[static_cast<std::size_t>(row)]);
    EXPECT_EQ(alone.coordinates.row(0), found.coordinates.row(row));
  }

  // The mesh by chance: the same triangle, unless the point lies on an edge.
  const test::ShuffledMesh other = shuffled(mesh, 9);
  const LocatedPoints there = TriangleWalk(other.mesh.points, other.mesh.triangles).locate(points);
  ASSERT_EQ(there.outside.size(), found.outside.size());
  Index inside = 0;
  for (Index i = 0; i < points.rows(); ++i)
  {
    if (found.coordinates.row(i).minCoeff() > 0.0)
    {
      ++inside;
      EXPECT_EQ(
        other.origin[static_cast<std::size_t>(there.triangles[static_cast<std::size_t>(i)])],
        found.triangles[static_cast<std::size_t>(i)]);
    }
  }
  EXPECT_GT(inside, 300);
  EXPECT_LT((placesOf(other.mesh, there) - places).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(TriangleWalk, SizeDoesNotMatter)
{
  const PlaneMesh mesh = onGrid(test::plate(12, test::threeHoles(), 0.2));
  const PlanePoints points = pointsFor(mesh, 500);
  const LocatedPoints found = TriangleWalk(mesh.points, mesh.triangles).locate(points);
  for (const double scale : { std::ldexp(1.0, -20), std::ldexp(1.0, 20) })
  {
    const LocatedPoints scaled =
      TriangleWalk(scale * mesh.points, mesh.triangles).locate(scale * points);
    EXPECT_EQ(scaled.triangles, found.triangles);
    EXPECT_EQ(scaled.coordinates, found.coordinates);
  }
  // Scales that are no powers of two round the points, so that edges are missed; insides are not.
  for (const double scale : { 1e-6, 1e6 })
  {
    const LocatedPoints scaled =
      TriangleWalk(scale * mesh.points, mesh.triangles).locate(scale * points);
    for (std::size_t i = 0; i < found.triangles.size(); ++i)
    {
      if (found.coordinates.row(static_cast<Index>(i)).minCoeff() > 1e-9)
      {
        EXPECT_EQ(scaled.triangles[i], found.triangles[i]);
      }
    }
    EXPECT_LT(
      (placesOf({ scale * mesh.points, mesh.triangles }, scaled) / scale - placesOf(mesh, found))
        .cwiseAbs()
        .maxCoeff(),
      1e-14);
  }
}

TEST(TriangleWalk, ManyTrianglesRoundOneVertex)
{
  const PlaneMesh mesh = shuffled(onGrid(test::disk(2, 1000)), 1).mesh;
  PlanePoints points(101, 2);
  points << pointsFor(mesh, 33), PlanePoints::Zero(2, 2);
  EXPECT_GE(lowestThatHolds(mesh, points.row(100)), 0);
  compare(mesh, points, 1e-13);
}

TEST(TriangleWalk, OneTriangle)
{
  PlaneMesh mesh;
  mesh.points.resize(3, 2);
  mesh.points << 0, 0, 1, 0, 0, 1;
  for (Index turn = 0; turn < 3; ++turn)
  {
    mesh.triangles = test::facesOf<Triangles>({ turn, (turn + 1) % 3, (turn + 2) % 3 });
    compare(mesh, pointsFor(mesh, 50));
  }
}

TEST(TriangleWalk, PiecesThatTouchInAVertexOrNotAtAll)
{
  PlaneMesh mesh;
  mesh.points.resize(8, 2);
  mesh.points << 1, 1, 2, 1, 1, 2, 0, 1, 1, 0, 3, 3, 4, 3, 3, 4;
  mesh.triangles = test::facesOf<Triangles>({ 5, 6, 7, 0, 1, 2, 0, 3, 4 });
  compare(mesh, pointsFor(mesh, 200));
  mesh.triangles = test::facesOf<Triangles>({ 0, 3, 4, 5, 6, 7, 0, 1, 2 });
  compare(mesh, pointsFor(mesh, 200));
}

TEST(TriangleWalk, AnyOfTheTrianglesThatAreThereTwice)
{
  PlaneMesh mesh = onGrid(test::plate(4, {}, 0.2));
  Triangles twice(2 * mesh.triangles.rows(), 3);
  twice << mesh.triangles.colwise().reverse(), mesh.triangles;
  mesh.triangles = twice;
  const PlanePoints points = pointsFor(mesh, 200);
  const LocatedPoints found = TriangleWalk(mesh.points, mesh.triangles).locate(points);
  for (Index i = 0; i < points.rows(); ++i)
  {
    EXPECT_EQ(holds(mesh, found.triangles[static_cast<std::size_t>(i)], points.row(i)),
      lowestThatHolds(mesh, points.row(i)) >= 0);
  }
}

TEST(TriangleWalk, NothingToFind)
{
  PlaneMesh mesh = onGrid(test::plate(3, {}));
  EXPECT_TRUE(
    TriangleWalk(mesh.points, mesh.triangles).locate(PlanePoints(0, 2)).triangles.empty());

  PlanePoints points(2, 2);
  points << 0.5, 0.5, 3, 4;
  for (const Triangles& triangles :
    { Triangles(0, 3), Triangles(test::turnedOver(mesh.triangles)) })
  {
    TriangleWalk walk(mesh.points, triangles);
    EXPECT_TRUE(walk.empty());
    const LocatedPoints found = walk.locate(points);
    EXPECT_EQ(found.triangles, (std::vector<Index>{ -1, -1 }));
    EXPECT_EQ(found.outside.size(), 2u);
    EXPECT_EQ(found.coordinates, Points(Points::Zero(2, 3)));
  }
  EXPECT_TRUE(TriangleWalk(PlanePoints(0, 2), Triangles(0, 3)).empty());
}

TEST(TriangleWalk, PointsThatAreNotFiniteAreOutside)
{
  const PlaneMesh mesh = onGrid(test::plate(12, test::threeHoles(), 0.2));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  PlanePoints points(4, 2);
  points << nan, 0.5, 0.5, infinity, 0.5, 0.05, -infinity, nan;
  const LocatedPoints found = TriangleWalk(mesh.points, mesh.triangles).locate(points);
  EXPECT_EQ(found.triangles[2], lowestThatHolds(mesh, points.row(2)));
  ASSERT_EQ(found.outside.size(), 3u);
  for (const OutsidePoint& point : found.outside)
  {
    EXPECT_NE(point.point, 2);
    EXPECT_GE(found.triangles[static_cast<std::size_t>(point.point)], 0);
  }
}

TEST(TriangleWalk, TrianglesMustNamePoints)
{
  const PlaneMesh mesh = onGrid(test::plate(2, {}));
  for (const Index wrong : { Index(-1), mesh.points.rows() })
  {
    Triangles triangles = mesh.triangles;
    triangles(3, 1) = wrong;
    test::expectInvalid([&] { TriangleWalk(mesh.points, triangles); }, "triangle 3 names point");
  }
}

TEST(TriangleWalk, ReportsProgressAndCanBeAborted)
{
  const PlaneMesh mesh = onGrid(test::plate(4, {}));
  TriangleWalk walk(mesh.points, mesh.triangles);
  const PlanePoints points = pointsFor(mesh, 5000);
  double last = -1.0;
  walk.locate(points, [&](double fraction) {
    EXPECT_GT(fraction, last);
    last = fraction;
    return true;
  });
  EXPECT_GT(last, 0.5);
  EXPECT_LE(last, 1.0);
  EXPECT_THROW(walk.locate(points, [](double) { return false; }), hexsweep::Aborted);
}
}
