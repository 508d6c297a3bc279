// SPDX-License-Identifier: BSD-3-Clause
// Bodies with caps at several heights in assemblies: they are cut into pieces, and come whole.
#include "AssemblyMeshes.h"
#include "CADMeshes.h"
#include "CADParts.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax2.hxx>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace TestAssemblyPieces
{
using assemblymeshes::block;
using assemblymeshes::dataFile;
using assemblymeshes::fileOf;
using assemblymeshes::gridOf;
using assemblymeshes::HexFaces;
using assemblymeshes::report;
using assemblymeshes::Swept;
using assemblymeshes::volumesIn;

TopoDS_Shape rod(double x, double y, double z, double radius, double height)
{
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z), gp_Dir(0, 0, 1)), radius, height).Shape();
}

TopoDS_Shape cut(const TopoDS_Shape& from, const TopoDS_Shape& tool)
{
  return BRepAlgoAPI_Cut(from, tool).Shape();
}

TopoDS_Shape fuse(const TopoDS_Shape& one, const TopoDS_Shape& other)
{
  return BRepAlgoAPI_Fuse(one, other).Shape();
}

/// A block with a hole whose upper part is wider.
TopoDS_Shape counterbored(double size, double height, double radius, double wide, double depth)
{
  return cut(cut(block(-size / 2, -size / 2, 0, size, size, height), rod(0, 0, 0, radius, height)),
    rod(0, 0, height - depth, wide, depth));
}

/// A bolt whose shank is below its head.
TopoDS_Shape bolt(double bottom, double length, double radius, double head, double height)
{
  return fuse(rod(0, 0, bottom, radius, length), rod(0, 0, bottom + length, head, height));
}

/// One conforming, certified mesh with the volume of each body. Faces between pieces are no faces
/// of the output.
void expectWhole(Swept& swept, const std::vector<double>& volumes, double least = 0.2)
{
  ASSERT_TRUE(swept.events.errors.empty()) << swept.events.errors.front();
  ASSERT_TRUE(swept.events.warnings.empty()) << swept.events.warnings.front();
  vtkUnstructuredGrid* hexes = swept.grid();
  EXPECT_EQ(report(hexes, "NotCertified"), 0.0);
  EXPECT_GE(report(hexes, "MinScaledJacobian"), least);
  const HexFaces faces(hexes);
  EXPECT_EQ(faces.most, 2);
  EXPECT_EQ(volumesIn(hexes).size(), volumes.size());
  double whole = 0.0;
  for (const double volume : volumes)
  {
    whole += volume;
  }
  EXPECT_NEAR(cadmeshes::volumeOf(hexes), whole, 0.01 * whole);
  vtkDataArray* pairs = swept.quads()->GetCellData()->GetArray("VolumeIds");
  double skin = 0.0;
  for (vtkIdType q = 0; q < pairs->GetNumberOfTuples(); ++q)
  {
    EXPECT_NE(pairs->GetComponent(q, 0), pairs->GetComponent(q, 1));
    skin += pairs->GetComponent(q, 1) == 0.0 ? 1.0 : 0.0;
  }
  double outer = 0.0;
  for (const auto& [corners, count] : faces.uses)
  {
    outer += count == 1 ? 1.0 : 0.0;
  }
  EXPECT_EQ(skin, outer);
}

std::vector<double> piecesOf(vtkUnstructuredGrid* grid)
{
  std::vector<double> pieces;
  vtkDataArray* array = grid->GetFieldData()->GetArray("SweepReportPieces");
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    pieces.push_back(array->GetTuple1(i));
  }
  return pieces;
}

//------------------------------------------------------------------------------
// A bolt with its head, a counterbored plate and a washer under the head.
TEST(AssemblyPieces, AHeadedBoltAWasherAndACounterboredPlateFit)
{
  const std::string file = dataFile("headed_bolt");
  Swept swept(file, 1.5);
  const double pi = std::acos(-1.0);
  expectWhole(swept,
    { 72000.0 - pi * (25.0 * 12.0 + 169.0 * 8.0), pi * (121.0 - 25.0) * 2.0,
      pi * (25.0 * 20.0 + 72.25 * 6.0) },
    0.4);
  const TopoDS_Shape shape = cadparts::readSTEP(file);
  // As the kernel integrates them; what solids share counts twice there.
  EXPECT_NEAR(
    cadmeshes::volumeOf(swept.grid()), cadparts::volumeOf(shape), 0.01 * cadparts::volumeOf(shape));
  EXPECT_LT(cadmeshes::distanceFromNearestFace(shape, swept.quads()), 1e-7);
  std::multiset<double> pieces;
  for (const double count : piecesOf(swept.grid()))
  {
    pieces.insert(count);
  }
  EXPECT_EQ(pieces, (std::multiset<double>{ 1.0, 2.0, 2.0 }));
}

// One grid a body, not a piece.
TEST(AssemblyPieces, EachBodyIsOneGridWithItsName)
{
  vtkNew<vtkCADReader> reader;
  reader->SetFileName(dataFile("headed_bolt").c_str());
  vtkNew<vtkAssemblySweep> sweep;
  sweep->SetInputConnection(reader->GetOutputPort());
  sweep->SetSize(3.0);
  sweep->Update();
  ASSERT_EQ(sweep->GetOutput()->GetNumberOfPartitionedDataSets(), 3U);
  std::set<int> ids;
  for (const unsigned int v : { 0U, 1U, 2U })
  {
    vtkUnstructuredGrid* grid = gridOf(sweep, v);
    ASSERT_EQ(volumesIn(grid).size(), 1U);
    ids.insert(*volumesIn(grid).begin());
    EXPECT_EQ(report(grid, "NotCertified"), 0.0);
    const HexFaces faces(grid);
    EXPECT_EQ(faces.most, 2);
    EXPECT_EQ(grid->GetFieldData()->GetAbstractArray("VolumeName")->GetNumberOfValues(), 1);
  }
  EXPECT_EQ(ids, (std::set<int>{ 1, 2, 3 }));
}

//------------------------------------------------------------------------------
class PiecesOfFiles : public testing::TestWithParam<std::string>
{
};

TEST_P(PiecesOfFiles, BodiesWithSeveralCapsAreAssembliesToo)
{
  const std::string file = dataFile(GetParam());
  const TopoDS_Shape shape = cadparts::readSTEP(file);
  Swept swept(file, 0.02 * std::sqrt(cadparts::areaOf(shape)));
  expectWhole(swept, { cadparts::volumeOf(shape) }, 0.2);
  const double area = cadparts::areaOf(shape);
  EXPECT_NEAR(HexFaces(swept.grid()).skinArea, area, 0.02 * area);
  EXPECT_GT(piecesOf(swept.grid()).front(), 1.0);
}

INSTANTIATE_TEST_SUITE_P(Data, PiecesOfFiles,
  testing::Values("boss_plate", "counterbore_plate", "pocket_block", "stepped_shaft"),
  [](const testing::TestParamInfo<std::string>& given) { return given.param; });

//------------------------------------------------------------------------------
// The cut at the depth of the counterbore ends on the side that a block shares.
TEST(AssemblyPieces, CutsGoOnIntoTheFacesOfNeighbours)
{
  const TopoDS_Shape plate = counterbored(20.0, 6.0, 3.0, 5.0, 2.0);
  const TopoDS_Shape beside = block(10, -10, 0, 8, 20, 6);
  Swept swept(fileOf("beside_counterbore", { plate, beside }), 1.0);
  expectWhole(swept, { cadparts::volumeOf(plate), 960.0 });
}

// Two plates held by bolts whose heads sink into the upper one.
TEST(AssemblyPieces, BoltsThroughTwoPlatesFit)
{
  const TopoDS_Shape lower = cut(block(-12, -12, -5, 24, 24, 5), rod(0, 0, -5, 3.0, 5));
  const TopoDS_Shape upper = counterbored(24.0, 8.0, 3.0, 6.0, 4.0);
  const TopoDS_Shape screw = bolt(-5.0, 9.0, 3.0, 5.0, 3.0);
  Swept swept(fileOf("two_plates", { lower, upper, screw }), 1.0);
  expectWhole(
    swept, { cadparts::volumeOf(lower), cadparts::volumeOf(upper), cadparts::volumeOf(screw) });
}

// A boss that is higher than its neighbour is not cut at that one's height.
TEST(AssemblyPieces, OnlyWhatLiesBesideACapIsCut)
{
  const TopoDS_Shape part =
    fuse(fuse(block(0, 0, 0, 20, 10, 3), block(2, 2, 3, 5, 5, 2)), block(12, 2, 3, 5, 5, 6));
  Swept swept(fileOf("two_bosses", { part, block(0, 0, -2, 20, 10, 2) }), 1.0);
  expectWhole(swept, { 600.0 + 50.0 + 150.0, 400.0 });
  EXPECT_EQ(piecesOf(swept.grid()), (std::vector<double>{ 3.0, 1.0 }));
}

//------------------------------------------------------------------------------
TEST(AssemblyPieces, LayersOfABodyAreSharedOutByHeight)
{
  const TopoDS_Shape shaft = fuse(rod(0, 0, 0, 6.0, 6.0), rod(0, 0, 6.0, 3.0, 12.0));
  vtkNew<vtkCADReader> reader;
  reader->SetFileName(fileOf("shaft_layers", { shaft }).c_str());
  vtkNew<vtkAssemblySweep> sweep;
  sweep->SetInputConnection(reader->GetOutputPort());
  sweep->SetSize(2.0);
  sweep->AddVolumeLayers(1, 9);
  sweep->MergedOn();
  sweep->Update();
  std::set<long> heights;
  vtkUnstructuredGrid* grid = gridOf(sweep);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    heights.insert(std::lround(1e6 * grid->GetPoint(i)[2]));
  }
  EXPECT_EQ(heights.size(), 10U);
  EXPECT_EQ(heights.count(6000000), 1U);
}
}
