// SPDX-License-Identifier: BSD-3-Clause
#include "AssemblyMeshes.h"
#include "CADMeshes.h"

#include <TopoDS_Shape.hxx>

#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

using assemblymeshes::block;
using assemblymeshes::fileOf;
using assemblymeshes::HexFaces;
using assemblymeshes::report;
using assemblymeshes::Swept;

//------------------------------------------------------------------------------
// Two pads of different size on both sides of a plate: borders on both caps, none on the other.
TEST(AssemblySweep, BordersOfTheTargetAreCarriedToTheSource)
{
  const std::string file = fileOf(
    "pads", { block(0, 0, 0, 20, 16, 2), block(3, 4, 2, 6, 5, 4), block(8, 6, -3, 7, 6, 3) });
  Swept swept(file, 1.0);
  ASSERT_TRUE(swept.events.errors.empty()) << swept.events.errors.front();
  EXPECT_EQ(report(swept.grid(), "NotCertified"), 0.0);
  EXPECT_GE(report(swept.grid(), "MinScaledJacobian"), 0.2);
  const HexFaces faces(swept.grid());
  EXPECT_EQ(faces.most, 2);
  const double area = 2.0 * (20 * 16 + 20 * 2 + 16 * 2) + 2.0 * (6 + 5) * 4 + 2.0 * (7 + 6) * 3;
  EXPECT_NEAR(faces.skinArea, area, 1e-9 * area);
  EXPECT_NEAR(cadmeshes::volumeOf(swept.grid()), 640.0 + 120.0 + 126.0, 1e-6);
}

//------------------------------------------------------------------------------
/// Blocks that touch: a conforming mesh with their volume and the area of their skin.
void expectFits(
  const std::string& name, const std::vector<TopoDS_Shape>& shapes, double volume, double skinArea)
{
  Swept swept(fileOf(name, shapes), 1.0);
  ASSERT_TRUE(swept.events.errors.empty()) << swept.events.errors.front();
  ASSERT_TRUE(swept.events.warnings.empty()) << swept.events.warnings.front();
  EXPECT_EQ(report(swept.grid(), "NotCertified"), 0.0);
  EXPECT_GE(report(swept.grid(), "MinScaledJacobian"), 0.2);
  const HexFaces faces(swept.grid());
  EXPECT_EQ(faces.most, 2);
  EXPECT_NEAR(faces.skinArea, skinArea, 1e-9 * skinArea);
  EXPECT_NEAR(cadmeshes::volumeOf(swept.grid()), volume, 1e-9 * volume);
}

// Blocks on three sides of a cube: whatever way it is swept, a face lies inside one of its sides.
TEST(AssemblySweep, FacesInsideSidesAreRowsAndLayersOfThem)
{
  expectFits("three_sides",
    { block(0, 0, 0, 10, 10, 10), block(10, 2, 2, 5, 5, 5), block(2, 10, 3, 5, 5, 5),
      block(3, 3, 10, 5, 5, 5) },
    1000.0 + 3 * 125.0, 600.0 + 3 * 100.0);
}

// Swept the likeliest way each, the quads of both caps of the plate would be given.
TEST(AssemblySweep, CapsThatWouldBeKnownTwiceAreSweptOtherwise)
{
  expectFits("pads_on_both_sides",
    { block(0, 0, 0, 8, 8, 2), block(1, 1, -2, 2, 2, 2), block(5, 5, -2, 2, 2, 2),
      block(5, 1, 2, 2, 2, 2) },
    128.0 + 24.0, 192.0 + 3 * 16.0);
  expectFits("arms", { block(0, 0, 0, 9, 3, 3), block(3, -3, 0, 3, 3, 3), block(3, 3, 0, 3, 3, 3) },
    81.0 + 54.0, 126.0 + 2 * 36.0);
}

// Blocks that share parts of their sides leave faces with six corners.
TEST(AssemblySweep, SidesMayHaveMoreThanFourCorners)
{
  expectFits("staggered",
    { block(0, 0, 0, 10, 10, 4), block(5, 5, 4, 10, 10, 4), block(10, -5, 0, 8, 10, 8) },
    400.0 + 400.0 + 640.0,
    // Less twice what they share: 25 between the first two, 20 each with the third.
    360.0 + 360.0 + 448.0 - 2 * (25.0 + 20.0 + 20.0));
}

//------------------------------------------------------------------------------
TEST(AssemblySweep, OneSolidIsAnAssemblyToo)
{
  Swept swept(fileOf("one", { block(0, 0, 0, 4, 3, 2) }), 0.5);
  ASSERT_TRUE(swept.events.errors.empty()) << swept.events.errors.front();
  EXPECT_EQ(report(swept.grid(), "NotCertified"), 0.0);
  EXPECT_NEAR(cadmeshes::volumeOf(swept.grid()), 24.0, 1e-9);
}
