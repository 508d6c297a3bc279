// SPDX-License-Identifier: BSD-3-Clause
// Solids of cubes, whose volume and areas are whole numbers, swept between all of their caps.
#include "Core/Stacks/StackSweep.h"

#include "Core/Solids/SolidInput.h"
#include "Core/Stacks/PickedCaps.h"
#include "Support/LentThreads.h"
#include "Support/SolidShapes.h"

namespace TestStackSweep
{
using hexsweep::CapLikeFaces;
using hexsweep::capLikeFaces;
using hexsweep::Index;
using hexsweep::SolidSurface;
using hexsweep::stackDirections;
using hexsweep::StackFaceKind;
using hexsweep::StackMesh;
using hexsweep::StackOptions;
using hexsweep::sweepStack;
using test::cubes;
using test::expectInvalid;

const Eigen::RowVector3d Up(0.0, 0.0, 1.0);

SolidSurface solidOf(const test::SolidInput& input)
{
  hexsweep::SolidOptions options;
  options.partTouching = true;
  return hexsweep::makeSolidSurface(input, options);
}

/// Every face of a hexahedron has one neighbour, or is one of the boundary's quads.
void expectConforming(const StackMesh& mesh)
{
  constexpr int Faces[6][4] = { { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 },
    { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
  std::map<std::array<Index, 4>, int> uses;
  for (Index h = 0; h < mesh.hexes.rows(); ++h)
  {
    for (const auto& face : Faces)
    {
      std::array<Index, 4> key{};
      for (std::size_t c = 0; c < 4; ++c)
      {
        key[c] = mesh.hexes(h, face[c]);
      }
      std::sort(key.begin(), key.end());
      ++uses[key];
    }
  }
  for (const auto& quad : mesh.boundary)
  {
    std::array<Index, 4> key = quad.points;
    std::sort(key.begin(), key.end());
    uses[key] += 10;
    const auto& side = Faces[quad.side];
    for (const int corner : side)
    {
      const Index point = mesh.hexes(quad.hex, corner);
      EXPECT_NE(std::find(quad.points.begin(), quad.points.end(), point), quad.points.end());
    }
  }
  for (const auto& [key, use] : uses)
  {
    EXPECT_TRUE(use == 2 || use == 11) << use;
  }
}

/// Area vectors' lengths of the outer quads by face.
std::map<Index, double> areasOf(const StackMesh& mesh)
{
  std::map<Index, double> areas;
  for (const auto& quad : mesh.boundary)
  {
    const Eigen::RowVector3d a = mesh.points.row(quad.points[2]) - mesh.points.row(quad.points[0]);
    const Eigen::RowVector3d b = mesh.points.row(quad.points[3]) - mesh.points.row(quad.points[1]);
    areas[quad.faceId] += 0.5 * a.cross(b).norm();
  }
  return areas;
}

std::map<Index, double> areasOf(const SolidSurface& solid)
{
  std::map<Index, double> areas;
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = solid.points.row(solid.triangles(t, 0));
    const Eigen::RowVector3d b = solid.points.row(solid.triangles(t, 1));
    const Eigen::RowVector3d c = solid.points.row(solid.triangles(t, 2));
    areas[solid.faceIds[static_cast<std::size_t>(t)]] += 0.5 * (b - a).cross(c - a).norm();
  }
  return areas;
}

/// The mesh of cubes is exact: caps and sides are planes between whole numbers.
StackMesh expectExact(const SolidSurface& solid, Index volume, double least)
{
  const CapLikeFaces faces = capLikeFaces(solid, Up);
  EXPECT_TRUE(faces.isStack());
  StackOptions options;
  options.size = 0.5;
  StackMesh mesh = sweepStack(solid, faces, options);
  const hexsweep::HexQualitySummary summary = hexsweep::summarize(mesh.qualities);
  EXPECT_EQ(summary.notCertified, 0);
  EXPECT_GE(summary.minScaledJacobian, least);
  EXPECT_NEAR(mesh.volume, static_cast<double>(volume), 1e-9 * static_cast<double>(volume));
  expectConforming(mesh);
  const std::map<Index, double> truth = areasOf(solid);
  const std::map<Index, double> found = areasOf(mesh);
  EXPECT_EQ(found.size(), truth.size());
  for (const auto& [face, area] : truth)
  {
    EXPECT_NEAR(found.count(face) ? found.at(face) : 0.0, area, 1e-9 * area) << face;
  }
  return mesh;
}

/// A T: a plate of 5 x 3 x 1 with a rib on it.
bool inRib(int x, int, int z)
{
  return z == 0 || x == 2;
}

TEST(StackSweep, ARibOnAPlate)
{
  const SolidSurface solid = solidOf(cubes({ 5, 3, 3 }, inRib));
  const StackMesh mesh = expectExact(solid, 15 + 6, 0.5);
  EXPECT_EQ(mesh.regions, 3);
  EXPECT_EQ(mesh.levels, 3);
}

TEST(StackSweep, CapsAboveAndBelowAndAnIslandOfMaterialUnderARoof)
{
  // Two plates one above the other on one post, and a foot below.
  const SolidSurface solid = solidOf(cubes({ 5, 5, 5 }, [](int x, int y, int z) {
    const bool post = x == 2 && y == 2;
    return post || z == 1 || (z == 3 && x < 4) || (z == 0 && x == 0);
  }));
  expectExact(solid, 25 + 20 + 3 + 5, 0.3);
}

TEST(StackSweep, RandomLandscapesAreExact)
{
  for (unsigned int seed = 1; seed <= 12; ++seed)
  {
    std::mt19937 engine(seed);
    std::array<std::array<int, 5>, 5> low{};
    std::array<std::array<int, 5>, 5> high{};
    Index volume = 0;
    for (std::size_t x = 0; x < 5; ++x)
    {
      for (std::size_t y = 0; y < 5; ++y)
      {
        low[x][y] = static_cast<int>(engine() % 3);
        high[x][y] = 3 + static_cast<int>(engine() % 3);
        volume += high[x][y] - low[x][y];
      }
    }
    const SolidSurface solid = solidOf(cubes({ 5, 5, 6 }, [&](int x, int y, int z) {
      const auto i = static_cast<std::size_t>(x);
      const auto j = static_cast<std::size_t>(y);
      return z >= low[i][j] && z < high[i][j];
    }));
    SCOPED_TRACE(seed);
    expectExact(solid, volume, 0.2);
  }
}

TEST(StackSweep, BitsDoNotDependOnThreads)
{
  const SolidSurface solid = solidOf(cubes({ 5, 3, 3 }, inRib));
  const CapLikeFaces faces = capLikeFaces(solid, Up);
  StackOptions options;
  options.size = 0.4;
  const StackMesh one = sweepStack(solid, faces, options);
  options.parallelFor = test::sideBySide;
  const StackMesh three = sweepStack(solid, faces, options);
  EXPECT_TRUE(one.points == three.points);
  EXPECT_TRUE(one.hexes == three.hexes);
}

TEST(StackSweep, AnySizeAndPlaceGivesTheSameMesh)
{
  const test::SolidInput input = cubes({ 5, 3, 3 }, inRib);
  const SolidSurface solid = solidOf(input);
  const StackMesh mesh = sweepStack(solid, capLikeFaces(solid, Up), {});
  for (const double scale : { 0x1p-20, 0x1p20 })
  {
    test::SolidInput scaled = input;
    scaled.points *= scale;
    const SolidSurface other = solidOf(scaled);
    const StackMesh same = sweepStack(other, capLikeFaces(other, Up), {});
    EXPECT_EQ(same.hexes.rows(), mesh.hexes.rows());
    EXPECT_NEAR(same.volume, 21.0 * scale * scale * scale, 1e-9 * scale * scale * scale);
  }
}

TEST(StackSweep, TheDirectionIsFound)
{
  // Along x and z there are several caps, along y one at either end.
  const SolidSurface ribbed = solidOf(cubes({ 5, 3, 3 }, inRib));
  const std::vector<CapLikeFaces> ways = stackDirections(ribbed);
  ASSERT_FALSE(ways.empty());
  EXPECT_TRUE(ways.front().isPlain());
  EXPECT_NEAR(std::abs(ways.front().direction.y()), 1.0, 1e-12);
}

TEST(PickedCaps, AreAtTheirEndsOfWhatIsFound)
{
  const SolidSurface ribbed = solidOf(cubes({ 5, 3, 3 }, inRib));
  const std::vector<CapLikeFaces> ways = stackDirections(ribbed);
  EXPECT_EQ(hexsweep::pickedDirections(ribbed, {}).size(), ways.size());
  // Each cap of each way, picked, gives that way, and at the other end the same reversed.
  for (const CapLikeFaces& way : ways)
  {
    for (const hexsweep::StackFace& face : way.faces)
    {
      if (face.kind != hexsweep::StackFaceKind::Top)
      {
        continue;
      }
      const auto above = hexsweep::pickedDirections(ribbed, { {}, { face.id } });
      ASSERT_EQ(above.size(), 1U);
      EXPECT_NEAR((above.front().direction - way.direction).norm(), 0.0, 1e-12);
      const auto below = hexsweep::pickedDirections(ribbed, { { face.id }, {} });
      ASSERT_EQ(below.size(), 1U);
      EXPECT_NEAR((below.front().direction + way.direction).norm(), 0.0, 1e-12);
      EXPECT_TRUE(hexsweep::pickedDirections(ribbed, { { face.id }, { face.id } }).empty());
    }
  }
  EXPECT_EQ(hexsweep::pickedDirections(ribbed, { { 1000 }, {} }).size(), ways.size());
  EXPECT_EQ(hexsweep::describePicked({ { 3 }, { 5, 6 } }),
    "face 3 as source cap and faces 5 and 6 as target caps");
}

TEST(StackSweep, LayersAreShared)
{
  const SolidSurface solid = solidOf(cubes({ 5, 3, 3 }, inRib));
  StackOptions options;
  options.size = 0.5;
  options.layers = 6;
  const StackMesh mesh = sweepStack(solid, capLikeFaces(solid, Up), options);
  EXPECT_EQ(*std::max_element(mesh.layerOf.begin(), mesh.layerOf.end()), 5);
}

TEST(StackSweep, WhatIsOutOfRangeIsRefused)
{
  const SolidSurface solid = solidOf(cubes({ 5, 3, 3 }, inRib));
  const CapLikeFaces faces = capLikeFaces(solid, Up);
  StackOptions options;
  options.size = -1.0;
  expectInvalid([&] { sweepStack(solid, faces, options); }, "Size");
  options.size = 0.0;
  options.imprintTolerance = 0.7;
  expectInvalid([&] { sweepStack(solid, faces, options); }, "ImprintTolerance");
  options.imprintTolerance = 0.05;
  options.layers = -1;
  expectInvalid([&] { sweepStack(solid, faces, options); }, "NumberOfLayers");
}

TEST(StackSweep, FacesInTheWayAreNamed)
{
  // Tops and bottoms of one id: it faces both ways.
  const SolidSurface solid = solidOf(cubes(
    { 3, 3, 2 }, [](int x, int, int z) { return z == 0 || x == 1; },
    [](const test::Cell&, int direction) { return direction > 4 ? 7 : direction; }));
  const CapLikeFaces faces = capLikeFaces(solid, Up);
  EXPECT_FALSE(faces.isStack());
  EXPECT_NE(hexsweep::describeRefusedFaces(faces).find("face 7"), std::string::npos);
  expectInvalid([&] { sweepStack(solid, faces, {}); }, "face 7");
}

TEST(CapLikeFaces, TellsCapsFromSides)
{
  const SolidSurface solid = solidOf(cubes({ 5, 3, 3 }, inRib));
  const CapLikeFaces faces = capLikeFaces(solid, Up);
  // The plate on both sides of the rib is one face, by its label.
  EXPECT_EQ(faces.tops, 2);
  EXPECT_EQ(faces.bottoms, 1);
  for (const auto& face : faces.faces)
  {
    const Index direction = face.id % 10;
    EXPECT_EQ(face.kind,
      direction == 6     ? StackFaceKind::Top
        : direction == 5 ? StackFaceKind::Bottom
                         : StackFaceKind::Side);
  }
}
}
