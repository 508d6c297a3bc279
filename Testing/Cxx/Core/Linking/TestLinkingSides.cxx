// SPDX-License-Identifier: BSD-3-Clause
// Structured quads on tubes whose shape is known in closed form.
#include "Core/Linking/LinkingSides.h"

#include "Support/SideTubes.h"

#include "Core/Common/Errors.h"
#include "Core/Geometry/TriangleSearch.h"
#include "Core/Linking/LayerSpacing.h"

#include <Eigen/Geometry>
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
using test::tube;
using test::TwoPi;
using Place = test::TubePlace;

Points ringOf(Index n, const Place& place, double offset = 0.0)
{
  Points ring(n, 3);
  for (Index j = 0; j < n; ++j)
  {
    ring.row(j) = place((static_cast<double>(j) + offset) / static_cast<double>(n), 0.0);
  }
  return ring;
}

Loop numbers(Index n)
{
  Loop loop;
  for (Index j = 0; j < n; ++j)
  {
    loop.push_back(j);
  }
  return loop;
}

LinkingMesh mesh(const SideTube& side, const Points& ring, const LayerRequest& request)
{
  return hexsweep::meshLinkingSides(ring, { numbers(ring.rows()) }, { side }, request);
}

LayerRequest layers(Index count)
{
  LayerRequest request;
  request.layers = count;
  return request;
}

Eigen::RowVector3d node(const LinkingMesh& mesh, Index n, Index k, Index j)
{
  return mesh.rings.points.row(k * n + j);
}

/// Least sine at a corner of a quad, about the mean normal of the quad.
double leastCorner(const LinkingMesh& mesh)
{
  double least = 1.0;
  for (Index q = 0; q < mesh.quads.rows(); ++q)
  {
    Eigen::RowVector3d p[4];
    for (int c = 0; c < 4; ++c)
    {
      p[c] = mesh.rings.points.row(mesh.quads(q, c));
    }
    const Eigen::RowVector3d normal = (p[2] - p[0]).cross(p[3] - p[1]).normalized();
    for (int c = 0; c < 4; ++c)
    {
      const Eigen::RowVector3d a = (p[(c + 1) % 4] - p[c]).normalized();
      const Eigen::RowVector3d b = (p[(c + 3) % 4] - p[c]).normalized();
      least = std::min(least, a.cross(b).dot(normal));
    }
  }
  return least;
}

double greatestDistance(const SideTube& side, const Points& nodes)
{
  const hexsweep::TriangleSearch search(side.surface.points, side.surface.triangles);
  double greatest = 0.0;
  for (Index i = 0; i < nodes.rows(); ++i)
  {
    greatest = std::max(greatest, search.closest(nodes.row(i)).distance);
  }
  return greatest;
}

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
      const LinkingMesh mesh =
        hexsweep::meshLinkingSides(rings, { numbers(Around), hole }, { outer, inner }, layers(16));
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
  const LinkingMesh result = mesh(side, ringOf(Columns, box), layers(19));
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

// A facetted right cylinder has straight generators and plane rings: nodes are known.
TEST(LinkingSides, CylinderIsMeshedExactly)
{
  const SideTube side = tube(24, 5, Cylinder, {}, 0.0);
  const Index n = 24;
  const LinkingMesh result = mesh(side, ringOf(n, Cylinder), layers(7));
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

TEST(LinkingSides, GivenRingIsKeptInItsOrder)
{
  const SideTube side = tube(40, 12, Cylinder, {}, 0.3);
  const Points forward = ringOf(20, Cylinder);
  const LinkingMesh a = mesh(side, forward, layers(4));
  const Points backward = forward.colwise().reverse();
  const LinkingMesh b = mesh(side, backward, layers(4));
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
  const LinkingMesh result = mesh(side, ringOf(30, bulge), layers(11));
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
  const LinkingMesh result = mesh(side, ringOf(24, undercut), layers(40));
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
  const LinkingMesh result = mesh(side, ringOf(30, slanted), layers(5));
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
  LayerRequest request = layers(6);
  request.growth = 1.4;
  const std::vector<double> expected = hexsweep::layerFractions(6, 1.4);
  const LinkingMesh grown = mesh(side, ringOf(24, Cylinder), request);
  for (Index k = 0; k <= 6; ++k)
  {
    EXPECT_NEAR(node(grown, 24, k, 5).z(), 3.0 * expected[static_cast<std::size_t>(k)], 0.01);
  }
  request.positions = { 0.25, 0.3 };
  EXPECT_EQ(mesh(side, ringOf(24, Cylinder), request).rings.numberOfLayers(), 3);
  request.positions.clear();
  request.size = 0.5;
  EXPECT_EQ(mesh(side, ringOf(24, Cylinder), request).rings.numberOfLayers(), 6);
  request.size = 0.75;
  EXPECT_EQ(mesh(side, ringOf(24, Cylinder), request).rings.numberOfLayers(), 4);
}

/// A box of 1 x 1 x 2 whose corner edges wind by a quarter turn, four faces.
const Place TwistedBox = [](double v, double u) -> Eigen::RowVector3d {
  const double side = std::floor(4.0 * v + 1e-9);
  const double along = 4.0 * v - side;
  const Eigen::Rotation2Dd turn(TwoPi / 4.0 * (u - side));
  const Eigen::Vector2d p = turn * Eigen::Vector2d(0.5 - along, -0.5);
  return { -p.x(), -p.y(), 2.0 * u };
};

TEST(LinkingSides, CadEdgesBecomeColumns)
{
  const auto faceOf = [](double v, double u) {
    // Two stacked faces on each of four sides: edges across the layers as well.
    return static_cast<Index>(4.0 * v) + (u > 0.4 ? 4 : 0);
  };
  const SideTube side = tube(40, 30, TwistedBox, faceOf, 0.0);
  const Points ring = ringOf(20, TwistedBox);
  const LinkingMesh result = mesh(side, ring, layers(13));
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
  const LinkingMesh result = mesh(side, ringOf(20, TwistedBox, 0.5), layers(13));
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
  const LinkingMesh result = mesh(side, ringOf(32, pyramid), layers(8));
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

TEST(LinkingSides, ScaleAndPlaceDoNotMatter)
{
  const auto faceOf = [](double v, double) { return static_cast<Index>(4.0 * v); };
  const SideTube side = tube(40, 30, TwistedBox, faceOf, 0.0);
  const LinkingMesh unit = mesh(side, ringOf(20, TwistedBox), layers(9));
  for (const double scale : { 1e-6, 1e6 })
  {
    SideTube scaled = side;
    scaled.surface.points *= scale;
    const LinkingMesh result = mesh(scaled, scale * ringOf(20, TwistedBox), layers(9));
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
  LayerRequest graded = layers(8);
  graded.growth = 1.3;
  const LinkingMesh other = mesh(side, ring, graded);
  side.patches = { partOf(other, 20, 5, 10) };
  const LinkingMesh result = mesh(side, ring, layers(8));
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
  EXPECT_LT((mesh(side, ring, layers(8)).rings.points - other.rings.points).norm(), 1e-15);
  EXPECT_THROW(mesh(side, ring, layers(7)), InvalidInput);
  side.patches = { partOf(other, 20, 5, 10) };
  side.patches[0].quads.conservativeResize(side.patches[0].quads.rows() - 2, Eigen::NoChange);
  const LinkingMesh torn = mesh(side, ring, layers(8));
  ASSERT_EQ(torn.refusedPatches.size(), 1u);
  EXPECT_NE(torn.refusedPatches[0].find("not structured"), std::string::npos);
}

TEST(LinkingSides, WallsOfOneQuadAreNoMesh)
{
  const auto faceOf = [](double v, double) { return static_cast<Index>(4.0 * v); };
  SideTube side = tube(40, 30, TwistedBox, faceOf, 0.0);
  const Points ring = ringOf(20, TwistedBox);
  const LinkingMesh plain = mesh(side, ring, layers(8));
  LayerRequest one = layers(1);
  const LinkingMesh walls = mesh(side, ring, one);
  side.patches = { partOf(walls, 20, 0, 20) };
  EXPECT_EQ(mesh(side, ring, layers(8)).rings.points, plain.rings.points);
  EXPECT_EQ(mesh(side, ring, one).rings.points, walls.rings.points);
}

TEST(LinkingSides, AThicknessThatIsNoneIsRefused)
{
  const SideTube side = tube(24, 6, Cylinder, {}, 0.2);
  LayerRequest request;
  for (const double size : { -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    request.size = size;
    EXPECT_THROW(mesh(side, ringOf(24, Cylinder), request), InvalidInput) << size;
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
  const LinkingMesh result = hexsweep::meshLinkingSides(rings, loops, sides, layers(3));
  const auto backwards = [](Index count, const std::function<void(Index)>& call) {
    EXPECT_EQ(count, 2);
    for (Index i = count - 1; i >= 0; --i)
    {
      call(i);
    }
  };
  const LinkingMesh shared =
    hexsweep::meshLinkingSides(rings, loops, sides, layers(3), 1e-6, {}, backwards);
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
  EXPECT_NO_THROW(mesh(side, ringOf(24, Cylinder), layers(3))); // a notch in the far loop
  side.surface.triangles.row(100) = side.surface.triangles.row(101);
  EXPECT_THROW(mesh(side, ringOf(24, Cylinder), layers(3)), InvalidInput);
}
}
