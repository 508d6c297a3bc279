// SPDX-License-Identifier: BSD-3-Clause
// Bodies whose caps run almost tangentially into the sides, mapped from a grid: what caps and
// interior make must not be worse than the grid, neither at its worst nor on the whole, and what is
// chosen not worse than what could have been.
#include "Core/CapQuads/SweepProjection.h"
#include "Core/Interior/InteriorStarts.h"
#include "Core/Interior/SweptHexes.h"
#include "Core/Linking/LinkingRings.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include "Support/CapMeshes.h"
#include "Support/HexBlocks.h"
#include "Support/SweepMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace TestRoundedBodies
{
using test::Index;
using test::Points;

struct Body
{
  const char* name;
  double roundness; ///< 1: the grid's corners are on a smooth surface
  double length;    ///< over the width
  double bend;      ///< angle between the caps
  double twist;
  double taper;
  int cells = 12; ///< along an edge of a cap
  int layers = 30;
};

void PrintTo(const Body& body, std::ostream* os)
{
  *os << body.name;
}

/// The cube [-1, 1]^3 drawn over a ball, then stretched, tapered, twisted and bent.
Eigen::RowVector3d placeIn(const Body& body, double x, double y, double t)
{
  const Eigen::Array3d u(2 * x - 1, 2 * y - 1, 2 * t - 1);
  const Eigen::Array3d s = body.roundness * u.square();
  const Eigen::Array3d ball(u[0] * std::sqrt(1 - s[1] / 2 - s[2] / 2 + s[1] * s[2] / 3),
    u[1] * std::sqrt(1 - s[2] / 2 - s[0] / 2 + s[2] * s[0] / 3),
    u[2] * std::sqrt(1 - s[0] / 2 - s[1] / 2 + s[0] * s[1] / 3));
  const double width = 1 + body.taper * ball[2];
  const double turn = 0.5 * body.twist * ball[2];
  const Eigen::Vector2d section =
    Eigen::Rotation2Dd(turn) * Eigen::Vector2d(width * ball[0], 0.8 * width * ball[1]);
  const double along = body.length * ball[2];
  const double radius = 2 * body.length / body.bend;
  const double angle = along / radius;
  return { (radius + section.x()) * std::cos(angle) - radius, section.y(),
    (radius + section.x()) * std::sin(angle) };
}

class RoundedBodies : public testing::TestWithParam<Body>
{
};

TEST_P(RoundedBodies, AreNotWorseThanTheGridTheyWereMappedFrom)
{
  const Body& body = GetParam();
  const int layers = body.layers;
  const hexsweep::QuadMesh plate = test::quadPlate(body.cells, {});
  const test::Sweep sweep = test::sweepCap(plate.points.leftCols<2>(), plate.quads,
    test::evenLayers(layers), [&](double x, double y, double t) { return placeIn(body, x, y, t); });
  const auto grid =
    test::judge(sweep.layers, hexsweep::sweptHexes(sweep.quads, sweep.layers, layers));
  ASSERT_GT(grid.minScaledJacobian, 0.0);
  ASSERT_LT(grid.minScaledJacobian, 0.2);

  hexsweep::SweepProjectionInput input;
  input.source = { sweep.source, sweep.quads };
  input.target = test::plate(3 * body.cells, {});
  for (Index i = 0; i < input.target.points.rows(); ++i)
  {
    input.target.points.row(i) =
      placeIn(body, input.target.points(i, 0), input.target.points(i, 1), 1.0);
  }
  const auto loops = hexsweep::checkSurface(sweep.quads, sweep.source.rows(), "source quads").loops;
  input.linking =
    hexsweep::traceLinkingRings(sweep.source, loops, sweep.linkingPoints, sweep.linkingQuads);
  input.ensureValid = true;
  input.improveQuality = true;
  const hexsweep::SweepProjection caps = hexsweep::projectSweep(input);
  ASSERT_EQ(caps.quality.inverted, 0);

  hexsweep::SweepCage cage;
  cage.source = sweep.source;
  cage.target = caps.quads.points;
  cage.quads = sweep.quads;
  cage.boundary = hexsweep::gatherSweepBoundary(cage.source, cage.target, *input.linking);
  const hexsweep::SweepInterior inside =
    hexsweep::sweepInterior(cage, hexsweep::interiorStarts(hexsweep::InteriorKind::Automatic), {});
  const auto hexes =
    test::judge(inside.points, hexsweep::sweptHexes(cage.quads, inside.points, layers));
  EXPECT_EQ(hexes.notCertified, 0);
  EXPECT_GE(hexes.minScaledJacobian, grid.minScaledJacobian * (1.0 - 1e-12)) << inside.method;
  EXPECT_GE(hexes.meanScaledJacobian, grid.meanScaledJacobian) << inside.method;

  using hexsweep::InteriorKind;
  for (const InteriorKind kind :
    { InteriorKind::Blend, InteriorKind::HarmonicCoordinates, InteriorKind::LayerMarch })
  {
    const hexsweep::SweepInterior named =
      hexsweep::sweepInterior(cage, hexsweep::interiorStarts(kind), {});
    const auto others =
      test::judge(named.points, hexsweep::sweptHexes(cage.quads, named.points, layers));
    EXPECT_GE(hexes.minScaledJacobian, others.minScaledJacobian * (1.0 - 1e-12)) << named.method;
    EXPECT_GE(hexes.meanScaledJacobian, others.meanScaledJacobian) << named.method;
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, RoundedBodies,
  testing::Values(Body{ "Egg", 0.85, 1.5, 0.1, 0.0, 0.2 }, Body{ "Bean", 0.8, 2.0, 1.2, 0.0, 0.0 },
    Body{ "Limb", 0.9, 4.0, 0.8, 0.6, -0.2 }, Body{ "Trunk", 0.92, 3.0, 0.4, -0.9, 0.3 },
    Body{ "FineEgg", 0.85, 1.5, 0.1, 0.0, 0.2, 16, 40 },
    Body{ "EggOfThinLayers", 0.9, 1.2, 0.1, 0.0, 0.3, 8, 60 },
    Body{ "Ball", 0.92, 1.0, 0.05, 0.0, 0.0 }, Body{ "Lens", 0.9, 0.4, 0.05, 0.0, 0.0 },
    Body{ "FlatBean", 0.85, 0.5, 0.6, 0.0, 0.1, 16, 12 },
    Body{ "TwistedLimb", 0.85, 5.0, 1.2, 1.0, 0.1 }));
}
