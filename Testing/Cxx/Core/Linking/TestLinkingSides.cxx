// SPDX-License-Identifier: BSD-3-Clause
// Structured quads on tubes whose shape is known in closed form.
#include "Core/Linking/LinkingSides.h"

#include "Support/TubeMeshes.h"

#include "Core/Common/Errors.h"
#include "Core/Linking/LayerSpacing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace TestLinkingSides
{
using hexsweep::Index;
using hexsweep::InvalidInput;
using hexsweep::LayerRequest;
using hexsweep::LinkingMesh;
using hexsweep::Loop;
using hexsweep::Points;
using hexsweep::QuadMesh;
using hexsweep::SideTube;
using test::Cylinder;
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

// A facetted right cylinder has straight generators and plane rings: nodes are known.
TEST(LinkingSides, CylinderIsMeshedExactly)
{
  const SideTube side = tube(24, 5, Cylinder, {}, 0.0);
  const Index n = 24;
  const LinkingMesh result = meshTube(side, ringOf(n, Cylinder), layerRequest(7));
  ASSERT_EQ(result.rings.numberOfLayers(), 7);
  EXPECT_NEAR(result.meanColumnLength, 3.0, 1e-9);
  for (Index k = 0; k <= 7; ++k)
  {
    for (Index j = 0; j < n; ++j)
    {
      const Eigen::RowVector3d expected =
        Cylinder(static_cast<double>(j) / 24.0, static_cast<double>(k) / 7.0);
      EXPECT_LT((node(result, n, k, j) - expected).norm(), 1e-6) << k << " " << j;
    }
  }
}

// Cut as finely as its area asks, each of its edges would be a million.
TEST(LinkingSides, SlenderSidesAreNotCutEndlessly)
{
  constexpr double Height = 3e5;
  const Place needle = [](double v, double u) -> Eigen::RowVector3d {
    return { std::cos(TwoPi * v), std::sin(TwoPi * v), Height * u };
  };
  SideTube side = tube(24, 1, needle, {}, 0.0);
  side.leastTriangles = 50.0; // as long as it takes
  const LinkingMesh result = meshTube(side, ringOf(24, needle), layerRequest(2));
  for (Index j = 0; j < 24; ++j)
  {
    EXPECT_NEAR(node(result, 24, 1, j).z(), 0.5 * Height, 1e-3 * Height);
  }
}

TEST(LinkingSides, GivenRingIsKeptInItsOrder)
{
  const SideTube side = tube(40, 12, Cylinder, {}, 0.3);
  const Points forward = ringOf(20, Cylinder);
  const LinkingMesh a = meshTube(side, forward, layerRequest(4));
  const Points backward = forward.colwise().reverse();
  const LinkingMesh b = meshTube(side, backward, layerRequest(4));
  EXPECT_EQ(Points(a.rings.points.topRows(20)), forward);
  EXPECT_EQ(Points(b.rings.points.topRows(20)), backward);
  for (Index k = 0; k <= 4; ++k)
  {
    for (Index j = 0; j < 20; ++j)
    {
      EXPECT_LT((node(a, 20, k, j) - node(b, 20, k, 19 - j)).norm(), 1e-9);
    }
  }
}

TEST(LinkingSides, NodesLieOnTheTriangles)
{
  const Place bulge = [](double v, double u) -> Eigen::RowVector3d {
    const double r = 1.0 + 0.6 * std::sin(3.0 * u) + 0.2 * std::cos(3.0 * TwoPi * v) * u;
    return { r * std::cos(TwoPi * v), 1.7 * r * std::sin(TwoPi * v),
      3.0 * u + std::sin(TwoPi * v) };
  };
  const SideTube side = tube(60, 30, bulge, {}, 0.3);
  const LinkingMesh result = meshTube(side, ringOf(30, bulge), layerRequest(11));
  EXPECT_LT(greatestDistance(side, result.rings.points), 1e-14 * 6.0);
  EXPECT_EQ(result.flipped, 0);
  EXPECT_GT(leastCorner(result), 0.7);
}

// The side comes back under itself: its height falls on the way.
TEST(LinkingSides, HeightNeedNotRise)
{
  const Place undercut = [](double v, double u) -> Eigen::RowVector3d {
    const double r = 2.0 + std::sin(TwoPi * u);
    const double z = 3.0 * u - 1.2 * std::sin(2.0 * TwoPi * u);
    return { r * std::cos(TwoPi * v), r * std::sin(TwoPi * v), z };
  };
  const SideTube side = tube(48, 60, undercut, {}, 0.3);
  const LinkingMesh result = meshTube(side, ringOf(24, undercut), layerRequest(40));
  EXPECT_LT(greatestDistance(side, result.rings.points), 1e-13);
  EXPECT_GT(leastCorner(result), 0.9);
  // By symmetry every ring is a circle, and all columns are equally long.
  for (Index k = 0; k <= 40; ++k)
  {
    for (Index j = 1; j < 24; ++j)
    {
      EXPECT_NEAR(node(result, 24, k, j).z(), node(result, 24, k, 0).z(), 0.05);
    }
  }
}

// One column is ten times as long as that across.
TEST(LinkingSides, SidesOfVeryDifferentLength)
{
  const Place slanted = [](double v, double u) -> Eigen::RowVector3d {
    return { std::cos(TwoPi * v), std::sin(TwoPi * v), u * (1.1 - 0.9 * std::cos(TwoPi * v)) };
  };
  const SideTube side = tube(60, 20, slanted, {}, 0.2);
  const LinkingMesh result = meshTube(side, ringOf(30, slanted), layerRequest(5));
  EXPECT_GT(leastCorner(result), 0.3);
  for (Index j = 0; j < 30; ++j)
  {
    double shortest = 1e9;
    double longest = 0.0;
    for (Index k = 0; k < 5; ++k)
    {
      const double step = (node(result, 30, k + 1, j) - node(result, 30, k, j)).norm();
      shortest = std::min(shortest, step);
      longest = std::max(longest, step);
    }
    EXPECT_GT(shortest, 0.9 * longest) << j;
  }
}

TEST(LinkingSides, LayersFollowGrowthAndPositions)
{
  const SideTube side = tube(24, 6, Cylinder, {}, 0.2);
  LayerRequest request = layerRequest(6);
  request.growth = 1.4;
  const std::vector<double> expected = hexsweep::layerFractions(6, 1.4);
  const LinkingMesh grown = meshTube(side, ringOf(24, Cylinder), request);
  for (Index k = 0; k <= 6; ++k)
  {
    EXPECT_NEAR(node(grown, 24, k, 5).z(), 3.0 * expected[static_cast<std::size_t>(k)], 0.01);
  }
  request.positions = { 0.25, 0.3 };
  EXPECT_EQ(meshTube(side, ringOf(24, Cylinder), request).rings.numberOfLayers(), 3);
  request.positions.clear();
  request.size = 0.5;
  EXPECT_EQ(meshTube(side, ringOf(24, Cylinder), request).rings.numberOfLayers(), 6);
  request.size = 0.75;
  EXPECT_EQ(meshTube(side, ringOf(24, Cylinder), request).rings.numberOfLayers(), 4);
}

TEST(LinkingSides, ScaleAndPlaceDoNotMatter)
{
  const auto faceOf = [](double v, double) { return static_cast<Index>(4.0 * v); };
  const SideTube side = tube(40, 30, TwistedBox, faceOf, 0.0);
  const LinkingMesh unit = meshTube(side, ringOf(20, TwistedBox), layerRequest(9));
  for (const double scale : { 1e-6, 1e6 })
  {
    SideTube scaled = side;
    scaled.surface.points *= scale;
    const LinkingMesh result = meshTube(scaled, scale * ringOf(20, TwistedBox), layerRequest(9));
    EXPECT_LT((result.rings.points / scale - unit.rings.points).cwiseAbs().maxCoeff(), 1e-9);
  }
}

/// The quads of the columns from..to of a mesh, as another mesher would give them.
QuadMesh partOf(const LinkingMesh& mesh, Index n, Index from, Index to)
{
  QuadMesh part;
  const Index width = to - from;
  part.points.resize((mesh.rings.numberOfLayers() + 1) * (width + 1), 3);
  part.quads.resize(mesh.rings.numberOfLayers() * width, 4);
  for (Index k = 0; k <= mesh.rings.numberOfLayers(); ++k)
  {
    for (Index j = 0; j <= width; ++j)
    {
      part.points.row(k * (width + 1) + j) = node(mesh, n, k, (from + j) % n);
    }
  }
  for (Index k = 0; k < mesh.rings.numberOfLayers(); ++k)
  {
    for (Index j = 0; j < width; ++j)
    {
      const Index a = k * (width + 1) + j;
      part.quads.row(k * width + j) << a + 1, a, a + width + 1, a + width + 2;
    }
  }
  return part;
}

TEST(LinkingSides, MeshedPartsKeepTheirNodes)
{
  const auto faceOf = [](double v, double) { return static_cast<Index>(4.0 * v); };
  SideTube side = tube(40, 30, TwistedBox, faceOf, 0.0);
  const Points ring = ringOf(20, TwistedBox);
  LayerRequest graded = layerRequest(8);
  graded.growth = 1.3;
  const LinkingMesh other = meshTube(side, ring, graded);
  side.patches = { partOf(other, 20, 5, 10) };
  const LinkingMesh result = meshTube(side, ring, layerRequest(8));
  for (Index k = 0; k <= 8; ++k)
  {
    for (Index j = 5; j <= 10; ++j)
    {
      EXPECT_EQ(Eigen::RowVector3d(node(result, 20, k, j)), node(other, 20, k, j));
    }
    // Across the box the layers are as they were asked for.
    EXPECT_NEAR(node(result, 20, k, 17).z(), 0.25 * static_cast<double>(k), 0.01);
  }
  EXPECT_GT(leastCorner(result), 0.6);
  side.patches = { partOf(other, 20, 0, 20) };
  EXPECT_LT(
    (meshTube(side, ring, layerRequest(8)).rings.points - other.rings.points).norm(), 1e-15);
  EXPECT_THROW(meshTube(side, ring, layerRequest(7)), InvalidInput);
  side.patches = { partOf(other, 20, 5, 10) };
  side.patches[0].quads.conservativeResize(side.patches[0].quads.rows() - 2, Eigen::NoChange);
  const LinkingMesh torn = meshTube(side, ring, layerRequest(8));
  ASSERT_EQ(torn.refusedPatches.size(), 1u);
  EXPECT_NE(torn.refusedPatches[0].find("not structured"), std::string::npos);
}

TEST(LinkingSides, WallsOfOneQuadAreNoMesh)
{
  const auto faceOf = [](double v, double) { return static_cast<Index>(4.0 * v); };
  SideTube side = tube(40, 30, TwistedBox, faceOf, 0.0);
  const Points ring = ringOf(20, TwistedBox);
  const LinkingMesh plain = meshTube(side, ring, layerRequest(8));
  LayerRequest one = layerRequest(1);
  const LinkingMesh walls = meshTube(side, ring, one);
  side.patches = { partOf(walls, 20, 0, 20) };
  EXPECT_EQ(meshTube(side, ring, layerRequest(8)).rings.points, plain.rings.points);
  EXPECT_EQ(meshTube(side, ring, one).rings.points, walls.rings.points);
}

TEST(LinkingSides, AThicknessThatIsNoneIsRefused)
{
  const SideTube side = tube(24, 6, Cylinder, {}, 0.2);
  LayerRequest request;
  for (const double size : { -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    request.size = size;
    EXPECT_THROW(meshTube(side, ringOf(24, Cylinder), request), InvalidInput) << size;
  }
}

TEST(LinkingSides, SplitsASurfaceAndFindsTheSource)
{
  const Place inner = [](double v, double u) -> Eigen::RowVector3d {
    return { 0.4 * std::cos(TwoPi * v), 0.4 * std::sin(TwoPi * v), 3.0 - 3.0 * u };
  };
  const SideTube outside = tube(24, 6, Cylinder);
  const SideTube inside = tube(12, 6, inner); // runs from the target to the source
  hexsweep::LinkingSurface surface;
  hexsweep::TriangleMesh& both = surface.mesh;
  both.points.resize(outside.surface.points.rows() + inside.surface.points.rows(), 3);
  both.points << outside.surface.points, inside.surface.points;
  both.triangles.resize(outside.surface.triangles.rows() + inside.surface.triangles.rows(), 3);
  both.triangles << outside.surface.triangles,
    (inside.surface.triangles.array() + outside.surface.points.rows()).matrix();
  Points rings(36, 3);
  const Points hole = inside.surface.points.bottomRows(12);
  rings << hole, ringOf(24, Cylinder);
  Loop outer = numbers(24);
  for (Index& i : outer)
  {
    i += 12;
  }
  const std::vector<Loop> loops = { numbers(12), outer };
  const auto sides = hexsweep::splitLinkingSides(surface, rings, loops);
  ASSERT_EQ(sides.size(), 2u);
  const LinkingMesh result = hexsweep::meshLinkingSides(rings, loops, sides, layerRequest(3));
  const auto backwards = [](Index count, const std::function<void(Index)>& call) {
    EXPECT_EQ(count, 2);
    for (Index i = count - 1; i >= 0; --i)
    {
      call(i);
    }
  };
  const LinkingMesh shared =
    hexsweep::meshLinkingSides(rings, loops, sides, layerRequest(3), 1e-6, {}, backwards);
  EXPECT_EQ(shared.rings.points, result.rings.points);
  EXPECT_EQ(shared.quads, result.quads);
  EXPECT_EQ(shared.quadTriangle, result.quadTriangle);
  EXPECT_EQ(Points(result.rings.points.topRows(12)), hole);
  for (Index i = 0; i < result.rings.points.rows(); ++i)
  {
    EXPECT_NEAR(result.rings.points(i, 2),
      static_cast<double>(result.nodeRing[static_cast<std::size_t>(i)]), 0.01);
  }
  EXPECT_THROW(hexsweep::splitLinkingSides(surface, rings, { loops[0] }), InvalidInput);
}

TEST(LinkingSides, RefusesWhatIsNoTube)
{
  SideTube side = tube(24, 6, Cylinder);
  side.surface.triangles.conservativeResize(side.surface.triangles.rows() - 1, Eigen::NoChange);
  EXPECT_NO_THROW(meshTube(side, ringOf(24, Cylinder), layerRequest(3))); // a notch in the far loop
  side.surface.triangles.row(100) = side.surface.triangles.row(101);
  EXPECT_THROW(meshTube(side, ringOf(24, Cylinder), layerRequest(3)), InvalidInput);
}
}
