// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/RingCollapse.h"

#include "Core/Common/Errors.h"
#include "Core/Interior/BlendInterior.h"
#include "Core/Interior/SweptHexes.h"
#include "Support/HexBlocks.h"
#include "Support/InteriorTests.h"

namespace TestRingCollapse
{
using test::Points;
using test::Sweep;

Eigen::RowVector3d turned(double x, double y, double angle, double z)
{
  const double u = x - 1.0;
  const double v = y - 0.5;
  return { u * std::cos(angle) - v * std::sin(angle), u * std::sin(angle) + v * std::cos(angle),
    z };
}

constexpr double Sharpness = 0.1; // half of the rhombus's short diagonal

void check(const Sweep& sweep)
{
  hexsweep::checkRings(test::boundaryOf(sweep),
    hexsweep::checkSurface(sweep.quads, sweep.source.rows(), "source quads").loops);
}

TEST(RingCollapse, StraightColumnsThatCrossAreNamed)
{
  // A loop turned by 179 degrees with straight columns: half way all of it is nearly one point.
  const double turn = 179.0 / 180.0 * std::acos(-1.0);
  const Sweep sweep =
    test::makeSweep(6, 6, false, test::evenLayers(7), [=](double x, double y, double t) {
      return Eigen::RowVector3d((1 - t) * turned(x, y, 0.0, 0.0) + t * turned(x, y, turn, 3.0));
    });
  try
  {
    check(sweep);
    FAIL() << "the collapse was not seen";
  }
  catch (const hexsweep::InvalidInput& error)
  {
    EXPECT_NE(
      std::string(error.what()).find("ring 4 is turned over against ring 3"), std::string::npos)
      << error.what();
  }
}

/// On a rhombus with two sharp corners, about which the whole ring slides by an angle.
Eigen::RowVector3d onRhombus(double x, double y, double slide, double z)
{
  const double u = x - 0.5;
  const double v = y - 0.5;
  const double distance = 2.0 * std::max(std::abs(u), std::abs(v));
  const double angle = std::atan2(v, u) + slide;
  const double radius =
    distance / (std::abs(std::cos(angle)) + std::abs(std::sin(angle)) / Sharpness);
  return { radius * std::cos(angle), radius * std::sin(angle), z };
}

TEST(RingCollapse, ColumnsMaySlideOverASharpRidge)
{
  // Of an oblique prism with slanted layers, in which an edge that passes a ridge turns far round.
  for (const double shear : { 1.0, 1.5, 2.0 })
  {
    const Sweep sweep =
      test::makeSweep(4, 4, false, test::evenLayers(4), [=](double x, double y, double t) {
        const Eigen::RowVector3d place = onRhombus(x, y, 0.42 * t, t);
        return Eigen::RowVector3d(place[0], place[1] + shear * t, place[2] + 1.45 * place[0]);
      });
    EXPECT_NO_THROW(check(sweep)) << shear;
  }
}

TEST(RingCollapse, TwistsThatHexahedraFollowArePassed)
{
  // One quad, one layer: the only hexahedron there is, and it is certified.
  for (const double degrees : { 90.0, 120.0, 150.0, 170.0 })
  {
    const double turn = degrees / 180.0 * std::acos(-1.0);
    const Sweep sweep = test::makeSweep(1, 1, false, test::evenLayers(1),
      [=](double x, double y, double t) { return turned(x, y, turn * t, 30.0 * t); });
    EXPECT_NO_THROW(check(sweep)) << degrees;
  }
  // A prism of unequal sides turned by 150 degrees in four layers.
  const Sweep sweep = test::makeSweep(6, 6, false, test::evenLayers(4),
    [](double x, double y, double t) { return turned(x, y, 2.6 * t, 6.0 * t); });
  EXPECT_NO_THROW(check(sweep));
  const Points swept = test::run(hexsweep::blendInterior, sweep);
  EXPECT_EQ(test::judge(swept, hexsweep::sweptHexes(sweep.quads, swept, 4)).notCertified, 0);
}
}
