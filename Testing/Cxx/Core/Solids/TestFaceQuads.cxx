// SPDX-License-Identifier: BSD-3-Clause
// Quads of boxes, whose corners and areas are known.
#include "Core/Solids/FaceQuads.h"

#include "Core/Solids/TargetFaces.h"

#include "Support/QuadBox.h"

#include <random>
#include <set>

namespace TestFaceQuads
{
using hexsweep::FaceQuads;
using hexsweep::Index;
using hexsweep::makeSolidSurface;
using hexsweep::quadsOfFaces;
using hexsweep::SolidSurface;
using test::box;
using test::SolidInput;
using test::withQuads;

/// The top of a box, 2 x 3 x 1: six unit squares at z = 1 that look up.
void expectTop(const SolidInput& input)
{
  const auto quads = quadsOfFaces(input, makeSolidSurface(input), { 16 });
  ASSERT_TRUE(quads);
  ASSERT_EQ(quads->mesh.quads.rows(), 6);
  EXPECT_EQ(quads->mesh.points.rows(), 3 * 4);
  for (Index q = 0; q < 6; ++q)
  {
    EXPECT_EQ(test::areaOf(quads->mesh, q), Eigen::RowVector3d(0.0, 0.0, 1.0));
    const Index row = quads->cellIds[static_cast<std::size_t>(q)] - 100;
    for (Index c = 0; c < 4; ++c)
    {
      const Eigen::RowVector3d corner = quads->mesh.points.row(quads->mesh.quads(q, c));
      bool isCorner = false;
      for (Index d = 0; d < 4; ++d)
      {
        isCorner = isCorner || corner == input.points.row(input.quads(row, d));
      }
      EXPECT_TRUE(isCorner) << "quad " << q << " is not the cell that it is said to be";
    }
  }
  for (Index p = 0; p < quads->mesh.points.rows(); ++p)
  {
    const Index given = quads->pointIds[static_cast<std::size_t>(p)];
    EXPECT_EQ(quads->mesh.points.row(p), input.points.row(given));
  }
  EXPECT_EQ(std::set<Index>(quads->pointIds.begin(), quads->pointIds.end()).size(), 12u);
}

/// Triangles begun at another corner and turned over by chance; pairs stay pairs.
SolidInput shuffled(SolidInput solid, unsigned seed)
{
  std::mt19937 random(seed);
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    const Eigen::Matrix<Index, 1, 3> old = solid.triangles.row(t);
    const Index start = static_cast<Index>(random() % 3);
    const Index step = random() % 2 == 0 ? 1 : 2;
    for (Index c = 0; c < 3; ++c)
    {
      solid.triangles(t, c) = old[(start + step * c) % 3];
    }
  }
  return solid;
}

TEST(FaceQuads, TheTopOfABox)
{
  expectTop(withQuads(box(2, 3, 1)));
}

TEST(FaceQuads, WhicheverWayTrianglesBeginAndTurn)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    SCOPED_TRACE(seed);
    expectTop(shuffled(withQuads(box(2, 3, 1)), seed));
  }
}

TEST(FaceQuads, PointsThatAreRepeatedAreJoined)
{
  const SolidInput soup = test::soup(withQuads(box(2, 3, 1)));
  const auto quads = quadsOfFaces(soup, makeSolidSurface(soup), { 16 });
  ASSERT_TRUE(quads);
  EXPECT_EQ(quads->mesh.points.rows(), 12);
  for (Index p = 0; p < 12; ++p)
  {
    EXPECT_EQ(
      quads->mesh.points.row(p), soup.points.row(quads->pointIds[static_cast<std::size_t>(p)]));
  }
}

TEST(FaceQuads, SeveralFacesOrNone)
{
  const SolidInput input = withQuads(box(2, 3, 1), [](Index face) { return face != 16; });
  const SolidSurface solid = makeSolidSurface(input);
  const auto both = quadsOfFaces(input, solid, { 5, 1 });
  ASSERT_TRUE(both);
  EXPECT_EQ(both->mesh.quads.rows(), 6 + 3);
  EXPECT_FALSE(quadsOfFaces(input, solid, { 16 }));
  EXPECT_FALSE(quadsOfFaces(input, solid, { 5, 16 }));
  EXPECT_FALSE(quadsOfFaces(box(2, 3, 1), makeSolidSurface(box(2, 3, 1)), { 5 }));
}

TEST(FaceQuads, HalfAQuadIsNone)
{
  SolidInput input = withQuads(box(1, 1, 1));
  for (Index t = 0; t < input.triangles.rows(); ++t)
  {
    if (input.faceIds[static_cast<std::size_t>(t)] == 16)
    {
      input.faceIds[static_cast<std::size_t>(t)] = 99; // the other half stays on face 16
      break;
    }
  }
  EXPECT_FALSE(quadsOfFaces(input, makeSolidSurface(input), { 16 }));
}

TEST(FaceQuads, PatchesOfTheSides)
{
  const SolidInput input =
    withQuads(box(2, 3, 4), [](Index face) { return face == 1 || face == 34; });
  const SolidSurface solid = makeSolidSurface(input);
  const auto topology = hexsweep::findSweepTopology(solid, { 5 }, { 46 });
  const auto patches = hexsweep::sidePatches(input, solid, topology);
  ASSERT_EQ(patches.size(), 1u);
  ASSERT_EQ(patches[0].size(), 2u);
  EXPECT_EQ(patches[0][0].quads.rows(), 3 * 4); // x = 0
  EXPECT_EQ(patches[0][1].quads.rows(), 2 * 4); // y = 3
  const SolidInput bare = box(2, 3, 4);
  const auto none = hexsweep::sidePatches(bare, makeSolidSurface(bare), topology);
  ASSERT_EQ(none.size(), 1u);
  EXPECT_TRUE(none[0].empty());
}
}
