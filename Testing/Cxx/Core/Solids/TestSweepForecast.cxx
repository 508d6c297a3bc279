// SPDX-License-Identifier: BSD-3-Clause
// Shafts with steps, and caps that go on smoothly into their sides, of known angles.
#include "Core/Solids/SweepForecast.h"

#include "Core/Solids/SolidInput.h"
#include "Core/Solids/TargetFaces.h"

#include "Support/CapMeshes.h"

#include <cmath>

namespace TestSweepForecast
{
using hexsweep::findSweepTopology;
using hexsweep::forecastSweep;
using hexsweep::Index;
using hexsweep::makeSolidSurface;
using hexsweep::Points;
using hexsweep::SolidInput;
using hexsweep::SolidSurface;

struct Station
{
  double radius;
  double height;
  Index face; ///< of the band up to the next station; of the last one: of the cap above
};

/// Turned about the z axis: face 1 is the disk below, bands follow.
SolidInput turned(const std::vector<Station>& stations)
{
  constexpr Index N = 48;
  SolidInput solid;
  const Index rings = static_cast<Index>(stations.size());
  solid.points = Points::Zero(rings * N + 2, 3);
  std::vector<Index> corners;
  const Index below = rings * N;
  const Index above = below + 1;
  for (Index k = 0; k < rings; ++k)
  {
    const Station& station = stations[static_cast<std::size_t>(k)];
    for (Index j = 0; j < N; ++j)
    {
      const double angle = 2.0 * test::Pi * static_cast<double>(j) / N;
      solid.points.row(k * N + j) << station.radius * std::cos(angle),
        station.radius * std::sin(angle), station.height;
      const Index next = (j + 1) % N;
      if (k == 0)
      {
        corners.insert(corners.end(), { below, next, j });
        solid.faceIds.push_back(1);
      }
      if (k + 1 < rings)
      {
        corners.insert(corners.end(), { k * N + j, k * N + next, (k + 1) * N + next });
        corners.insert(corners.end(), { k * N + j, (k + 1) * N + next, (k + 1) * N + j });
        solid.faceIds.insert(solid.faceIds.end(), { station.face, station.face });
      }
      else
      {
        corners.insert(corners.end(), { above, k * N + j, k * N + next });
        solid.faceIds.push_back(station.face);
      }
    }
  }
  solid.points(below, 2) = stations.front().height;
  solid.points(above, 2) = stations.back().height;
  solid.triangles = test::facesOf<hexsweep::Triangles>(corners);
  return solid;
}

/// What is told, in order.
std::vector<std::string> forecast(const SolidInput& input, Index target)
{
  const SolidSurface solid = makeSolidSurface(input);
  const hexsweep::SweepForecast told =
    forecastSweep(solid, findSweepTopology(solid, { 1 }, { target }));
  std::vector<std::string> texts;
  for (const std::string& text : { told.shoulder, told.tangentRims })
  {
    if (!text.empty())
    {
      texts.push_back(text);
    }
  }
  return texts;
}

TEST(SweepForecast, NothingIsSaidOfGoodSweeps)
{
  EXPECT_TRUE(forecast(turned({ { 1.0, 0.0, 2 }, { 1.0, 3.0, 3 } }), 3).empty());
  // A shallow groove and a cone are no shoulders.
  EXPECT_TRUE(forecast(turned({ { 1.0, 0.0, 2 }, { 1.0, 1.0, 3 }, { 0.97, 1.0, 4 },
                         { 0.97, 1.2, 5 }, { 1.0, 1.2, 6 }, { 1.0, 3.0, 7 } }),
    7)
                .empty());
  EXPECT_TRUE(forecast(turned({ { 1.0, 0.0, 2 }, { 0.5, 3.0, 3 } }), 3).empty());
}

TEST(SweepForecast, AShoulderIsNamedByItsFace)
{
  for (const double radius : { 0.5, 1.8 })
  {
    const std::vector<std::string> texts = forecast(
      turned({ { 1.0, 0.0, 2 }, { 1.0, 1.5, 17 }, { radius, 1.5, 4 }, { radius, 3.0, 5 } }), 5);
    ASSERT_EQ(texts.size(), 1u);
    EXPECT_NE(texts[0].find("face 17 of the sides runs across the sweep"), std::string::npos)
      << texts[0];
    EXPECT_NE(texts[0].find("Cut the solid at this face"), std::string::npos) << texts[0];
  }
}

TEST(SweepForecast, CapsThatGoOnSmoothlyIntoTheirSidesAreNamed)
{
  // A bowl below: its last band leans by atan(0.05 / 0.4) = 7 degrees against the cap.
  const std::vector<std::string> texts =
    forecast(turned({ { 0.6, 0.0, 9 }, { 1.0, 0.05, 2 }, { 1.2, 0.4, 3 }, { 1.2, 3.0, 4 } }), 4);
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_NE(texts[0].find("(1 into 9)"), std::string::npos) << texts[0];
}
}
