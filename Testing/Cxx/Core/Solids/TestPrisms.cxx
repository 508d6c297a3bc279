// SPDX-License-Identifier: BSD-3-Clause
// Sweeps whose target is an affine image of the source, from the solid to the hexahedra.
#include "Core/Hexahedra/HexQuality.h"
#include "Core/Interior/InteriorStarts.h"
#include "Core/Interior/SweptHexes.h"
#include "Core/Solids/CapCrossings.h"
#include "Core/Solids/SolidCage.h"
#include "Core/Solids/SourceQuads.h"
#include "Support/SweptSolids.h"

#include <gtest/gtest.h>

namespace TestPrisms
{
using namespace test;
using hexsweep::SolidCage;
using hexsweep::SolidInput;
using Place = std::function<Eigen::RowVector3d(double, double, double)>;

constexpr Index Layers = 5;

struct Prism
{
  hexsweep::QuadMesh quads;
  SolidCage cage;
  hexsweep::SweepInterior interior;
  double size;
};

Prism meshed(const SolidInput& input, double quadSize)
{
  const hexsweep::SolidSurface solid = hexsweep::makeSolidSurface(input);
  const hexsweep::SweepTopology topology = hexsweep::sweepBetween(solid, { 1 }, { 2 });
  Prism prism;
  prism.quads = hexsweep::makeSourceQuads(input, solid, topology, quadSize).mesh;
  hexsweep::SolidCageInput cage{ solid, topology, prism.quads, {}, {} };
  cage.layers.layers = Layers;
  prism.cage = hexsweep::makeSolidCage(cage);
  prism.interior = hexsweep::sweepInterior(prism.cage,
    hexsweep::interiorStarts(hexsweep::InteriorKind::Automatic, prism.cage.isRuled), {});
  prism.size = (solid.points.colwise().maxCoeff() - solid.points.colwise().minCoeff()).norm();
  return prism;
}

Place affinePlace(const Eigen::Matrix3d& linear, const Eigen::RowVector3d& move)
{
  return [=](double x, double y, double h) -> Eigen::RowVector3d {
    const Eigen::RowVector3d p(x, y, 0.0);
    return (1.0 - h) * p + h * (p * linear.transpose() + move);
  };
}

/// The greatest distance of any node from where the sweep takes its source node.
double greatestError(const Prism& prism, const Place& place)
{
  const Points& source = prism.quads.points;
  const Index n = source.rows();
  double greatest = 0.0;
  for (Index k = 0; k <= Layers; ++k)
  {
    const double height = static_cast<double>(k) / static_cast<double>(Layers);
    for (Index i = 0; i < n; ++i)
    {
      greatest = std::max(greatest,
        (prism.interior.points.row(k * n + i) - place(source(i, 0), source(i, 1), height)).norm());
    }
  }
  return greatest;
}

/// Least and mean of the least sine at a corner, of all quads.
std::pair<double, double> quadSines(const hexsweep::QuadMesh& mesh)
{
  double least = 1.0;
  double sum = 0.0;
  for (Index q = 0; q < mesh.quads.rows(); ++q)
  {
    double own = 1.0;
    for (Index c = 0; c < 4; ++c)
    {
      const Eigen::RowVector3d corner = mesh.points.row(mesh.quads(q, c));
      const Eigen::RowVector3d u = mesh.points.row(mesh.quads(q, (c + 1) % 4)) - corner;
      const Eigen::RowVector3d v = mesh.points.row(mesh.quads(q, (c + 3) % 4)) - corner;
      own = std::min(own, std::abs(u.cross(v).z()) / (u.norm() * v.norm()));
    }
    least = std::min(least, own);
    sum += own;
  }
  return { least, sum / static_cast<double>(mesh.quads.rows()) };
}

std::vector<Section> flange()
{
  std::vector<Section> sections{ circleSection(0, 0, 50, 72), holeSection(0, 0, 16, 36) };
  for (int h = 0; h < 6; ++h)
  {
    const double angle = 2.0 * Pi * h / 6.0;
    sections.push_back(holeSection(35 * std::cos(angle), 35 * std::sin(angle), 5, 16));
  }
  return sections;
}

std::vector<Section> plateWithTwentyHoles()
{
  std::vector<Section> sections{ { { 0, 0 }, { 50, 0 }, { 50, 40 }, { 0, 40 } } };
  for (int i = 0; i < 5; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      sections.push_back(holeSection(5.1 + 10 * i, 4.9 + 10 * j, 1.5 + 0.2 * j, 12));
    }
  }
  return sections;
}

struct Shape
{
  const char* name;
  std::vector<Section> sections;
  double quadSize;
};

std::vector<Shape> shapes()
{
  return { { "flange", flange(), 4.0 }, { "35-gon", { circleSection(0, 0, 10, 35) }, 1.0 },
    { "plate", plateWithTwentyHoles(), 1.5 } };
}

TEST(Prisms, RightOnesHaveTheJacobiansOfTheirQuads)
{
  for (const Shape& shape : shapes())
  {
    SCOPED_TRACE(shape.name);
    const Place place = affinePlace(Eigen::Matrix3d::Identity(), { 0, 0, 6.5 });
    const Prism prism = meshed(sweptSolid(shape.sections, place), shape.quadSize);
    EXPECT_TRUE(prism.cage.isRuled);
    EXPECT_EQ(prism.interior.method, "Ruled");
    EXPECT_LE(greatestError(prism, place), 1e-12 * prism.size);
    const hexsweep::HexQualitySummary quality =
      hexsweep::summarize(hexsweep::hexQualities(prism.interior.points,
        hexsweep::sweptHexes(prism.quads.quads, prism.interior.points, Layers), true));
    const auto [least, mean] = quadSines(prism.quads);
    EXPECT_EQ(quality.notCertified, 0);
    EXPECT_NEAR(quality.minScaledJacobian, least, 1e-10);
    EXPECT_NEAR(quality.meanScaledJacobian, mean, 1e-10);
    // The target quads are the source quads moved.
    Points moved = prism.quads.points;
    moved.rowwise() += Eigen::RowVector3d(0, 0, 6.5);
    EXPECT_LE((prism.cage.target - moved).rowwise().norm().maxCoeff(), 1e-12 * prism.size);
  }
}

TEST(Prisms, ObliqueOnesAndFrustaAreStraight)
{
  Eigen::Matrix3d frustum = Eigen::Matrix3d::Identity();
  frustum.topLeftCorner<2, 2>() << 0.7, 0.1, -0.05, 0.6;
  Eigen::Matrix3d tilted = Eigen::Matrix3d::Identity();
  tilted.row(2) << 0.2, -0.1, 1.0;
  for (const Shape& shape : shapes())
  {
    SCOPED_TRACE(shape.name);
    for (const Place& place : { affinePlace(Eigen::Matrix3d::Identity(), { 11, -4, 14 }),
           affinePlace(frustum, { 3, 2, 14 }), affinePlace(tilted, { 0, 5, 25 }) })
    {
      const Prism prism = meshed(sweptSolid(shape.sections, place, 2), shape.quadSize);
      EXPECT_EQ(prism.interior.method, "Ruled");
      EXPECT_LE(greatestError(prism, place), 1e-12 * prism.size);
    }
  }
}

TEST(Prisms, AnImprintThatSlantsAcrossASideChangesNothing)
{
  // One side of an L is two faces with a slanted border between them.
  const Section section{ { 0, 0 }, { 30, 0 }, { 30, 10 }, { 10, 10 }, { 10, 20 }, { 0, 20 } };
  const Place place = affinePlace(Eigen::Matrix3d::Identity(), { 0, 0, 25 });
  SolidInput solid = sweptSolid({ section }, place, 6);
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    const Eigen::RowVector3d middle =
      (solid.points.row(solid.triangles(t, 0)) + solid.points.row(solid.triangles(t, 1)) +
        solid.points.row(solid.triangles(t, 2))) /
      3.0;
    if (middle.y() < 1e-9 && middle.x() < middle.z())
    {
      solid.faceIds[static_cast<std::size_t>(t)] = 99;
    }
  }
  const Prism prism = meshed(solid, 2.5);
  EXPECT_EQ(prism.interior.method, "Ruled");
  EXPECT_LE(greatestError(prism, place), 1e-12 * prism.size);
}

TEST(Prisms, SidesThatAreMeshedAlreadyComeFirst)
{
  const Section square{ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } };
  const Place place = affinePlace(Eigen::Matrix3d::Identity(), { 0, 0, 4 });
  const SolidInput input = sweptSolid({ square }, place, 4);
  const hexsweep::SolidSurface solid = hexsweep::makeSolidSurface(input);
  const hexsweep::SweepTopology topology = hexsweep::sweepBetween(solid, { 1 }, { 2 });
  // One wall, of one column and four layers, the layers not even.
  hexsweep::QuadMesh wall{ Points(10, 3), hexsweep::Quads(4, 4) };
  const double heights[] = { 0.0, 0.5, 1.5, 3.0, 4.0 };
  for (Index k = 0; k < 5; ++k)
  {
    wall.points.row(2 * k) << 0, 0, heights[k];
    wall.points.row(2 * k + 1) << 4, 0, heights[k];
  }
  for (Index k = 0; k < 4; ++k)
  {
    wall.quads.row(k) << 2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2;
  }
  hexsweep::QuadMesh cap{ Points(4, 3), hexsweep::Quads(1, 4) };
  cap.points << 0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0;
  cap.quads << 0, 1, 2, 3;
  hexsweep::SolidCageInput cage{ solid, topology, cap, { { wall } }, {} };
  cage.layers.layers = 4;
  const SolidCage made = hexsweep::makeSolidCage(cage);
  EXPECT_FALSE(made.isRuled);
  EXPECT_NEAR(hexsweep::ringPoints(made.linking.rings, 0, 1).col(2).minCoeff(), 0.5, 1e-12);
}

TEST(Prisms, CapsThatCrossThemselvesAreNamed)
{
  // The rim of the cap crosses itself: a node of the outline lies beyond the hole.
  SolidInput solid =
    sweptSolid({ { { 0, 0 }, { 6, 0 }, { 6, 4 }, { 0, 4 } }, holeSection(3, 2, 1, 12) },
      affinePlace(Eigen::Matrix3d::Identity(), { 0, 0, 3 }));
  for (Index i = 0; i < solid.points.rows(); ++i)
  {
    if (solid.points(i, 0) == 6.0 && solid.points(i, 1) == 4.0)
    {
      solid.points.row(i).head<2>() << 2.5, 1.5;
    }
  }
  const hexsweep::SolidSurface surface = hexsweep::makeSolidSurface(solid);
  const hexsweep::SweepTopology topology = hexsweep::sweepBetween(surface, { 1 }, { 2 });
  expectInvalid(
    [&] { hexsweep::checkCapCrossings(surface, topology.sourceTriangles, "source cap"); },
    "the source cap crosses itself at (");
  expectInvalid(
    [&] { hexsweep::checkCapCrossings(surface, topology.sourceTriangles, "source cap"); },
    "of face 1");
}

TEST(Prisms, CapsThatAreFoldedAreNamed)
{
  // Two triangles of a square; a corner moves inward over one diagonal, which may be their edge.
  int folded = 0;
  for (const Eigen::RowVector2d& corner :
    { Eigen::RowVector2d(4.0, 0.0), Eigen::RowVector2d(0.0, 0.0) })
  {
    const SolidInput solid =
      sweptSolid({ { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } } }, [&](double x, double y, double h) {
        const bool moves = x == corner[0] && y == corner[1];
        const double across = moves ? 0.7 * h : 0.0;
        return Eigen::RowVector3d(x + across * (4.0 - 2.0 * x), y + across * (4.0 - 2.0 * y),
          3.0 * h + (moves ? 0.1 * h : 0.0));
      });
    const hexsweep::SolidSurface surface = hexsweep::makeSolidSurface(solid);
    const hexsweep::SweepTopology topology = hexsweep::sweepBetween(surface, { 1 }, { 2 });
    try
    {
      hexsweep::checkCapCrossings(surface, topology.targetTriangles, "target cap");
    }
    catch (const hexsweep::InvalidInput& error)
    {
      ++folded;
      EXPECT_EQ(std::string(error.what()).rfind("the target cap is folded at (", 0), 0u)
        << error.what();
    }
  }
  EXPECT_EQ(folded, 1);
}
}
