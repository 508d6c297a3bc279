// SPDX-License-Identifier: BSD-3-Clause
// Solids with grooves, ribs and slanted imprints on their sides, whose edges are no columns.
#include "FailureSolids.h"

#include "HexSweepArrays.h"

namespace
{
struct Wanderer
{
  const char* name;
  double least; ///< scaled Jacobian
};

void PrintTo(const Wanderer& wanderer, std::ostream* os)
{
  *os << wanderer.name;
}

class WanderingEdges : public testing::TestWithParam<Wanderer>
{
};

TEST_P(WanderingEdges, DoNotSpoilTheMesh)
{
  test::SolidSweep sweep(test::failureGrid(GetParam().name));
  sweep.filter->Update();
  ASSERT_GT(sweep.hexes()->GetNumberOfCells(), 0) << sweep.messages();
  EXPECT_EQ(test::report(sweep.hexes(), hexsweep::reports::NotCertified), 0.0);
  EXPECT_GT(test::report(sweep.hexes(), hexsweep::reports::MinScaledJacobian), GetParam().least);
}

// With wandering edges kept: 22 of 3536 hexahedra inverted; least 0.007; more than 100 s; 8727 of
// 64675 inverted.
INSTANTIATE_TEST_SUITE_P(Solids, WanderingEdges,
  testing::Values(Wanderer{ "kept_edges_wander/groove_tilted_mini_refused", 0.38 },
    Wanderer{ "kept_edges_wander/rib_tilted_mini_sj005", 0.5 },
    Wanderer{ "kept_edges_wander/f3", 0.02 }, Wanderer{ "part_of_split_target_taken/f8", 0.4 }));
}
