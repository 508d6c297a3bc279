// SPDX-License-Identifier: BSD-3-Clause
// Frustums between regular polygons and circles: the angles at their columns are known.
#include "Core/Solids/OpeningCorners.h"

#include "Core/CapQuads/CapMeshing.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include "Support/CapMeshes.h"

#include <cmath>

namespace TestOpeningCorners
{
using hexsweep::CapQuadOptions;
using hexsweep::CornerFan;
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::openingCorners;
using hexsweep::Points;
using hexsweep::QuadMesh;
using hexsweep::SideTube;
using hexsweep::TriangleMesh;

constexpr Index Around = 120;

/// On a regular polygon of n corners (0: a circle) of radius 1, by angle.
Eigen::RowVector3d outline(Index corners, double angle, double z)
{
  double radius = 1.0;
  if (corners > 0)
  {
    const double sector = 2.0 * test::Pi / static_cast<double>(corners);
    const double within = std::remainder(angle - 0.5 * sector, sector);
    radius = std::cos(0.5 * sector) / std::cos(within);
  }
  return { radius * std::cos(angle), radius * std::sin(angle), z };
}

/// Straight from one outline to another, two above it.
SideTube frustum(Index below, Index above)
{
  constexpr Index Rings = 12;
  SideTube side;
  side.surface.points.resize((Rings + 1) * Around, 3);
  side.surface.triangles.resize(2 * Rings * Around, 3);
  for (Index k = 0; k <= Rings; ++k)
  {
    for (Index j = 0; j < Around; ++j)
    {
      const double angle = 2.0 * test::Pi * static_cast<double>(j) / Around;
      const double u = static_cast<double>(k) / Rings;
      side.surface.points.row(k * Around + j) =
        (1.0 - u) * outline(below, angle, 0.0) + u * outline(above, angle, 2.0);
    }
  }
  for (Index k = 0; k < Rings; ++k)
  {
    for (Index j = 0; j < Around; ++j)
    {
      const Index a = k * Around + j;
      const Index b = k * Around + (j + 1) % Around;
      side.surface.triangles.row(2 * a) << a, b, b + Around;
      side.surface.triangles.row(2 * a + 1) << a, b + Around, a + Around;
    }
  }
  for (Index j = 0; j < Around; ++j)
  {
    side.sourceLoop.push_back(j);
  }
  return side;
}

QuadMesh quadsOn(Index corners, bool turned, const std::vector<CornerFan>& fans = {})
{
  TriangleMesh cap;
  cap.points = Points::Zero(Around + 1, 3);
  cap.triangles.resize(Around, 3);
  for (Index j = 0; j < Around; ++j)
  {
    cap.points.row(j) = outline(corners, 2.0 * test::Pi * static_cast<double>(j) / Around, 0.0);
    cap.triangles.row(j) << Around, j, (j + 1) % Around;
  }
  if (turned)
  {
    cap.triangles = cap.triangles.rowwise().reverse().eval();
  }
  CapQuadOptions options;
  options.size = 0.15;
  options.fans = fans;
  return meshCapWithQuads(cap, {}, options).mesh;
}

/// Quads at the points that are farthest from the centre, at least.
Index leastAtCorners(const QuadMesh& quads)
{
  std::vector<Index> count(static_cast<std::size_t>(quads.points.rows()), 0);
  for (Index i = 0; i < quads.quads.size(); ++i)
  {
    ++count[static_cast<std::size_t>(quads.quads.data()[i])];
  }
  Index least = quads.quads.rows();
  for (Index i = 0; i < quads.points.rows(); ++i)
  {
    least = quads.points.row(i).norm() > 1.0 - 1e-12
      ? std::min(least, count[static_cast<std::size_t>(i)])
      : least;
  }
  return least;
}

std::vector<CornerFan> fansOf(const QuadMesh& quads, const SideTube& side)
{
  const std::vector<Loop> loops =
    hexsweep::checkSurface(quads.quads, quads.points.rows(), "quads").loops;
  return openingCorners(quads, loops, { side }, 8);
}

TEST(OpeningCorners, CornersOfAPolygonOnTheWayToACircleWantTwoQuads)
{
  Index wanting = 0;
  for (const Index corners : { 3, 4, 5, 6 })
  {
    for (const bool turned : { false, true })
    {
      const QuadMesh plain = quadsOn(corners, turned);
      const std::vector<CornerFan> fans = fansOf(plain, frustum(corners, 0));
      for (const CornerFan& fan : fans)
      {
        EXPECT_EQ(fan.faces, 2);
        EXPECT_NEAR(fan.place.norm(), 1.0, 1e-12);
      }
      // Either all are named, or none lacks a quad.
      EXPECT_EQ(static_cast<Index>(fans.size()), leastAtCorners(plain) < 2 ? corners : 0);
      wanting += fans.empty() ? 0 : 1;
      const QuadMesh opened = quadsOn(corners, turned, fans);
      EXPECT_GE(leastAtCorners(opened), 2);
      EXPECT_TRUE(fansOf(opened, frustum(corners, 0)).empty());
    }
  }
  EXPECT_GT(wanting, 4);
}

TEST(OpeningCorners, PrismsAndCirclesAreLeftAlone)
{
  for (const Index corners : { 3, 4, 6, 0 })
  {
    EXPECT_TRUE(fansOf(quadsOn(corners, false), frustum(corners, corners)).empty()) << corners;
  }
  // Two quads share the right angle at the square's corners.
  EXPECT_TRUE(fansOf(quadsOn(0, false), frustum(0, 4)).empty());
}
}
