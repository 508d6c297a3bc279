// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/BorderImprint.h"

#include "Core/Geometry/TriangleSearch.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "Support/CapMeshes.h"

#include <Eigen/Geometry>

#include <map>
#include <random>

namespace TestBorderImprint
{
using namespace test;
using hexsweep::BorderLines;
using hexsweep::ImprintBase;
using hexsweep::ImprintedSurface;

ImprintBase baseOf(TriangleMesh surface, double snap = 0.0)
{
  ImprintBase base;
  base.faceIds.assign(static_cast<std::size_t>(surface.triangles.rows()), 1);
  base.surface = std::move(surface);
  base.snap = snap;
  return base;
}

/// Lines from each point to the next one.
BorderLines chain(const std::vector<Eigen::RowVector3d>& points, bool endsOnBoundary)
{
  BorderLines lines;
  lines.points.resize(static_cast<Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    lines.points.row(static_cast<Index>(i)) = points[i];
    lines.onBoundary.push_back(endsOnBoundary && (i == 0 || i + 1 == points.size()));
    if (i > 0)
    {
      lines.pieces.emplace_back(static_cast<Index>(i) - 1, static_cast<Index>(i));
    }
  }
  return lines;
}

double lengthOf(const ImprintedSurface& made)
{
  double length = 0.0;
  for (const hexsweep::ImprintedEdge& edge : made.edges)
  {
    length +=
      (made.mesh.points.row(edge.ends.first) - made.mesh.points.row(edge.ends.second)).norm();
  }
  return length;
}

Eigen::RowVector3d areaOf(const TriangleMesh& mesh, Index t)
{
  const Eigen::RowVector3d a = mesh.points.row(mesh.triangles(t, 0));
  return 0.5 *
    (mesh.points.row(mesh.triangles(t, 1)) - a).cross(mesh.points.row(mesh.triangles(t, 2)) - a);
}

/// The parts of each triangle cover it, none turned over; points come first, edges are edges.
void expectSameShape(const ImprintedSurface& made, const TriangleMesh& given)
{
  EXPECT_EQ(made.mesh.points.topRows(given.points.rows()), given.points);
  const hexsweep::SurfaceTopology before =
    hexsweep::checkSurface(given.triangles, given.points.rows(), "given");
  const hexsweep::SurfaceTopology after =
    hexsweep::checkSurface(made.mesh.triangles, made.mesh.points.rows(), "imprinted");
  EXPECT_EQ(before.eulerCharacteristic, after.eulerCharacteristic);
  EXPECT_EQ(before.loops.size(), after.loops.size());
  Points sums = Points::Zero(given.triangles.rows(), 3);
  for (Index t = 0; t < made.mesh.triangles.rows(); ++t)
  {
    const Index origin = made.triangleOrigin[static_cast<std::size_t>(t)];
    const Eigen::RowVector3d part = areaOf(made.mesh, t);
    EXPECT_GE(part.dot(areaOf(given, origin)), 0.0);
    sums.row(origin) += part;
  }
  for (Index t = 0; t < given.triangles.rows(); ++t)
  {
    EXPECT_LE((sums.row(t) - areaOf(given, t)).norm(), 1e-13);
  }
}

TEST(BorderImprint, StraightLinesBecomeEdges)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> inside(0.02, 0.98);
  for (int trial = 0; trial < 50; ++trial)
  {
    const TriangleMesh plate = test::plate(12, {}, 0.3, static_cast<unsigned>(trial));
    const double x = inside(generator);
    const double y = inside(generator);
    const double end = inside(generator);
    const BorderLines lines = chain({ { x, 0, 0 }, { x, y, 0 }, { 1, end, 0 } }, true);
    const auto made = hexsweep::imprintBorders(baseOf(plate), lines);
    ASSERT_TRUE(made);
    expectSameShape(*made, plate);
    EXPECT_NEAR(lengthOf(*made), y + std::hypot(1 - x, end - y), 1e-6);
    for (Index i = 0; i < 3; ++i)
    {
      EXPECT_LE(
        (made->mesh.points.row(made->pointOf[static_cast<std::size_t>(i)]) - lines.points.row(i))
          .norm(),
        1e-6);
    }
  }
}

TEST(BorderImprint, ALineCrossesABorderInAPointOfBoth)
{
  TriangleMesh square{ Points(4, 3), Triangles(2, 3) };
  square.points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  square.triangles << 0, 1, 2, 0, 2, 3;
  ImprintBase base = baseOf(square);
  base.faceIds = { 1, 2 };
  const auto made = hexsweep::imprintBorders(base, chain({ { 0.25, 0, 0 }, { 0.25, 1, 0 } }, true));
  ASSERT_TRUE(made);
  expectSameShape(*made, square);
  ASSERT_EQ(made->edges.size(), 2u);
  Index crossing = -1;
  for (Index i = 4; i < made->mesh.points.rows(); ++i)
  {
    crossing = made->mesh.points(i, 0) == 0.25 && made->mesh.points(i, 1) == 0.25 ? i : crossing;
  }
  EXPECT_GE(crossing, 4);
}

TEST(BorderImprint, LinesOverAHillStayOnItsTriangles)
{
  const TriangleMesh hill = curvedPlate(0, 0.3, 0.3);
  const BorderLines lines =
    chain({ { 0, 0.31, 0 }, { 0.4, 0.37, 0.3 * bump(0.4, 0.37) }, { 1, 0.83, 0 } }, true);
  const auto made = hexsweep::imprintBorders(baseOf(hill), lines);
  ASSERT_TRUE(made);
  expectSameShape(*made, hill);
  const hexsweep::TriangleSearch search(hill.points, hill.triangles);
  for (Index i = 0; i < made->mesh.points.rows(); ++i)
  {
    EXPECT_LE(search.closest(made->mesh.points.row(i)).distance, 1e-14);
  }
  // One way, from end to end.
  std::map<Index, int> count;
  for (const hexsweep::ImprintedEdge& edge : made->edges)
  {
    ++count[edge.ends.first];
    ++count[edge.ends.second];
  }
  for (const auto& [point, edges] : count)
  {
    EXPECT_EQ(edges, point == made->pointOf[0] || point == made->pointOf[2] ? 1 : 2);
  }
}

TEST(BorderImprint, FacetsOfOneCircleFollowEachOther)
{
  // Faces within and beyond half the radius; the lines are another polygon of the same circle.
  const TriangleMesh mesh = disk(8, 24);
  ImprintBase base = baseOf(mesh);
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
    for (Index c = 0; c < 3; ++c)
    {
      middle += mesh.points.row(mesh.triangles(t, c)) / 3.0;
    }
    base.faceIds[static_cast<std::size_t>(t)] = middle.norm() < 0.5 ? 1 : 2;
  }
  BorderLines lines;
  constexpr Index N = 17;
  lines.points.resize(N, 3);
  for (Index j = 0; j < N; ++j)
  {
    const double angle = 0.1 + 2.0 * Pi * static_cast<double>(j) / static_cast<double>(N);
    lines.points.row(j) << 0.5 * std::cos(angle), 0.5 * std::sin(angle), 0.0;
    lines.onBoundary.push_back(false);
    lines.pieces.emplace_back(j, (j + 1) % N);
  }
  const auto made = hexsweep::imprintBorders(base, lines);
  ASSERT_TRUE(made);
  expectSameShape(*made, mesh);
  // The length of the mesh's own polygon, not that of the lines.
  EXPECT_NEAR(lengthOf(*made), 24 * 2 * 0.5 * std::sin(Pi / 24), 1e-12);
}

TEST(BorderImprint, NearnessToABorderIsWhatTheCallerSays)
{
  TriangleMesh two{ Points(6, 3), Triangles(4, 3) };
  two.points << 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0;
  two.triangles << 0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4;
  ImprintBase base = baseOf(two);
  base.faceIds = { 1, 1, 2, 2 };
  const BorderLines lines = chain({ { 1.01, 0, 0 }, { 1.01, 1, 0 } }, true);
  base.snap = 0.02;
  const auto one = hexsweep::imprintBorders(base, lines);
  ASSERT_TRUE(one);
  EXPECT_EQ(one->mesh.points.rows(), 6);
  ASSERT_EQ(one->edges.size(), 1u);
  EXPECT_EQ(one->edges[0].ends, (std::pair<Index, Index>(1, 4)));
  base.snap = 0.005;
  const auto other = hexsweep::imprintBorders(base, lines);
  ASSERT_TRUE(other);
  expectSameShape(*other, two);
  EXPECT_EQ(other->edges.size(), 2u); // a diagonal is crossed
  base.undivided = { { 2, 1 }, { 4, 5 } };
  const auto whole = hexsweep::imprintBorders(base, lines);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->mesh.points.rows(), 6);
}
}
