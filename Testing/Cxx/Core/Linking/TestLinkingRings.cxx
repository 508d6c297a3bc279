// SPDX-License-Identifier: BSD-3-Clause
// Rings are found by topology: the truth is the function that made the sweep.
#include "Core/Linking/LinkingRings.h"

#include "Core/Common/Errors.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "Support/SweepMeshes.h"

#include <gtest/gtest.h>

#include <string>

namespace TestLinkingRings
{
using hexsweep::Index;
using hexsweep::RingStack;
using test::Sweep;

std::vector<hexsweep::Loop> loopsOf(const Sweep& sweep)
{
  return hexsweep::checkSurface(sweep.quads, sweep.source.rows(), "quads").loops;
}

RingStack trace(const Sweep& sweep)
{
  return hexsweep::traceLinkingRings(
    sweep.source, loopsOf(sweep), sweep.linkingPoints, sweep.linkingQuads);
}

/// Greatest distance of a ring node from where its column is at that layer.
double ringError(const Sweep& sweep, const RingStack& rings)
{
  const auto loops = loopsOf(sweep);
  EXPECT_EQ(rings.tables.size(), loops.size());
  EXPECT_EQ(rings.numberOfLayers(), sweep.numberOfLayers);
  double error = 0.0;
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    for (Index k = 0; k <= sweep.numberOfLayers; ++k)
    {
      const hexsweep::Points ring = hexsweep::ringPoints(rings, l, k);
      for (std::size_t j = 0; j < loops[l].size(); ++j)
      {
        const Index row = k * sweep.source.rows() + loops[l][j];
        error = std::max(error, (ring.row(static_cast<Index>(j)) - sweep.layers.row(row)).norm());
      }
    }
  }
  return error;
}

std::string errorOf(const Sweep& sweep)
{
  try
  {
    trace(sweep);
  }
  catch (const hexsweep::InvalidInput& error)
  {
    return error.what();
  }
  return "";
}

void expectError(const Sweep& sweep, const std::string& part)
{
  const std::string text = errorOf(sweep);
  EXPECT_NE(text.find(part), std::string::npos) << "got: \"" << text << '"';
}

Sweep holedSweep()
{
  return test::makeSweep(12, 9, true, test::evenLayers(5), test::affineMotion);
}

void removeLinkingQuad(Sweep& sweep, Index quad)
{
  const Index rest = sweep.linkingQuads.rows() - quad - 1;
  sweep.linkingQuads.middleRows(quad, rest) = sweep.linkingQuads.bottomRows(rest).eval();
  sweep.linkingQuads.conservativeResize(sweep.linkingQuads.rows() - 1, 4);
}

TEST(LinkingRings, FollowTheColumnsOfEveryLoop)
{
  const Sweep sweep = holedSweep();
  const RingStack rings = trace(sweep);
  ASSERT_EQ(rings.tables.size(), 2u);
  EXPECT_EQ(ringError(sweep, rings), 0.0);
  EXPECT_EQ(rings.maximumMatchDistance, 0.0);
  EXPECT_EQ(rings.snapped, 0);
}

TEST(LinkingRings, OrderAndOrientationOfCellsDoNotMatter)
{
  Sweep sweep = holedSweep();
  test::disorderLinkingSides(sweep);
  EXPECT_EQ(ringError(sweep, trace(sweep)), 0.0);
}

TEST(LinkingRings, PatchesAreJoinedAlongSeams)
{
  Sweep sweep = holedSweep();
  test::cutLinkingSides(sweep);
  EXPECT_EQ(ringError(sweep, trace(sweep)), 0.0);
  test::disorderLinkingSides(sweep);
  EXPECT_EQ(ringError(sweep, trace(sweep)), 0.0);
}

TEST(LinkingRings, OneLayerWorks)
{
  Sweep sweep = test::makeSweep(3, 2, false, test::evenLayers(1), test::affineMotion);
  EXPECT_EQ(ringError(sweep, trace(sweep)), 0.0);
}

TEST(LinkingRings, RingsMayComeClose)
{
  // Layers a billionth of a loop edge thick: far less than the tolerance at the loop's edges.
  Sweep sweep = test::makeSweep(12, 9, true, { 0, 1e-10, 2e-10, 0.5, 1 }, test::affineMotion);
  EXPECT_EQ(ringError(sweep, trace(sweep)), 0.0);
}

TEST(LinkingRings, RingsMayEvenTouchInside)
{
  // Rings 2 and 3 coincide: no patch boundary there, so nothing is welded.
  Sweep sweep = test::makeSweep(12, 9, true, { 0, 0.3, 0.6, 0.6, 1 }, test::affineMotion);
  EXPECT_EQ(ringError(sweep, trace(sweep)), 0.0);
}

TEST(LinkingRings, AnySizeAnywhere)
{
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    for (const double offset : { 0.0, 1e6 })
    {
      Sweep sweep =
        test::placed(holedSweep(), scale, scale * offset * Eigen::RowVector3d(1, -2, 0.5));
      test::cutLinkingSides(sweep);
      EXPECT_EQ(ringError(sweep, trace(sweep)), 0.0) << scale << ' ' << offset;
    }
  }
}

TEST(LinkingRings, SinglePrecisionLinkingSidesAreMatchedAndReported)
{
  Sweep sweep = holedSweep();
  sweep.linkingPoints = sweep.linkingPoints.cast<float>().cast<double>().eval();
  const RingStack rings = trace(sweep);
  EXPECT_LT(ringError(sweep, rings), 1e-6);
  EXPECT_GT(rings.snapped, 0);
  EXPECT_GT(rings.maximumMatchDistance, 0.0);
  EXPECT_LT(rings.maximumMatchDistance, 1e-6);
}

TEST(LinkingRings, ToleranceIsRelativeToTheLocalEdge)
{
  Sweep sweep = holedSweep();
  const Eigen::RowVector3d step(1e-4, 0, 0);
  sweep.source.rowwise() += step;
  EXPECT_NE(errorOf(sweep), "");
  const RingStack rings = hexsweep::traceLinkingRings(
    sweep.source, loopsOf(sweep), sweep.linkingPoints, sweep.linkingQuads, 1e-2);
  EXPECT_NEAR(rings.maximumMatchDistance, 1e-4, 1e-12);
  EXPECT_THROW(hexsweep::traceLinkingRings(
                 sweep.source, loopsOf(sweep), sweep.linkingPoints, sweep.linkingQuads, -1.0),
    hexsweep::InvalidInput);
}

TEST(LinkingRings, ErrorsNameLoopRingAndPlace)
{
  Sweep apart = holedSweep();
  apart.linkingPoints.rowwise() += Eigen::RowVector3d(0, 0, 10);
  expectError(apart, "no boundary node at node 0 of loop 0");

  Sweep hole = holedSweep();
  removeLinkingQuad(hole, 2); // layer 2 of the first column
  expectError(hole, "ring 2 of loop 0 has no quad ahead at the edge from (");

  Sweep first = holedSweep();
  removeLinkingQuad(first, 0);
  expectError(first, "ring 0 of loop 0 has no quad at the edge from (0, 0, 0)");

  Sweep extra = holedSweep();
  const Index before = extra.linkingQuads.rows();
  extra.linkingQuads.conservativeResize(before + 1, 4);
  extra.linkingQuads.row(before) = extra.linkingQuads.row(0);
  expectError(extra, "quads of the linking sides meet at the edge");

  Sweep nothing = holedSweep();
  nothing.linkingQuads.resize(0, 4);
  expectError(nothing, "no quads");

  Sweep notFinite = holedSweep();
  notFinite.linkingPoints(7, 1) = std::nan("");
  expectError(notFinite, "not a finite number");
}

TEST(LinkingRings, LeftOverQuadsAreAnError)
{
  // The cap has no hole, the linking sides have one.
  Sweep holed = holedSweep();
  Sweep plain = test::makeSweep(12, 9, false, test::evenLayers(5), test::affineMotion);
  plain.linkingPoints = holed.linkingPoints;
  plain.linkingQuads = holed.linkingQuads;
  expectError(plain, "are not reached from any loop");

  // The other way round the second loop finds no node.
  Sweep other = test::makeSweep(12, 9, false, test::evenLayers(5), test::affineMotion);
  holed.linkingPoints = other.linkingPoints;
  holed.linkingQuads = other.linkingQuads;
  expectError(holed, "of loop 1 of the source quads");
}

TEST(LinkingRings, DifferentNumbersOfLayersAreAnError)
{
  Sweep sweep = holedSweep();
  // Drop the last layer on the hole's side: its quads are those on the columns of loop 1.
  const RingStack rings = trace(sweep);
  const Index layers = sweep.numberOfLayers;
  std::vector<char> last(static_cast<std::size_t>(sweep.linkingPoints.rows()), 0);
  for (Index j = 0; j < rings.tables[1].cols(); ++j)
  {
    last[static_cast<std::size_t>(rings.tables[1](layers, j))] = 1;
  }
  for (Index q = sweep.linkingQuads.rows() - 1; q >= 0; --q)
  {
    if (last[static_cast<std::size_t>(sweep.linkingQuads.row(q).maxCoeff())])
    {
      removeLinkingQuad(sweep, q);
    }
  }
  expectError(sweep, "5 layers at loop 0 but 4 at loop 1");
}

TEST(LinkingRings, TargetLoopsMustLieOnTheLastRing)
{
  Sweep sweep = holedSweep();
  const auto loops = loopsOf(sweep);
  const RingStack rings = trace(sweep);
  const hexsweep::TargetMatch match = hexsweep::matchTargetLoops(sweep.target, rings);
  EXPECT_EQ(match.maximumDistance, 0.0);
  EXPECT_EQ(match.snapped, 0);

  sweep.target.row(loops[1][3]) += Eigen::RowVector3d(0, 0, 0.25);
  try
  {
    hexsweep::matchTargetLoops(sweep.target, rings);
    FAIL() << "no error";
  }
  catch (const hexsweep::InvalidInput& error)
  {
    const std::string text = error.what();
    EXPECT_NE(text.find("1 nodes differ"), std::string::npos) << text;
    EXPECT_NE(text.find("point " + std::to_string(loops[1][3]) + " (loop 1)"), std::string::npos)
      << text;
    EXPECT_NE(text.find("0.25 away"), std::string::npos) << text;
  }
}
}
