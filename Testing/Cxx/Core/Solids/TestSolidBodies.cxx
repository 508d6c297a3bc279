// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Common/Errors.h"
#include "Core/Solids/SolidBodies.h"

#include "Support/SolidShapes.h"

#include <gtest/gtest.h>

#include <numeric>

namespace TestSolidBodies
{
using hexsweep::Index;
using hexsweep::solidBodies;
using hexsweep::SolidBody;
using hexsweep::SolidInput;

SolidInput moved(SolidInput solid, const Eigen::RowVector3d& by, double scale = 1.0)
{
  solid.points = ((scale * solid.points).rowwise() + by).eval();
  return solid;
}

SolidInput together(const SolidInput& a, const SolidInput& b)
{
  SolidInput both;
  both.points.resize(a.points.rows() + b.points.rows(), 3);
  both.points << a.points, b.points;
  both.triangles.resize(a.triangles.rows() + b.triangles.rows(), 3);
  both.triangles << a.triangles, (b.triangles.array() + a.points.rows()).matrix();
  both.faceIds = a.faceIds;
  both.faceIds.insert(both.faceIds.end(), b.faceIds.begin(), b.faceIds.end());
  return both;
}

double volumeOf(const SolidInput& solid)
{
  const hexsweep::SolidSurface surface = makeSolidSurface(solid);
  double volume = 0.0;
  for (Index t = 0; t < surface.triangles.rows(); ++t)
  {
    const Eigen::Vector3d a = surface.points.row(surface.triangles(t, 0));
    const Eigen::Vector3d b = surface.points.row(surface.triangles(t, 1));
    const Eigen::Vector3d c = surface.points.row(surface.triangles(t, 2));
    volume += a.dot(b.cross(c)) / 6.0;
  }
  return volume;
}

TEST(SolidBodies, OneBodyComesBackAsItIs)
{
  const SolidInput box = test::box(1, 2, 3);
  const std::vector<SolidBody> bodies = solidBodies(box, {});
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_EQ(bodies[0].volumeId, 1);
  EXPECT_EQ(bodies[0].input.triangles, box.triangles);
  EXPECT_EQ(bodies[0].input.faceIds, box.faceIds);
}

TEST(SolidBodies, PiecesThatAreNotConnectedAreCountedFromOne)
{
  const SolidInput solid =
    together(test::box(1, 2, 3), moved(test::box(2, 2, 2), { 5.0, 0.0, 0.0 }));
  for (const SolidInput& input : { solid, test::soup(solid) })
  {
    const std::vector<SolidBody> bodies = solidBodies(input, {});
    ASSERT_EQ(bodies.size(), 2u);
    EXPECT_EQ(bodies[0].volumeId, 1);
    EXPECT_EQ(bodies[1].volumeId, 2);
    EXPECT_NEAR(volumeOf(bodies[0].input), 6.0, 1e-12);
    EXPECT_NEAR(volumeOf(bodies[1].input), 8.0, 1e-12);
    EXPECT_EQ(bodies[1].input.cellIds.front(), test::box(1, 2, 3).triangles.rows());
  }
}

TEST(SolidBodies, BodiesThatTouchOnAFaceAreTwo)
{
  const std::vector<SolidBody> bodies =
    solidBodies(together(test::box(2, 2, 2), moved(test::box(1, 1, 1), { 2.0, 0.5, 0.5 })), {});
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_NEAR(volumeOf(bodies[0].input), 8.0, 1e-12);
  EXPECT_NEAR(volumeOf(bodies[1].input), 1.0, 1e-12);
}

TEST(SolidBodies, ABodyThatFillsANotchIsNoVoid)
{
  // A U of 3 x 3 x 2 and the block between its legs, which touches it on three sides.
  const SolidInput u = test::cubes({ 3, 3, 2 }, [](int x, int y, int) { return x != 1 || y == 0; });
  for (const double scale : { 1.0, 0.1, 1.0 / 3.0 })
  {
    const SolidInput block = moved(test::box(1, 2, 2), { scale, scale, 0.0 }, scale);
    for (const SolidInput& solid : { together(moved(u, { 0.0, 0.0, 0.0 }, scale), block),
           together(block, moved(u, { 0.0, 0.0, 0.0 }, scale)) })
    {
      EXPECT_EQ(solidBodies(solid, {}).size(), 2u);
    }
  }
}

TEST(SolidBodies, AVoidIsNoBodyWhicheverWayItsTrianglesRun)
{
  const SolidInput box = test::box(3, 3, 3);
  SolidInput inner = moved(test::box(1, 1, 1), { 1.2, 1.2, 1.2 }, 0.5);
  for (int turn = 0; turn < 2; ++turn)
  {
    for (const SolidInput& solid : { together(box, inner), together(inner, box) })
    {
      const std::vector<SolidBody> bodies = solidBodies(solid, {});
      ASSERT_EQ(bodies.size(), 1u);
      try
      {
        makeSolidSurface(bodies[0].input);
        FAIL() << "a void cannot be swept";
      }
      catch (const hexsweep::InvalidInput& error)
      {
        EXPECT_NE(std::string(error.what()).find("inner void"), std::string::npos) << error.what();
      }
    }
    inner.triangles.col(0).swap(inner.triangles.col(1));
  }
}

TEST(SolidBodies, IdsTellBodiesApart)
{
  const SolidInput a = test::box(1, 1, 1);
  const SolidInput solid = together(a, moved(a, { 3.0, 0.0, 0.0 }));
  std::vector<Index> ids(static_cast<std::size_t>(solid.triangles.rows()), 7);
  std::fill(ids.begin(), ids.begin() + a.triangles.rows(), 12);
  const std::vector<SolidBody> bodies = solidBodies(solid, ids);
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_EQ(bodies[0].volumeId, 7);
  EXPECT_EQ(bodies[1].volumeId, 12);
  EXPECT_EQ(bodies[0].input.cellIds.front(), a.triangles.rows());
  EXPECT_EQ(solidBodies(solid, std::vector<Index>(ids.size(), 3)).size(), 1u);
  EXPECT_THROW(solidBodies(solid, { 1, 2 }), hexsweep::InvalidInput);
}

TEST(SolidBodies, EachHasItsOwnPointsAndQuadsAlone)
{
  // With all points each of many bodies would be as large as the whole.
  const SolidInput box = test::box(1, 1, 1);
  constexpr Index Across = 12;
  constexpr Index Count = Across * Across * Across;
  SolidInput solid;
  solid.points.resize(Count * box.points.rows(), 3);
  solid.triangles.resize(Count * box.triangles.rows(), 3);
  for (Index b = 0; b < Count; ++b)
  {
    const Eigen::RowVector3d shift(static_cast<double>(b % Across),
      static_cast<double>(b / Across % Across), static_cast<double>(b / Across / Across));
    solid.points.middleRows(b * box.points.rows(), box.points.rows()) =
      (2.0 * shift).replicate(box.points.rows(), 1) + box.points;
    solid.triangles.middleRows(b * box.triangles.rows(), box.triangles.rows()) =
      box.triangles.array() + b * box.points.rows();
  }
  // The first two triangles of each are halves of a quad.
  solid.quads.resize(Count, 4);
  solid.quadOfTriangle.assign(static_cast<std::size_t>(solid.triangles.rows()), -1);
  for (Index b = 0; b < Count; ++b)
  {
    const Index t = b * box.triangles.rows();
    solid.quadOfTriangle[static_cast<std::size_t>(t)] = b;
    solid.quads.row(b) << solid.triangles(t, 0), solid.triangles(t, 1), solid.triangles(t, 2),
      solid.triangles(t, 0);
    solid.quadCellIds.push_back(100 + b);
  }
  const std::vector<SolidBody> bodies = solidBodies(solid, {});
  ASSERT_EQ(bodies.size(), static_cast<std::size_t>(Count));
  for (Index b = 0; b < Count; ++b)
  {
    const SolidInput& body = bodies[static_cast<std::size_t>(b)].input;
    ASSERT_EQ(body.points.rows(), box.points.rows());
    ASSERT_EQ(body.quads.rows(), 1);
    EXPECT_EQ(body.quadCellIds.front(), 100 + b);
    EXPECT_EQ(body.quadOfTriangle.front(), 0);
    EXPECT_EQ(body.quads.row(0).head<3>(), body.triangles.row(0));
    for (Index p = 0; p < body.points.rows(); ++p)
    {
      ASSERT_EQ(body.points.row(p), solid.points.row(body.pointIds[static_cast<std::size_t>(p)]));
    }
  }
  EXPECT_NEAR(volumeOf(bodies.back().input), 1.0, 1e-12);
}

TEST(SolidBodies, AnOpenPieceIsABodyOfItsOwn)
{
  const SolidInput box = test::box(1, 1, 1);
  const SolidInput open = test::withTriangles(box, [](Index triangle) { return triangle != 0; });
  const std::vector<SolidBody> bodies =
    solidBodies(together(box, moved(open, { 3.0, 0.0, 0.0 })), {});
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_NO_THROW(makeSolidSurface(bodies[0].input));
  EXPECT_THROW(makeSolidSurface(bodies[1].input), hexsweep::InvalidInput);
}
}
