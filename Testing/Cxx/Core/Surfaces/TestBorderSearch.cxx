// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/BorderSearch.h"

#include "Support/CapMeshes.h"

namespace TestBorderSearch
{
using hexsweep::BorderSearch;
using hexsweep::ChainShape;
using hexsweep::chainShape;
using hexsweep::PointPair;
using test::Index;
using test::Points;

ChainShape polygonShape(Index n, Points& points)
{
  points = Points::Zero(n, 3);
  std::vector<PointPair> edges;
  for (Index j = 0; j < n; ++j)
  {
    const double angle = 2.0 * test::Pi * static_cast<double>(j) / static_cast<double>(n);
    points.row(j) << 3.0 * std::cos(angle), 3.0 * std::sin(angle), 0.0;
    edges.emplace_back(j, (j + 1) % n);
  }
  return chainShape(points, edges);
}

TEST(BorderSearch, FacetsOfACircleKnowTheirSagitta)
{
  Points points;
  for (const Index n : { 12, 20, 100 })
  {
    const ChainShape shape = polygonShape(n, points);
    const double sagitta = 3.0 * (1.0 - std::cos(test::Pi / static_cast<double>(n)));
    for (Index j = 0; j < n; ++j)
    {
      EXPECT_FALSE(shape.corner[static_cast<std::size_t>(j)]);
      EXPECT_GE(shape.sagitta[static_cast<std::size_t>(j)], sagitta);
      EXPECT_LE(shape.sagitta[static_cast<std::size_t>(j)], 1.15 * sagitta);
    }
  }
  const ChainShape octagon = polygonShape(8, points);
  EXPECT_TRUE(octagon.corner[0]);
  EXPECT_EQ(octagon.sagitta[0], 0.0);
}

TEST(BorderSearch, PlacesOnTheBoundaryAndBetweenFaces)
{
  test::TriangleMesh two{ Points(6, 3), test::Triangles(4, 3) };
  two.points << 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0;
  two.triangles << 0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4;
  const BorderSearch search(two, { 1, 1, 2, 2 }, {});
  EXPECT_EQ(search.edges().size(), 7u);
  EXPECT_EQ(search.corners(), (std::vector<Index>{ 0, 1, 2, 3, 4, 5 }));
  const BorderSearch::Place inner = search.closest({ 1.2, 0.75, 0.3 }, false);
  EXPECT_EQ(inner.edge.ends, PointPair(1, 4));
  EXPECT_FALSE(inner.edge.onBoundary);
  EXPECT_NEAR(inner.along, 0.75, 1e-15);
  EXPECT_NEAR(inner.distance, std::hypot(0.2, 0.3), 1e-15);
  const BorderSearch::Place outer = search.closest({ 1.2, 0.75, 0.0 }, true);
  EXPECT_EQ(outer.edge.ends, PointPair(4, 5));
  EXPECT_TRUE(outer.edge.onBoundary);
  EXPECT_NEAR(outer.along, 0.2, 1e-15);
  EXPECT_NEAR(outer.distance, 0.25, 1e-15);
  // Without faces the two inner ends are on straight edges, and corners only if they are kept.
  EXPECT_EQ(BorderSearch(two, { 1, 1, 1, 1 }, {}).corners(), (std::vector<Index>{ 0, 2, 3, 5 }));
  EXPECT_EQ(
    BorderSearch(two, { 1, 1, 1, 1 }, { 4 }).corners(), (std::vector<Index>{ 0, 2, 3, 4, 5 }));
}
}
