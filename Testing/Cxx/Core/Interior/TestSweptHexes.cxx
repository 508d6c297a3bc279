// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/SweptHexes.h"

#include "Core/Common/Errors.h"
#include "Core/Hexahedra/HexQuality.h"
#include "Support/SweepMeshes.h"

#include <gtest/gtest.h>

namespace TestSweptHexes
{
using hexsweep::Hexes;
using hexsweep::Index;
using hexsweep::Quads;
using test::Sweep;

Sweep someSweep()
{
  return test::makeSweep(9, 6, true, test::evenLayers(4), test::affineMotion);
}

TEST(SweptHexes, NumberingFollowsTheSourceQuads)
{
  const Sweep sweep = someSweep();
  const Hexes hexes = hexsweep::sweptHexes(sweep.quads, sweep.layers, 4);
  const Index n = sweep.source.rows();
  const Index m = sweep.quads.rows();
  ASSERT_EQ(hexes.rows(), 4 * m);
  const auto backwards = [](Index count, const std::function<void(Index)>& call) {
    for (Index i = count - 1; i >= 0; --i)
    {
      call(i);
    }
  };
  EXPECT_EQ(hexsweep::sweptHexes(sweep.quads, sweep.layers, 4, backwards), hexes);
  for (Index k = 0; k < 4; ++k)
  {
    for (Index j = 0; j < m; ++j)
    {
      for (int c = 0; c < 4; ++c)
      {
        EXPECT_EQ(hexes(k * m + j, c), k * n + sweep.quads(j, c));
        EXPECT_EQ(hexes(k * m + j, c + 4), (k + 1) * n + sweep.quads(j, c));
      }
    }
  }
}

TEST(SweptHexes, AreRightHandedWhicheverWayTheQuadsFace)
{
  const Sweep sweep = someSweep();
  for (const bool turned : { false, true })
  {
    const Quads quads = turned ? Quads(sweep.quads.rowwise().reverse()) : sweep.quads;
    const Hexes hexes = hexsweep::sweptHexes(quads, sweep.layers, 4);
    for (const auto& quality : hexsweep::hexQualities(sweep.layers, hexes))
    {
      EXPECT_GT(quality.scaledJacobian, 0.2);
    }
    EXPECT_EQ(hexes(0, 0) < hexes(0, 4), !turned);
  }
}

TEST(SweptHexes, OneBadLayerDoesNotTurnTheMesh)
{
  // The first layer is folded back.
  const Sweep sweep = test::makeSweep(9, 6, false, { 0, -0.1, 0.3, 0.6, 1 }, test::affineMotion);
  const Hexes hexes = hexsweep::sweptHexes(sweep.quads, sweep.layers, 4);
  EXPECT_EQ(
    hexsweep::summarize(hexsweep::hexQualities(sweep.layers, hexes)).inverted, sweep.quads.rows());
}

TEST(SameQuads, AnyStartAndDirectionIsTheSameQuad)
{
  const Sweep sweep = someSweep();
  Quads other = sweep.quads;
  for (Index q = 0; q < other.rows(); ++q)
  {
    for (int c = 0; c < 4; ++c)
    {
      other(q, c) = sweep.quads(q, (q + (q % 2 ? 1 : 3) * c) % 4);
    }
  }
  EXPECT_NO_THROW(hexsweep::checkSameQuads(sweep.quads, other));

  std::swap(other(5, 0), other(5, 1));
  EXPECT_THROW(hexsweep::checkSameQuads(sweep.quads, other), hexsweep::InvalidInput);
  EXPECT_THROW(
    hexsweep::checkSameQuads(sweep.quads, sweep.quads.topRows(3)), hexsweep::InvalidInput);
}
}
