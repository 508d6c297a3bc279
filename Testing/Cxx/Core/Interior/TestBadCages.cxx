// SPDX-License-Identifier: BSD-3-Clause
// What Core says to a program whose sizes or ids are wrong.
#include "Core/Common/Errors.h"
#include "Core/Hexahedra/HexQuality.h"
#include "Core/Interior/InteriorStarts.h"
#include "Core/Interior/SweptHexes.h"
#include "Support/InteriorTests.h"

#include <functional>
#include <string>

namespace TestBadCages
{
using hexsweep::InvalidInput;
using hexsweep::SweepCage;
using test::Points;

/// What InvalidInput says; empty if nothing is thrown.
std::string refusal(const std::function<void()>& call)
{
  try
  {
    call();
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  return {};
}

void expectRefused(const std::string& part, const std::function<void()>& call)
{
  EXPECT_NE(refusal(call).find(part), std::string::npos) << refusal(call);
}

SweepCage plainCage()
{
  const test::Sweep sweep = test::makeSweep(4, 3, false, test::evenLayers(2), test::affineMotion);
  return { sweep.source, sweep.target, sweep.quads, test::boundaryOf(sweep) };
}

void fill(const SweepCage& cage)
{
  hexsweep::sweepInterior(cage, hexsweep::interiorStarts(hexsweep::InteriorKind::Automatic), {});
}

TEST(BadCalls, HexahedraOfPointsThatDoNotExist)
{
  hexsweep::Hexes hexes(2, 8);
  hexes << 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7;
  const auto judge = [&] { hexsweep::hexQualities(Points::Random(8, 3), hexes); };
  EXPECT_EQ(refusal(judge), "");
  hexes(1, 6) = 8;
  expectRefused("hexahedron 1 has the point 8", judge);
  hexes(1, 6) = -1;
  expectRefused("hexahedron 1 has the point -1", judge);
  expectRefused("12 corners", [] { hexsweep::hexQualities(Points::Zero(12, 3)); });
}

TEST(BadCalls, SweptPointsThatAreNoLayers)
{
  hexsweep::Quads quads(1, 4);
  quads << 0, 1, 2, 3;
  EXPECT_EQ(refusal([&] { hexsweep::sweptHexes(quads, Points::Random(12, 3), 2); }), "");
  expectRefused(
    "do not make 2 layers", [&] { hexsweep::sweptHexes(quads, Points::Random(11, 3), 2); });
  expectRefused(
    "do not make 0 layers", [&] { hexsweep::sweptHexes(quads, Points::Random(12, 3), 0); });
  expectRefused(
    "do not make -1 layers", [&] { hexsweep::sweptHexes(quads, Points::Random(12, 3), -1); });
  expectRefused(
    "quad 0 has the point 3", [&] { hexsweep::sweptHexes(quads, Points::Random(9, 3), 2); });
}

TEST(BadCalls, CagesWhosePartsDoNotBelongTogether)
{
  const SweepCage good = plainCage();
  EXPECT_EQ(refusal([&] { fill(good); }), "");
  expectRefused("at least one start", [&] { hexsweep::sweepInterior(good, {}, {}); });

  SweepCage bad = good;
  bad.target.conservativeResize(bad.target.rows() - 1, 3);
  expectRefused("target points", [&] { fill(bad); });
  bad = good;
  bad.quads(1, 2) = bad.source.rows();
  expectRefused("quad 1 has the point", [&] { fill(bad); });
  bad = good;
  bad.boundary.rings.resize(1);
  expectRefused("1 rings", [&] { fill(bad); });
  bad = good;
  bad.boundary.fractions.pop_back();
  expectRefused("fractions", [&] { fill(bad); });
  bad = good;
  bad.boundary.rings[1].conservativeResize(3, 3);
  expectRefused("a ring of the cage has 3 points", [&] { fill(bad); });
  bad = good;
  bad.boundary.nodes[2] = -5;
  expectRefused("loop node 2 has the point -5", [&] { fill(bad); });
}

TEST(BadCalls, MethodsThatDoNotExist)
{
  const int count = static_cast<int>(hexsweep::interiorMethodNames().size());
  for (int kind = 0; kind < count; ++kind)
  {
    EXPECT_FALSE(hexsweep::interiorStarts(static_cast<hexsweep::InteriorKind>(kind)).empty());
  }
  for (const int kind : { -1, count })
  {
    expectRefused("Method " + std::to_string(kind),
      [&] { hexsweep::interiorStarts(static_cast<hexsweep::InteriorKind>(kind)); });
  }
}

TEST(InteriorStarts, LentThreadsGiveTheSameBits)
{
  const SweepCage cage = plainCage();
  hexsweep::Index calls = 0;
  const hexsweep::ParallelFor backwards = [&](hexsweep::Index count,
                                            const std::function<void(hexsweep::Index)>& call) {
    for (hexsweep::Index i = count; i-- > 0;)
    {
      ++calls;
      call(i);
    }
  };
  for (const auto kind : { hexsweep::InteriorKind::Automatic, hexsweep::InteriorKind::Blend,
         hexsweep::InteriorKind::HarmonicCoordinates })
  {
    const auto serial = hexsweep::interiorStarts(kind).front().method(cage, {}, {});
    calls = 0;
    const auto lent = hexsweep::interiorStarts(kind).front().method(cage, {}, backwards);
    EXPECT_GT(calls, 0);
    EXPECT_TRUE((serial.array() == lent.array()).all());
  }
}
}
