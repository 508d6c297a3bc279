// SPDX-License-Identifier: BSD-3-Clause
#include "AssemblyMeshes.h"
#include "CADMeshes.h"

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax2.hxx>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace TestAssemblyBlocks
{
using assemblymeshes::block;
using assemblymeshes::fileOf;
using assemblymeshes::HexFaces;
using assemblymeshes::report;
using assemblymeshes::Swept;
using assemblymeshes::volumesIn;

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
/// A plate with a round pad on each side, and two blocks apart from it.
std::string padsOf(const std::string& name, double shift)
{
  const auto disk = [](double x, double y, double z) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z), gp_Dir(0, 0, 1)), 0.4, 1.0).Shape();
  };
  return fileOf(name,
    { block(0, 0, 0, 4, 4, 1), disk(1, 1, 1), disk(1 + shift, 1 + shift, -1),
      block(9, 0, 0, 1, 1, 1), block(9, 0, 1, 1, 1, 1) });
}

// The borders of two round pads cross where both are seen on one cap of the plate.
TEST(AssemblySweep, BordersOfBothSidesMayCross)
{
  for (const double shift : { 0.2, 0.3, 0.4, 0.5 })
  {
    Swept swept(padsOf("crossing_pads", shift), 0.2);
    ASSERT_TRUE(swept.events.errors.empty()) << swept.events.errors.front();
    ASSERT_TRUE(swept.events.warnings.empty()) << swept.events.warnings.front();
    EXPECT_EQ(report(swept.grid(), "NotCertified"), 0.0);
    EXPECT_EQ(HexFaces(swept.grid()).most, 2);
    const double volume = 16.0 + 2.0 * std::acos(-1.0) * 0.16 + 2.0;
    EXPECT_NEAR(cadmeshes::volumeOf(swept.grid()), volume, 0.01 * volume);
  }
}

// Between these there is no room for quads of this size: what has none, or bad ones, is named.
TEST(AssemblySweep, BordersTooNearToEachOtherAreToldOfTheirVolumesAlone)
{
  Swept swept(padsOf("close_pads", 0.01), 0.2);
  EXPECT_TRUE(swept.events.errors.empty());
  const std::set<int> volumes = volumesIn(swept.grid());
  EXPECT_EQ(volumes.count(4) + volumes.count(5), 2U);
  std::map<int, double> worst;
  vtkDataArray* ids = swept.grid()->GetCellData()->GetArray("VolumeId");
  vtkDataArray* bounds = swept.grid()->GetCellData()->GetArray("JacobianLowerBound");
  for (vtkIdType h = 0; h < ids->GetNumberOfTuples(); ++h)
  {
    double& own = worst.try_emplace(static_cast<int>(ids->GetTuple1(h)), HUGE_VAL).first->second;
    own = std::min(own, bounds->GetTuple1(h));
  }
  for (int volume = 1; volume <= 5; ++volume)
  {
    const std::string name = "volume " + std::to_string(volume) + " ";
    const auto names = [&](const std::string& warning) {
      return warning.find(name) != std::string::npos;
    };
    const bool isGood = worst.count(volume) > 0 && worst[volume] > 0.0;
    EXPECT_EQ(
      std::any_of(swept.events.warnings.begin(), swept.events.warnings.end(), names), !isGood)
      << name;
  }
  EXPECT_FALSE(swept.events.warnings.empty());
}

// Nearer still, they are one border.
TEST(AssemblySweep, BordersThatHardlyDifferAreOne)
{
  for (const double shift : { 0.0005, 0.001, 0.002 })
  {
    Swept swept(padsOf("same_pads", shift), 0.2);
    ASSERT_TRUE(swept.events.warnings.empty()) << swept.events.warnings.front();
    EXPECT_EQ(report(swept.grid(), "NotCertified"), 0.0);
    EXPECT_EQ(volumesIn(swept.grid()).size(), 5U);
    EXPECT_EQ(HexFaces(swept.grid()).most, 2);
  }
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
}
