// SPDX-License-Identifier: BSD-3-Clause
#include "AssemblyMeshes.h"
#include "CADMeshes.h"
#include "CADParts.h"

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace TestAssemblySweep
{
using assemblymeshes::dataFile;
using assemblymeshes::gridOf;
using assemblymeshes::HexFaces;
using assemblymeshes::report;
using assemblymeshes::Swept;
using assemblymeshes::volumesIn;

/// What case.json says, as the CAD kernel measured it.
struct Assembly
{
  std::string name;
  int volumes;
  double volume;
  double outerArea;
  int sharedFaces;
};

//------------------------------------------------------------------------------
class AssemblySweepOfFiles : public testing::TestWithParam<Assembly>
{
};

TEST_P(AssemblySweepOfFiles, IsOneConformingCertifiedMesh)
{
  const Assembly& given = GetParam();
  const std::string file = dataFile(given.name);
  const TopoDS_Shape shape = cadparts::readSTEP(file);
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, false, false);
  const double size = std::sqrt(box.SquareExtent());
  Swept swept(file, size / 60.0);
  ASSERT_TRUE(swept.events.errors.empty()) << swept.events.errors.front();
  EXPECT_TRUE(swept.events.warnings.empty()) << swept.events.warnings.front();
  vtkUnstructuredGrid* hexes = swept.grid();
  EXPECT_EQ(report(hexes, "NotCertified"), 0.0);
  EXPECT_GE(report(hexes, "MinScaledJacobian"), 0.2);
  EXPECT_EQ(volumesIn(hexes).size(), static_cast<std::size_t>(given.volumes));
  const HexFaces faces(hexes);
  EXPECT_EQ(faces.most, 2);
  // Nodes are on the geometry: what is missing is what chords cut off.
  EXPECT_NEAR(faces.skinArea, given.outerArea, 0.01 * given.outerArea);
  EXPECT_NEAR(cadmeshes::volumeOf(hexes), given.volume, 0.01 * given.volume);
  EXPECT_LT(cadmeshes::distanceFromNearestFace(
              shape, vtkUnstructuredGrid::SafeDownCast(swept.sweep->GetOutputDataObject(1))),
    1e-9 * size);
}

TEST_P(AssemblySweepOfFiles, SharedFacesHaveOneMeshOfBothVolumes)
{
  Swept swept(dataFile(GetParam().name));
  ASSERT_TRUE(swept.events.errors.empty()) << swept.events.errors.front();
  auto* quads = vtkUnstructuredGrid::SafeDownCast(swept.sweep->GetOutputDataObject(1));
  std::set<std::pair<int, int>> shared;
  for (vtkIdType q = 0; q < quads->GetNumberOfCells(); ++q)
  {
    const auto value = [&](const char* name, int component) {
      return static_cast<int>(quads->GetCellData()->GetArray(name)->GetComponent(q, component));
    };
    ASSERT_GE(value("HexIds", 0), 0);
    ASSERT_EQ(value("HexIds", 1) >= 0, value("VolumeIds", 1) > 0);
    if (value("VolumeIds", 1) > 0)
    {
      shared.insert({ value("BoundaryId", 0), value("VolumeIds", 1) });
    }
  }
  EXPECT_EQ(shared.size(), static_cast<std::size_t>(GetParam().sharedFaces));
}

INSTANTIATE_TEST_SUITE_P(Data, AssemblySweepOfFiles,
  testing::Values(Assembly{ "bolted_joint", 6, 25199.159054348504, 6062.035345410779, 8 },
    Assembly{ "flanged_pipe", 2, 127573.79447697433, 37020.52782990212, 1 },
    Assembly{ "lined_elbow", 3, 28424.46067513735, 5642.188796756752, 2 },
    Assembly{ "pad_on_plate", 2, 22775.22131576613, 7784.991118430778, 1 },
    Assembly{ "pin_in_plate", 2, 26940.530723760046, 7780.176907920016, 1 },
    Assembly{ "sector_ring", 6, 42411.50082346221, 12723.45024703866, 6 },
    Assembly{ "tee_blocks", 2, 7599.999999999999, 3119.9999999999995, 1 },
    Assembly{ "three_blocks", 3, 3072.0, 1528.0, 2 }),
  [](const testing::TestParamInfo<Assembly>& given) { return given.param.name; });

//------------------------------------------------------------------------------
TEST(AssemblySweep, OutputsAVolumeASetThatShareGlobalIds)
{
  vtkNew<vtkCADReader> reader;
  reader->SetFileName(dataFile("tee_blocks").c_str());
  vtkNew<vtkAssemblySweep> sweep;
  sweep->SetInputConnection(reader->GetOutputPort());
  sweep->SetSize(3.0);
  sweep->Update();
  ASSERT_EQ(sweep->GetOutput()->GetNumberOfPartitionedDataSets(), 2U);
  std::map<vtkIdType, std::array<double, 3>> places;
  vtkIdType shared = 0;
  for (const unsigned int v : { 0U, 1U })
  {
    vtkUnstructuredGrid* grid = gridOf(sweep, v);
    EXPECT_EQ(report(grid, "NotCertified"), 0.0);
    vtkDataArray* ids = grid->GetPointData()->GetGlobalIds();
    ASSERT_NE(ids, nullptr);
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      std::array<double, 3> place{};
      grid->GetPoint(i, place.data());
      const auto [known, isNew] =
        places.try_emplace(static_cast<vtkIdType>(ids->GetTuple1(i)), place);
      shared += isNew ? 0 : 1;
      EXPECT_EQ(known->second, place);
    }
  }
  EXPECT_GT(shared, 9); // the nodes of face 3
  auto* quads = vtkUnstructuredGrid::SafeDownCast(sweep->GetOutputDataObject(1));
  vtkDataArray* volumes = quads->GetCellData()->GetArray("VolumeIds");
  vtkIdType between = 0;
  for (vtkIdType q = 0; q < quads->GetNumberOfCells(); ++q)
  {
    if (volumes->GetComponent(q, 1) > 0)
    {
      ++between;
      EXPECT_EQ(quads->GetCellData()->GetArray("BoundaryId")->GetTuple1(q), 3.0);
    }
  }
  EXPECT_GT(between, 4);
}

//------------------------------------------------------------------------------
/// Whether each node inside a face has four quads of it.
bool isStructured(vtkUnstructuredGrid* quads, int face)
{
  std::map<vtkIdType, int> uses;
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  for (vtkIdType q = 0; q < quads->GetNumberOfCells(); ++q)
  {
    if (static_cast<int>(quads->GetCellData()->GetArray("BoundaryId")->GetTuple1(q)) != face)
    {
      continue;
    }
    vtkNew<vtkIdList> corners;
    quads->GetCellPoints(q, corners);
    for (vtkIdType c = 0; c < 4; ++c)
    {
      ++uses[corners->GetId(c)];
      ++edges[std::minmax({ corners->GetId(c), corners->GetId((c + 1) % 4) })];
    }
  }
  std::set<vtkIdType> rim;
  for (const auto& [ends, count] : edges)
  {
    if (count == 1)
    {
      rim.insert({ ends.first, ends.second });
    }
  }
  return !uses.empty() && std::all_of(uses.begin(), uses.end(), [&](const auto& use) {
    return rim.count(use.first) > 0 || use.second == 4;
  });
}

// The side of one block is the cap of the other: its quads are rows and layers.
TEST(AssemblySweep, CapsOnSidesAreStructured)
{
  Swept swept(dataFile("tee_blocks"), 1.0);
  auto* quads = vtkUnstructuredGrid::SafeDownCast(swept.sweep->GetOutputDataObject(1));
  EXPECT_TRUE(isStructured(quads, 3));
}

// Three sweeps within each other, along a bend: sides are shared whole.
TEST(AssemblySweep, NestedSweepsHaveTheSameLayers)
{
  Swept swept(dataFile("lined_elbow"), 2.0);
  auto* quads = vtkUnstructuredGrid::SafeDownCast(swept.sweep->GetOutputDataObject(1));
  EXPECT_TRUE(isStructured(quads, 4));
  EXPECT_TRUE(isStructured(quads, 7));
  vtkDataArray* layers = swept.grid()->GetFieldData()->GetArray("SweepReportLayers");
  ASSERT_EQ(layers->GetNumberOfTuples(), 3);
  EXPECT_EQ(layers->GetTuple1(0), layers->GetTuple1(1));
  EXPECT_EQ(layers->GetTuple1(0), layers->GetTuple1(2));
}

// Six sectors in a circle: the last one ends where the first began.
TEST(AssemblySweep, AStackThatClosesUponItselfFits)
{
  vtkNew<vtkCADReader> reader;
  reader->SetFileName(dataFile("sector_ring").c_str());
  vtkNew<vtkAssemblySweep> sweep;
  const test::Events events(sweep);
  sweep->SetInputConnection(reader->GetOutputPort());
  sweep->SetSize(3.0);
  sweep->MergedOn();
  // From face to face round the ring, in place of from bottom to top.
  const int faces[7] = { 5, 6, 11, 16, 21, 26, 5 };
  for (int v = 1; v <= 6; ++v)
  {
    sweep->AddVolumeSource(v, faces[v - 1]);
    sweep->AddVolumeTarget(v, faces[v]);
  }
  sweep->Update();
  ASSERT_TRUE(events.errors.empty()) << events.errors.front();
  ASSERT_TRUE(events.warnings.empty()) << events.warnings.front();
  vtkUnstructuredGrid* hexes = gridOf(sweep);
  EXPECT_EQ(report(hexes, "NotCertified"), 0.0);
  const HexFaces conforming(hexes);
  EXPECT_EQ(conforming.most, 2);
  constexpr double OuterArea = 12723.45024703866; // case.json
  EXPECT_NEAR(conforming.skinArea, OuterArea, 0.01 * OuterArea);
}

//------------------------------------------------------------------------------
// Layers of the pin follow the plate's: no node of it lies between two layers of the plate.
TEST(AssemblySweep, LayersOfThePinFollowThePlates)
{
  Swept swept(dataFile("pin_in_plate"), 2.0);
  vtkUnstructuredGrid* hexes = swept.grid();
  auto* quads = vtkUnstructuredGrid::SafeDownCast(swept.sweep->GetOutputDataObject(1));
  std::set<long> heights;
  vtkDataArray* volumes = quads->GetCellData()->GetArray("VolumeIds");
  for (vtkIdType q = 0; q < quads->GetNumberOfCells(); ++q)
  {
    if (volumes->GetComponent(q, 1) > 0)
    {
      vtkNew<vtkIdList> corners;
      quads->GetCellPoints(q, corners);
      for (vtkIdType i = 0; i < 4; ++i)
      {
        heights.insert(std::lround(1e6 * quads->GetPoint(corners->GetId(i))[2]));
      }
    }
  }
  EXPECT_EQ(*heights.begin(), 0);
  EXPECT_EQ(*heights.rbegin(), 10000000);
  // The plate is 10 high, hexahedra are 2.
  EXPECT_EQ(heights.size(), 6U);
  EXPECT_EQ(report(hexes, "NotCertified"), 0.0);
}

//------------------------------------------------------------------------------
TEST(AssemblySweep, NamedCapsAreObeyed)
{
  vtkNew<vtkCADReader> reader;
  reader->SetFileName(dataFile("three_blocks").c_str());
  vtkNew<vtkAssemblySweep> sweep;
  sweep->SetInputConnection(reader->GetOutputPort());
  sweep->SetSize(2.0);
  sweep->AddVolumeSource(2, 11);
  sweep->AddVolumeTarget(2, 12);
  sweep->MergedOn();
  sweep->Update();
  EXPECT_EQ(report(gridOf(sweep), "NotCertified"), 0.0);
  auto* quads = vtkUnstructuredGrid::SafeDownCast(sweep->GetOutputDataObject(1));
  std::map<int, int> parts;
  for (vtkIdType q = 0; q < quads->GetNumberOfCells(); ++q)
  {
    parts[static_cast<int>(quads->GetCellData()->GetArray("BoundaryId")->GetTuple1(q))] =
      static_cast<int>(quads->GetCellData()->GetArray("BoundaryPart")->GetTuple1(q));
  }
  EXPECT_NE(parts[11], 2);
  EXPECT_NE(parts[12], 2);
  EXPECT_EQ(parts[13], 2);
  EXPECT_EQ(parts[14], 2);
}
}
