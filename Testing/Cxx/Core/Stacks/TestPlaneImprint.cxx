// SPDX-License-Identifier: BSD-3-Clause
// Segments that cross, touch and lie on each other become a graph, and that is triangulated.
#include "Core/Stacks/ConstrainedTriangulation.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Predicates.h"

namespace TestPlaneImprint
{
using hexsweep::ConstrainedTriangles;
using hexsweep::imprintSegments;
using hexsweep::Index;
using hexsweep::Pi;
using hexsweep::PlaneGraph;
using hexsweep::PlaneSegments;
using hexsweep::triangulateGraph;

/// Adds closed chains.
struct Chains : PlaneSegments
{
  void add(const std::vector<Eigen::RowVector2d>& loop, double near, double high = 0.0)
  {
    const Index first = this->points.rows();
    const Index count = static_cast<Index>(loop.size());
    this->points.conservativeResize(first + count, 2);
    for (Index i = 0; i < count; ++i)
    {
      this->points.row(first + i) = loop[static_cast<std::size_t>(i)];
      this->corner.push_back(false);
      this->segments.emplace_back(first + i, first + (i + 1) % count);
      this->tolerance.push_back(near);
      this->rise.push_back(high);
    }
  }

  void addCircle(double x, double y, double radius, int chords, double turn, double near)
  {
    std::vector<Eigen::RowVector2d> loop;
    for (int i = 0; i < chords; ++i)
    {
      const double angle = turn + 2.0 * Pi * i / chords;
      loop.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
    }
    const double half = Pi / chords;
    this->add(loop, near, 1.1 * radius * (1.0 - std::cos(half)));
  }

  void addBox(double x, double y, double a, double b, double near)
  {
    this->add({ { x - a, y - b }, { x + a, y - b }, { x + a, y + b }, { x - a, y + b } }, near);
  }
};

double areaOf(const PlaneGraph& graph, const ConstrainedTriangles& triangles, Index region)
{
  double area = 0.0;
  for (Index t = 0; t < triangles.triangles.rows(); ++t)
  {
    if (triangles.regionOf[static_cast<std::size_t>(t)] == region)
    {
      const Eigen::RowVector2d a = graph.points.row(triangles.triangles(t, 0));
      const Eigen::RowVector2d b = graph.points.row(triangles.triangles(t, 1));
      const Eigen::RowVector2d c = graph.points.row(triangles.triangles(t, 2));
      area += 0.5 * ((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x());
    }
  }
  return area;
}

std::vector<double> regionAreas(const PlaneGraph& graph, const ConstrainedTriangles& triangles)
{
  std::vector<double> areas;
  for (Index r = 0; r < triangles.regions; ++r)
  {
    areas.push_back(areaOf(graph, triangles, r));
  }
  std::sort(areas.begin(), areas.end());
  return areas;
}

/// Whether no two edges share more than their ends, by exact signs.
bool isPlanar(const PlaneGraph& graph)
{
  for (std::size_t i = 0; i < graph.edges.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const auto& [a, b] = graph.edges[i];
      const auto& [c, d] = graph.edges[j];
      const auto side = [&](Index p, Index q, Index r) {
        return hexsweep::orientation(graph.points.row(p), graph.points.row(q), graph.points.row(r));
      };
      if (a != c && a != d && b != c && b != d && side(a, b, c) * side(a, b, d) < 0 &&
        side(c, d, a) * side(c, d, b) < 0)
      {
        return false;
      }
    }
  }
  return true;
}

TEST(PlaneImprint, CrossingBoxesAreCut)
{
  Chains chains;
  chains.addBox(0.0, 0.0, 2.0, 1.0, 1e-6);
  chains.addBox(0.5, 0.25, 1.0, 2.0, 1e-6);
  const PlaneGraph graph = imprintSegments(chains);
  EXPECT_EQ(graph.points.rows(), 12);
  EXPECT_TRUE(isPlanar(graph));
  const std::vector<double> areas = regionAreas(graph, triangulateGraph(graph));
  ASSERT_EQ(areas.size(), 5U);
  double sum = 0.0;
  for (const double area : areas)
  {
    sum += area;
  }
  EXPECT_NEAR(sum, 8.0 + 8.0 - 4.0, 1e-12);
  EXPECT_NEAR(areas.back(), 4.0, 1e-12);
}

TEST(PlaneImprint, TwoChainsOfChordsOfOneCircleBecomeOne)
{
  Chains chains;
  chains.addCircle(0.0, 0.0, 5.0, 24, 0.0, 1e-3);
  chains.addCircle(0.0, 0.0, 5.0, 31, 0.1, 1e-3);
  const PlaneGraph graph = imprintSegments(chains);
  const ConstrainedTriangles triangles = triangulateGraph(graph);
  EXPECT_EQ(triangles.regions, 1);
  EXPECT_EQ(static_cast<Index>(graph.edges.size()), graph.points.rows());
  EXPECT_NEAR(areaOf(graph, triangles, 0), 25.0 * Pi, 0.02 * 25.0 * Pi);
}

TEST(PlaneImprint, NearlyCoincidentCurvesBecomeOneAndFarOnesDoNot)
{
  for (const double gap : { 0.0, 1e-9, 0.01, 0.2 })
  {
    Chains chains;
    chains.addBox(0.0, 0.0, 4.0, 3.0, 0.05);
    chains.addBox(-2.0 + gap, 0.0, 2.0, 1.0, 0.05);
    const PlaneGraph graph = imprintSegments(chains);
    EXPECT_TRUE(isPlanar(graph));
    const Index regions = triangulateGraph(graph).regions;
    EXPECT_EQ(regions, 2) << gap;
    // The short side of the inner box lies on the outer one.
    EXPECT_EQ(graph.edges.size(), gap < 0.05 ? 9U : 8U) << gap;
    EXPECT_LE(graph.greatestMove, 0.05);
  }
}

TEST(PlaneImprint, SmallFeaturesStay)
{
  Chains chains;
  chains.addBox(0.0, 0.0, 50.0, 50.0, 1.0);
  chains.addCircle(0.0, 0.0, 0.3, 12, 0.0, 0.01);
  EXPECT_EQ(triangulateGraph(imprintSegments(chains)).regions, 2);
}

TEST(PlaneImprint, RandomCirclesAndBoxesGiveAPlanarGraph)
{
  for (unsigned int seed = 1; seed <= 20; ++seed)
  {
    std::mt19937 engine(seed);
    const auto between = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(engine()) / 4294967296.0;
    };
    Chains chains;
    for (int i = 0; i < 8; ++i)
    {
      const double x = between(-10.0, 10.0);
      const double y = std::round(between(-10.0, 10.0));
      if (i % 2 == 0)
      {
        chains.addCircle(x, y, between(1.0, 6.0), 40, 0.0, 0.03);
      }
      else
      {
        chains.addBox(x, y, between(1.0, 6.0), std::round(between(1.0, 6.0)), 0.03);
      }
    }
    const PlaneGraph graph = imprintSegments(chains);
    EXPECT_TRUE(isPlanar(graph)) << seed;
    const ConstrainedTriangles triangles = triangulateGraph(graph);
    // Euler: each edge has a region or the outside on either side.
    Index sides = 0;
    for (const auto& isEdge : triangles.isEdge)
    {
      sides += std::count(isEdge.begin(), isEdge.end(), true);
    }
    EXPECT_LE(sides, 2 * static_cast<Index>(graph.edges.size())) << seed;
    for (Index t = 0; t < triangles.triangles.rows(); ++t)
    {
      EXPECT_GT(
        hexsweep::orientation(graph.points.row(triangles.triangles(t, 0)),
          graph.points.row(triangles.triangles(t, 1)), graph.points.row(triangles.triangles(t, 2))),
        0);
    }
  }
}
}
