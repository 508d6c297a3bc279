// SPDX-License-Identifier: BSD-3-Clause
// Linking sides between CAD edges: edges become columns, and sides without any follow the others.
#include "Core/Linking/LinkingSides.h"

#include "Support/TubeMeshes.h"

#include "Core/Geometry/TriangleSearch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace TestLinkingSideEdges
{
using hexsweep::Index;
using hexsweep::LinkingMesh;
using hexsweep::Loop;
using hexsweep::Points;
using hexsweep::SideTube;
using test::greatestDistance;
using test::layerRequest;
using test::leastCorner;
using test::meshTube;
using test::node;
using test::numbers;
using test::ringOf;
using test::tube;
using test::TwistedBox;
using test::TwoPi;
using Place = test::TubePlace;

/// Mean angle by which the columns of ring nodes [first, first + n) turn about the z axis.
double meanTurn(const LinkingMesh& mesh, Index firstNode, Index n)
{
  double sum = 0.0;
  for (Index j = 0; j < n; ++j)
  {
    double angle = 0.0;
    for (Index k = 1; k <= mesh.rings.numberOfLayers(); ++k)
    {
      const Eigen::RowVector3d a = mesh.rings.points.row(firstNode + (k - 1) * n + j);
      const Eigen::RowVector3d b = mesh.rings.points.row(firstNode + k * n + j);
      angle += std::remainder(std::atan2(b[1], b[0]) - std::atan2(a[1], a[0]), TwoPi);
    }
    sum += angle;
  }
  return sum / static_cast<double>(n);
}

// The wall of a pipe: CAD edges twist its outside, nothing is to be seen of that inside.
TEST(LinkingSides, SideWithoutCadEdgesFollowsTheOthers)
{
  constexpr double Height = 3.0;
  constexpr Index Around = 48;
  for (const double twist : { 0.3, 1.5 * TwoPi / 2.0 })
  {
    for (const double radius : { 0.96, 0.3 })
    {
      const auto pipe = [&](double r, double turn) -> Place {
        return [=](double v, double u) -> Eigen::RowVector3d {
          const double angle = TwoPi * v + turn * u;
          return { r * std::cos(angle), r * std::sin(angle), Height * u };
        };
      };
      const SideTube outer =
        tube(Around, 24, pipe(1.0, twist), [](double v, double) { return Index(4.0 * v); });
      const SideTube inner = tube(Around, 24, pipe(radius, 0.0));
      Points rings(2 * Around, 3);
      rings << ringOf(Around, pipe(1.0, 0.0)), ringOf(Around, pipe(radius, 0.0));
      Loop hole = numbers(Around);
      for (Index& point : hole)
      {
        point += Around;
      }
      const LinkingMesh mesh = hexsweep::meshLinkingSides(
        rings, { numbers(Around), hole }, { outer, inner }, layerRequest(16));
      EXPECT_NEAR(meanTurn(mesh, 0, Around), twist, 1e-9);
      // The least sum of the squares of turn over gap and turn over height.
      const double gap = 1.0 - radius;
      const double share = Height * Height / (Height * Height + gap * gap);
      EXPECT_NEAR(meanTurn(mesh, 17 * Around, Around), share * twist, 1e-3 * twist)
        << "twist " << twist << ", radius " << radius;
    }
  }
}

// A box with a groove across its left side. At the groove's corners borders lead straighter on
// across the left side than round the groove.
TEST(LinkingSides, EdgesRoundAGrooveAreKept)
{
  const auto profile = [](const double(&values)[6], double u) {
    const int part = std::min(4, static_cast<int>(5.0 * u));
    return values[part] + (5.0 * u - part) * (values[part + 1] - values[part]);
  };
  const Place box = [&](double v, double u) -> Eigen::RowVector3d {
    const double side = 4.0 * (v - std::floor(v));
    const double t = side - std::floor(side);
    const double x = profile({ 0.0, 0.0, 0.4, 0.4, 0.0, 0.0 }, u);
    const double z = profile({ 0.0, 1.0, 1.0, 2.0, 2.0, 3.0 }, u);
    switch (static_cast<int>(side))
    {
      case 0:
        return { x + t * (2.0 - x), 0.0, z + t * (3.0 * u - z) };
      case 1:
        return { 2.0, 2.0 * t, 3.0 * u };
      case 2:
        return { 2.0 + t * (x - 2.0), 2.0, 3.0 * u + t * (z - 3.0 * u) };
      default:
        return { x, 2.0 - 2.0 * t, z + 4.0 * t * (1.0 - t) * u * (1.0 - u) };
    }
  };
  const SideTube side = tube(32, 20, box, [](double v, double u) {
    const Index quarter = static_cast<Index>(4.0 * v);
    return quarter < 3 ? quarter : 3 + static_cast<Index>(5.0 * u);
  });
  constexpr Index Columns = 16;
  const LinkingMesh result = meshTube(side, ringOf(Columns, box), layerRequest(19));
  EXPECT_EQ(result.keptEdges, 4);
  EXPECT_TRUE(result.lostEdges.empty());
  for (const Index corner : { Index(0), Index(12) })
  {
    for (Index k = 0; k <= 19; ++k)
    {
      const Eigen::RowVector3d place = node(result, Columns, k, corner);
      const double z = 3.8 * static_cast<double>(k) / 19.0; // length along the edge
      const double x = std::max(0.0, std::min({ z - 1.0, 0.4, 2.8 - z }));
      EXPECT_NEAR(place[0], x, 1e-12) << "layer " << k;
      EXPECT_NEAR(place[1], corner == 0 ? 0.0 : 2.0, 1e-12);
    }
  }
}

TEST(LinkingSides, CadEdgesBecomeColumns)
{
  const auto faceOf = [](double v, double u) {
    // Two stacked faces on each of four sides: edges across the layers as well.
    return static_cast<Index>(4.0 * v) + (u > 0.4 ? 4 : 0);
  };
  const SideTube side = tube(40, 30, TwistedBox, faceOf, 0.0);
  const Points ring = ringOf(20, TwistedBox);
  const LinkingMesh result = meshTube(side, ring, layerRequest(13));
  EXPECT_EQ(result.keptEdges, 4);
  EXPECT_TRUE(result.lostEdges.empty());
  EXPECT_TRUE(result.lostCorners.empty());
  // The edge's polyline, to rounding.
  for (Index corner = 0; corner < 4; ++corner)
  {
    Points edge(30 * 3, 3);
    for (Index k = 0; k < 30; ++k)
    {
      edge.row(3 * k) = side.surface.points.row(k * 40 + 10 * corner);
      edge.row(3 * k + 1) = edge.row(3 * k + 2) =
        side.surface.points.row((k + 1) * 40 + 10 * corner);
    }
    const hexsweep::TriangleSearch search(edge);
    for (Index k = 0; k <= 13; ++k)
    {
      EXPECT_LT(search.closest(node(result, 20, k, 5 * corner)).distance, 1e-15 * 4.0);
    }
  }
  // Each quad is on the face that its middle is on.
  for (Index q = 0; q < result.quads.rows(); ++q)
  {
    const Index face =
      side.faceIds[static_cast<std::size_t>(result.quadTriangle[static_cast<std::size_t>(q)])];
    EXPECT_EQ(face % 4, (q % 20) / 5);
  }
}

TEST(LinkingSides, EdgesWithoutNodesAreNamed)
{
  const auto faceOf = [](double v, double) { return static_cast<Index>(4.0 * v); };
  const SideTube side = tube(40, 30, TwistedBox, faceOf, 0.0);
  const LinkingMesh result = meshTube(side, ringOf(20, TwistedBox, 0.5), layerRequest(13));
  EXPECT_EQ(result.keptEdges, 0);
  EXPECT_EQ(result.lostEdges.size(), 4u);
  // The corners of the target loop have nodes all the same.
  for (Index corner = 0; corner < 4; ++corner)
  {
    double nearest = 1.0;
    for (Index j = 0; j < 20; ++j)
    {
      nearest = std::min(
        nearest, (node(result, 20, 13, j) - side.surface.points.row(30 * 40 + 10 * corner)).norm());
    }
    EXPECT_EQ(nearest, 0.0) << corner;
  }
}

// A box as CAD systems export it: two triangles a face.
TEST(LinkingSides, TwoTrianglesAFace)
{
  const Place pyramid = [](double v, double u) -> Eigen::RowVector3d {
    const Eigen::RowVector3d p = TwistedBox(v, 0.0);
    return { (1.0 - 0.6 * u) * p.x(), (1.0 - 0.6 * u) * p.y(), u };
  };
  const SideTube side =
    tube(4, 1, pyramid, [](double v, double) { return static_cast<Index>(4.0 * v); });
  const LinkingMesh result = meshTube(side, ringOf(32, pyramid), layerRequest(8));
  EXPECT_EQ(result.keptEdges, 4);
  EXPECT_EQ(result.flipped, 0);
  EXPECT_LT(greatestDistance(side, result.rings.points), 1e-15);
  EXPECT_GT(leastCorner(result), 0.8);
  // Rings keep their height up to what the diagonals do to it.
  for (Index j = 0; j < 32; ++j)
  {
    EXPECT_NEAR(node(result, 32, 4, j).z(), 0.5, 0.05);
  }
}
}
