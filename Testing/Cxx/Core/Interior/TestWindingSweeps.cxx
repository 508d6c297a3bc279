// SPDX-License-Identifier: BSD-3-Clause
// Holes that turn about each other on the way: quads and hexes have the winding of the sides.
#include "Core/CapQuads/SweepProjection.h"
#include "Core/Hexahedra/HexQuality.h"
#include "Core/Interior/InteriorStarts.h"
#include "Core/Interior/SectionInterior.h"
#include "Core/Interior/SweptHexes.h"
#include "Core/Linking/LinkingRings.h"
#include "Core/Surfaces/Cap.h"
#include "Core/Surfaces/QuadHalving.h"
#include "Support/InteriorTests.h"
#include "Support/WindingSweeps.h"

namespace TestWindingSweeps
{
using hexsweep::Index;
using hexsweep::Points;
using hexsweep::SweepProjection;
using hexsweep::SweepProjectionInput;
using test::Holes;
using test::WindingShape;
using test::WindingSweep;

SweepProjectionInput inputOf(const WindingSweep& winding)
{
  SweepProjectionInput input;
  input.source = { winding.sweep.source, winding.sweep.quads };
  input.target = winding.target;
  input.linking =
    test::traced(input.source, { winding.sweep.linkingPoints, winding.sweep.linkingQuads });
  input.ensureValid = true;
  input.improveQuality = true;
  return input;
}

struct Reached
{
  const char* name;
  WindingShape shape;
  double quadMinimum; ///< least scaled Jacobian
  double hexMinimum;
};

void PrintTo(const Reached& reached, std::ostream* os)
{
  *os << reached.name;
}

WindingShape shape(Holes holes, double degrees)
{
  WindingShape shape;
  shape.holes = holes;
  shape.degrees = degrees;
  return shape;
}

WindingShape bent(Holes holes, double degrees)
{
  WindingShape result = shape(holes, degrees);
  result.height = 4.0;
  result.bend = 1.2;
  result.bulge = 0.3;
  return result;
}

class WindingSweeps : public testing::TestWithParam<Reached>
{
};

TEST_P(WindingSweeps, EveryElementIsValidAndWindsAsTheSides)
{
  const Reached& reached = GetParam();
  const WindingSweep winding = test::windingSweep(reached.shape);
  const SweepProjectionInput input = inputOf(winding);
  const SweepProjection projection = hexsweep::projectSweep(input);
  EXPECT_EQ(projection.quality.inverted, 0);
  EXPECT_TRUE(projection.missedHoles.empty());
  EXPECT_GE(projection.quality.minimum, 0.95 * reached.quadMinimum);
  EXPECT_NEAR(projection.winding, reached.shape.degrees * test::Pi / 180.0, 0.01);
  if (reached.shape.bend == 0.0)
  {
    const std::vector<double> turns = test::turnOfPaths(winding.sweep.quads, winding.sweep.cap,
      hexsweep::PlanePoints(projection.quads.points.leftCols<2>()));
    ASSERT_EQ(turns.size(), reached.shape.holes == Holes::One ? 1u : 2u);
    for (const double turn : turns)
    {
      EXPECT_NEAR(turn, reached.shape.degrees * test::Pi / 180.0, 1e-6);
    }
  }

  hexsweep::SweepCage cage;
  cage.source = input.source.points;
  cage.target = projection.quads.points;
  cage.quads = input.source.quads;
  cage.boundary = hexsweep::gatherSweepBoundary(cage.source, cage.target, *input.linking);
  const double turn = hexsweep::windingOf(cage.boundary);
  EXPECT_DOUBLE_EQ(turn, projection.winding);
  const hexsweep::SweepInterior interior = hexsweep::sweepInterior(
    cage, hexsweep::interiorStarts(hexsweep::InteriorKind::Automatic, false, turn), {});
  const hexsweep::HexQualitySummary hexes = hexsweep::summarize(hexsweep::hexQualities(
    interior.points, hexsweep::sweptHexes(cage.quads, interior.points, reached.shape.layers)));
  EXPECT_EQ(hexes.hexes, cage.quads.rows() * reached.shape.layers);
  EXPECT_EQ(hexes.notCertified, 0);
  EXPECT_GE(hexes.minScaledJacobian, 0.95 * reached.hexMinimum);
}

INSTANTIATE_TEST_SUITE_P(Interior, WindingSweeps,
  testing::Values(Reached{ "TwoHolesBy90", shape(Holes::Two, 90.0), 0.242, 0.234 },
    Reached{ "TwoHolesBy120", shape(Holes::Two, 120.0), 0.143, 0.135 },
    Reached{ "TwoHolesBy180", shape(Holes::Two, 180.0), 0.158, 0.141 },
    Reached{ "ASquareHoleBy150", shape(Holes::One, 150.0), 0.306, 0.300 },
    Reached{ "ASquareHoleBy210", shape(Holes::One, 210.0), 0.170, 0.159 },
    Reached{ "TwoHolesOfABentBarBy180", bent(Holes::Two, 180.0), 0.1, 0.1 },
    Reached{ "AHoleOfABentBarBy210", bent(Holes::One, 210.0), 0.177, 0.167 }),
  [](const testing::TestParamInfo<Reached>& test) { return std::string(test.param.name); });

TEST(WindingSweeps, QuadsThatAreTooCoarseAreSaidToBe)
{
  // 15 degrees a quad: a round and a half is more than six quads from the holes to the rim can
  // bear.
  WindingShape coarse = shape(Holes::Two, 540.0);
  coarse.cells = 6;
  const SweepProjection projection = hexsweep::projectSweep(inputOf(test::windingSweep(coarse)));
  EXPECT_TRUE(projection.quality.inverted > 0 || !projection.missedHoles.empty());
  for (const hexsweep::MissedHole& hole : projection.missedHoles)
  {
    EXPECT_GT(hole.turns, 0);
    EXPECT_LT(hole.place.head<2>().norm(), 0.6);
  }
}

TEST(SectionInterior, KeepsTheContract)
{
  test::expectInteriorContract(hexsweep::sectionInterior, 1e-12);
}

TEST(SectionInterior, BoundaryBitForBit)
{
  test::expectBoundaryBitForBit(hexsweep::sectionInterior);
}

TEST(SectionInterior, AnySize)
{
  const test::Sweep sweep = test::windingSweep(shape(Holes::Two, 90.0)).sweep;
  const Points plain = test::run(hexsweep::sectionInterior, sweep);
  for (const double scale : { 1e-6, 1e6 })
  {
    const test::Sweep sized = test::placed(sweep, scale, { 0.0, 0.0, 0.0 });
    EXPECT_LT(test::greatestDistance(test::run(hexsweep::sectionInterior, sized), plain * scale),
      1e-6 * scale);
  }
}

TEST(WindingSweeps, TheMapOfTwoLoopsTakesTheTurnOfTheSides)
{
  for (const double degrees : { 150.0, 210.0, -210.0, 570.0 })
  {
    WindingShape turned = shape(Holes::One, degrees);
    turned.layers = 36;
    const WindingSweep winding = test::windingSweep(turned);
    const SweepProjectionInput input = inputOf(winding);
    const hexsweep::TriangleMesh source{ input.source.points,
      hexsweep::halveQuads(input.source.points, input.source.quads) };
    // By rings that are known, and by the quads of the sides.
    const hexsweep::LinkedLoops linked = hexsweep::linkLoops(*input.linking);
    const hexsweep::CommonDisks byRings = hexsweep::mapPairs(hexsweep::makeCap(source, "source"),
      hexsweep::makeCap(input.target, "target"), linked, hexsweep::Weights::Cotangent, 1e-6, {}, {},
      hexsweep::TriangulationImprovement::Off);
    const hexsweep::CommonDisks byQuads = hexsweep::mapLinkedCaps(source, input.target,
      hexsweep::QuadMesh{ winding.sweep.linkingPoints, winding.sweep.linkingQuads },
      hexsweep::Weights::Cotangent, 1e-6);
    std::vector<hexsweep::FixedNode> boundary;
    for (std::size_t l = 0; l < input.linking->loops.size(); ++l)
    {
      const Points last = hexsweep::ringPoints(*input.linking, l, turned.layers);
      for (std::size_t j = 0; j < input.linking->loops[l].size(); ++j)
      {
        boundary.push_back({ input.linking->loops[l][j], last.row(static_cast<Index>(j)) });
      }
    }
    for (const hexsweep::CommonDisks* disks : { &byRings, &byQuads })
    {
      const Points image = hexsweep::projectThroughDisks(input.source.points,
        std::vector<bool>(static_cast<std::size_t>(input.source.points.rows()), true), boundary,
        disks->first, disks->second)
                             .points;
      const std::vector<double> turns = test::turnOfPaths(
        winding.sweep.quads, winding.sweep.cap, hexsweep::PlanePoints(image.leftCols<2>()));
      ASSERT_EQ(turns.size(), 1u);
      EXPECT_NEAR(turns[0], degrees * test::Pi / 180.0, 1e-6);
    }
  }
}
}
