// SPDX-License-Identifier: BSD-3-Clause
#include "AssemblyMeshes.h"
#include "CADMeshes.h"

#include <BRepPrimAPI_MakeCone.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax2.hxx>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace TestAssemblyMessages
{
using assemblymeshes::block;
using assemblymeshes::fileOf;
using assemblymeshes::gridOf;
using assemblymeshes::report;
using assemblymeshes::Swept;
using assemblymeshes::volumesIn;

/// Ids of the faces of a solid at its least and greatest z.
std::pair<int, int> facesAcross(vtkCADReader* reader, unsigned int solid)
{
  auto* triangles = vtkPolyData::SafeDownCast(reader->GetOutput()->GetPartition(solid, 0));
  vtkDataArray* ids = triangles->GetCellData()->GetArray("FaceId");
  double bounds[6];
  triangles->GetBounds(bounds);
  std::pair<int, int> found{ -1, -1 };
  for (vtkIdType t = 0; t < triangles->GetNumberOfCells(); ++t)
  {
    double own[6];
    triangles->GetCellBounds(t, own);
    if (own[4] == own[5])
    {
      (own[4] == bounds[4] ? found.first : found.second) = static_cast<int>(ids->GetTuple1(t));
    }
  }
  return found;
}

//------------------------------------------------------------------------------
TEST(AssemblySweep, AVolumeThatCannotBeSweptIsNamedWithItsFaces)
{
  // A cone to its tip on a block.
  const std::string file = fileOf("cone",
    { block(0, 0, 0, 10, 10, 10),
      BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(5, 5, 10), gp_Dir(0, 0, 1)), 3.0, 0.0, 4.0).Shape() });
  Swept swept(file, 1.0);
  EXPECT_TRUE(swept.events.errors.empty());
  ASSERT_EQ(swept.events.warnings.size(), 1U);
  const std::string& warning = swept.events.warnings.front();
  EXPECT_NE(warning.find("volume 2"), std::string::npos) << warning;
  EXPECT_NE(warning.find("has no hexahedra"), std::string::npos) << warning;
  // The other one is there.
  EXPECT_EQ(volumesIn(swept.grid()), std::set<int>{ 1 });
  EXPECT_NEAR(cadmeshes::volumeOf(swept.grid()), 1000.0, 1e-6);
}

//------------------------------------------------------------------------------
/// The filter's one warning about blocks as the reader gives them without imprinting.
std::string warningAbout(const std::vector<TopoDS_Shape>& shapes)
{
  vtkNew<vtkCADReader> reader;
  reader->SetFileName(fileOf("neighbours", shapes).c_str());
  reader->ImprintAndMergeOff();
  vtkNew<vtkAssemblySweep> sweep;
  const test::Events events(sweep);
  sweep->SetInputConnection(reader->GetOutputPort());
  sweep->SetSize(2.0);
  sweep->Update();
  EXPECT_TRUE(events.errors.empty()) << events.errors.front();
  EXPECT_EQ(events.warnings.size(), 1U);
  return events.warnings.empty() ? std::string() : events.warnings.front();
}

TEST(AssemblySweep, SaysOnceHowVolumesLieWrong)
{
  const TopoDS_Shape first = block(0, 0, 0, 10, 10, 10);
  const auto expectWords = [](const std::string& warning, const std::string& words) {
    EXPECT_NE(warning.find(words), std::string::npos) << warning;
  };
  expectWords(warningAbout({ first, block(5, 5, 5, 10, 10, 10) }), "overlap at (");
  // Bars that cross: no corner of one lies in the other.
  expectWords(warningAbout({ block(-10, 0, 0, 20, 2, 2), block(-1, -10, 0.5, 2, 20, 1) }),
    "go through or lie upon each other");
  expectWords(warningAbout({ first, block(2, 3, 4, 2, 2, 2) }), "(\"Solid 2\") lies in volume 1");
  expectWords(warningAbout({ first, block(0, 0, 0, 10, 10, 10) }), "are the same body");
  expectWords(warningAbout({ first, block(0, 0, 10.0005, 10, 10, 5) }), "are 0.0005 apart");
  // They touch and were not imprinted.
  expectWords(warningAbout({ first, block(1, 1, 10, 4, 4, 4) }), "without sharing a face");
}

TEST(AssemblySweep, VolumesThatAreFarFromEachOtherGiveNoWarning)
{
  Swept swept(fileOf("apart", { block(0, 0, 0, 4, 4, 4), block(5, 0, 0, 4, 4, 4) }), 1.0);
  EXPECT_TRUE(swept.events.errors.empty());
  EXPECT_TRUE(swept.events.warnings.empty()) << swept.events.warnings.front();
  EXPECT_EQ(volumesIn(swept.grid()).size(), 2U);
}

//------------------------------------------------------------------------------
// Blocks whose sides share layers, asked for different numbers of them.
TEST(AssemblySweep, NumbersOfLayersThatContradictEachOtherAreRefusedInWords)
{
  vtkNew<vtkCADReader> reader;
  reader->SetFileName(
    fileOf("beside", { block(0, 0, 0, 4, 4, 4), block(4, 0, 0, 4, 4, 4) }).c_str());
  vtkNew<vtkAssemblySweep> sweep;
  const test::Events events(sweep);
  sweep->SetInputConnection(reader->GetOutputPort());
  sweep->SetSize(1.0);
  sweep->AddVolumeLayers(1, 3);
  sweep->AddVolumeLayers(2, 5);
  // Top and bottom are caps of both, so that the face between them is a side of both.
  for (const int volume : { 1, 2 })
  {
    reader->Update();
    const auto [bottom, top] = facesAcross(reader, static_cast<unsigned int>(volume - 1));
    sweep->AddVolumeSource(volume, bottom);
    sweep->AddVolumeTarget(volume, top);
  }
  sweep->Update();
  ASSERT_EQ(events.errors.size(), 1U);
  EXPECT_NE(events.errors.front().find("contradict"), std::string::npos) << events.errors.front();
  EXPECT_NE(events.errors.front().find("volume 2"), std::string::npos) << events.errors.front();
  EXPECT_NE(events.errors.front().find("they share face"), std::string::npos);
  sweep->RemoveAllVolumeLayers();
  sweep->AddVolumeLayers(1, 3);
  sweep->Update();
  EXPECT_EQ(gridOf(sweep, 1)->GetFieldData()->GetArray("SweepReportLayers")->GetTuple1(0), 3.0);
}
}
