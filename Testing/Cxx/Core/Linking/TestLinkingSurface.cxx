// SPDX-License-Identifier: BSD-3-Clause
// Tubes in pieces, and their ends.
#include "Core/Linking/LinkingSurface.h"

#include "Support/CapMeshes.h"
#include "Support/TubeMeshes.h"

#include <limits>
#include <set>

namespace TestLinkingSurface
{
using hexsweep::Index;
using hexsweep::joinLinkingSurface;
using hexsweep::LinkingSurface;
using hexsweep::Loop;
using hexsweep::Points;
using hexsweep::Quads;
using hexsweep::Triangles;

constexpr double Right = test::Pi / 2.0;

/// The four walls of [-1, 1]^2 x [0, 1], each 2 x 1 quads on six points of its own; the second and
/// the fourth inside out.
LinkingSurface walls()
{
  LinkingSurface surface;
  surface.mesh.points.resize(24, 3);
  std::vector<Index> triangles;
  std::vector<Index> quads;
  for (Index w = 0; w < 4; ++w)
  {
    const double c = std::round(std::cos(Right * static_cast<double>(w)));
    const double s = std::round(std::sin(Right * static_cast<double>(w)));
    for (Index p = 0; p < 6; ++p)
    {
      const double along = static_cast<double>(p % 3) - 1.0;
      surface.mesh.points.row(6 * w + p) << c * along + s, s * along - c, p < 3 ? 0.0 : 1.0;
    }
    for (Index q = 0; q < 2; ++q)
    {
      const Index a = 6 * w + q;
      quads.insert(quads.end(), { a, a + 1, a + 4, a + 3 });
      const Index row = static_cast<Index>(surface.quadOfTriangle.size()) / 2;
      surface.quadOfTriangle.insert(surface.quadOfTriangle.end(), 2, row);
      if (w % 2 == 0)
      {
        triangles.insert(triangles.end(), { a, a + 1, a + 4, a, a + 4, a + 3 });
      }
      else
      {
        triangles.insert(triangles.end(), { a, a + 4, a + 1, a, a + 3, a + 4 });
      }
    }
  }
  surface.mesh.triangles = test::facesOf<Triangles>(triangles);
  surface.quads = test::facesOf<Quads>(quads);
  return surface;
}

/// Two loops, 8 and 4 nodes round, on circles of radius 2 and 1, at heights 0, 1, 2.
Points twoTubes()
{
  std::vector<Eigen::RowVector3d> rows;
  for (const Index n : { 8, 4 })
  {
    for (int k = 0; k <= 2; ++k)
    {
      for (Index j = 0; j < n; ++j)
      {
        const double angle = 2.0 * test::Pi * static_cast<double>(j) / static_cast<double>(n);
        const double radius = n == 8 ? 2.0 : 1.0;
        rows.emplace_back(radius * std::cos(angle), radius * std::sin(angle), k);
      }
    }
  }
  Points points(static_cast<Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    points.row(static_cast<Index>(i)) = rows[i];
  }
  return points;
}

TEST(LinkingSurface, PiecesAreJoinedToATube)
{
  const LinkingSurface given = walls();
  const LinkingSurface surface = joinLinkingSurface(given, 1e-6, test::Pi / 6.0);
  const auto topology =
    hexsweep::checkSurface(surface.mesh.triangles, surface.mesh.points.rows(), "tube");
  ASSERT_EQ(topology.loops.size(), 2u); // each of 8 edges: the walls hang together
  EXPECT_EQ(topology.loops[0].size(), 8u);
  EXPECT_EQ(topology.loops[1].size(), 8u);
  EXPECT_EQ(surface.mesh.points, given.mesh.points);
  // Its normals are all outward or all inward.
  std::set<bool> outward;
  for (Index t = 0; t < surface.mesh.triangles.rows(); ++t)
  {
    const auto corner = [&](int c) -> Eigen::RowVector3d {
      return surface.mesh.points.row(surface.mesh.triangles(t, c));
    };
    const Eigen::RowVector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    const Eigen::RowVector3d center = (corner(0) + corner(1) + corner(2)) / 3.0;
    outward.insert(normal.head<2>().dot(center.head<2>()) > 0.0);
  }
  EXPECT_EQ(outward.size(), 1u);
  // Quads are on the joined points as well, in the same places.
  for (Index i = 0; i < given.quads.size(); ++i)
  {
    EXPECT_EQ(surface.mesh.points.row(surface.quads.data()[i]),
      given.mesh.points.row(given.quads.data()[i]));
  }
  const std::set<Index> used(surface.quads.data(), surface.quads.data() + surface.quads.size());
  EXPECT_EQ(used.size(), 16u);
}

TEST(LinkingSurface, FacesByAngleOnlyWithoutIds)
{
  LinkingSurface given = walls();
  const auto facesAt = [&](double degrees) {
    const auto ids = joinLinkingSurface(given, 1e-6, degrees * test::Pi / 180.0).faceIds;
    return std::set<Index>(ids.begin(), ids.end()).size();
  };
  EXPECT_EQ(facesAt(80.0), 4u);
  EXPECT_EQ(facesAt(100.0), 1u);
  test::expectInvalid([&] { facesAt(0.0); }, "0 and 180");
  test::expectInvalid([&] { facesAt(180.0); }, "0 and 180");
  test::expectInvalid([&] { facesAt(std::numeric_limits<double>::quiet_NaN()); }, "0 and 180");
  given.faceIds.assign(16, 7);
  EXPECT_EQ(facesAt(80.0), 1u);
}

TEST(LinkingSurface, LoopsOfQuads)
{
  const std::vector<Index> rows = hexsweep::loopsOfQuads({ test::numbers(3), test::numbers(4) }, 2);
  EXPECT_EQ(rows, (std::vector<Index>{ 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1 }));
}

TEST(LinkingSurface, TheLastRingsOnTheTarget)
{
  hexsweep::TriangleMesh target = test::annulus(1.0, 2.0, 3, 8);
  target.points.col(2).setConstant(2.0);
  const std::vector<Loop> loops = { test::numbers(8), test::numbers(4) };
  const Points nodes = twoTubes();
  const auto text = [&](const Points& points) {
    return hexsweep::describeMissedTarget(points, loops, 2, target, 1e-6);
  };
  EXPECT_EQ(text(nodes), "");
  Points middle = nodes;
  middle.middleRows(8, 8).col(2).array() += 0.3; // ring 1 of the outer loop
  EXPECT_EQ(text(middle), "");
  Points outer = nodes;
  outer.middleRows(16, 8).col(2).array() += 0.3;
  EXPECT_NE(text(outer).find("target surface"), std::string::npos);
  Points inner = nodes;
  inner.middleRows(24 + 8, 4).col(2).array() += 0.3;
  EXPECT_NE(text(inner).find("last ring of the linking sides"), std::string::npos);
  // A target that names a point twice is no surface.
  target.triangles = Triangles(target.triangles.topRows(1));
  target.triangles(0, 2) = target.triangles(0, 1);
  EXPECT_THROW(text(nodes), hexsweep::InvalidInput);
}
}
