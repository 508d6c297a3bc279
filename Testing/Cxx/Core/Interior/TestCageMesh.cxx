// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/CageMesh.h"

#include "Core/Interior/SweptHexes.h"
#include "Support/CageTests.h"

#include <array>
#include <set>

namespace TestCageMesh
{
using hexsweep::Index;
using hexsweep::Points;
using hexsweep::Quads;
using test::CageModels;
using test::Sweep;

/// A volume that turns by half a circle: source and target side by side, facing the same way.
Eigen::RowVector3d bentMotion(double x, double y, double t)
{
  const double angle = std::acos(-1.0) * t;
  return { x, (2 + y) * std::cos(angle), (2 + y) * std::sin(angle) };
}

std::vector<Sweep> sweeps()
{
  std::vector<Sweep> all;
  for (const bool hole : { false, true })
  {
    for (const test::Motion& motion :
      { test::Motion(test::bendingMotion), test::Motion(bentMotion) })
    {
      all.push_back(test::makeSweep(6, 6, hole, test::evenLayers(5), motion));
      all.push_back(test::turnedOver(all.back()));
    }
  }
  return all;
}

/// The same cyclic order, beginning at the smallest id.
template <std::size_t N>
std::array<Index, N> fromSmallest(std::array<Index, N> ids)
{
  std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
  return ids;
}

/// Faces that one hexahedron alone has, outward in VTK_HEXAHEDRON order.
std::set<std::array<Index, 4>> boundaryFaces(const hexsweep::Hexes& hexes)
{
  const int faces[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 },
    { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
  std::set<std::array<Index, 4>> boundary;
  for (Index h = 0; h < hexes.rows(); ++h)
  {
    for (const auto& face : faces)
    {
      std::array<Index, 4> ids{};
      std::array<Index, 4> opposite{};
      for (int c = 0; c < 4; ++c)
      {
        ids[static_cast<std::size_t>(c)] = hexes(h, face[c]);
        opposite[static_cast<std::size_t>(c)] = hexes(h, face[3 - c]);
      }
      if (boundary.erase(fromSmallest(opposite)) == 0)
      {
        boundary.insert(fromSmallest(ids));
      }
    }
  }
  return boundary;
}

double volumeOf(const hexsweep::CageMesh& cage, const Points& sweptPoints)
{
  const Points vertices = hexsweep::cageVertices(cage, sweptPoints);
  double volume = 0.0;
  for (Index t = 0; t < cage.triangles.rows(); ++t)
  {
    const auto corner = [&](int c) { return vertices.row(cage.triangles(t, c)); };
    volume += corner(0).cross(corner(1)).dot(corner(2)) / 6;
  }
  return volume;
}

/// A cube with corners that can be moved; the quads of its only hexahedron, and two models.
struct OneHex
{
  Quads quads = (Quads(1, 4) << 0, 1, 2, 3).finished();
  Points physical =
    (Points(8, 3) << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1)
      .finished();
  Points model = physical;

  /// Whether the target quad is cut from corner 0 to corner 2.
  bool targetCutFrom0() const
  {
    const auto mesh =
      hexsweep::triangulateCage(hexsweep::cageQuads(quads, physical, 1), physical, model);
    // Quad 1, whose triangles are 2 and 3: the cut joins the two ids that both of them have.
    int seen[8] = {};
    for (const int t : { 2, 3 })
    {
      for (int c = 0; c < 3; ++c)
      {
        ++seen[mesh.nodes[static_cast<std::size_t>(mesh.triangles(t, c))]];
      }
    }
    EXPECT_EQ(seen[4] + seen[5] + seen[6] + seen[7], 6);
    return seen[4] == 2 && seen[6] == 2;
  }
};

TEST(CageMesh, QuadsAreTheBoundaryOfTheHexes)
{
  for (const Sweep& sweep : sweeps())
  {
    const CageModels models = test::modelsOf(sweep);
    const auto expected =
      boundaryFaces(hexsweep::sweptHexes(sweep.quads, sweep.layers, sweep.numberOfLayers));
    std::set<std::array<Index, 4>> found;
    for (Index q = 0; q < models.cageQuads.rows(); ++q)
    {
      const auto row = models.cageQuads.row(q);
      found.insert(fromSmallest(std::array<Index, 4>{ row[0], row[1], row[2], row[3] }));
    }
    EXPECT_EQ(static_cast<Index>(found.size()), models.cageQuads.rows());
    EXPECT_EQ(found, expected);
  }
}

TEST(CageMesh, TrianglesAreClosedAndOriented)
{
  for (const Sweep& sweep : sweeps())
  {
    const CageModels models = test::modelsOf(sweep);
    const auto& triangles = models.cage.triangles;
    std::set<std::pair<Index, Index>> edges;
    for (Index t = 0; t < triangles.rows(); ++t)
    {
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_TRUE(edges.emplace(triangles(t, c), triangles(t, (c + 1) % 3)).second);
      }
    }
    for (const auto& edge : edges)
    {
      EXPECT_EQ(edges.count({ edge.second, edge.first }), 1u);
    }
    // A sphere, or a torus where the caps have a hole.
    const bool hole = sweep.quads.rows() < 36;
    const Index vertices = static_cast<Index>(models.cage.nodes.size());
    EXPECT_EQ(vertices - static_cast<Index>(edges.size()) / 2 + triangles.rows(), hole ? 0 : 2);
    // Outward in both models.
    EXPECT_GT(volumeOf(models.cage, models.physical), 0.0);
    EXPECT_GT(volumeOf(models.cage, models.model), 0.0);
  }
}

TEST(CageMesh, EncloseTheVolumeOfThePrism)
{
  // Base area, by the shoelace formula, times height; far away.
  const Eigen::RowVector3d offset(1e3, -2e3, 5e2);
  const Sweep sweep =
    test::placed(test::makeSweep(6, 6, true, test::evenLayers(5),
                   [](double x, double y, double t) { return Eigen::RowVector3d(x, y, 3 * t); }),
      1.0, offset);
  double area = 0.0;
  for (Index q = 0; q < sweep.quads.rows(); ++q)
  {
    const auto corner = [&](int c) { return sweep.cap.row(sweep.quads(q, c)); };
    const Eigen::RowVector2d first = corner(2) - corner(0);
    const Eigen::RowVector2d second = corner(3) - corner(1);
    area += (first.x() * second.y() - first.y() * second.x()) / 2;
  }
  const CageModels models = test::modelsOf(sweep);
  EXPECT_NEAR(hexsweep::enclosedVolume(models.cageQuads, models.physical), 3 * area, 1e-11);
  EXPECT_NEAR(volumeOf(models.cage, models.physical.rowwise() - offset), 3 * area, 1e-11);
}

TEST(CageMesh, BoundaryOfAUnitCubeHasVolumeOne)
{
  const OneHex cube;
  EXPECT_NEAR(
    hexsweep::enclosedVolume(hexsweep::cageQuads(cube.quads, cube.physical, 1), cube.physical), 1.0,
    1e-15);
}

TEST(CageMesh, DiagonalIsGoodInBothModels)
{
  EXPECT_TRUE(OneHex().targetCutFrom0());
  // A re-entrant corner must be an end of the diagonal, in whichever model it is.
  for (const bool inPhysical : { false, true })
  {
    for (int corner = 4; corner < 8; ++corner)
    {
      OneHex hex;
      auto place = (inPhysical ? hex.physical : hex.model).row(corner);
      place.head<2>() += 1.2 * (Eigen::RowVector2d(0.5, 0.5) - place.head<2>());
      EXPECT_EQ(hex.targetCutFrom0(), corner % 2 == 0) << corner;
    }
  }
  // Long in one direction in both, but more so in the physical model.
  OneHex hex;
  hex.physical.row(4) += Eigen::RowVector3d(-0.5, -0.5, 0);
  hex.model.row(5) += Eigen::RowVector3d(0.1, -0.1, 0);
  EXPECT_FALSE(hex.targetCutFrom0());
}

TEST(CageMesh, RoundingDoesNotChooseTheDiagonal)
{
  OneHex hex;
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (const double scale : { 1e-6, 1.0 / 3.0, 1e6 })
  {
    OneHex placed = hex;
    placed.physical =
      (scale * hex.physical * turn.transpose()).rowwise() + scale * Eigen::RowVector3d(17, 3, 29);
    EXPECT_TRUE(placed.targetCutFrom0());
  }
}

TEST(CageMesh, PhysicalModelIsTheBoundary)
{
  const Sweep sweep = test::makeSweep(6, 6, true, test::evenLayers(5), test::bendingMotion);
  const CageModels models = test::modelsOf(sweep);
  EXPECT_EQ(hexsweep::cageVertices(models.cage, models.physical),
    hexsweep::cageVertices(models.cage, sweep.layers));
  EXPECT_TRUE(test::rowsOf(models.physical, test::insideRows(sweep)).isZero(0.0));
}

TEST(TopologicalModel, IsThePrismOverTheTarget)
{
  // The volume arrives from above, z > 0, at the target, z = 0, along a circle: the parabola
  // through its last layers has its tangent up to second order.
  double last = 1.0;
  for (const int layers : { 4, 8, 16 })
  {
    const Sweep sweep = test::makeSweep(6, 6, true, test::evenLayers(layers), bentMotion);
    const Index n = sweep.source.rows();
    for (const Sweep& either : { sweep, test::turnedOver(sweep) })
    {
      const CageModels models = test::modelsOf(either);
      EXPECT_EQ(models.model.bottomRows(n), sweep.target);
      const double height = models.boundary.meanColumnLength / layers;
      const Eigen::RowVector3d step = models.model.row(n) - models.model.row(0);
      EXPECT_NEAR(step.norm(), height, 1e-13);
      const double tilt = (step / height + Eigen::RowVector3d(0, 0, 1)).norm();
      EXPECT_LT(tilt, 1.7 / layers / layers);
      EXPECT_LE(tilt, last);
      last = tilt;
      for (Index k = 0; k <= layers; ++k)
      {
        const Points expected = sweep.target.rowwise() - static_cast<double>(layers - k) * step;
        EXPECT_LT(test::greatestDistance(models.model.middleRows(k * n, n), expected), 1e-13);
      }
    }
    last /= 3;
  }
}

TEST(TopologicalModel, OfAStraightSweepIsTheSweep)
{
  // Leaning, with a curved cap, and far away.
  for (const double offset : { 0.0, 1e3 })
  {
    const Sweep sweep =
      test::makeSweep(6, 6, true, test::evenLayers(4), [=](double x, double y, double t) {
        return Eigen::RowVector3d(x + 1.2 * t + offset, y, 3 * t + 0.4 * x * (2 - x) * y);
      });
    for (const Sweep& either : { sweep, test::turnedOver(sweep) })
    {
      EXPECT_LT(
        test::greatestDistance(test::modelsOf(either).model, sweep.layers), 1e-14 * (10 + offset));
    }
  }
}

TEST(TopologicalModel, GradedLayersAndTwistsChangeNothing)
{
  // A square that turns about its middle, and a path that is a parabola: tangent (2, 0, 1).
  const test::Motion motion = [](double x, double y, double t) {
    const Eigen::Rotation2Dd turn(1.3 * t);
    const Eigen::Vector2d place = turn * Eigen::Vector2d(0.5 * x - 0.5, y - 0.5);
    return Eigen::RowVector3d(place.x() + t * t, place.y(), t);
  };
  const Sweep sweep = test::makeSweep(6, 6, false, { 0, 0.2, 0.5, 0.9, 1 }, motion);
  const CageModels models = test::modelsOf(sweep);
  const Eigen::RowVector3d step = models.model.row(sweep.source.rows()) - models.model.row(0);
  // The fractions are by length of the columns, which the path's parameter is not quite.
  EXPECT_LT((step.normalized() - Eigen::RowVector3d(2, 0, 1).normalized()).norm(), 0.03);
}

TEST(TopologicalModel, RingsThatArriveSidewaysLeaveTheAreasDirection)
{
  const Sweep sweep =
    test::makeSweep(6, 6, false, test::evenLayers(6), [](double x, double y, double t) {
      return Eigen::RowVector3d(x + 3 * t * t * t, y, 1.2 * t - 0.55 * t * t);
    });
  const CageModels models = test::modelsOf(sweep);
  const Eigen::RowVector3d step = models.model.row(sweep.source.rows()) - models.model.row(0);
  EXPECT_LT((step.normalized() - Eigen::RowVector3d(0, 0, 1)).norm(), 1e-13);
}

TEST(TopologicalModel, LoopWithoutAreaTakesTheWayItsNodesArrive)
{
  const Sweep sweep = test::makeSweep(6, 6, false, test::evenLayers(4),
    [](double x, double y, double t) { return Eigen::RowVector3d(x, y, 2 * t); });
  auto boundary = test::boundaryOf(sweep);
  // A loop that returns the way it came; its nodes move up and aside.
  boundary.outerBegin = 0;
  boundary.outerSize = 4;
  for (std::size_t k = 0; k < boundary.rings.size(); ++k)
  {
    const double z = 4 * static_cast<double>(k);
    const double x = 3 * static_cast<double>(k);
    boundary.rings[k].topRows(4) << x, 0, z, x + 1, 0, z, x + 1, 1, z, x + 1, 0, z;
  }
  const auto physical = hexsweep::physicalModel(sweep.source, sweep.target, sweep.quads, boundary);
  const Points model = hexsweep::topologicalModel(
    sweep.target, hexsweep::cageQuads(sweep.quads, physical, 4), boundary);
  const Eigen::RowVector3d step = model.row(sweep.source.rows()) - model.row(0);
  const Eigen::RowVector3d expected =
    boundary.meanColumnLength / 4 * Eigen::RowVector3d(0.6, 0, 0.8);
  EXPECT_LT((step - expected).norm(), 1e-12);
}
}
