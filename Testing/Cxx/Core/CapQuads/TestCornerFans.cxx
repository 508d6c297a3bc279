// SPDX-License-Identifier: BSD-3-Clause
// Corners of polygons get as many quads as are asked for, and the meshes stay valid.
#include "Core/CapQuads/CapMeshing.h"

#include "Support/CapMeshes.h"

#include <cmath>

namespace TestCornerFans
{
using hexsweep::CapQuadOptions;
using hexsweep::CapQuads;
using hexsweep::CornerFan;
using hexsweep::Index;
using hexsweep::meshCapWithQuads;
using hexsweep::Points;
using hexsweep::TriangleMesh;

/// A regular polygon of radius 1, as a fan about its centre, its last point.
TriangleMesh polygon(Index n)
{
  TriangleMesh cap;
  cap.points = Points::Zero(n + 1, 3);
  cap.triangles.resize(n, 3);
  for (Index j = 0; j < n; ++j)
  {
    const double angle = 2.0 * test::Pi * static_cast<double>(j) / static_cast<double>(n);
    cap.points.row(j) << std::cos(angle), std::sin(angle), 0.0;
    cap.triangles.row(j) << n, j, (j + 1) % n;
  }
  return cap;
}

Index quadsAt(const CapQuads& quads, const Eigen::RowVector3d& place)
{
  Index count = 0;
  for (Index i = 0; i < quads.mesh.quads.size(); ++i)
  {
    count += quads.mesh.points.row(quads.mesh.quads.data()[i]) == place ? 1 : 0;
  }
  return count;
}

double leastAngleAt(const CapQuads& quads, const Eigen::RowVector3d& place)
{
  double least = test::Pi;
  const Points& points = quads.mesh.points;
  for (Index q = 0; q < quads.mesh.quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      if (points.row(quads.mesh.quads(q, c)) == place)
      {
        const Eigen::RowVector3d u = points.row(quads.mesh.quads(q, (c + 1) % 4)) - place;
        const Eigen::RowVector3d v = points.row(quads.mesh.quads(q, (c + 3) % 4)) - place;
        least = std::min(least, std::acos(u.dot(v) / (u.norm() * v.norm())));
      }
    }
  }
  return least;
}

TEST(CornerFans, CornersGetTheQuadsThatTheyAreAskedToHave)
{
  for (const Index n : { 3, 4, 5, 6, 8 })
  {
    for (const double size : { 0.5, 0.2, 0.08 })
    {
      for (const Index wanted : { 2, 3 })
      {
        const TriangleMesh cap = polygon(n);
        CapQuadOptions options;
        options.size = size;
        for (Index j = 0; j < n; ++j)
        {
          options.fans.push_back({ cap.points.row(j), wanted });
        }
        const CapQuads quads = meshCapWithQuads(cap, {}, options);
        const auto topology =
          hexsweep::checkSurface(quads.mesh.quads, quads.mesh.points.rows(), "quads");
        EXPECT_NO_THROW(hexsweep::checkCap(topology, "quads"));
        EXPECT_EQ(quads.inverted, 0) << n << " corners, size " << size;
        const double share =
          test::Pi * (1.0 - 2.0 / static_cast<double>(n)) / static_cast<double>(wanted);
        for (Index j = 0; j < n; ++j)
        {
          EXPECT_GE(quadsAt(quads, cap.points.row(j)), wanted) << n << " corners, size " << size;
          EXPECT_GT(leastAngleAt(quads, cap.points.row(j)), share / 3.0)
            << n << " corners, size " << size;
        }
      }
    }
  }
}

TEST(CornerFans, OnlyTheNodesThatAreNamedChange)
{
  const TriangleMesh cap = polygon(4);
  CapQuadOptions options;
  options.size = 0.1;
  const CapQuads plain = meshCapWithQuads(cap, {}, options);
  EXPECT_EQ(quadsAt(plain, cap.points.row(0)), 1);
  options.fans = { { cap.points.row(0), 2 }, { Eigen::RowVector3d(7.0, 7.0, 7.0), 2 } };
  const CapQuads opened = meshCapWithQuads(cap, {}, options);
  EXPECT_EQ(quadsAt(opened, cap.points.row(0)), 2);
  for (Index j = 1; j < 4; ++j)
  {
    EXPECT_EQ(quadsAt(opened, cap.points.row(j)), quadsAt(plain, cap.points.row(j)));
  }
}
}
