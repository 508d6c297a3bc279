// SPDX-License-Identifier: BSD-3-Clause
// Caps counted on the face graph against the ones that are made of triangles.
#include "Core/Solids/CapCandidates.h"

#include "Core/Common/Errors.h"
#include "Core/Solids/SweepCap.h"

#include "Support/SolidShapes.h"
#include "Support/SweptShapes.h"

namespace TestCapCandidates
{
using hexsweep::CapCandidate;
using hexsweep::FaceGraph;
using hexsweep::FaceSet;
using hexsweep::Index;
using hexsweep::Pi;
using test::box;
using test::cubes;

/// Faces by bits of a number.
FaceSet facesOf(unsigned bits, std::size_t count)
{
  FaceSet faces;
  for (std::size_t f = 0; f < count; ++f)
  {
    if (bits >> f & 1u)
    {
      faces.push_back(f);
    }
  }
  return faces;
}

/// Every set of faces is a cap here if and only if it is one there, with the same loops.
void expectSameCaps(const test::SolidInput& input)
{
  const hexsweep::SolidSurface solid = hexsweep::makeSolidSurface(input);
  const FaceGraph graph = hexsweep::makeFaceGraph(solid);
  int caps = 0;
  int others = 0;
  for (unsigned bits = 1; bits < 1u << graph.faces.size(); ++bits)
  {
    const FaceSet faces = facesOf(bits, graph.faces.size());
    std::vector<Index> ids;
    for (const std::size_t face : faces)
    {
      ids.push_back(graph.patches.ids[face]);
    }
    std::sort(ids.begin(), ids.end());
    const std::optional<CapCandidate> found = hexsweep::makeCapCandidate(graph, faces);
    try
    {
      const hexsweep::SweepCap expected = hexsweep::makeSweepCap(
        solid, graph.halfEdges, ids, hexsweep::trianglesOfFaces(solid, ids), "cap");
      ASSERT_TRUE(found.has_value()) << bits;
      EXPECT_EQ(found->loops, expected.loops);
      EXPECT_EQ(found->faceIds, ids);
      ++caps;
    }
    catch (const hexsweep::InvalidInput&)
    {
      EXPECT_FALSE(found.has_value()) << bits;
      ++others;
    }
  }
  EXPECT_GT(caps, 10);
  EXPECT_GT(others, 10);
}

TEST(CapCandidates, AreThoseOfTheTriangles)
{
  const auto quarters = [](const test::Cell& cell, int direction) -> Index {
    return direction == 6 ? 6 + cell[0] / 2 + 2 * (cell[1] / 2) : direction;
  };
  expectSameCaps(box(4, 4, 2, quarters));
  expectSameCaps(cubes(
    { 3, 3, 2 }, [](int x, int y, int) { return x != 1 || y != 1; }, test::planeLabel));
  // Faces in several pieces, and tunnels.
  expectSameCaps(cubes(
    { 3, 3, 3 }, [](int, int y, int z) { return y != 1 || z != 1; },
    [](const test::Cell& cell, int direction) -> Index { return direction + 10 * (cell[0] / 2); }));
}

TEST(CapCandidates, Measures)
{
  const hexsweep::SolidSurface solid = hexsweep::makeSolidSurface(test::sweptSolid(
    test::circle(90, 2.0), 4, test::upward(3.0, [](double t) { return 1.0 - t / 2; }),
    [](int, int) -> Index { return 3; }));
  const FaceGraph graph = hexsweep::makeFaceGraph(solid);
  EXPECT_EQ(graph.genus, 0);
  ASSERT_EQ(graph.faces.size(), 3u);
  ASSERT_EQ(graph.contacts.size(), 2u);
  const CapCandidate bottom = *hexsweep::makeCapCandidate(graph, { 0 });
  const double chord = 4.0 * std::sin(Pi / 90.0);
  EXPECT_NEAR(bottom.perimeter, 90.0 * chord, 1e-12);
  EXPECT_NEAR(bottom.area, 90.0 * 2.0 * std::sin(Pi / 45.0), 1e-12);
  EXPECT_NEAR(bottom.flatness, 1.0, 1e-12);
  EXPECT_EQ(bottom.corners, 0);
  // Facets lean inward by the apothem's change over the height.
  const double lean = std::atan2(std::cos(Pi / 90.0), 3.0);
  EXPECT_NEAR(bottom.upright, std::cos(lean), 1e-12);
  EXPECT_FALSE(hexsweep::makeCapCandidate(graph, { 0, 1 }).has_value());
  EXPECT_EQ(hexsweep::stepsFrom(graph, { 0 }), (std::vector<Index>{ 0, 2, 1 }));
}
}
