// SPDX-License-Identifier: BSD-3-Clause
// The strip of sides that unfold into the plane: there its coordinates are linear.
#include "Core/Linking/SideStrip.h"

#include "Core/Linking/StripSearch.h"

#include "Support/CapMeshes.h"
#include "Support/SideTubes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace TestSideStrip
{
using hexsweep::Index;
using hexsweep::Points;
using hexsweep::SideStrip;
using hexsweep::SideTube;

constexpr Index Around = 12;
constexpr Index Along = 5;
constexpr double Height = 3.0;
/// Moves the target of an oblique prism.
const Eigen::RowVector3d Slant(0.7, -0.4, Height);

/// A section with unequal edges, its corners counter-clockwise.
Eigen::RowVector3d corner(Index j)
{
  const double v = static_cast<double>(j % Around) / static_cast<double>(Around);
  const double radius = 1.0 + 0.3 * std::cos(3.0 * test::TwoPi * v) + 0.2 * std::sin(7.0 * v);
  return { radius * std::cos(test::TwoPi * v), 1.5 * radius * std::sin(test::TwoPi * v), 0.0 };
}

/// Length along the section up to each corner, over its whole length; entry Around is 1.
std::vector<double> cornerPlaces()
{
  std::vector<double> places{ 0.0 };
  for (Index j = 0; j < Around; ++j)
  {
    places.push_back(places.back() + (corner(j + 1) - corner(j)).norm());
  }
  const double whole = places.back();
  for (double& place : places)
  {
    place /= whole;
  }
  return places;
}

/// Of a place in the section: fraction of the section's length up to it.
double placeOf(const Eigen::RowVector3d& p)
{
  const std::vector<double> places = cornerPlaces();
  double nearest = 1e9;
  double result = 0.0;
  for (Index j = 0; j < Around; ++j)
  {
    const Eigen::RowVector3d edge = corner(j + 1) - corner(j);
    const double t = std::clamp((p - corner(j)).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    const double distance = (p - corner(j) - t * edge).norm();
    if (distance < nearest)
    {
      nearest = distance;
      const auto k = static_cast<std::size_t>(j);
      result = places[k] + t * (places[k + 1] - places[k]);
    }
  }
  EXPECT_LT(nearest, 1e-12);
  return result;
}

/// Nodes stand on the generators through the corners, so that the triangles make up the prism; how
/// high depends on chance.
SideTube prism(const Eigen::RowVector3d& slant, bool withFaces)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> shake(-0.35, 0.35);
  const auto place = [&](double v, double u) -> Eigen::RowVector3d {
    const bool isInside = u > 0.01 && u < 0.99;
    const double t = u + (isInside ? shake(generator) / static_cast<double>(Along) : 0.0);
    return corner(std::lround(v * static_cast<double>(Around))) + t * slant;
  };
  const auto face = [](double v, double) {
    return static_cast<Index>(v * static_cast<double>(Around));
  };
  return withFaces ? test::tube(Around, Along, place, face) : test::tube(Around, Along, place);
}

/// (v, u) of a point of a prism; v from the strip's first source point.
Eigen::RowVector2d placeIn(
  const SideStrip& strip, const Eigen::RowVector3d& slant, const Eigen::RowVector3d& p)
{
  const double u = p.z() / Height;
  const Eigen::RowVector3d first = strip.surface.points.row(strip.source.front());
  const double v = placeOf(p - u * slant) - placeOf(first);
  return { v - std::floor(v), u };
}

/// All corners of the plane triangles against the closed form; v within whole turns.
double greatestError(const SideStrip& strip, const Eigen::RowVector3d& slant)
{
  double greatest = 0.0;
  for (Index t = 0; t < strip.planeTriangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Eigen::RowVector2d place = strip.plane.row(strip.planeTriangles(t, c));
      const Eigen::RowVector2d expected =
        placeIn(strip, slant, strip.surface.points.row(strip.surface.triangles(t, c)));
      greatest = std::max({ greatest, std::abs(std::remainder(place[0] - expected[0], 1.0)),
        std::abs(place[1] - expected[1]) });
    }
  }
  return greatest;
}

/// Of the triangles in the strip, in units of its area: 1 where they fill it once.
double signedArea(const SideStrip& strip)
{
  double area = 0.0;
  for (Index t = 0; t < strip.planeTriangles.rows(); ++t)
  {
    Eigen::Matrix2d edges;
    for (int c = 0; c < 2; ++c)
    {
      edges.row(c) = strip.plane.row(strip.planeTriangles(t, c + 1)) -
        strip.plane.row(strip.planeTriangles(t, 0));
    }
    area += 0.5 * edges.determinant();
  }
  return area;
}

TEST(SideStrip, RightPrismIsUnfolded)
{
  const Eigen::RowVector3d up(0.0, 0.0, Height);
  const SideTube side = prism(up, false);
  for (const double longest : { 10.0, 0.4 })
  {
    const SideStrip strip = mapSideToStrip(side, longest);
    EXPECT_TRUE(strip.columns.empty());
    EXPECT_EQ(strip.flipped, 0);
    EXPECT_LT(greatestError(strip, up), 1e-12) << longest;
    EXPECT_NEAR(signedArea(strip), 1.0, 1e-12);
    EXPECT_EQ(strip.sourceV.front(), 0.0);
    for (std::size_t i = 0; i < strip.target.size(); ++i)
    {
      const double expected = placeIn(strip, up, strip.surface.points.row(strip.target[i]))[0];
      EXPECT_NEAR(std::remainder(strip.targetV[i] - expected, 1.0), 0.0, 1e-12);
      EXPECT_GT(strip.targetV[i], i == 0 ? -1.0 : strip.targetV[i - 1]);
    }
  }
}

// Between generators that keep their v all is linear, however slanted the facets are.
TEST(SideStrip, CadEdgesOfAnObliquePrismAreColumns)
{
  const SideTube side = prism(Slant, true);
  for (const double longest : { 10.0, 0.4 })
  {
    const SideStrip strip = mapSideToStrip(side, longest);
    EXPECT_EQ(strip.flipped, 0);
    EXPECT_LT(greatestError(strip, Slant), 1e-12) << longest;
    EXPECT_NEAR(signedArea(strip), 1.0, 1e-12);
    ASSERT_EQ(strip.columns.size(), static_cast<std::size_t>(Around));
    for (std::size_t c = 0; c < strip.columns.size(); ++c)
    {
      const hexsweep::StripColumn& column = strip.columns[c];
      EXPECT_GT(column.v, c == 0 ? -1.0 : strip.columns[c - 1].v);
      ASSERT_EQ(column.points.size(), column.u.size());
      const Eigen::RowVector3d foot = strip.surface.points.row(column.points.front());
      for (std::size_t k = 0; k < column.points.size(); ++k)
      {
        const Eigen::RowVector3d p = strip.surface.points.row(column.points[k]);
        EXPECT_LT((foot + column.u[k] * Slant - p).norm(), 1e-14);
        EXPECT_NEAR(column.v, placeIn(strip, Slant, foot)[0], 1e-14);
      }
      EXPECT_EQ(column.u.front(), 0.0);
      EXPECT_EQ(column.u.back(), 1.0);
    }
  }
}

TEST(SideStrip, PlacesAreFoundOnTheSide)
{
  const SideTube side = prism(Slant, true);
  const SideStrip strip = mapSideToStrip(side, 0.4);
  const hexsweep::StripSearch search(strip);
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int trial = 0; trial < 200; ++trial)
  {
    const double v = any(generator);
    const double u = trial < 2 ? trial : any(generator);
    for (const double turns : { 0.0, -2.0, 1.0 })
    {
      const hexsweep::StripPlace found = search.at(v + turns, u);
      const Eigen::RowVector2d place = placeIn(strip, Slant, found.point);
      EXPECT_NEAR(std::remainder(place[0] - v, 1.0), 0.0, 1e-12);
      EXPECT_NEAR(place[1], u, 1e-12);
      // In that triangle: its barycentric coordinates.
      Eigen::Matrix3d corners;
      for (int c = 0; c < 3; ++c)
      {
        corners.col(c) =
          strip.surface.points.row(strip.surface.triangles(found.triangle, c)).transpose();
      }
      const Eigen::Vector3d share = corners.inverse() * found.point.transpose();
      EXPECT_NEAR(share.sum(), 1.0, 1e-9);
      EXPECT_GT(share.minCoeff(), -1e-9);
    }
  }
}

TEST(SideStrip, PartsOfATriangleMakeItUp)
{
  const SideTube side = prism(Slant, true);
  const SideStrip strip = mapSideToStrip(side, 0.4);
  ASSERT_EQ(strip.triangleOrigin.size(), static_cast<std::size_t>(strip.surface.triangles.rows()));
  EXPECT_GT(strip.surface.triangles.rows(), 2 * side.surface.triangles.rows());
  const auto vectorArea = [](const hexsweep::TriangleMesh& mesh, Index t) -> Eigen::RowVector3d {
    const Eigen::RowVector3d a = mesh.points.row(mesh.triangles(t, 0));
    const Eigen::RowVector3d b = mesh.points.row(mesh.triangles(t, 1));
    const Eigen::RowVector3d c = mesh.points.row(mesh.triangles(t, 2));
    return 0.5 * (b - a).cross(c - a);
  };
  Points sums = Points::Zero(side.surface.triangles.rows(), 3);
  for (Index t = 0; t < strip.surface.triangles.rows(); ++t)
  {
    sums.row(strip.triangleOrigin[static_cast<std::size_t>(t)]) += vectorArea(strip.surface, t);
    EXPECT_LE((strip.surface.points.row(strip.surface.triangles(t, 0)) -
                strip.surface.points.row(strip.surface.triangles(t, 1)))
                .norm(),
      0.4);
  }
  for (Index t = 0; t < sums.rows(); ++t)
  {
    EXPECT_LT((sums.row(t) - vectorArea(side.surface, t)).norm(), 1e-14) << t;
  }
}

TEST(SideStrip, SourceLoopSaysWhichEndIsWhich)
{
  SideTube side = prism(Slant, true);
  for (Index& point : side.sourceLoop)
  {
    point += Around * Along;
  }
  const SideStrip strip = mapSideToStrip(side, 10.0);
  for (const Index i : strip.source)
  {
    EXPECT_EQ(strip.surface.points(i, 2), Height);
  }
  for (const Index i : strip.target)
  {
    EXPECT_EQ(strip.surface.points(i, 2), 0.0);
  }
  EXPECT_EQ(strip.flipped, 0);
  EXPECT_NEAR(signedArea(strip), 1.0, 1e-12);
}

TEST(SideStrip, OpenDiskIsNoTube)
{
  SideTube side;
  side.surface = test::disk(3, 12);
  side.sourceLoop = test::loopsOf(side.surface).front();
  test::expectInvalid([&] { mapSideToStrip(side, 1.0); }, "no tube: it has 1 pieces, 1 boundary");
}

TEST(SideStrip, TwoTubesAreNoTube)
{
  const SideTube one = prism(Slant, false);
  SideTube side = one;
  const Index points = one.surface.points.rows();
  const Index triangles = one.surface.triangles.rows();
  side.surface.points.conservativeResize(2 * points, 3);
  side.surface.points.bottomRows(points) = one.surface.points.array() + 10.0;
  side.surface.triangles.conservativeResize(2 * triangles, 3);
  side.surface.triangles.bottomRows(triangles) = one.surface.triangles.array() + points;
  test::expectInvalid([&] { mapSideToStrip(side, 1.0); }, "it has 2 pieces, 4 boundary loops");
}

/// A torus of 8 x 8 pairs of triangles, two of which may be left out.
SideTube torus(bool holes)
{
  constexpr Index N = 8;
  SideTube side;
  side.surface.points.resize(N * N, 3);
  std::vector<Index> ids;
  for (Index k = 0; k < N; ++k)
  {
    for (Index j = 0; j < N; ++j)
    {
      const double big = test::TwoPi * static_cast<double>(k) / static_cast<double>(N);
      const double small = test::TwoPi * static_cast<double>(j) / static_cast<double>(N);
      const double r = 2.0 + std::cos(small);
      side.surface.points.row(k * N + j) << r * std::cos(big), r * std::sin(big), std::sin(small);
      const Index right = k * N + (j + 1) % N;
      const Index up = (k + 1) % N * N + j;
      const Index both = (k + 1) % N * N + (j + 1) % N;
      const bool isHole = holes && k % 4 == 0 && j == 2;
      if (!isHole)
      {
        ids.insert(ids.end(), { k * N + j, right, both, k * N + j, both, up });
      }
    }
  }
  side.surface.triangles = test::facesOf<hexsweep::Triangles>(ids);
  side.sourceLoop = { 2 };
  return side;
}

// Two loops, as a tube has, and a handle.
TEST(SideStrip, TorusWithTwoHolesIsNoTube)
{
  test::expectInvalid(
    [] { mapSideToStrip(torus(true), 10.0); }, "2 boundary loops and Euler characteristic -2");
}

// The Euler characteristic of a tube.
TEST(SideStrip, ClosedTorusIsNoTube)
{
  test::expectInvalid(
    [] { mapSideToStrip(torus(false), 10.0); }, "0 boundary loops and Euler characteristic 0");
}

TEST(SideStrip, SourceLoopInTheMiddleIsNone)
{
  SideTube side = prism(Slant, false);
  for (Index& point : side.sourceLoop)
  {
    point += 2 * Around;
  }
  test::expectInvalid([&] { mapSideToStrip(side, 1.0); }, "source loop is no boundary");
}
}
