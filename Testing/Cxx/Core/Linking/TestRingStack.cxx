// SPDX-License-Identifier: BSD-3-Clause
// Rings that are known against the same rings found again: traced, and by the search in the quads.
#include "Core/Linking/RingStack.h"

#include "Core/Linking/CapBoundary.h"
#include "Core/Linking/LinkingRings.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "Support/SweepMeshes.h"

#include <gtest/gtest.h>

namespace TestRingStack
{
using hexsweep::Index;
using hexsweep::LinkedLoops;
using hexsweep::Loop;
using hexsweep::Points;
using hexsweep::RingStack;
using test::Sweep;

std::vector<Loop> loopsOf(const Sweep& sweep)
{
  return hexsweep::checkSurface(sweep.quads, sweep.source.rows(), "quads").loops;
}

Sweep holedSweep()
{
  return test::makeSweep(7, 5, true, test::evenLayers(3), test::affineMotion);
}

/// The same sides numbered side after side, ring after ring.
struct NumberedSides
{
  Points points{ 0, 3 };
  hexsweep::Quads quads{ 0, 4 };
};

NumberedSides numbered(const Sweep& sweep, const std::vector<Loop>& loops)
{
  NumberedSides sides;
  const Index layers = sweep.numberOfLayers;
  for (const Loop& loop : loops)
  {
    const Index n = static_cast<Index>(loop.size());
    const Index first = sides.points.rows();
    sides.points.conservativeResize(first + (layers + 1) * n, 3);
    const Index firstQuad = sides.quads.rows();
    sides.quads.conservativeResize(firstQuad + layers * n, 4);
    for (Index k = 0; k <= layers; ++k)
    {
      for (Index j = 0; j < n; ++j)
      {
        const Index a = first + k * n + j;
        const Index b = first + k * n + (j + 1) % n;
        sides.points.row(a) =
          sweep.layers.row(k * sweep.source.rows() + loop[static_cast<std::size_t>(j)]);
        if (k < layers)
        {
          sides.quads.row(firstQuad + k * n + j) << a, b, b + n, a + n;
        }
      }
    }
  }
  return sides;
}

void expectSame(const LinkedLoops& a, const LinkedLoops& b)
{
  EXPECT_EQ(a.swapped, b.swapped);
  ASSERT_EQ(a.pairs.size(), b.pairs.size());
  for (std::size_t p = 0; p < a.pairs.size(); ++p)
  {
    EXPECT_EQ(a.pairs[p].first, b.pairs[p].first);
    EXPECT_EQ(a.pairs[p].second, b.pairs[p].second);
  }
}

/// Pairs from the rings against those from a search in the quads.
void expectLookUpIsSearch(const Sweep& sweep, const RingStack& rings)
{
  const std::vector<Loop> loops = loopsOf(sweep);
  expectSame(hexsweep::linkLoops(rings),
    hexsweep::linkLoops(
      sweep.source, loops, sweep.target, loops, sweep.linkingPoints, sweep.linkingQuads, 1e-6));
}

RingStack trace(const Sweep& sweep)
{
  return hexsweep::traceLinkingRings(
    sweep.source, loopsOf(sweep), sweep.linkingPoints, sweep.linkingQuads);
}

TEST(RingStack, NumberedSidesNeedNoTracing)
{
  Sweep sweep = holedSweep();
  const std::vector<Loop> loops = loopsOf(sweep);
  const NumberedSides sides = numbered(sweep, loops);
  sweep.linkingPoints = sides.points;
  sweep.linkingQuads = sides.quads;
  const RingStack known = hexsweep::stackRings(sides.points, loops, sweep.numberOfLayers);
  const RingStack found = trace(sweep);
  EXPECT_EQ(known.numberOfLayers(), 3);
  EXPECT_EQ(known.points, found.points);
  EXPECT_EQ(known.loops, found.loops);
  EXPECT_EQ(known.turned, found.turned);
  ASSERT_EQ(known.tables.size(), found.tables.size());
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    EXPECT_EQ(known.tables[l], found.tables[l]);
    for (Index k = 0; k <= 3; ++k)
    {
      EXPECT_EQ(hexsweep::ringPoints(known, l, k), hexsweep::ringPoints(found, l, k));
    }
  }
  expectLookUpIsSearch(sweep, known);
}

TEST(RingStack, PairsAreThoseOfTheQuads)
{
  // Whichever cap the numbering begins at, whatever the cells' order and orientation, and however
  // the sides are cut: both ways must agree bit for bit.
  bool seen[2] = { false, false };
  for (const bool fromTarget : { false, true })
  {
    for (const bool cut : { false, true })
    {
      for (const bool disorder : { false, true })
      {
        Sweep sweep = holedSweep();
        if (fromTarget)
        {
          std::swap(sweep.source, sweep.target);
        }
        if (cut)
        {
          test::cutLinkingSides(sweep);
        }
        if (disorder)
        {
          test::disorderLinkingSides(sweep);
        }
        const RingStack rings = trace(sweep);
        expectLookUpIsSearch(sweep, rings);
        seen[hexsweep::linkLoops(rings).swapped ? 1 : 0] = true;
      }
    }
  }
  EXPECT_TRUE(seen[0] && seen[1]);
}

TEST(RingStack, TurnedQuadsTurnTheRings)
{
  Sweep sweep = holedSweep();
  const RingStack plain = trace(sweep);
  for (Index q = 0; q < sweep.linkingQuads.rows(); ++q)
  {
    sweep.linkingQuads.row(q).reverseInPlace();
  }
  const RingStack turned = trace(sweep);
  for (std::size_t l = 0; l < plain.tables.size(); ++l)
  {
    EXPECT_EQ(plain.tables[l], turned.tables[l]);
    EXPECT_NE(plain.turned[l], turned.turned[l]);
  }
  expectLookUpIsSearch(sweep, turned);
}
}
