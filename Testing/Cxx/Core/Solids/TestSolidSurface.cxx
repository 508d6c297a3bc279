// SPDX-License-Identifier: BSD-3-Clause
// Solids made of cubes: merging, turning, volume, shells, and every way not to bound a solid.
#include "Core/Solids/SolidInput.h"

#include "Support/SolidShapes.h"

#include <algorithm>
#include <limits>
#include <random>
#include <set>

namespace TestSolidSurface
{
using hexsweep::Index;
using hexsweep::makeSolidSurface;
using hexsweep::Points;
using hexsweep::SolidOptions;
using hexsweep::SolidSurface;
using hexsweep::Triangles;
using test::box;
using test::cubes;
using test::expectInvalid;
using test::SolidInput;
using test::volumeOf;

void expectBad(const SolidInput& input, const std::string& part, const SolidOptions& options = {})
{
  expectInvalid([&] { makeSolidSurface(input, options); }, part);
}

/// A ring of cubes round a hole along z.
bool inRing(int x, int y, int)
{
  return x != 1 || y != 1;
}

TEST(SolidSurface, ABoxStaysAsItIs)
{
  const SolidInput input = box(2, 3, 4);
  const SolidSurface solid = makeSolidSurface(input);
  EXPECT_EQ(solid.points, input.points);
  EXPECT_EQ(solid.triangles, input.triangles);
  EXPECT_EQ(solid.faceIds, input.faceIds);
  EXPECT_EQ(solid.mergedPoints + solid.collapsedTriangles + solid.turnedTriangles, 0);
  EXPECT_FALSE(solid.facesByAngle);
  EXPECT_DOUBLE_EQ(volumeOf(solid), 24.0);
  for (std::size_t t = 0; t < solid.cellIds.size(); ++t)
  {
    EXPECT_EQ(solid.cellIds[t], static_cast<Index>(t));
    EXPECT_EQ(solid.triangleRows[t], static_cast<Index>(t));
  }
}

TEST(SolidSurface, TurnsTrianglesOutward)
{
  const SolidInput input = cubes({ 3, 3, 2 }, inRing);
  std::mt19937 generator(3);
  for (int run = 0; run < 5; ++run)
  {
    SolidInput shaken = input;
    Index turned = 0;
    for (Index t = 0; t < input.triangles.rows(); ++t)
    {
      // The last run turns all of them.
      if (run == 4 || generator() % 2 == 0)
      {
        std::swap(shaken.triangles(t, 1), shaken.triangles(t, 2));
        ++turned;
      }
    }
    const SolidSurface solid = makeSolidSurface(shaken);
    EXPECT_EQ(solid.triangles, input.triangles);
    EXPECT_EQ(solid.turnedTriangles, turned);
    EXPECT_DOUBLE_EQ(volumeOf(solid), 16.0);
  }
}

TEST(SolidSurface, MergesTheCornersOfSoupAtAnySizeAndPlace)
{
  const SolidInput ring = cubes({ 3, 3, 2 }, inRing);
  const SolidInput input = test::soup(ring);
  const SolidSurface plain = makeSolidSurface(input);
  EXPECT_EQ(plain.points.rows(), ring.points.rows());
  EXPECT_EQ(plain.mergedPoints, input.points.rows() - ring.points.rows());
  EXPECT_TRUE(std::is_sorted(plain.pointRows.begin(), plain.pointRows.end()));
  for (Index i = 0; i < ring.triangles.size(); ++i)
  {
    const Index p = plain.triangles.data()[i];
    EXPECT_EQ(plain.points.row(p), ring.points.row(ring.triangles.data()[i]));
    EXPECT_EQ(plain.points.row(p), input.points.row(plain.pointRows[static_cast<std::size_t>(p)]));
  }
  for (const test::Placement& placement : test::placements())
  {
    SCOPED_TRACE(placement.name);
    SolidInput moved = input;
    moved.points = placement.motion(input.points);
    const double noise = 1e-7 * placement.motion.scale;
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-noise, noise);
    for (Index i = 0; i < moved.points.size(); ++i)
    {
      moved.points.data()[i] += uniform(generator);
    }
    const SolidSurface solid = makeSolidSurface(moved);
    EXPECT_EQ(solid.triangles, plain.triangles);
    EXPECT_EQ(solid.mergedPoints, plain.mergedPoints);
    EXPECT_NEAR(volumeOf(solid) / std::pow(placement.motion.scale, 3), 16.0, 1e-5);
  }
}

TEST(SolidSurface, ToleranceIsRelativeToTheLocalEdge)
{
  // Two halves of a box; one is shifted by a hundredth of an edge.
  const SolidInput whole = box(2, 1, 1);
  SolidInput halves = test::soup(whole);
  for (Index i = 0; i < halves.points.rows(); ++i)
  {
    if (whole.faceIds[static_cast<std::size_t>(i / 3)] == 22)
    {
      halves.points(i, 0) += 0.01;
    }
  }
  expectBad(halves, "Raise the match tolerance");
  const SolidSurface solid = makeSolidSurface(halves, { 0.02, hexsweep::Pi / 6.0 });
  EXPECT_EQ(solid.points.rows(), whole.points.rows());
}

TEST(SolidSurface, SurfacesThatTouchStayApart)
{
  // A slit in a box, closed until its walls coincide.
  SolidInput slit = cubes({ 5, 3, 3 }, [](int x, int, int z) { return x != 2 || z == 0; });
  for (Index i = 0; i < slit.points.rows(); ++i)
  {
    if (slit.points(i, 0) == 2.0 && slit.points(i, 2) > 1.0)
    {
      slit.points(i, 0) = 3.0;
    }
  }
  const SolidSurface solid = makeSolidSurface(slit);
  EXPECT_EQ(solid.mergedPoints, 0);
  EXPECT_EQ(solid.points.rows(), slit.points.rows());
  // The bevel that closing the slit leaves at its foot takes half a cube of each of three rows.
  EXPECT_NEAR(volumeOf(solid), 39.0 + 3.0 * 2.0 - 1.5, 1e-12);
}

TEST(SolidSurface, CollapsedTrianglesAreLeftOutAndCounted)
{
  SolidInput input = test::soup(box(1, 1, 1));
  const SolidSurface plain = makeSolidSurface(input);
  // Between two corners that lie in one place, and with one point twice.
  const Index n = input.points.rows();
  input.points.conservativeResize(n + 3, 3);
  input.points.bottomRows<3>() << input.points.row(0), input.points.row(0), input.points.row(1);
  input = test::withTriangle(input, n, n + 1, n + 2, 5);
  input = test::withTriangle(input, 0, 0, 1, 5);
  const SolidSurface solid = makeSolidSurface(input);
  EXPECT_EQ(solid.collapsedTriangles, 2);
  EXPECT_EQ(solid.triangles, plain.triangles);
  EXPECT_EQ(solid.points, plain.points);
}

TEST(SolidSurface, EdgesWithoutLengthAreClosedUp)
{
  // A corner that is two points, as at the tip of a cone: one of its triangles goes over to the new
  // point, and two triangles without area fill the gap between its sides.
  const SolidInput plain = box(1, 1, 1);
  SolidInput input = plain;
  const Index n = plain.points.rows();
  const Eigen::Matrix<Index, 1, 3> old = plain.triangles.row(0);
  input.points.conservativeResize(n + 1, 3);
  input.points.row(n) = plain.points.row(old[0]);
  input.triangles(0, 0) = n;
  input = test::withTriangle(input, old[0], old[1], n, plain.faceIds[0]);
  input = test::withTriangle(input, old[0], n, old[2], plain.faceIds[0]);
  const SolidSurface solid = makeSolidSurface(input);
  EXPECT_EQ(solid.collapsedTriangles, 2);
  EXPECT_EQ(solid.mergedPoints, 1);
  EXPECT_EQ(solid.triangles, plain.triangles);
  EXPECT_EQ(solid.points, plain.points);
}

TEST(SolidSurface, UnusedPointsAreLeftOut)
{
  SolidInput input = box(1, 1, 1);
  const Points points = input.points;
  input.points.resize(points.rows() + 2, 3);
  input.points << Points::Constant(1, 3, std::numeric_limits<double>::quiet_NaN()), points,
    Points::Constant(1, 3, 1e30);
  input.triangles.array() += 1;
  const SolidSurface solid = makeSolidSurface(input);
  EXPECT_EQ(solid.points, points);
  EXPECT_EQ(solid.pointRows.front(), 1);
}

TEST(SolidSurface, CellIdsAreCarried)
{
  SolidInput input = box(1, 1, 1);
  for (Index t = 0; t < 12; ++t)
  {
    input.cellIds.push_back(100 + t / 2);
  }
  EXPECT_EQ(makeSolidSurface(input).cellIds, input.cellIds);
}

TEST(SolidSurface, FacesByFeatureAngle)
{
  SolidInput input = cubes({ 3, 3, 2 }, inRing);
  const std::vector<Index> planes = input.faceIds;
  input.faceIds.clear();
  const SolidSurface solid = makeSolidSurface(input);
  EXPECT_TRUE(solid.facesByAngle);
  // The planes of the outside and of the hole are all different: ids correspond one to one.
  std::map<Index, Index> faceOfPlane;
  Index next = 0;
  for (std::size_t t = 0; t < planes.size(); ++t)
  {
    const auto known = faceOfPlane.emplace(planes[t], next);
    next += known.second ? 1 : 0;
    EXPECT_EQ(solid.faceIds[t], known.first->second);
  }
  EXPECT_EQ(next, 10);
}

TEST(SolidSurface, ATwelveSidedPrismIsSmoothAtThirtyDegrees)
{
  for (const Index sides : { 11, 12 })
  {
    SolidInput prism;
    prism.points.resize(2 * sides, 3);
    std::vector<Index> ids;
    for (Index i = 0; i < sides; ++i)
    {
      const double angle = 2.0 * hexsweep::Pi * static_cast<double>(i) / static_cast<double>(sides);
      prism.points.row(i) << std::cos(angle), std::sin(angle), 0.0;
      prism.points.row(i + sides) << std::cos(angle), std::sin(angle), 1.0;
      const Index j = (i + 1) % sides;
      ids.insert(ids.end(), { i, j, j + sides, i, j + sides, i + sides });
      if (i > 1)
      {
        ids.insert(ids.end(), { 0, i, i - 1, sides, sides + i - 1, sides + i });
      }
    }
    prism.triangles = test::facesOf<Triangles>(ids);
    for (const test::Placement& placement : test::placements())
    {
      SCOPED_TRACE(placement.name);
      SolidInput moved = prism;
      moved.points = placement.motion(prism.points);
      const SolidSurface solid = makeSolidSurface(moved);
      const std::set<Index> faces(solid.faceIds.begin(), solid.faceIds.end());
      EXPECT_EQ(faces.size(), sides == 12 ? 3u : 13u);
    }
  }
}

TEST(SolidSurface, TrianglesAndFaces)
{
  const SolidSurface solid = makeSolidSurface(box(1, 1, 1));
  const std::vector<Index> triangles = hexsweep::trianglesOfFaces(solid, { 16, 5 });
  EXPECT_EQ(triangles.size(), 4u);
  EXPECT_TRUE(std::is_sorted(triangles.begin(), triangles.end()));
  EXPECT_EQ(hexsweep::facesOfTriangles(solid, triangles), (std::vector<Index>{ 5, 16 }));
}

TEST(SolidSurface, Empty)
{
  expectBad({}, "is empty");
  SolidInput collapsed;
  collapsed.points = Points::Random(3, 3);
  collapsed.triangles = test::facesOf<Triangles>({ 0, 1, 1, 2, 2, 2 });
  expectBad(collapsed, "all of its 2 triangles collapse");
}

TEST(SolidSurface, IdsOfTheWrongLength)
{
  SolidInput input = box(1, 1, 1);
  input.faceIds.pop_back();
  expectBad(input, "12 triangles but 11 face ids");
  input = box(1, 1, 1);
  input.cellIds = { 1, 2 };
  expectBad(input, "12 triangles but 2 cell ids");
}

TEST(SolidSurface, PointsThatDoNotExistOrAreNotFinite)
{
  SolidInput input = box(1, 1, 1);
  input.triangles(3, 1) = 8;
  expectBad(input, "triangle 3 names point 8");
  input.triangles(3, 1) = -1;
  expectBad(input, "triangle 3 names point -1");
  input = box(1, 1, 1);
  input.points(input.triangles(0, 0), 2) = std::numeric_limits<double>::infinity();
  expectBad(input, "not a finite number");
}

TEST(SolidSurface, ATriangleWithoutArea)
{
  SolidInput input = box(2, 1, 1);
  const Index n = input.points.rows();
  input.points.conservativeResize(n + 1, 3);
  input.points.row(n) = 0.5 * (input.points.row(0) + input.points.row(1));
  input.cellIds.resize(static_cast<std::size_t>(input.triangles.rows() + 1));
  for (std::size_t t = 0; t < input.cellIds.size(); ++t)
  {
    input.cellIds[t] = 500 + static_cast<Index>(t);
  }
  expectBad(test::withTriangle(input, 0, n, 1, 77), "cell 520 of face 77");
  expectBad(test::withTriangle(input, 0, n, 1, 77), "without area");
}

TEST(SolidSurface, TrianglesWithoutAreaThatFillACrackAreFlippedAway)
{
  const SolidInput whole = box(2, 1, 1);
  const double volume = volumeOf(makeSolidSurface(whole));
  // Each edge in turn gets a point, or three, which one of its two triangles does not know.
  for (Index row = 0; row < whole.triangles.rows(); ++row)
  {
    for (const Index points : { 1, 3 })
    {
      for (Index c = 0; c < 3; ++c)
      {
        const Index from = whole.triangles(row, c);
        const Index to = whole.triangles(row, (c + 1) % 3);
        const Index far = whole.triangles(row, (c + 2) % 3);
        const Index n = whole.points.rows();
        SolidInput input = whole;
        input.points.conservativeResize(n + points, 3);
        for (Index k = 0; k < points; ++k)
        {
          input.points.row(n + k) = whole.points.row(from) +
            static_cast<double>(k + 1) / 4.0 * (whole.points.row(to) - whole.points.row(from));
        }
        // This triangle knows the points, and a fan without area leads back to the whole edge.
        input.triangles.row(row) << far, from, n;
        const Index face = whole.faceIds[static_cast<std::size_t>(row)];
        for (Index k = 0; k < points; ++k)
        {
          const Index next = k + 1 < points ? n + k + 1 : to;
          input = test::withTriangle(input, far, n + k, next, face);
          input = test::withTriangle(input, n + k, from, next, 99);
        }
        const SolidSurface solid = makeSolidSurface(input);
        EXPECT_EQ(solid.flippedTriangles, points);
        EXPECT_NEAR(volumeOf(solid), volume, 1e-14);
        EXPECT_EQ(std::count(solid.faceIds.begin(), solid.faceIds.end(), 99), 0);
        EXPECT_EQ(solid.triangles.rows(), whole.triangles.rows() + 2 * points);
      }
    }
  }
}

TEST(SolidSurface, OpenWhereAFaceIsMissing)
{
  const SolidInput whole = box(2, 2, 1);
  const SolidInput open = test::withTriangles(
    whole, [&](Index t) { return whole.faceIds[static_cast<std::size_t>(t)] != 16; });
  expectBad(open, "is open: 8 edges have");
  expectBad(open, "A face is missing");
  expectBad(test::withTriangles(whole, [](Index t) { return t != 4; }), "is open: 3 edges have");
}

TEST(SolidSurface, MoreThanTwoTrianglesAtAnEdge)
{
  // Two cubes that share an edge, and a box with a wall inside.
  const SolidInput edge = cubes({ 2, 2, 1 }, [](int x, int y, int) { return x == y; });
  expectBad(edge, "4 triangles meet at one edge");
  expectBad(edge, "at (1, 1, 0.5)");
  SolidInput wall = box(2, 1, 1);
  std::map<std::vector<double>, Index> middle;
  for (Index i = 0; i < wall.points.rows(); ++i)
  {
    if (wall.points(i, 0) == 1.0)
    {
      middle[{ wall.points(i, 1), wall.points(i, 2) }] = i;
    }
  }
  wall = test::withTriangle(wall, middle[{ 0, 0 }], middle[{ 1, 0 }], middle[{ 1, 1 }], 9);
  wall = test::withTriangle(wall, middle[{ 0, 0 }], middle[{ 1, 1 }], middle[{ 0, 1 }], 9);
  expectBad(wall, "3 triangles meet at one edge");
}

TEST(SolidSurface, ATriangleThatIsThereTwice)
{
  SolidInput input = box(1, 1, 1);
  const Eigen::Matrix<Index, 1, 3> row = input.triangles.row(7);
  input = test::withTriangle(input, row[1], row[0], row[2], 3);
  expectBad(input, "cell 7 of face");
  expectBad(input, "are the same triangle");
}

TEST(SolidSurface, PartsThatTouchInAPoint)
{
  const SolidInput input = cubes({ 2, 2, 2 }, [](int x, int y, int z) { return x == y && y == z; });
  expectBad(input, "touch in a point only, at (1, 1, 1)");
}

TEST(SolidSurface, ASurfaceWithoutInside)
{
  // A grid whose left and right ends are joined, its lower and upper ones upside down.
  constexpr Index n = 6;
  SolidInput bottle;
  bottle.points.resize(n * n, 3);
  std::vector<Index> ids;
  const auto point = [](Index i, Index j) { return j == n ? (n - i) % n * n : i % n * n + j; };
  std::mt19937 generator(1);
  for (Index i = 0; i < n; ++i)
  {
    for (Index j = 0; j < n; ++j)
    {
      for (Index c = 0; c < 3; ++c)
      {
        bottle.points(i * n + j, c) = static_cast<double>(generator() % 1000);
      }
      const Index a = point(i, j);
      const Index b = point(i + 1, j);
      const Index c = point(i + 1, j + 1);
      const Index d = point(i, j + 1);
      ids.insert(ids.end(), { a, b, c, a, c, d });
    }
  }
  bottle.triangles = test::facesOf<Triangles>(ids);
  expectBad(bottle, "cannot be oriented");
}

TEST(SolidSurface, SeveralShells)
{
  expectBad(cubes({ 3, 1, 1 }, [](int x, int, int) { return x != 1; }), "2 closed shells side by");
  expectBad(cubes({ 3, 3, 3 }, [](int x, int y, int z) { return x != 1 || y != 1 || z != 1; }),
    "an inner void");
  expectBad(cubes({ 5, 1, 1 }, [](int x, int, int) { return x % 2 == 0; }), "3 closed shells");
}

TEST(SolidSurface, NoVolume)
{
  SolidInput sheet;
  sheet.points = Points::Random(4, 3);
  sheet.triangles = test::facesOf<Triangles>({ 0, 1, 2, 0, 2, 3, 0, 2, 1, 0, 3, 2 });
  // Upper and lower side share the diagonal as well.
  expectBad(sheet, "are the same triangle");
  sheet.triangles = test::facesOf<Triangles>({ 0, 1, 2, 0, 2, 1 });
  expectBad(sheet, "encloses no volume");
  // The walls of a flattened box collapse, and its bottom and top come to lie on the same points.
  SolidInput flat = box(2, 2, 1);
  flat.points.col(2).setZero();
  expectBad(flat, "are the same triangle");
  // Flat, but with an area each: two triangulated squares with different diagonals.
  sheet.points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  sheet.triangles = test::facesOf<Triangles>({ 0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2 });
  expectBad(sheet, "encloses no volume");
}

TEST(SolidSurface, OneFaceOnly)
{
  SolidInput input = box(1, 1, 1);
  input.faceIds.clear();
  SolidOptions options;
  options.featureAngle = 1.6;
  expectBad(input, "leaves it one face: its sharpest edge bends by 90 degrees", options);
  options.featureAngle = 1.5;
  EXPECT_EQ(makeSolidSurface(input, options).faceIds.size(), 12u);
  options.featureAngle = 0.0;
  expectBad(input, "feature angle is 0 degrees", options);
  options.featureAngle = 1.5;
  options.matchTolerance = 0.5;
  expectBad(input, "match tolerance is 0.5", options);
}
}
