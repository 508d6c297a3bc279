// SPDX-License-Identifier: BSD-3-Clause
// What remeshing keeps, and what it reaches: on plates and on a curved cap.
#include "Core/CapQuads/TriangleRemesher.h"

#include "Support/CapMeshes.h"
#include "Support/StretchedCaps.h"

#include "Core/CapQuads/SurfaceRemeshing.h"
#include "Core/Geometry/TriangleSearch.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace TestTriangleRemesher
{
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::RemeshedSurface;
using hexsweep::RemeshingInput;
using hexsweep::SurfaceSearch;
using hexsweep::TriangleMesh;
using hexsweep::TriangleRemesher;

constexpr double Growth = 0.3;

/// All loops are curves that stay as they are.
RemeshingInput keepingLoops(const TriangleMesh& mesh)
{
  RemeshingInput input{ mesh, {}, test::boundaryFlags(mesh) };
  for (Loop loop : test::loopsOf(mesh))
  {
    loop.push_back(loop.front());
    input.curves.push_back(loop);
  }
  return input;
}

/// By its ends, the lower id first.
using Edge = std::pair<Index, Index>;

/// Opposite corners of each edge: two inside, one on the boundary.
std::map<Edge, std::vector<Index>> cornersAcross(const TriangleMesh& mesh)
{
  std::map<Edge, std::vector<Index>> result;
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      result[std::minmax(mesh.triangles(t, c), mesh.triangles(t, (c + 1) % 3))].push_back(
        mesh.triangles(t, (c + 2) % 3));
    }
  }
  return result;
}

/// Edges with a corner inside the circle through the triangle across by more than a part of it.
std::set<Edge> notDelaunay(const TriangleMesh& mesh, double part)
{
  std::set<Edge> result;
  for (const auto& [edge, across] : cornersAcross(mesh))
  {
    if (across.size() == 2)
    {
      const auto p = [&](Index i) -> Eigen::RowVector3d { return mesh.points.row(i); };
      Eigen::RowVector3d a = p(edge.first);
      Eigen::RowVector3d b = p(edge.second);
      if ((b - a).cross(p(across[0]) - a).z() < 0.0)
      {
        std::swap(a, b);
      }
      if (test::isInCircle(a, b, p(across[0]), p(across[1]), part))
      {
        result.insert(edge);
      }
    }
  }
  return result;
}

double leastArea(const TriangleMesh& plane)
{
  double least = 1e9;
  for (Index t = 0; t < plane.triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = plane.points.row(plane.triangles(t, 0));
    const Eigen::RowVector3d b = plane.points.row(plane.triangles(t, 1));
    const Eigen::RowVector3d c = plane.points.row(plane.triangles(t, 2));
    least = std::min(least, 0.5 * (b - a).cross(c - a).z());
  }
  return least;
}

void expectKept(const RemeshingInput& input, const RemeshedSurface& result)
{
  ASSERT_EQ(result.pointOf.size(), input.stays.size());
  Index kept = 0;
  for (std::size_t i = 0; i < input.stays.size(); ++i)
  {
    if (input.stays[i])
    {
      ++kept;
      ASSERT_GE(result.pointOf[i], 0) << i;
      EXPECT_EQ(
        result.mesh.points.row(result.pointOf[i]), input.mesh.points.row(static_cast<Index>(i)));
    }
  }
  EXPECT_GT(kept, 3);
}

void expectSameTopology(const TriangleMesh& before, const TriangleMesh& after)
{
  const auto old = hexsweep::checkSurface(before.triangles, before.points.rows(), "before");
  const auto now = hexsweep::checkSurface(after.triangles, after.points.rows(), "after");
  EXPECT_EQ(now.numberOfComponents, old.numberOfComponents);
  EXPECT_EQ(now.eulerCharacteristic, old.eulerCharacteristic);
  EXPECT_EQ(now.loops.size(), old.loops.size());
}

/// A polygon, counter-clockwise, whose corners stay, and triangles from a point in it.
RemeshingInput fan(const hexsweep::Points& polygon, const Eigen::RowVector3d& middle)
{
  const Index n = polygon.rows();
  RemeshingInput input;
  input.mesh.points.resize(n + 1, 3);
  input.mesh.points << polygon, middle;
  input.mesh.triangles.resize(n, 3);
  for (Index j = 0; j < n; ++j)
  {
    input.mesh.triangles.row(j) << j, (j + 1) % n, n;
  }
  input.stays.assign(static_cast<std::size_t>(n), true);
  input.stays.push_back(false);
  return input;
}

hexsweep::Points relaxed(const RemeshingInput& input)
{
  const SurfaceSearch surface(input.mesh);
  TriangleRemesher remesher(input, surface, 1.0, Growth);
  remesher.relax();
  const RemeshedSurface result = remesher.result();
  expectKept(input, result);
  EXPECT_GT(leastArea(result.mesh), 0.0);
  return result.mesh.points.row(result.pointOf.back());
}

TEST(TriangleRemesher, FlipsToDelaunay)
{
  for (const std::size_t holes : { 0u, 3u })
  {
    std::vector<test::Block> blocks = test::threeHoles();
    blocks.resize(holes);
    const TriangleMesh plate = test::plate(12, blocks, 0.3);
    const RemeshingInput input = keepingLoops(plate);
    const SurfaceSearch surface(plate);
    TriangleRemesher remesher(input, surface, 0.1, Growth);
    EXPECT_GT(notDelaunay(plate, 1e-2).size(), 20u);
    EXPECT_GT(remesher.flip(), 20);
    const RemeshedSurface result = remesher.result();
    EXPECT_TRUE(notDelaunay(result.mesh, 1e-5).empty());
    EXPECT_GT(leastArea(result.mesh), 0.0);
    EXPECT_EQ(result.mesh.points.rows(), plate.points.rows());
    EXPECT_NEAR(test::surfaceArea(result.mesh), test::surfaceArea(plate), 1e-13);
    EXPECT_EQ(remesher.flip(), 0);
  }
}

TEST(TriangleRemesher, FlipsNoCurve)
{
  const TriangleMesh plate = test::plate(12, {}, 0.3);
  RemeshingInput input = keepingLoops(plate);
  // Edges that are not Delaunay, as curves of one edge.
  const std::set<Edge> wrong = notDelaunay(plate, 1e-2);
  for (const Edge& edge : wrong)
  {
    input.curves.push_back({ edge.first, edge.second });
    input.stays[static_cast<std::size_t>(edge.first)] = true;
    input.stays[static_cast<std::size_t>(edge.second)] = true;
  }
  ASSERT_GT(wrong.size(), 20u);
  const SurfaceSearch surface(plate);
  TriangleRemesher remesher(input, surface, 0.1, Growth);
  remesher.flip();
  const RemeshedSurface result = remesher.result();
  std::set<Edge> kept;
  const auto edges = cornersAcross(result.mesh);
  for (const Edge& edge : wrong)
  {
    const Edge now = std::minmax(result.pointOf[static_cast<std::size_t>(edge.first)],
      result.pointOf[static_cast<std::size_t>(edge.second)]);
    EXPECT_EQ(edges.count(now), 1u);
    kept.insert(now);
  }
  const std::set<Edge> stillWrong = notDelaunay(result.mesh, 1e-5);
  EXPECT_FALSE(stillWrong.empty());
  for (const Edge& edge : stillWrong)
  {
    EXPECT_EQ(kept.count(edge), 1u);
  }
}

TEST(TriangleRemesher, EdgesAreAboutAsLongAsWanted)
{
  for (const std::size_t holes : { 0u, 3u })
  {
    std::vector<test::Block> blocks = test::threeHoles();
    blocks.resize(holes);
    const TriangleMesh plate = test::plate(12, blocks, 0.3);
    const RemeshingInput input = keepingLoops(plate);
    const SurfaceSearch surface(plate);
    const double size = 1.0 / 12.0; // as the edges of the boundary are
    const RemeshedSurface result = remeshSurface(input, surface, size, Growth);
    expectKept(input, result);
    expectSameTopology(plate, result.mesh);
    EXPECT_GT(leastArea(result.mesh), 0.0);
    EXPECT_NEAR(test::surfaceArea(result.mesh), test::surfaceArea(plate), 1e-13);
    double sum = 0.0;
    double count = 0.0;
    for (const auto& [edge, across] : cornersAcross(result.mesh))
    {
      const double length =
        (result.mesh.points.row(edge.first) - result.mesh.points.row(edge.second)).norm() / size;
      EXPECT_GT(length, 0.6);
      EXPECT_LT(length, 1.5);
      sum += length;
      count += 1.0;
    }
    EXPECT_NEAR(sum / count, 1.0, 0.1);
  }
}

// Fine edges round one hole, and lengths that grow with the distance from there.
TEST(TriangleRemesher, LengthsGrowFromFineCurves)
{
  constexpr Index Fine = 96;
  const double inner = 0.2;
  const TriangleMesh ring = test::annulus(inner, 2.0, 60, Fine);
  RemeshingInput input = keepingLoops(ring);
  const SurfaceSearch surface(ring);
  const double size = 0.3;
  const double growth = 0.2;
  const RemeshedSurface result = remeshSurface(input, surface, size, growth);
  expectKept(input, result);
  const double spacing = 2.0 * inner * std::sin(test::Pi / static_cast<double>(Fine));
  const double outerSpacing = 10.0 * spacing;
  double longest = 0.0;
  for (const auto& [edge, across] : cornersAcross(result.mesh))
  {
    const Eigen::RowVector3d a = result.mesh.points.row(edge.first);
    const Eigen::RowVector3d b = result.mesh.points.row(edge.second);
    const double length = (a - b).norm();
    const double reach = 0.5 * (a.norm() + b.norm());
    const double wanted =
      std::min({ size, spacing + growth * (reach - inner), outerSpacing + growth * (2.0 - reach) });
    EXPECT_LT(length, 1.6 * wanted) << a << ", " << b;
    EXPECT_GT(length, 0.5 * wanted) << a << ", " << b;
    longest = std::max(longest, length);
  }
  EXPECT_GT(longest, 15.0 * spacing);
}

TEST(TriangleRemesher, CurvedCapStaysOnItsSurface)
{
  const TriangleMesh cap = test::curvedPlate(2, 0.2, 0.5);
  const RemeshingInput input = keepingLoops(cap);
  const SurfaceSearch surface(cap);
  const RemeshedSurface result = remeshSurface(input, surface, 0.06, Growth);
  expectKept(input, result);
  expectSameTopology(cap, result.mesh);
  const hexsweep::TriangleSearch search(cap.points, cap.triangles);
  const hexsweep::Points normals = surface.project(result.mesh.points).normals;
  for (Index i = 0; i < result.mesh.points.rows(); ++i)
  {
    EXPECT_LT(search.closest(result.mesh.points.row(i)).distance, 1e-15);
  }
  for (Index t = 0; t < result.mesh.triangles.rows(); ++t)
  {
    Eigen::RowVector3d p[3];
    Eigen::RowVector3d up = Eigen::RowVector3d::Zero();
    for (int c = 0; c < 3; ++c)
    {
      p[c] = result.mesh.points.row(result.mesh.triangles(t, c));
      up += normals.row(result.mesh.triangles(t, c));
    }
    EXPECT_GT((p[1] - p[0]).cross(p[2] - p[0]).dot(up), 0.0) << t;
  }
}

// Every second point of a straight boundary may go.
TEST(TriangleRemesher, CurvesAreShortenedToThePointsThatStay)
{
  const TriangleMesh plate = test::plate(12, {}, 0.3);
  RemeshingInput input = keepingLoops(plate);
  for (std::size_t k = 1; k < input.curves[0].size(); k += 2)
  {
    input.stays[static_cast<std::size_t>(input.curves[0][k])] = false;
  }
  const SurfaceSearch surface(plate);
  TriangleRemesher remesher(input, surface, 1.0 / 6.0, Growth);
  remesher.flip();
  EXPECT_EQ(remesher.shortenCurves(), 24);
  remesher.collectGarbage();
  RemeshedSurface result = remesher.result();
  expectKept(input, result);
  for (std::size_t k = 1; k < input.curves[0].size(); k += 2)
  {
    EXPECT_EQ(result.pointOf[static_cast<std::size_t>(input.curves[0][k])], -1);
  }
  expectSameTopology(plate, result.mesh);
  EXPECT_EQ(test::loopsOf(result.mesh)[0].size(), 24u);
  EXPECT_NEAR(test::surfaceArea(result.mesh), 1.0, 1e-13);
  EXPECT_GT(leastArea(result.mesh), 0.0);
}

TEST(TriangleRemesher, SplitsAndCollapsesTowardsTheWantedLength)
{
  const TriangleMesh plate = test::plate(12, {}, 0.2);
  RemeshingInput input{ plate, {},
    std::vector<bool>(static_cast<std::size_t>(plate.points.rows()), false) };
  const SurfaceSearch surface(plate);
  // Longest edges: a diagonal of 1.4 cells and some shaking.
  TriangleRemesher atSize(input, surface, 0.5 / 12.0, Growth);
  const Index splits = atSize.splitLong();
  EXPECT_GT(splits, 100);
  const RemeshedSurface finer = atSize.result();
  EXPECT_EQ(finer.mesh.points.rows(), plate.points.rows() + splits);
  expectSameTopology(plate, finer.mesh);
  EXPECT_NEAR(test::surfaceArea(finer.mesh), 1.0, 1e-13);
  TriangleRemesher fineEnough(input, surface, 2.0 / 12.0, Growth);
  EXPECT_EQ(fineEnough.splitLong(), 0);

  TriangleRemesher coarser(keepingLoops(plate), surface, 4.0 / 12.0, 1.0);
  const Index collapses = coarser.collapseShort();
  EXPECT_GT(collapses, 20);
  coarser.collectGarbage();
  const RemeshedSurface coarse = coarser.result();
  EXPECT_EQ(coarse.mesh.points.rows(), plate.points.rows() - collapses);
  expectSameTopology(plate, coarse.mesh);
  EXPECT_GT(leastArea(coarse.mesh), 0.0);
}

TEST(TriangleRemesher, RelaxesToTheCentroid)
{
  hexsweep::Points corners(4, 3);
  corners << 0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 3.0, 2.0, 0.0, 0.0, 1.0, 0.0;
  // A rectangle of 3 x 1 and a triangle of half its area on it.
  const Eigen::RowVector3d centroid =
    (2.0 * Eigen::RowVector3d(1.5, 0.5, 0.0) + Eigen::RowVector3d(2.0, 4.0 / 3.0, 0.0)) / 3.0;
  for (const double x : { 0.2, 1.0, 2.9 })
  {
    const Eigen::RowVector3d start(x, 0.4, 0.0);
    EXPECT_LT((relaxed(fan(corners, start)) - centroid).norm(), 1e-15) << x;
  }
}

// The centroid of an arrow head lies outside: whatever goes there turns triangles over.
TEST(TriangleRemesher, RelaxingTurnsNoTriangleOver)
{
  hexsweep::Points arrow(4, 3);
  arrow << 0.0, 1.0, 0.0, -4.0, -4.0, 0.0, 0.0, 0.0, 0.0, 4.0, -4.0, 0.0;
  const Eigen::RowVector3d start(0.0, 0.5, 0.0);
  EXPECT_EQ(relaxed(fan(arrow, start)), start);
}
}
