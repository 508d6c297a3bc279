// SPDX-License-Identifier: BSD-3-Clause
#include "CADMeshes.h"
#include "CADParts.h"
#include "TestEvents.h"
#include "vtkAssemblySweep.h"
#include "vtkCADReader.h"

#include <BRepBndLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkHexahedron.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using cadmeshes::temporaryFile;

namespace
{
/// What case.json says, as the CAD kernel measured it.
struct Assembly
{
  std::string name;
  int volumes;
  double volume;
  double outerArea;
  int sharedFaces;
};

/// The faces of a mesh's hexahedra, and how often each is used.
struct HexFaces
{
  std::map<std::array<vtkIdType, 4>, int> uses;
  double skinArea = 0.0;
  int most = 0;

  explicit HexFaces(vtkUnstructuredGrid* grid)
  {
    std::map<std::array<vtkIdType, 4>, std::array<vtkIdType, 4>> corners;
    vtkNew<vtkIdList> points;
    for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
    {
      grid->GetCellPoints(c, points);
      for (int f = 0; f < 6; ++f)
      {
        const vtkIdType* face = vtkHexahedron::GetFaceArray(f);
        std::array<vtkIdType, 4> own{};
        for (std::size_t i = 0; i < 4; ++i)
        {
          own[i] = points->GetId(face[i]);
        }
        std::array<vtkIdType, 4> key = own;
        std::sort(key.begin(), key.end());
        corners[key] = own;
        this->most = std::max(this->most, ++this->uses[key]);
      }
    }
    for (const auto& [key, count] : this->uses)
    {
      this->skinArea += count == 1 ? areaOf(grid, corners[key]) : 0.0;
    }
  }

  static double areaOf(vtkUnstructuredGrid* grid, const std::array<vtkIdType, 4>& corners)
  {
    double p[4][3];
    for (std::size_t i = 0; i < 4; ++i)
    {
      grid->GetPoint(corners[i], p[i]);
    }
    double d[3];
    double e[3];
    double normal[3];
    vtkMath::Subtract(p[2], p[0], d);
    vtkMath::Subtract(p[3], p[1], e);
    vtkMath::Cross(d, e, normal);
    return 0.5 * vtkMath::Norm(normal);
  }
};

std::set<int> volumesIn(vtkUnstructuredGrid* grid)
{
  std::set<int> ids;
  vtkDataArray* array = grid->GetCellData()->GetArray("VolumeId");
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    ids.insert(static_cast<int>(array->GetTuple1(c)));
  }
  return ids;
}

double report(vtkUnstructuredGrid* grid, const std::string& name)
{
  vtkDataArray* array = grid->GetFieldData()->GetArray(("SweepReport" + name).c_str());
  return array ? array->GetTuple1(0) : HUGE_VAL;
}

vtkUnstructuredGrid* gridOf(vtkAssemblySweep* sweep, unsigned int place = 0)
{
  return vtkUnstructuredGrid::SafeDownCast(sweep->GetOutput()->GetPartition(place, 0));
}

/// A file read and swept, merged.
struct Swept
{
  vtkNew<vtkCADReader> reader;
  vtkNew<vtkAssemblySweep> sweep;
  test::Events events{ sweep };

  explicit Swept(const std::string& file, double size = 0.0)
  {
    this->reader->SetFileName(file.c_str());
    this->sweep->SetInputConnection(this->reader->GetOutputPort());
    this->sweep->MergedOn();
    this->sweep->SetSize(size);
    this->sweep->Update();
  }
  vtkUnstructuredGrid* grid() { return gridOf(this->sweep); }
};

std::string dataFile(const std::string& name)
{
  return std::string(HEXSWEEP_DATA_DIR) + "/cad/" + name + ".step";
}

TopoDS_Shape together(const std::vector<TopoDS_Shape>& shapes)
{
  TopoDS_Compound all;
  const BRep_Builder builder;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& shape : shapes)
  {
    builder.Add(all, shape);
  }
  return all;
}

TopoDS_Shape block(double x, double y, double z, double dx, double dy, double dz)
{
  return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Shape();
}

std::string fileOf(const std::string& name, const std::vector<TopoDS_Shape>& shapes)
{
  const std::string file = temporaryFile(name + ".step");
  cadparts::writeSTEP(together(shapes), file);
  return file;
}

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
}

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

// The images of two round pads cross: the plate is left out, and what lies apart is there.
TEST(AssemblySweep, BordersWithoutAPlaceLeaveOutOneVolumeAlone)
{
  const auto disk = [](double x, double y, double z) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z), gp_Dir(0, 0, 1)), 0.4, 1.0).Shape();
  };
  Swept swept(fileOf("crossing_pads",
                { block(0, 0, 0, 4, 4, 1), disk(1, 1, 1), disk(1.3, 1.3, -1),
                  block(9, 0, 0, 1, 1, 1), block(9, 0, 1, 1, 1, 1) }),
    0.2);
  EXPECT_TRUE(swept.events.errors.empty());
  const std::set<int> volumes = volumesIn(swept.grid());
  EXPECT_EQ(volumes.count(4) + volumes.count(5), 2U);
  EXPECT_EQ(report(swept.grid(), "NotCertified"), 0.0);
  // Each volume that is missing is named.
  EXPECT_EQ(swept.events.warnings.size(), 5U - volumes.size());
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

//------------------------------------------------------------------------------
TEST(AssemblySweep, OneSolidIsAnAssemblyToo)
{
  Swept swept(fileOf("one", { block(0, 0, 0, 4, 3, 2) }), 0.5);
  ASSERT_TRUE(swept.events.errors.empty()) << swept.events.errors.front();
  EXPECT_EQ(report(swept.grid(), "NotCertified"), 0.0);
  EXPECT_NEAR(cadmeshes::volumeOf(swept.grid()), 24.0, 1e-9);
}
