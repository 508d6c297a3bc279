// SPDX-License-Identifier: BSD-3-Clause
// Layer positions against the closed form of a geometric series.
#include "Core/Linking/LayerSpacing.h"

#include "Core/Common/Errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace TestLayerSpacing
{
using hexsweep::Index;
using hexsweep::InvalidInput;
using hexsweep::layerFractions;

TEST(LayerSpacing, GrowthIsAGeometricSeries)
{
  for (const double growth : { 0.5, 0.9, 1.2, 3.0 })
  {
    const Index layers = 9;
    const std::vector<double> fractions = layerFractions(layers, growth);
    ASSERT_EQ(fractions.size(), 10u);
    for (Index k = 0; k <= layers; ++k)
    {
      const double n = static_cast<double>(k);
      EXPECT_NEAR(fractions[static_cast<std::size_t>(k)],
        (std::pow(growth, n) - 1.0) / (std::pow(growth, 9.0) - 1.0), 1e-14)
        << growth << " " << k;
    }
  }
}

TEST(LayerSpacing, BothEndsAreMirrorImages)
{
  for (const Index layers : { 1, 2, 7, 8 })
  {
    const std::vector<double> fractions = layerFractions(layers, 1.5, true);
    for (std::size_t k = 0; k < fractions.size(); ++k)
    {
      EXPECT_NEAR(fractions[k] + fractions[fractions.size() - 1 - k], 1.0, 1e-15);
    }
    if (layers > 3)
    {
      EXPECT_NEAR((fractions[2] - fractions[1]) / (fractions[1] - fractions[0]), 1.5, 1e-13);
    }
  }
}

TEST(LayerSpacing, EqualLayersAreExact)
{
  const std::vector<double> fractions = layerFractions(10);
  for (std::size_t k = 0; k < fractions.size(); ++k)
  {
    EXPECT_EQ(fractions[k], static_cast<double>(k) / 10.0);
  }
}

TEST(LayerSpacing, PositionsAreTakenAsTheyAre)
{
  EXPECT_EQ(
    layerFractions(std::vector<double>{ 0.1, 0.7 }), (std::vector<double>{ 0.0, 0.1, 0.7, 1.0 }));
}

TEST(LayerSpacing, RefusesWhatIsNoLayering)
{
  EXPECT_THROW(layerFractions(0), InvalidInput);
  EXPECT_THROW(layerFractions(-3), InvalidInput);
  EXPECT_THROW(layerFractions(5, 0.0), InvalidInput);
  EXPECT_THROW(layerFractions(5, -1.0), InvalidInput);
  EXPECT_THROW(layerFractions(5, std::numeric_limits<double>::quiet_NaN()), InvalidInput);
  EXPECT_THROW(layerFractions(2000, 2.0), InvalidInput); // the first one would have no thickness
  EXPECT_THROW(layerFractions(std::vector<double>{ 0.5, 0.5 }), InvalidInput);
  EXPECT_THROW(layerFractions(std::vector<double>{ 0.0 }), InvalidInput);
  EXPECT_THROW(layerFractions(std::vector<double>{ 0.5, 1.0 }), InvalidInput);
}

TEST(LayerSpacing, NumberOfLayersFollowsTheSize)
{
  EXPECT_EQ(hexsweep::layersOfSize(10.0, 1.0), 10);
  EXPECT_EQ(hexsweep::layersOfSize(10.0, 3.0), 3);
  EXPECT_EQ(hexsweep::layersOfSize(1.0, 300.0), 1);
  EXPECT_THROW(hexsweep::layersOfSize(1.0, 0.0), InvalidInput);
  EXPECT_THROW(hexsweep::layersOfSize(1.0, 1e-9), InvalidInput);
}
}
