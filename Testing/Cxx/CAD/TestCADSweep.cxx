// SPDX-License-Identifier: BSD-3-Clause
#include "CADMeshes.h"
#include "CADParts.h"
#include "TestEvents.h"
#include "vtkCADReader.h"
#include "vtkModelGeometry.h"
#include "vtkOneToOneSweep.h"

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPolyData.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace TestCADSweep
{
using cadmeshes::temporaryFile;

double sizeOf(const TopoDS_Shape& shape)
{
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, false, false);
  return std::sqrt(box.SquareExtent());
}

double report(vtkUnstructuredGrid* grid, const std::string& name)
{
  vtkDataArray* array = grid->GetFieldData()->GetArray(("SweepReport" + name).c_str());
  return array ? array->GetTuple1(0) : HUGE_VAL;
}

/// A part in a file, and a reader of it.
struct PartFile
{
  TopoDS_Shape shape;
  std::string name = temporaryFile("part.step");
  vtkNew<vtkCADReader> reader;

  explicit PartFile(const std::string& part)
  {
    cadparts::writeSTEP(cadparts::part(part), this->name);
    this->shape = cadparts::readSTEP(this->name);
    this->reader->SetFileName(this->name);
  }
};

bool haveTheSamePoints(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  bool same = a->GetNumberOfPoints() == b->GetNumberOfPoints();
  for (vtkIdType i = 0; same && i < a->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    a->GetPoint(i, p);
    b->GetPoint(i, q);
    same = p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
  }
  return same;
}

//------------------------------------------------------------------------------
class CADSweepOfParts : public testing::TestWithParam<std::string>
{
};

TEST_P(CADSweepOfParts, IsCertifiedWithItsNodesOnTheKernelsSurfaces)
{
  PartFile part(GetParam());
  const double size = sizeOf(part.shape);
  vtkNew<vtkOneToOneSweep> sweep;
  const test::Events events(sweep);
  sweep->SetInputConnection(part.reader->GetOutputPort());
  sweep->SetSize(size / 20.0);
  sweep->Update();
  ASSERT_TRUE(events.errors.empty()) << events.errors.front();
  EXPECT_TRUE(events.warnings.empty()) << events.warnings.front();
  auto* hexes = sweep->GetOutput();
  ASSERT_GT(hexes->GetNumberOfCells(), 0);
  EXPECT_EQ(report(hexes, "NotCertified"), 0.0);
  EXPECT_EQ(report(hexes, "UnsnappedNodes"), 0.0);
  EXPECT_LT(report(hexes, "GreatestSnap"), 0.02 * size / 20.0);
  EXPECT_FALSE(hexes->GetFieldData()->HasArray("CADGeometry"));

  const cadmeshes::Distances off = cadmeshes::distancesFrom(
    part.shape, vtkUnstructuredGrid::SafeDownCast(sweep->GetOutputDataObject(1)));
  EXPECT_GT(off.nodesInFaces, 100);
  EXPECT_LT(off.inFaces, 1e-9 * size);
  EXPECT_GT(off.nodesOnEdges, 15);
  EXPECT_LT(off.onEdges, 1e-7); // the kernel's own tolerance of edges
}

INSTANTIATE_TEST_SUITE_P(Parts, CADSweepOfParts, testing::ValuesIn([] {
  std::vector<std::string> names;
  for (const cadparts::Part& part : cadparts::all())
  {
    names.emplace_back(part.name);
  }
  return names;
}()),
  [](const testing::TestParamInfo<std::string>& given) { return given.param; });

//------------------------------------------------------------------------------
class CADSweepVolume : public testing::TestWithParam<std::string>
{
};

TEST_P(CADSweepVolume, FallsWithTheSquareOfTheSizeOrFaster)
{
  PartFile part(GetParam());
  const double exact = cadparts::volumeOf(part.shape);
  const double size = sizeOf(part.shape);
  std::vector<double> errors;
  for (const double share : { 16.0, 64.0 })
  {
    vtkNew<vtkOneToOneSweep> sweep;
    sweep->SetInputConnection(part.reader->GetOutputPort());
    sweep->SetSize(size / share);
    sweep->Update();
    ASSERT_EQ(report(sweep->GetOutput(), "NotCertified"), 0.0);
    errors.push_back(std::abs(cadmeshes::volumeOf(sweep->GetOutput()) - exact) / exact);
  }
  EXPECT_LT(errors[0], 0.05);
  // A sixteenth; numbers of edges are whole, so the sizes are not exactly a quarter.
  EXPECT_LT(errors[1], 0.1 * errors[0]);
}

INSTANTIATE_TEST_SUITE_P(Parts, CADSweepVolume,
  testing::Values("bar", "elbow", "loft", "solid_loft"),
  [](const testing::TestParamInfo<std::string>& given) { return given.param; });

//------------------------------------------------------------------------------
TEST(CADSweep, GeometryIsStillThereAfterSavingTheSolid)
{
  PartFile part("funnel");
  part.reader->Update();
  const std::string file = temporaryFile("solid.vtp");
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(cadmeshes::solidOf(part.reader));
  writer->SetFileName(file.c_str());
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());

  vtkNew<vtkOneToOneSweep> direct;
  direct->SetInputConnection(part.reader->GetOutputPort());
  direct->SetSize(1.5);
  direct->Update();
  vtkNew<vtkOneToOneSweep> saved;
  const test::Events events(saved);
  saved->SetInputConnection(reader->GetOutputPort());
  saved->SetSize(1.5);
  saved->Update();
  EXPECT_TRUE(events.warnings.empty());
  EXPECT_GT(report(saved->GetOutput(), "SnappedNodes"), 0.0);
  EXPECT_TRUE(haveTheSamePoints(direct->GetOutput(), saved->GetOutput()));
}

TEST(CADSweep, WithoutSnapNodesStayOnTheFacets)
{
  PartFile part("bar");
  vtkNew<vtkOneToOneSweep> sweep;
  sweep->SetInputConnection(part.reader->GetOutputPort());
  sweep->SnapToGeometryOff();
  sweep->SetSize(1.0);
  sweep->Update();
  auto* hexes = sweep->GetOutput();
  EXPECT_FALSE(hexes->GetFieldData()->HasArray("SweepReportSnappedNodes"));
  const cadmeshes::Distances off = cadmeshes::distancesFrom(
    part.shape, vtkUnstructuredGrid::SafeDownCast(sweep->GetOutputDataObject(1)));
  // Facets of a circle of radius 5 that turn by 12 degrees.
  EXPECT_GT(off.inFaces, 1e-3);
  EXPECT_LT(off.inFaces, 5.0 * (1.0 - std::cos(0.5 * 12.0 * 3.1416 / 180.0)) * 1.01);
}

TEST(CADSweep, SolidsThatWereMovedAreSweptOnTheirFacetsWithAWarning)
{
  PartFile part("bar");
  part.reader->Update();
  vtkNew<vtkTransform> move;
  move->Translate(3.0, 0.0, 0.0);
  vtkNew<vtkTransformPolyDataFilter> moved;
  moved->SetInputData(cadmeshes::solidOf(part.reader));
  moved->SetTransform(move);
  vtkNew<vtkOneToOneSweep> sweep;
  const test::Events events(sweep);
  sweep->SetInputConnection(moved->GetOutputPort());
  sweep->SetSize(1.0);
  sweep->Update();
  ASSERT_EQ(events.warnings.size(), 1U);
  EXPECT_NE(events.warnings.front().find("moved or changed"), std::string::npos);
  EXPECT_EQ(report(sweep->GetOutput(), "NotCertified"), 0.0);
}

//------------------------------------------------------------------------------
/// The assemblies of Data/cad, body by body: they are imprinted on each other, and each is swept.
class CADSweepOfAssemblies : public testing::TestWithParam<std::string>
{
};

TEST_P(CADSweepOfAssemblies, EachBodyIsCertifiedWithItsNodesOnTheKernelsSurfaces)
{
  const std::string file = std::string(HEXSWEEP_DATA_DIR) + "/cad/" + GetParam() + ".step";
  vtkNew<vtkCADReader> reader;
  reader->SetFileName(file);
  vtkNew<vtkOneToOneSweep> sweep;
  const test::Events events(sweep);
  sweep->SetInputConnection(reader->GetOutputPort());
  reader->Update();
  const TopoDS_Shape shape = cadparts::readSTEP(file);
  const double size = sizeOf(shape);
  sweep->SetSize(size / 25.0);
  sweep->Update();
  ASSERT_TRUE(events.errors.empty()) << events.errors.front();
  auto* hexes = sweep->GetOutput();
  vtkDataArray* bad = hexes->GetFieldData()->GetArray("SweepReportNotCertified");
  ASSERT_EQ(bad->GetNumberOfTuples(),
    static_cast<vtkIdType>(reader->GetOutput()->GetNumberOfPartitionedDataSets()));
  for (vtkIdType body = 0; body < bad->GetNumberOfTuples(); ++body)
  {
    EXPECT_EQ(bad->GetTuple1(body), 0.0);
    EXPECT_EQ(hexes->GetFieldData()->GetArray("SweepReportUnsnappedNodes")->GetTuple1(body), 0.0);
  }
  // Imprinting divides faces and moves none.
  EXPECT_LT(cadmeshes::distanceFromNearestFace(
              shape, vtkUnstructuredGrid::SafeDownCast(sweep->GetOutputDataObject(1))),
    1e-9 * size);
  const double volume = cadparts::volumeOf(shape);
  EXPECT_NEAR(cadmeshes::volumeOf(hexes), volume, 0.03 * volume);
}

INSTANTIATE_TEST_SUITE_P(Data, CADSweepOfAssemblies,
  testing::Values("bolted_joint", "flanged_pipe", "lined_elbow", "pad_on_plate", "pin_in_plate",
    "sector_ring", "tee_blocks", "three_blocks"),
  [](const testing::TestParamInfo<std::string>& given) { return given.param; });
}
