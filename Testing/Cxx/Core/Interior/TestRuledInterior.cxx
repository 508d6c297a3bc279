// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/RuledInterior.h"

#include "Support/CageTests.h"

namespace TestRuledInterior
{
using hexsweep::Index;
using hexsweep::ruledInterior;

TEST(RuledInterior, KeepsTheContract)
{
  test::expectInteriorContract(ruledInterior);
}

TEST(RuledInterior, StraightAffineSweepsAreExact)
{
  test::expectStraightAffineSweepsExact(
    [](const test::Sweep& sweep) { return test::run(ruledInterior, sweep); }, 1e-13);
}

TEST(RuledInterior, NodesAreWhereTheLayersFractionsSay)
{
  const test::Sweep sweep =
    test::makeSweep(12, 9, true, { 0.0, 0.1, 0.3, 0.6, 0.8, 1.0 }, test::bendingMotion);
  const auto boundary = test::boundaryOf(sweep);
  const hexsweep::Points swept = test::run(ruledInterior, sweep);
  const Index n = sweep.source.rows();
  double farthest = 0.0;
  for (const Index row : test::insideRows(sweep))
  {
    const double t = boundary.fractions[static_cast<std::size_t>(row / n)];
    farthest = std::max(farthest,
      (swept.row(row) - (1.0 - t) * sweep.source.row(row % n) - t * sweep.target.row(row % n))
        .norm());
  }
  EXPECT_LT(farthest, 1e-15 * test::sizeOf(sweep) * 8);
}
}
