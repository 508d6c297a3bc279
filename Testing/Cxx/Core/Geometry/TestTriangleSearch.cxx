// SPDX-License-Identifier: BSD-3-Clause
// Against brute force, and against the variational inequality of a projection to a convex set.
#include "Core/Geometry/TriangleSearch.h"

#include "Support/CapMeshes.h"

namespace TestTriangleSearch
{
using hexsweep::Index;
using hexsweep::Points;
using hexsweep::TrianglePoint;
using hexsweep::TriangleSearch;
using Vector = Eigen::RowVector3d;

class Random
{
public:
  explicit Random(unsigned seed)
    : Generator(seed)
  {
  }
  Vector point(double size = 1.0)
  {
    return { this->number(size), this->number(size), this->number(size) };
  }
  double number(double size = 1.0)
  {
    return std::uniform_real_distribution<double>(-size, size)(this->Generator);
  }
  Index index(Index count) { return static_cast<Index>(this->Generator() % count); }

private:
  std::mt19937_64 Generator;
};

void expectProjection(
  const TrianglePoint& found, const Vector& p, const Vector& a, const Vector& b, const Vector& c)
{
  const double size =
    (p - a).norm() + (p - b).norm() + (p - c).norm() + (a - b).norm() + (b - c).norm();
  EXPECT_GE(found.coordinates.minCoeff(), 0.0);
  EXPECT_LE(found.coordinates.maxCoeff(), 1.0 + 1e-15);
  EXPECT_NEAR(found.coordinates.sum(), 1.0, 1e-15);
  const Vector q = found.coordinates[0] * a + found.coordinates[1] * b + found.coordinates[2] * c;
  EXPECT_NEAR(found.distance, (p - q).norm(), 1e-13 * size);
  // q is nearest in a convex set if and only if no point of it lies on p's side of q.
  for (const Vector& v : { a, b, c })
  {
    EXPECT_LE((p - q).dot(v - q), 1e-12 * size * size);
  }
}

TrianglePoint bruteForce(const Points& corners, const Vector& p)
{
  TrianglePoint best;
  for (Index t = 0; t < corners.rows() / 3; ++t)
  {
    TrianglePoint found = hexsweep::closestPointOnTriangle(
      p, corners.row(3 * t), corners.row(3 * t + 1), corners.row(3 * t + 2));
    found.triangle = t;
    if (best.triangle < 0 || found.distance < best.distance)
    {
      best = found;
    }
  }
  return best;
}

Points cornersOf(const hexsweep::TriangleMesh& mesh)
{
  Points corners(mesh.triangles.rows() * 3, 3);
  for (Index i = 0; i < corners.rows(); ++i)
  {
    corners.row(i) = mesh.points.row(mesh.triangles(i / 3, i % 3));
  }
  return corners;
}

TEST(TriangleSearch, ProjectionToAnyTriangle)
{
  Random random(1);
  for (int i = 0; i < 5000; ++i)
  {
    const Vector a = random.point();
    const Vector b = random.point();
    // Every third one is a sliver.
    const Vector c = i % 3 == 0 ? Vector(0.5 * (a + b) + random.point(1e-5)) : random.point();
    const Vector p = random.point(2.0);
    expectProjection(hexsweep::closestPointOnTriangle(p, a, b, c), p, a, b, c);
  }
}

TEST(TriangleSearch, ClosedForms)
{
  const Vector a(0, 0, 0);
  const Vector b(4, 0, 0);
  const Vector c(0, 4, 0);
  const auto inside = hexsweep::closestPointOnTriangle({ 1, 2, 3 }, a, b, c);
  EXPECT_DOUBLE_EQ(inside.distance, 3.0);
  EXPECT_LT((inside.coordinates - Vector(0.25, 0.25, 0.5)).norm(), 1e-15);
  const auto edge = hexsweep::closestPointOnTriangle({ 3, 3, 0 }, a, b, c);
  EXPECT_DOUBLE_EQ(edge.distance, std::sqrt(2.0));
  EXPECT_LT((edge.coordinates - Vector(0.0, 0.5, 0.5)).norm(), 1e-15);
  const auto vertex = hexsweep::closestPointOnTriangle({ -3, -4, 0 }, a, b, c);
  EXPECT_DOUBLE_EQ(vertex.distance, 5.0);
  EXPECT_EQ(vertex.coordinates, Vector(1, 0, 0));
}

TEST(TriangleSearch, SegmentsAndPointsAreTrianglesToo)
{
  Random random(2);
  for (int i = 0; i < 1000; ++i)
  {
    const Vector a = random.point();
    const Vector b = random.point();
    const Vector p = random.point(2.0);
    for (const auto& [u, v, w] :
      { std::make_tuple(a, b, b), std::make_tuple(a, a, b), std::make_tuple(a, b, a) })
    {
      expectProjection(hexsweep::closestPointOnTriangle(p, u, v, w), p, u, v, w);
    }
    EXPECT_NEAR(hexsweep::closestPointOnTriangle(p, a, a, a).distance, (p - a).norm(), 1e-15);
  }
}

TEST(TriangleSearch, EqualsBruteForceOnSoupsWithAnyStart)
{
  Random random(3);
  for (const Index count : { 1, 2, 5, 40, 300 })
  {
    Points corners(3 * count, 3);
    for (Index t = 0; t < count; ++t)
    {
      const Vector center = random.point();
      for (Index c = 0; c < 3; ++c)
      {
        corners.row(3 * t + c) = center + random.point(t % 7 == 0 ? 1.0 : 0.1);
      }
    }
    const TriangleSearch search(corners);
    for (int i = 0; i < 300; ++i)
    {
      const Vector p = random.point(i % 2 ? 1.0 : 3.0);
      const TrianglePoint expected = bruteForce(corners, p);
      for (const Index start : { Index(-1), random.index(count), random.index(count) })
      {
        const TrianglePoint found = search.closest(p, start);
        EXPECT_NEAR(found.distance, expected.distance, 1e-14);
        EXPECT_EQ(found.triangle, expected.triangle);
      }
    }
  }
}

TEST(TriangleSearch, EqualsBruteForceOnACurvedMesh)
{
  hexsweep::TriangleMesh mesh = test::plate(12, test::threeHoles(), 0.3);
  mesh.points = test::lifted(mesh.points, test::bump);
  const Points corners = cornersOf(mesh);
  const TriangleSearch search(mesh.points, mesh.triangles);
  Random random(4);
  Index last = -1;
  for (int i = 0; i < 2000; ++i)
  {
    const Vector p = Vector(0.5, 0.5, 0.3) + random.point(0.7);
    const TrianglePoint found = search.closest(p, last);
    last = found.triangle;
    EXPECT_NEAR(found.distance, bruteForce(corners, p).distance, 1e-14);
  }
  // Vertices lie in several triangles: found at no distance, whatever the start.
  for (Index v = 0; v < mesh.points.rows(); ++v)
  {
    EXPECT_LT(
      search.closest(mesh.points.row(v), random.index(mesh.triangles.rows())).distance, 1e-15);
  }
}

TEST(TriangleSearch, TiesGoToTheLowestId)
{
  Points corners(3 * 50, 3);
  for (Index t = 0; t < 50; ++t)
  {
    corners.middleRows<3>(3 * t) << 0, 0, 0, 1, 0, 0, 0, 1, 0;
  }
  const TriangleSearch search(corners);
  Random random(5);
  for (Index start = -1; start < 50; ++start)
  {
    EXPECT_EQ(search.closest(random.point(2.0), start).triangle, 0);
  }
}

TEST(TriangleSearch, AlwaysNamesATriangleWhereThereAreAny)
{
  const hexsweep::TriangleMesh mesh = test::plate(5, {});
  const TriangleSearch search(mesh.points, mesh.triangles);
  const double nan = std::nan("");
  for (const Vector& p : { Vector(nan, 0, 0), Vector(nan, nan, nan), Vector(1e308, -1e308, 1e308) })
  {
    EXPECT_GE(search.closest(p).triangle, 0);
    EXPECT_LT(search.closest(p).triangle, mesh.triangles.rows());
  }
  EXPECT_EQ(TriangleSearch(Points(0, 3)).closest({ 1, 2, 3 }).triangle, -1);
}

TEST(TriangleSearch, SizePlaceAndTurnDoNotMatter)
{
  hexsweep::TriangleMesh mesh = test::plate(12, test::threeHoles(), 0.3);
  mesh.points = test::lifted(mesh.points, test::bump);
  Random random(6);
  Points queries(200, 3);
  for (Index i = 0; i < queries.rows(); ++i)
  {
    queries.row(i) = Vector(0.5, 0.5, 0.3) + random.point(0.7);
  }
  const TriangleSearch plain(mesh.points, mesh.triangles);
  for (const test::Placement& placement : test::placements())
  {
    const TriangleSearch moved(placement.motion(mesh.points), mesh.triangles);
    const Points places = placement.motion(queries);
    for (Index i = 0; i < queries.rows(); ++i)
    {
      EXPECT_NEAR(moved.closest(places.row(i)).distance / placement.motion.scale,
        plain.closest(queries.row(i)).distance, 20 * placement.relativeRounding)
        << placement.name;
    }
  }
}
}
