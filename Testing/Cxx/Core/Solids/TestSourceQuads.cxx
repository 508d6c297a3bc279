// SPDX-License-Identifier: BSD-3-Clause
// Quads for the caps of boxes and prisms, whose corners, areas and angles are known.
#include "Core/Solids/SourceQuads.h"

#include "Core/Solids/TargetFaces.h"

#include "Support/QuadBox.h"

#include <limits>
#include <set>
#include <utility>

namespace TestSourceQuads
{
using hexsweep::findSweepTopology;
using hexsweep::Index;
using hexsweep::makeSolidSurface;
using hexsweep::makeSourceQuads;
using hexsweep::SolidSurface;
using hexsweep::SourceQuads;
using hexsweep::SweepTopology;
using test::box;
using test::Cell;
using test::SolidInput;
using test::withQuads;
using Place = std::array<double, 3>;

Place placeOf(const Eigen::RowVector3d& point)
{
  return { point.x(), point.y(), point.z() };
}

/// Caps 5 and 6, all sides face 1.
Index oneSide(const Cell&, int direction)
{
  return direction >= 5 ? direction : 1;
}

/// A regular prism of n sides, 2 high, that are one face: caps 5 (below) and 6.
SolidInput prism(Index n)
{
  SolidInput solid;
  solid.points = hexsweep::Points::Zero(2 * n + 2, 3);
  std::vector<Index> corners;
  for (Index j = 0; j < n; ++j)
  {
    const double angle = 2.0 * test::Pi * static_cast<double>(j) / static_cast<double>(n);
    solid.points.row(j) << std::cos(angle), std::sin(angle), 0.0;
    solid.points.row(n + j) << std::cos(angle), std::sin(angle), 2.0;
    const Index k = (j + 1) % n;
    corners.insert(
      corners.end(), { 2 * n, k, j, 2 * n + 1, n + j, n + k, j, k, n + k, j, n + k, n + j });
    solid.faceIds.insert(solid.faceIds.end(), { 5, 6, 1, 1 });
  }
  solid.points(2 * n + 1, 2) = 2.0;
  solid.triangles = test::facesOf<hexsweep::Triangles>(corners);
  return solid;
}

double turnOf(const SolidInput& input)
{
  const SolidSurface solid = makeSolidSurface(input);
  return hexsweep::greatestFacetTurn(solid, findSweepTopology(solid, { 5 }, {}));
}

TEST(SourceQuads, BordersOfTheSidesBeginAtTheCorners)
{
  const SolidSurface solid = makeSolidSurface(box(3, 2, 4));
  std::set<Place> places;
  for (const Index point : hexsweep::edgeStarts(solid, findSweepTopology(solid, { 5 }, { 46 })))
  {
    places.insert(placeOf(solid.points.row(point)));
  }
  EXPECT_EQ(places, (std::set<Place>{ { 0, 0, 0 }, { 3, 0, 0 }, { 3, 2, 0 }, { 0, 2, 0 } }));
  const SolidSurface smooth = makeSolidSurface(box(3, 2, 4, oneSide));
  EXPECT_TRUE(hexsweep::edgeStarts(smooth, findSweepTopology(smooth, { 5 }, { 6 })).empty());
}

TEST(SourceQuads, EdgesWhereQuadsOfTheSidesBegin)
{
  const SolidInput input = withQuads(box(4, 2, 3), [](Index face) { return face == 3; }); // y = 0
  const SolidSurface solid = makeSolidSurface(input);
  const SweepTopology topology = findSweepTopology(solid, { 5 }, { 36 });
  const auto edges = hexsweep::meshedEdges(input, solid, topology);
  std::set<double> middles;
  for (const auto& [from, to] : edges)
  {
    const Eigen::RowVector3d middle = 0.5 * (solid.points.row(from) + solid.points.row(to));
    EXPECT_EQ(middle.tail<2>(), Eigen::RowVector2d(0.0, 0.0));
    middles.insert(middle.x());
  }
  EXPECT_EQ(edges.size(), 4u);
  EXPECT_EQ(middles, (std::set<double>{ 0.5, 1.5, 2.5, 3.5 }));
  EXPECT_TRUE(hexsweep::meshedEdges(box(4, 2, 3), solid, topology).empty());
}

TEST(SourceQuads, NewQuadsKeepCornersAndEdgesAndCoverTheCap)
{
  const SolidInput input = withQuads(box(4, 2, 3), [](Index face) { return face == 3; });
  const SolidSurface solid = makeSolidSurface(input);
  const SweepTopology topology = findSweepTopology(solid, { 5 }, { 36 });
  const SourceQuads made = makeSourceQuads(input, solid, topology, 0.0);
  EXPECT_EQ(made.size, 1.0); // that of the edges that are kept
  EXPECT_EQ(made.inverted, 0);
  double area = 0.0;
  std::set<std::pair<Place, Place>> edges;
  for (Index q = 0; q < made.mesh.quads.rows(); ++q)
  {
    const Eigen::RowVector3d vector = test::areaOf(made.mesh, q);
    EXPECT_LT(vector.z(), 0.0) << "outward is down";
    area -= vector.z();
    for (Index c = 0; c < 4; ++c)
    {
      const Place a = placeOf(made.mesh.points.row(made.mesh.quads(q, c)));
      const Place b = placeOf(made.mesh.points.row(made.mesh.quads(q, (c + 1) % 4)));
      EXPECT_EQ(a[2], 0.0);
      edges.insert({ std::min(a, b), std::max(a, b) });
    }
  }
  EXPECT_NEAR(area, 8.0, 1e-12);
  for (const auto& [from, to] : hexsweep::meshedEdges(input, solid, topology))
  {
    const Place a = placeOf(solid.points.row(from));
    const Place b = placeOf(solid.points.row(to));
    EXPECT_EQ(edges.count({ std::min(a, b), std::max(a, b) }), 1u);
  }
}

TEST(SourceQuads, SizeIsTheWantedEdge)
{
  const SolidInput input = box(4, 2, 3);
  const SolidSurface solid = makeSolidSurface(input);
  const SweepTopology topology = findSweepTopology(solid, { 5 }, { 36 });
  const Index coarse = makeSourceQuads(input, solid, topology, 0.5).mesh.quads.rows();
  const Index fine = makeSourceQuads(input, solid, topology, 0.25).mesh.quads.rows();
  EXPECT_NEAR(static_cast<double>(coarse), 8.0 / 0.25, 12.0);
  EXPECT_NEAR(static_cast<double>(fine), 8.0 / 0.0625, 40.0);
  for (const double size :
    { -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    test::expectInvalid([&] { makeSourceQuads(input, solid, topology, size); }, "Set QuadSize");
  }
}

TEST(SourceQuads, TurnsOfFacets)
{
  EXPECT_NEAR(turnOf(prism(5)), 72.0, 1e-9);
  EXPECT_NEAR(turnOf(prism(20)), 18.0, 1e-9);
  EXPECT_EQ(turnOf(prism(40)), 0.0);    // 9 degrees: smooth
  EXPECT_EQ(turnOf(box(3, 2, 4)), 0.0); // corners between faces are meant to be there
  EXPECT_NEAR(turnOf(box(3, 2, 4, oneSide)), 90.0, 1e-9);
}
}
