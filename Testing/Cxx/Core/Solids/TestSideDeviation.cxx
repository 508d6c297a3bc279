// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SideDeviation.h"
#include "Core/Solids/SourceQuads.h"
#include "Support/LentThreads.h"
#include "Support/SweptSolids.h"

#include <gtest/gtest.h>

namespace TestSideDeviation
{
using namespace test;

/// A square bar of half width 1 and height 2 with a straight square hole, wider by `bulge` half
/// way.
hexsweep::SolidInput barrel(double bulge, bool ofHole)
{
  const Section square = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
  const Section hole = { { -0.4, -0.4 }, { -0.4, 0.4 }, { 0.4, 0.4 }, { 0.4, -0.4 } };
  return sweptSolid(
    { square, hole },
    [=](double x, double y, double h) {
      const bool bulges = (std::abs(x) > 0.5) != ofHole;
      const double wider = bulges ? bulge * (1.0 - std::abs(2.0 * h - 1.0)) : 0.0;
      const double r = std::max(std::abs(x), std::abs(y));
      return Eigen::RowVector3d((1.0 + wider / r) * x, (1.0 + wider / r) * y, 2.0 * h);
    },
    2);
}

double deviation(
  const hexsweep::SolidInput& input, Index layers, const hexsweep::ParallelFor& parallelFor = {})
{
  const hexsweep::SolidSurface solid = hexsweep::makeSolidSurface(input);
  const hexsweep::SweepTopology topology = hexsweep::sweepBetween(solid, { 1 }, { 2 });
  const hexsweep::QuadMesh quads = hexsweep::makeSourceQuads(input, solid, topology, 0.25).mesh;
  hexsweep::SolidCageInput cage{ solid, topology, quads, {}, {} };
  cage.layers.layers = layers;
  return hexsweep::greatestSideDistance(
    hexsweep::makeSolidCage(cage), solid, topology, parallelFor);
}

TEST(SideDeviation, QuadsCutOffARidgeThatNoLayerFollows)
{
  for (const bool ofHole : { false, true })
  {
    for (const double bulge : { 0.05, 0.2 })
    {
      const hexsweep::SolidInput solid = barrel(bulge, ofHole);
      const double slope = bulge / std::sqrt(1.0 + bulge * bulge);
      // Columns are not quite upright, so that rings between the caps are not quite level.
      const double drift = 2e-3 * bulge;
      EXPECT_NEAR(deviation(solid, 1), slope, drift);
      EXPECT_NEAR(deviation(solid, 2), 0.0, drift);
      // The middle layer of three is flat at two thirds of the bulge.
      EXPECT_NEAR(deviation(solid, 3), slope / 3.0, drift);
      EXPECT_EQ(deviation(solid, 21, sideBySide), deviation(solid, 21));
    }
  }
}

TEST(SideDeviation, APrismHasNone)
{
  EXPECT_LT(deviation(barrel(0.0, false), 3), 1e-12);
}
}
