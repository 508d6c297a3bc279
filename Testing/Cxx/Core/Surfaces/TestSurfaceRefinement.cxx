// SPDX-License-Identifier: BSD-3-Clause
// Refinement changes no shape: areas, normals and places are those of the triangles it came from.
#include "Core/Surfaces/SurfaceRefinement.h"

#include "Core/Geometry/TriangleSearch.h"
#include "Support/CapMeshes.h"

namespace TestSurfaceRefinement
{
using hexsweep::EdgeSubdivision;
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::RefinedSurface;
using hexsweep::TriangleMesh;
using Vector = Eigen::RowVector3d;

/// A regular polygon cut into a fan of triangles from its first corner: nothing but chords.
TriangleMesh facet(Index corners)
{
  TriangleMesh mesh;
  mesh.points.resize(corners, 3);
  std::vector<Index> ids;
  for (Index i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * test::Pi * static_cast<double>(i) / static_cast<double>(corners);
    mesh.points.row(i) << std::cos(angle), std::sin(angle), 0.3 * std::cos(2 * angle);
    if (i > 1)
    {
      ids.insert(ids.end(), { 0, i - 1, i });
    }
  }
  mesh.triangles = test::facesOf<hexsweep::Triangles>(ids);
  return mesh;
}

/// Twice the vector area.
Vector normalOf(const TriangleMesh& mesh, Index t)
{
  const auto p = [&](Index c) { return Vector(mesh.points.row(mesh.triangles(t, c))); };
  return (p(1) - p(0)).cross(p(2) - p(0));
}

/// Inner edges with both ends on one loop.
Index chords(const TriangleMesh& mesh)
{
  const auto topology = hexsweep::checkSurface(mesh.triangles, mesh.points.rows(), "mesh");
  std::vector<Index> loopOf(static_cast<std::size_t>(mesh.points.rows()), -1);
  std::map<std::pair<Index, Index>, bool> boundary;
  for (std::size_t l = 0; l < topology.loops.size(); ++l)
  {
    const Loop& loop = topology.loops[l];
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      loopOf[static_cast<std::size_t>(loop[i])] = static_cast<Index>(l);
      boundary[{ loop[i], loop[(i + 1) % loop.size()] }] = true;
    }
  }
  Index count = 0;
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index a = mesh.triangles(t, c);
      const Index b = mesh.triangles(t, (c + 1) % 3);
      const Index loop = loopOf[static_cast<std::size_t>(a)];
      count +=
        loop >= 0 && loop == loopOf[static_cast<std::size_t>(b)] && !boundary.count({ a, b });
    }
  }
  return count;
}

void expectSameShape(const TriangleMesh& mesh, const RefinedSurface& refined)
{
  ASSERT_GE(refined.mesh.points.rows(), mesh.points.rows());
  EXPECT_EQ(refined.mesh.points.topRows(mesh.points.rows()), mesh.points);
  ASSERT_EQ(static_cast<Index>(refined.triangleOrigin.size()), refined.mesh.triangles.rows());

  Eigen::VectorXd area = Eigen::VectorXd::Zero(mesh.triangles.rows());
  for (Index t = 0; t < refined.mesh.triangles.rows(); ++t)
  {
    const Index origin = refined.triangleOrigin[static_cast<std::size_t>(t)];
    const Vector normal = normalOf(refined.mesh, t);
    const Vector original = normalOf(mesh, origin);
    const double size = original.norm();
    area[origin] += normal.norm();
    // Not turned over, and in the plane of its triangle.
    EXPECT_GT(normal.dot(original), 0.0);
    EXPECT_LT(normal.cross(original).norm(), 1e-12 * size * size);
    for (Index c = 0; c < 3; ++c)
    {
      EXPECT_LT(
        hexsweep::closestPointOnTriangle(refined.mesh.points.row(refined.mesh.triangles(t, c)),
          mesh.points.row(mesh.triangles(origin, 0)), mesh.points.row(mesh.triangles(origin, 1)),
          mesh.points.row(mesh.triangles(origin, 2)))
          .distance,
        1e-14);
    }
  }
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    EXPECT_NEAR(area[t], normalOf(mesh, t).norm(), 1e-12 * normalOf(mesh, t).norm());
  }
  const auto before = hexsweep::checkSurface(mesh.triangles, mesh.points.rows(), "mesh");
  const auto after =
    hexsweep::checkSurface(refined.mesh.triangles, refined.mesh.points.rows(), "mesh");
  EXPECT_EQ(after.eulerCharacteristic, before.eulerCharacteristic);
  EXPECT_EQ(after.loops.size(), before.loops.size());
}

TEST(SurfaceRefinement, NothingToDoChangesNothing)
{
  const TriangleMesh mesh = test::curvedPlate(3, 0.3);
  const RefinedSurface refined = hexsweep::refineSurface(mesh, {}, false);
  EXPECT_EQ(refined.mesh.points, mesh.points);
  EXPECT_EQ(refined.mesh.triangles.rows(), mesh.triangles.rows());
  EXPECT_TRUE(refined.inserted.empty());
  expectSameShape(mesh, refined);
}

TEST(SurfaceRefinement, PointsAreInsertedWhereTheFractionsSay)
{
  const TriangleMesh mesh = test::curvedPlate(3, 0.3);
  std::vector<EdgeSubdivision> subdivisions;
  // Boundary edges of all loops, in both directions, and some inner edges.
  for (const Loop& loop : test::loopsOf(mesh))
  {
    for (std::size_t i = 0; i < loop.size(); i += 2)
    {
      const Index a = loop[i];
      const Index b = loop[(i + 1) % loop.size()];
      subdivisions.push_back(
        i % 4 ? EdgeSubdivision{ a, b, { 0.1, 0.25, 0.9 } } : EdgeSubdivision{ b, a, { 0.3 } });
    }
  }
  std::map<std::pair<Index, Index>, int> sides;
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    const Index a = mesh.triangles(t, 0);
    const Index b = mesh.triangles(t, 1);
    if (t % 5 == 0 && ++sides[{ std::min(a, b), std::max(a, b) }] == 1)
    {
      bool known = false;
      for (const EdgeSubdivision& s : subdivisions)
      {
        known = known || (s.from == a && s.to == b) || (s.from == b && s.to == a);
      }
      if (!known)
      {
        subdivisions.push_back({ a, b, { 0.2, 0.7 } });
      }
    }
  }
  const RefinedSurface refined = hexsweep::refineSurface(mesh, subdivisions, false);
  expectSameShape(mesh, refined);
  ASSERT_EQ(refined.inserted.size(), subdivisions.size());
  Index added = 0;
  for (std::size_t s = 0; s < subdivisions.size(); ++s)
  {
    const EdgeSubdivision& sub = subdivisions[s];
    ASSERT_EQ(refined.inserted[s].size(), sub.fractions.size());
    for (std::size_t k = 0; k < sub.fractions.size(); ++k, ++added)
    {
      const double f = sub.fractions[k];
      const Vector expected = (1.0 - f) * mesh.points.row(sub.from) + f * mesh.points.row(sub.to);
      EXPECT_LT((refined.mesh.points.row(refined.inserted[s][k]) - expected).norm(), 1e-15);
      EXPECT_GE(refined.inserted[s][k], mesh.points.rows());
    }
  }
  EXPECT_EQ(refined.mesh.points.rows(), mesh.points.rows() + added);
}

TEST(SurfaceRefinement, NoChordIsLeft)
{
  const TriangleMesh curved = test::curvedPlate(3, 0.3);
  for (const TriangleMesh& mesh : { facet(4), facet(5), facet(60), curved, test::plate(1, {}),
         test::plate(3, { { 1, 1, 1, 1 } }) })
  {
    const Index before = chords(mesh);
    const RefinedSurface refined = hexsweep::refineSurface(mesh, {}, true);
    expectSameShape(mesh, refined);
    EXPECT_EQ(chords(refined.mesh), 0);
    // Each chord was counted from both sides and is halved once.
    EXPECT_EQ(refined.mesh.points.rows(), mesh.points.rows() + before / 2);
  }
  EXPECT_EQ(chords(facet(60)), 2 * 57);
}

TEST(SurfaceRefinement, ChordsThatASubdivisionMakesAreSplitToo)
{
  // The point on the boundary edge is joined to the opposite corner, which lies on the loop.
  const TriangleMesh mesh = facet(6);
  const RefinedSurface refined =
    hexsweep::refineSurface(mesh, { { 2, 3, { 0.5 } }, { 1, 0, { 0.25, 0.5 } } }, true);
  expectSameShape(mesh, refined);
  EXPECT_EQ(chords(refined.mesh), 0);
}

TEST(SurfaceRefinement, EdgesBetweenTwoLoopsStay)
{
  const TriangleMesh mesh = test::annulus(0.5, 1.0, 2, 12);
  const RefinedSurface refined = hexsweep::refineSurface(mesh, {}, true);
  EXPECT_EQ(refined.mesh.points, mesh.points);
}

TEST(SurfaceRefinement, WrongInput)
{
  const TriangleMesh mesh = test::plate(3, {});
  test::expectInvalid(
    [&] {
      hexsweep::refineSurface(mesh, { { 0, mesh.points.rows() - 1, { 0.5 } } }, false);
    },
    "no edge between points 0 and");
  TriangleMesh fan = facet(4);
  fan.triangles = test::facesOf<hexsweep::Triangles>({ 0, 1, 2, 1, 0, 3, 0, 1, 3 });
  EXPECT_THROW(hexsweep::refineSurface(fan, {}, true), hexsweep::InvalidInput);
}
}
