// SPDX-License-Identifier: BSD-3-Clause
// Prisms whose target cap consists of several faces: the quads of each face are to cover it.
#include "Core/Solids/TargetImprint.h"

#include "Core/Hexahedra/HexQuality.h"
#include "Core/Interior/InteriorStarts.h"
#include "Core/Interior/SweptHexes.h"
#include "Core/Solids/BoundaryQuads.h"
#include "Core/Solids/SolidCage.h"
#include "Core/Solids/SourceQuads.h"
#include "Support/FacedPrisms.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace TestTargetImprint
{
using namespace test;
using hexsweep::SolidInput;

constexpr Index Layers = 3;

Place3 affinePlace(const Eigen::Matrix3d& linear, const Eigen::RowVector3d& move)
{
  return [=](double x, double y, double h) -> Eigen::RowVector3d {
    const Eigen::RowVector3d p(x, y, 0.0);
    return (1.0 - h) * p + h * (p * linear.transpose() + move);
  };
}

/// Right, oblique, frustum.
std::vector<Place3> places()
{
  const Eigen::Matrix3d straight = Eigen::Matrix3d::Identity();
  return { affinePlace(straight, { 0, 0, 5 }), affinePlace(straight, { 3, -2, 6 }),
    affinePlace(0.7 * straight, { 1, 1, 6 }) };
}

struct Swept
{
  hexsweep::SourceQuads quads;
  hexsweep::SolidCage cage;
  std::map<Index, double> areas;      ///< of the quads, by the face that they are said to be of
  std::map<Index, double> planeAreas; ///< over the plane of x and y
  std::map<Index, Index> quadCounts;
  Index notCertified = 0;
};

std::vector<Index> idsOf(const std::vector<CapFace>& faces)
{
  std::vector<Index> ids;
  for (const CapFace& face : faces)
  {
    ids.push_back(face.id);
  }
  return ids;
}

Swept swept(const SolidInput& input, const std::vector<CapFace>& bottom,
  const std::vector<CapFace>& top, double size)
{
  const hexsweep::SolidSurface solid = hexsweep::makeSolidSurface(input);
  const hexsweep::SweepTopology topology = hexsweep::sweepBetween(solid, idsOf(bottom), idsOf(top));
  Swept result;
  result.quads = hexsweep::makeSourceQuads(input, solid, topology, size);
  hexsweep::SolidCageInput cage{ solid, topology, result.quads.mesh, {}, {} };
  cage.layers.layers = Layers;
  cage.imprinted = result.quads.imprinted;
  result.cage = hexsweep::makeSolidCage(cage);
  const hexsweep::SweepInterior interior = hexsweep::sweepInterior(result.cage,
    hexsweep::interiorStarts(hexsweep::InteriorKind::Automatic, result.cage.isRuled), {});
  result.notCertified =
    hexsweep::summarize(hexsweep::hexQualities(interior.points,
                          hexsweep::sweptHexes(result.cage.quads, interior.points, Layers), true))
      .notCertified;
  for (const hexsweep::BoundaryQuad& quad : hexsweep::boundaryQuads(result.cage, solid, topology))
  {
    const auto& p = quad.points;
    const Eigen::RowVector3d u = interior.points.row(p[2]) - interior.points.row(p[0]);
    const Eigen::RowVector3d v = interior.points.row(p[3]) - interior.points.row(p[1]);
    const Index face = solid.faceIds[static_cast<std::size_t>(quad.triangle)];
    result.areas[face] += 0.5 * u.cross(v).norm();
    result.planeAreas[face] += 0.5 * std::abs(u.cross(v).z());
    ++result.quadCounts[face];
  }
  return result;
}

void expectAreas(const Swept& made, const std::vector<CapFace>& faces, const Place3& place,
  double height, double relative)
{
  for (const CapFace& face : faces)
  {
    const double area = areaOfFace(face, place, height);
    ASSERT_EQ(made.areas.count(face.id), 1u) << "face " << face.id;
    EXPECT_NEAR(made.areas.at(face.id), area, relative * area) << "face " << face.id;
  }
}

/// Sweeps the solid at every place and compares the areas of all faces of both caps.
void expectFacesCovered(const std::vector<CapFace>& bottom, const std::vector<CapFace>& top,
  double size, double relative = 1e-10)
{
  int number = 0;
  for (const Place3& place : places())
  {
    SCOPED_TRACE("place " + std::to_string(number++));
    const SolidInput input = facedPrism(bottom, top, bottom[0].outline[0], place);
    const Swept made = swept(input, bottom, top, size);
    EXPECT_EQ(made.quads.inverted, 0);
    EXPECT_EQ(made.quads.imprintWarning, "");
    EXPECT_TRUE(made.cage.isRuled);
    EXPECT_EQ(made.notCertified, 0);
    expectAreas(made, bottom, place, 0.0, relative);
    expectAreas(made, top, place, 1.0, relative);
  }
}

/// The target's nodes are the image of the source's.
double greatestError(const Swept& made, const Place3& place)
{
  double greatest = 0.0;
  for (Index i = 0; i < made.cage.source.rows(); ++i)
  {
    const Eigen::RowVector3d p = made.cage.source.row(i);
    greatest = std::max(greatest, (made.cage.target.row(i) - place(p.x(), p.y(), 1.0)).norm());
  }
  return greatest;
}

CapFace whole(Index id, double x = 6, double y = 4)
{
  return { id, { { 0, 0 }, { x, 0 }, { x, y }, { 0, y } }, {} };
}

std::vector<CapFace> halves(Index id, double x)
{
  return { { id, { { 0, 0 }, { x, 0 }, { x, 4 }, { 0, 4 } }, {} },
    { id + 1, { { x, 0 }, { 6, 0 }, { 6, 4 }, { x, 4 } }, {} } };
}

std::vector<CapFace> quarters(Index id, double x, double y)
{
  return { { id, { { 0, 0 }, { x, 0 }, { x, y }, { 0, y } }, {} },
    { id + 1, { { x, 0 }, { 6, 0 }, { 6, y }, { x, y } }, {} },
    { id + 2, { { x, y }, { 6, y }, { 6, 4 }, { x, 4 } }, {} },
    { id + 3, { { 0, y }, { x, y }, { x, 4 }, { 0, 4 } }, {} } };
}

std::vector<CapFace> withDisk(Index id, double radius, Index nodes)
{
  CapFace outer = whole(id);
  outer.holes.push_back(holeSection(3, 2, radius, nodes));
  Section disk = outer.holes[0];
  std::reverse(disk.begin(), disk.end());
  return { outer, { id + 1, disk, {} } };
}

TEST(TargetImprint, TwoFaces)
{
  expectFacesCovered({ whole(2) }, halves(20, 2.3), 0.4);
}

TEST(TargetImprint, FourFacesThatMeetInAPoint)
{
  expectFacesCovered({ whole(2) }, quarters(20, 2.3, 1.7), 0.4);
}

TEST(TargetImprint, AnLShapedBorder)
{
  const std::vector<CapFace> top{
    { 20, { { 0, 0 }, { 2, 0 }, { 2, 2.5 }, { 6, 2.5 }, { 6, 4 }, { 0, 4 } }, {} },
    { 21, { { 2, 0 }, { 6, 0 }, { 6, 2.5 }, { 2, 2.5 } }, {} }
  };
  expectFacesCovered({ whole(2) }, top, 0.4);
}

TEST(TargetImprint, BordersOfBothCapsThatCross)
{
  const std::vector<CapFace> bottom{ { 2, { { 0, 0 }, { 6, 0 }, { 6, 2.2 }, { 0, 1.1 } }, {} },
    { 3, { { 0, 1.1 }, { 6, 2.2 }, { 6, 4 }, { 0, 4 } }, {} } };
  expectFacesCovered(bottom, halves(20, 3.1), 0.4);
  expectFacesCovered(quarters(2, 2.5, 1.5), quarters(20, 4.0, 2.5), 0.4);
}

TEST(TargetImprint, BordersOfBothCapsThatCoincide)
{
  expectFacesCovered(halves(2, 2.3), halves(20, 2.3), 0.4);
  expectFacesCovered(quarters(2, 2.3, 1.7), quarters(20, 2.3, 1.7), 0.4);
  expectFacesCovered(quarters(2, 2.3, 1.7), halves(20, 2.3), 0.4);
}

TEST(TargetImprint, BordersThatAllButCoincideAreOneCurve)
{
  // Four thousandths of a unit are a hundredth of a quad.
  const std::vector<CapFace> bottom = halves(2, 2.3);
  const std::vector<CapFace> top = halves(20, 2.304);
  const Place3 place = places()[0];
  const Swept made = swept(facedPrism(bottom, top, { 0, 0 }, place), bottom, top, 0.4);
  EXPECT_EQ(made.quads.imprintWarning, "");
  EXPECT_EQ(made.notCertified, 0);
  expectAreas(made, bottom, place, 0.0, 1e-10);
  // The target's nodes are on the target's border.
  expectAreas(made, top, place, 1.0, 1e-10);
  EXPECT_EQ(made.quads.mesh.quads.rows(),
    swept(facedPrism(bottom, halves(20, 2.3), { 0, 0 }, place), bottom, top, 0.4)
      .quads.mesh.quads.rows());
}

/// Quads cut the facets' corners: of an inscribed polygon with edges h on a circle R that is
/// (h / R)^2 / 6 of the area.
double facetError(double size, double radius)
{
  return size * size / (6.0 * radius * radius);
}

TEST(TargetImprint, ADiskWithinTheTarget)
{
  for (const Index nodes : { 16, 48 })
  {
    expectFacesCovered({ whole(2) }, withDisk(20, 1.2, nodes), 0.25, facetError(0.5, 1.2));
  }
}

TEST(TargetImprint, DisksWithOtherFacetsAreOneCurve)
{
  // Twenty facets here, thirty-three there: one circle all the same.
  const std::vector<CapFace> bottom = withDisk(2, 1.2, 20);
  const std::vector<CapFace> top = withDisk(20, 1.2, 33);
  const Place3 place = places()[1];
  const Swept made = swept(facedPrism(bottom, top, { 0, 0 }, place), bottom, top, 0.25);
  EXPECT_EQ(made.quads.imprintWarning, "");
  EXPECT_EQ(made.notCertified, 0);
  expectAreas(made, bottom, place, 0.0, facetError(0.5, 1.2));
  expectAreas(made, top, place, 1.0, facetError(0.5, 1.2));
  EXPECT_EQ(made.quadCounts.at(3), made.quadCounts.at(21));
  EXPECT_EQ(made.quadCounts.at(2), made.quadCounts.at(20));
}

TEST(TargetImprint, AStarOnAPrismOfThirtyFiveSides)
{
  Section star;
  for (Index j = 0; j < 10; ++j)
  {
    const double angle = 2.0 * Pi * static_cast<double>(j) / 10.0 + 0.1;
    const double radius = j % 2 == 0 ? 6.0 : 3.0;
    star.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  const Section outline = circleSection(0, 0, 10, 35);
  Section hole = star;
  std::reverse(hole.begin(), hole.end());
  const std::vector<CapFace> bottom{ { 2, outline, {} } };
  const std::vector<CapFace> top{ { 20, outline, { hole } }, { 21, star, {} } };
  for (const Place3& place : places())
  {
    const Swept made = swept(facedPrism(bottom, top, outline[0], place), bottom, top, 1.0);
    EXPECT_EQ(made.quads.imprintWarning, "");
    EXPECT_TRUE(made.cage.isRuled);
    EXPECT_EQ(made.notCertified, 0);
    EXPECT_NEAR(made.areas.at(21), areaOfFace(top[1], place, 1.0), 1e-9);
    EXPECT_LE(greatestError(made, place), 1e-11);
  }
}

TEST(TargetImprint, TheTargetIsTheImageOfTheSource)
{
  for (const Place3& place : places())
  {
    const std::vector<CapFace> bottom = halves(2, 3.7);
    const std::vector<CapFace> top = quarters(20, 2.3, 1.7);
    const Swept made = swept(facedPrism(bottom, top, { 0, 0 }, place), bottom, top, 0.4);
    EXPECT_LE(greatestError(made, place), 1e-12 * 10.0);
    EXPECT_FALSE(made.quads.imprinted.empty());
  }
}

TEST(TargetImprint, AFaceTooNarrowForQuadsIsNamed)
{
  std::vector<CapFace> top = halves(20, 2.3);
  top.push_back({ 22, { { 2.304, 0 }, { 6, 0 }, { 6, 4 }, { 2.304, 4 } }, {} });
  top[1].outline = { { 2.3, 0 }, { 2.304, 0 }, { 2.304, 4 }, { 2.3, 4 } };
  const std::vector<CapFace> bottom = halves(2, 2.302);
  const Swept made = swept(facedPrism(bottom, top, { 0, 0 }, places()[0]), bottom, top, 0.4);
  EXPECT_NE(made.quads.imprintWarning.find("face 21"), std::string::npos)
    << made.quads.imprintWarning;
  EXPECT_EQ(made.notCertified, 0);
}

/// Corners beside a straight edge of a face, so that it can be bent.
void divideEdges(std::vector<CapFace>& faces, Index parts)
{
  for (CapFace& face : faces)
  {
    Section fine;
    for (std::size_t j = 0; j < face.outline.size(); ++j)
    {
      const Eigen::RowVector2d a = face.outline[j];
      const Eigen::RowVector2d b = face.outline[(j + 1) % face.outline.size()];
      for (Index k = 0; k < parts; ++k)
      {
        // Alike from either end.
        const double t = static_cast<double>(k) / static_cast<double>(parts);
        const bool rises = a.x() + a.y() < b.x() + b.y();
        fine.push_back(k == 0 ? a
            : rises           ? Eigen::RowVector2d(a + t * (b - a))
                              : Eigen::RowVector2d(b + (1.0 - t) * (a - b)));
      }
    }
    face.outline = fine;
  }
}

TEST(TargetImprint, AVaultOfSeveralFaces)
{
  const Place3 vault = [](double x, double y, double h) -> Eigen::RowVector3d {
    return { x, y, h * (5.0 + 0.15 * y * (4.0 - y) + 0.1 * x) };
  };
  const Place3 flat = affinePlace(Eigen::Matrix3d::Identity(), { 0, 0, 5 });
  const std::vector<CapFace> bottom{ whole(2) };
  for (std::vector<CapFace> top : { halves(20, 2.3), quarters(20, 2.3, 1.7) })
  {
    SCOPED_TRACE(top.size());
    const std::vector<CapFace> coarse = top;
    divideEdges(top, 8);
    const Swept made = swept(facedPrism(bottom, top, { 0, 0 }, vault), bottom, top, 0.4);
    EXPECT_EQ(made.quads.imprintWarning, "");
    EXPECT_FALSE(made.cage.isRuled);
    EXPECT_FALSE(made.cage.leftBorders);
    EXPECT_EQ(made.notCertified, 0);
    for (const CapFace& face : coarse)
    {
      const double area = areaOfFace(face, flat, 1.0);
      EXPECT_NEAR(made.planeAreas.at(face.id), area, 1e-10 * area) << "face " << face.id;
    }
  }
}

TEST(TargetImprint, FlatCapsBetweenWallsThatAreNotRuled)
{
  // The caps are affine images; the walls, which twist, have too few facets to be ruled.
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  linear.topLeftCorner<2, 2>() << 0.7, 0.1, -0.05, 0.6;
  const Place3 place = affinePlace(linear, { 1, 1, 6 });
  const std::vector<CapFace> bottom{ { 2, { { 0, 0 }, { 6, 0 }, { 6, 2.2 }, { 0, 1.1 } }, {} },
    { 3, { { 0, 1.1 }, { 6, 2.2 }, { 6, 4 }, { 0, 4 } }, {} } };
  const std::vector<CapFace> top = halves(20, 3.1);
  const Swept made = swept(facedPrism(bottom, top, { 0, 0 }, place), bottom, top, 0.4);
  EXPECT_EQ(made.quads.imprintWarning, "");
  EXPECT_FALSE(made.cage.isRuled);
  EXPECT_FALSE(made.cage.leftBorders);
  EXPECT_EQ(made.notCertified, 0);
  expectAreas(made, bottom, place, 0.0, 1e-10);
  expectAreas(made, top, place, 1.0, 1e-10);
}

TEST(TargetImprint, BordersThatCrowdAreLeftOutWithAWarning)
{
  // Strips that are a twenty-fifth of a quad wide, which nothing snaps together.
  std::vector<CapFace> top;
  for (Index k = 0; k <= 6; ++k)
  {
    const double left = k == 0 ? 0.0 : 2.0 + 0.016 * static_cast<double>(k);
    const double right = k == 6 ? 6.0 : 2.0 + 0.016 * static_cast<double>(k + 1);
    top.push_back({ 20 + k, { { left, 0 }, { right, 0 }, { right, 4 }, { left, 4 } }, {} });
  }
  const std::vector<CapFace> bottom{ whole(2) };
  const Swept made = swept(facedPrism(bottom, top, { 0, 0 }, places()[0]), bottom, top, 0.4);
  EXPECT_NE(
    made.quads.imprintWarning.find("faces 20, 21, 22, 23, 24, 25 and 26"), std::string::npos)
    << made.quads.imprintWarning;
  EXPECT_TRUE(made.quads.imprinted.empty());
  EXPECT_EQ(made.notCertified, 0);
}

std::vector<CapFace> slantedHalves(Index id, double below, double above)
{
  return { { id, { { 0, 0 }, { below, 0 }, { above, 4 }, { 0, 4 } }, {} },
    { id + 1, { { below, 0 }, { 6, 0 }, { 6, 4 }, { above, 4 } }, {} } };
}

TEST(TargetImprint, ChanceBordersNeverInvertAQuad)
{
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> inside(0.1, 5.9);
  int left = 0;
  for (std::size_t k = 0; k < 30; ++k)
  {
    SCOPED_TRACE(k);
    const double a = inside(generator);
    const double b = inside(generator);
    // Every third time both begin near each other.
    const double c = k % 3 == 0 ? a + 0.01 * (inside(generator) - 3.0) : inside(generator);
    const double d = inside(generator);
    const std::vector<CapFace> bottom = slantedHalves(2, a, b);
    const std::vector<CapFace> top = slantedHalves(20, c, d);
    const Place3 place = places()[k % 3];
    const Swept made =
      swept(facedPrism(bottom, top, { 0, 0 }, place), bottom, top, k % 2 == 0 ? 0.9 : 0.4);
    EXPECT_EQ(made.quads.inverted, 0);
    EXPECT_EQ(made.notCertified, 0);
    expectAreas(made, bottom, place, 0.0, 1e-10);
    if (made.quads.imprintWarning.empty())
    {
      expectAreas(made, top, place, 1.0, 1e-10);
    }
    else
    {
      ++left;
    }
  }
  EXPECT_LE(left, 6); // borders that nearly meet, at angles that leave no room for good quads
}
}
