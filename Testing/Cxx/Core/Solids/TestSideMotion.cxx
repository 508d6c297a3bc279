// SPDX-License-Identifier: BSD-3-Clause
// The rigid motion along which sides lie: of prisms, revolutions and screws in closed form.
#include "Core/Solids/SideMotion.h"

#include "Support/SolidShapes.h"
#include "Support/SweptShapes.h"

#include <cmath>

namespace TestSideMotion
{
using hexsweep::FaceGraph;
using hexsweep::Index;
using hexsweep::Pi;
using hexsweep::RigidMotion;
using hexsweep::SideMotion;
using hexsweep::SolidSurface;
using test::BottomFace;
using test::TopFace;

SideMotion motionOf(const SolidSurface& solid, Index source = BottomFace, Index target = TopFace)
{
  const FaceGraph graph = hexsweep::makeFaceGraph(solid);
  const std::vector<std::size_t> ends = hexsweep::facesWithIds(graph, { source, target });
  std::vector<char> isSide(graph.faces.size(), 1);
  isSide[ends[0]] = isSide[ends[1]] = 0;
  const auto cap = [&](Index id) {
    return *hexsweep::makeCapCandidate(graph, hexsweep::facesWithIds(graph, { id }));
  };
  return hexsweep::findSideMotion(graph, isSide, cap(source), cap(target));
}

SolidSurface swept(
  const std::vector<Eigen::RowVector2d>& section, int rings, const test::Path& path)
{
  return hexsweep::makeSolidSurface(
    test::sweptSolid(section, rings, path, [](int j, int) -> Index { return 3 + j; }));
}

/// The sine between two directions.
double sineBetween(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b)
{
  return a.normalized().cross(b.normalized()).norm();
}

TEST(SideMotion, ObliquePrismsAreShifted)
{
  const SideMotion found =
    motionOf(swept(test::rectangle(2.0, 1.0), 5, [](double x, double y, double t) {
      return Eigen::RowVector3d(x + 1.5 * t, y - 0.5 * t, 3.0 * t);
    }));
  EXPECT_NEAR(found.slip, 0.0, 1e-12);
  EXPECT_EQ(found.motion.angular, Eigen::RowVector3d::Zero());
  EXPECT_NEAR(sineBetween(found.motion.linear, { 1.5, -0.5, 3.0 }), 0.0, 1e-6);
}

TEST(SideMotion, RevolutionsTurnAboutTheirAxis)
{
  constexpr double Facet = Pi / 90.0;
  for (const int facets : { 20, 90, 160 })
  {
    // The inner side has a tenth of the outer one's radius.
    const SolidSurface solid = swept({ { -0.9, -0.4 }, { 0.9, -0.1 }, { 0.5, 0.6 } }, facets,
      test::roundBend(1.0, facets * Facet));
    const SideMotion found = motionOf(solid);
    EXPECT_LT(found.slip, Facet * Facet) << facets;
    EXPECT_NEAR(sineBetween(found.motion.angular, { 0.0, 1.0, 0.0 }), 0.0, Facet) << facets;
    constexpr double OuterRadius = 1.9;
    EXPECT_LT(
      found.motion.at({ 0.0, 0.0, 0.0 }).norm(), Facet * OuterRadius * found.motion.angular.norm())
      << "on the axis";
  }
}

TEST(SideMotion, TwistedPrismsAreScrewed)
{
  constexpr double Turn = 0.8;
  const SolidSurface solid =
    swept(test::polygon(60, [](int j) { return 1.0 + 0.3 * std::cos(0.1 * Pi * j); }), 40,
      [](double x, double y, double t) {
        const double c = std::cos(Turn * t);
        const double s = std::sin(Turn * t);
        return Eigen::RowVector3d(c * x - s * y, s * x + c * y, 2.0 * t);
      });
  const SideMotion found = motionOf(solid);
  EXPECT_LT(found.slip, 1e-3) << "facets of twisted quads";
  const Eigen::RowVector3d onAxis = found.motion.at({ 0.0, 0.0, 1.0 });
  EXPECT_NEAR(sineBetween(onAxis, { 0.0, 0.0, 1.0 }), 0.0, 0.01);
  EXPECT_NEAR(found.motion.angular.dot(onAxis) / onAxis.squaredNorm(), 0.5 * Turn, 0.01);
}

TEST(SideMotion, FrustaHaveNone)
{
  // A cone turns on itself, but that does not lead from cap to cap.
  constexpr double Slope = 0.5;
  const SideMotion found = motionOf(
    swept(test::circle(48, 1.0), 4, test::upward(1.0, [](double t) { return 1.0 - Slope * t; })));
  EXPECT_NEAR(found.slip, Slope * Slope / (1.0 + Slope * Slope), 0.01);
}

TEST(SideMotion, NothingIsShiftedThroughTheWallOfATube)
{
  // A shift along the annular ends comes in by one half of the outer wall and goes out by the
  // other.
  const auto ring = [](int x, int y, int) { return x == 0 || x == 3 || y == 0 || y == 3; };
  const auto walls = [](const test::Cell& cell, int direction) -> Index {
    const int along = direction == 1 || direction == 2 ? cell[0] : cell[1];
    return direction > 4 ? direction : (along == 0) == (direction % 2 == 1) ? 7 : 8;
  };
  const SolidSurface solid = hexsweep::makeSolidSurface(test::cubes({ 4, 4, 2 }, ring, walls));
  EXPECT_TRUE(std::isinf(motionOf(solid, 7, 8).slip));
  EXPECT_NEAR(motionOf(solid, 5, 6).slip, 0.0, 1e-12);
}
}
