// SPDX-License-Identifier: BSD-3-Clause
// Loops and Euler characteristic of plates with known holes; every kind of invalid mesh.
#include "Core/Surfaces/SurfaceTopology.h"

#include "Support/CapMeshes.h"

#include <numeric>
#include <set>

namespace TestSurfaceTopology
{
using hexsweep::checkCap;
using hexsweep::checkSurface;
using hexsweep::Faces;
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::Triangles;
using test::expectInvalid;
using test::facesOf;

/// A torus of n x n squares, one left out when `open`.
hexsweep::Quads torus(Index n, bool open)
{
  std::vector<Index> ids;
  for (Index q = open ? 1 : 0; q < n * n; ++q)
  {
    const Index i = q / n;
    const Index j = q % n;
    const Index k = (i + 1) % n;
    const Index l = (j + 1) % n;
    ids.insert(ids.end(), { i * n + j, k * n + j, k * n + l, i * n + l });
  }
  return facesOf<hexsweep::Quads>(ids);
}

/// A band of n squares; its ends are joined after half a turn when `twisted`.
hexsweep::Quads band(Index n, bool twisted)
{
  std::vector<Index> ids;
  for (Index i = 0; i < n; ++i)
  {
    const bool last = i + 1 == n;
    const Index low = last ? (twisted ? 1 : 0) : 2 * i + 2;
    const Index high = last ? (twisted ? 0 : 1) : 2 * i + 3;
    ids.insert(ids.end(), { 2 * i, low, high, 2 * i + 1 });
  }
  return facesOf<hexsweep::Quads>(ids);
}

Triangles tetrahedron()
{
  return facesOf<Triangles>({ 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2 });
}

void expectBad(const hexsweep::FacesRef& faces, Index points, const std::string& part)
{
  expectInvalid([&] { checkSurface(faces, points, "test mesh"); }, part);
  // The mesh is named in the message.
  expectInvalid([&] { checkSurface(faces, points, "test mesh"); }, "test mesh");
}

double signedArea(const hexsweep::Points& points, const Loop& loop)
{
  double area = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const auto p = points.row(loop[i]);
    const auto q = points.row(loop[(i + 1) % loop.size()]);
    area += 0.5 * (p.x() * q.y() - p.y() * q.x());
  }
  return area;
}

TEST(SurfaceTopology, PlatesWithHoles)
{
  const std::vector<test::Block> blocks = test::threeHoles();
  const double areas[4] = { 1.0, 4.0 / 144, 6.0 / 144, 6.0 / 144 };
  for (std::size_t holes = 0; holes <= 3; ++holes)
  {
    const std::vector<test::Block> some(blocks.begin(), blocks.begin() + static_cast<long>(holes));
    const auto triangles = test::plate(12, some);
    const auto quads = test::quadPlate(12, some);
    for (const Faces& faces : { Faces(triangles.triangles), Faces(quads.quads) })
    {
      const auto topology = checkSurface(faces, triangles.points.rows(), "plate");
      EXPECT_EQ(topology.numberOfComponents, 1);
      EXPECT_EQ(topology.eulerCharacteristic, 1 - static_cast<Index>(holes));
      ASSERT_EQ(topology.loops.size(), 1 + holes);
      EXPECT_NO_THROW(checkCap(topology, "plate"));
      std::vector<double> found;
      for (const Loop& loop : topology.loops)
      {
        EXPECT_EQ(loop.front(), *std::min_element(loop.begin(), loop.end()));
        found.push_back(signedArea(triangles.points, loop));
      }
      EXPECT_TRUE(std::is_sorted(topology.loops.begin(), topology.loops.end()));
      // The surface lies on the left: the outer loop runs counter-clockwise, holes clockwise.
      std::sort(found.begin(), found.end());
      EXPECT_NEAR(found.back(), areas[0], 1e-12);
      std::vector<double> expected;
      for (std::size_t h = 1; h <= holes; ++h)
      {
        expected.push_back(-areas[h]);
      }
      std::sort(expected.begin(), expected.end());
      for (std::size_t h = 0; h < holes; ++h)
      {
        EXPECT_NEAR(found[h], expected[h], 1e-12);
      }
    }
  }
}

TEST(SurfaceTopology, LoopsAreExactlyTheEdgesWithOneFace)
{
  const auto mesh = test::plate(12, test::threeHoles());
  std::set<std::pair<Index, Index>> sides;
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      sides.emplace(mesh.triangles(t, c), mesh.triangles(t, (c + 1) % 3));
    }
  }
  std::set<std::pair<Index, Index>> single;
  for (const auto& side : sides)
  {
    if (!sides.count({ side.second, side.first }))
    {
      single.insert(side);
    }
  }
  std::set<std::pair<Index, Index>> found;
  for (const Loop& loop : checkSurface(mesh.triangles, mesh.points.rows(), "plate").loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      found.emplace(loop[i], loop[(i + 1) % loop.size()]);
    }
  }
  EXPECT_EQ(found, single);
}

TEST(SurfaceTopology, UnusedPointsDoNotCount)
{
  const auto mesh = test::plate(4, {});
  const Triangles shifted = mesh.triangles.array() + 7;
  const auto topology = checkSurface(shifted, mesh.points.rows() + 20, "plate");
  EXPECT_EQ(topology.numberOfComponents, 1);
  EXPECT_EQ(topology.eulerCharacteristic, 1);
}

TEST(SurfaceTopology, ClosedSurfacesAndHandles)
{
  const auto sphere = checkSurface(tetrahedron(), 4, "sphere");
  EXPECT_EQ(sphere.eulerCharacteristic, 2);
  EXPECT_TRUE(sphere.loops.empty());
  expectInvalid([&] { checkCap(sphere, "sphere"); }, "closed surface");

  const auto closed = checkSurface(torus(5, false), 25, "torus");
  EXPECT_EQ(closed.eulerCharacteristic, 0);
  expectInvalid([&] { checkCap(closed, "torus"); }, "closed surface");

  const auto open = checkSurface(torus(5, true), 25, "torus");
  EXPECT_EQ(open.eulerCharacteristic, -1);
  ASSERT_EQ(open.loops.size(), 1u);
  EXPECT_EQ(open.loops[0].size(), 4u);
  expectInvalid([&] { checkCap(open, "torus"); }, "genus 1");

  const auto cylinder = checkSurface(band(6, false), 12, "band");
  EXPECT_EQ(cylinder.loops.size(), 2u);
  EXPECT_NO_THROW(checkCap(cylinder, "band"));
}

TEST(SurfaceTopology, TwoPiecesAreNoCap)
{
  const auto topology = checkSurface(facesOf<Triangles>({ 0, 1, 2, 3, 4, 5 }), 6, "pair");
  EXPECT_EQ(topology.numberOfComponents, 2);
  EXPECT_EQ(topology.loops.size(), 2u);
  expectInvalid([&] { checkCap(topology, "pair"); }, "2 pieces");
}

TEST(SurfaceTopology, NoFaces)
{
  expectBad(Triangles(0, 3), 0, "no faces");
}

TEST(SurfaceTopology, IdsOutsideTheMesh)
{
  expectBad(facesOf<Triangles>({ 0, 1, 3 }), 3, "point 3");
  expectBad(facesOf<Triangles>({ 0, -1, 2 }), 3, "point -1");
}

TEST(SurfaceTopology, FaceWithARepeatedPoint)
{
  expectBad(facesOf<Triangles>({ 0, 1, 2, 2, 1, 2 }), 3, "uses point 2 twice");
  expectBad(facesOf<hexsweep::Quads>({ 0, 1, 2, 0 }), 3, "uses point 0 twice");
}

TEST(SurfaceTopology, ThreeFacesAtAnEdge)
{
  expectBad(facesOf<Triangles>({ 0, 1, 2, 1, 0, 3, 0, 1, 4 }), 5, "more than two faces");
}

TEST(SurfaceTopology, DuplicateFace)
{
  expectBad(facesOf<Triangles>({ 0, 1, 2, 0, 1, 2 }), 3, "opposite orientation");
  expectBad(facesOf<Triangles>({ 0, 1, 2, 1, 3, 2, 1, 3, 2 }), 4, "more than two faces");
}

TEST(SurfaceTopology, MixedOrientation)
{
  expectBad(facesOf<Triangles>({ 0, 1, 2, 1, 2, 3 }), 4, "opposite orientation");
}

TEST(SurfaceTopology, BowTieOnTheBoundary)
{
  expectBad(facesOf<Triangles>({ 0, 1, 2, 0, 3, 4 }), 5, "point 0");
}

TEST(SurfaceTopology, ConesThatShareTheirApex)
{
  // Both fans about point 0 are closed, so that no boundary chain gives it away.
  expectBad(facesOf<Triangles>({ 0, 1, 2, 0, 2, 3, 0, 3, 1, 0, 4, 5, 0, 5, 6, 0, 6, 4 }), 7,
    "touch in point 0");
  // One closed fan and one open one.
  expectBad(facesOf<Triangles>({ 0, 1, 2, 0, 2, 3, 0, 3, 1, 0, 4, 5 }), 6, "touch in point 0");
}

TEST(SurfaceTopology, MoebiusStrip)
{
  expectBad(band(5, true), 10, "opposite orientation");
  expectInvalid([] { hexsweep::orientFaces(band(5, true), "strip"); }, "Moebius");
}

TEST(SurfaceTopology, OrientFacesUndoesAnyFlips)
{
  std::mt19937 generator(5);
  const Faces cases[3] = { test::plate(12, test::threeHoles()).triangles,
    test::quadPlate(12, test::threeHoles()).quads, tetrahedron() };
  for (const Faces& faces : cases)
  {
    Faces shaken = faces;
    for (Index f = 1; f < faces.rows(); ++f)
    {
      if (generator() % 2)
      {
        shaken.row(f) = faces.row(f).reverse().eval();
      }
    }
    const Faces oriented = hexsweep::orientFaces(shaken, "mesh");
    ASSERT_EQ(oriented.rows(), faces.rows());
    EXPECT_EQ(oriented.col(0), shaken.col(0));
    EXPECT_NO_THROW(checkSurface(oriented, 1000, "mesh"));
    EXPECT_EQ(Faces(oriented.row(0)), Faces(faces.row(0)));
    for (Index f = 0; f < faces.rows(); ++f)
    {
      // The first face was right: all others must be as they were, from some corner on.
      Index start = 0;
      while (faces(f, start) != oriented(f, 0))
      {
        ++start;
      }
      for (Index c = 0; c < faces.cols(); ++c)
      {
        EXPECT_EQ(oriented(f, c), faces(f, (start + c) % faces.cols()));
      }
    }
  }
  expectInvalid(
    [] {
      hexsweep::orientFaces(facesOf<Triangles>({ 0, 1, 2, 0, 1, 3, 0, 1, 4 }), "mesh");
    },
    "more than two faces");
}

TEST(SurfaceTopology, NeighborsShareTheEdge)
{
  const Triangles triangles = test::plate(6, { { 2, 2, 1, 1 } }).triangles;
  const Triangles neighbors = hexsweep::triangleNeighbors(triangles);
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      Index expected = -1;
      for (Index s = 0; s < triangles.rows(); ++s)
      {
        for (Index d = 0; d < 3; ++d)
        {
          if (triangles(s, d) == triangles(t, (c + 1) % 3) &&
            triangles(s, (d + 1) % 3) == triangles(t, c))
          {
            expected = s;
          }
        }
      }
      EXPECT_EQ(neighbors(t, c), expected);
    }
  }
}

TEST(SurfaceTopology, AFaceThatIsThereTwiceIsNamedAsSuch)
{
  const hexsweep::QuadMesh mesh = test::quadPlate(3, {});
  hexsweep::Quads twice(mesh.quads.rows() + 1, 4);
  twice << mesh.quads, mesh.quads.row(0);
  test::expectInvalid(
    [&] { hexsweep::checkSurface(twice, mesh.points.rows(), "quads"); }, "duplicate faces");
}
}
