// SPDX-License-Identifier: BSD-3-Clause
// The filter for several caps: outputs, sets, reports, reflections, several bodies, what it
// refuses.
#include "CapGrids.h"
#include "Support/SolidShapes.h"
#include "TestEvents.h"

#include <vtkCellArray.h>
#include <vtkIdTypeArray.h>
#include <vtkManyToManySweep.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOneToOneSweep.h>
#include <vtkPoints.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkSweepSets.h>

namespace TestManyToManySweep
{
using hexsweep::Index;
using Surface = vtkSmartPointer<vtkPolyData>;

/// A plate with a rib: several caps along x and z, one at either end along y.
bool isRibbed(int x, int, int z)
{
  return z == 0 || x == 2;
}

/// A plate with a post: several caps along every axis but z has one direction only.
bool isPosted(int x, int y, int z)
{
  return z == 0 || (x == 1 && y == 1);
}

Surface surfaceOf(const test::SolidInput& solid, const Eigen::RowVector3d& signs = { 1, 1, 1 })
{
  auto surface = Surface::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (Index i = 0; i < solid.points.rows(); ++i)
  {
    const Eigen::RowVector3d p = solid.points.row(i).cwiseProduct(signs);
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdTypeArray> faceIds;
  faceIds->SetName("FaceId");
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    const vtkIdType ids[3] = { solid.triangles(t, 0), solid.triangles(t, 1),
      solid.triangles(t, 2) };
    cells->InsertNextCell(3, ids);
    faceIds->InsertNextValue(solid.faceIds[static_cast<std::size_t>(t)]);
  }
  surface->SetPoints(points);
  surface->SetPolys(cells);
  surface->GetCellData()->AddArray(faceIds);
  return surface;
}

double valueOf(vtkDataObject* grid, const std::string& name, int component = 0)
{
  vtkDataArray* array = grid->GetFieldData()->GetArray(("SweepReport" + name).c_str());
  return array ? array->GetComponent(component, 0) : HUGE_VAL;
}

struct ManySweep
{
  vtkNew<vtkManyToManySweep> filter;
  test::Events events;

  explicit ManySweep(vtkDataObject* solid)
    : events(filter)
  {
    this->filter->SetSolidData(solid);
  }
  vtkUnstructuredGrid* hexes() { return this->filter->GetOutput(); }
  vtkUnstructuredGrid* boundary()
  {
    return vtkUnstructuredGrid::SafeDownCast(this->filter->GetOutputDataObject(1));
  }
};

/// By the divergence theorem over the outer quads.
double volumeInside(vtkUnstructuredGrid* boundary)
{
  double volume = 0.0;
  for (vtkIdType q = 0; q < boundary->GetNumberOfCells(); ++q)
  {
    vtkNew<vtkIdList> ids;
    boundary->GetCellPoints(q, ids);
    Eigen::RowVector3d p[4];
    for (int c = 0; c < 4; ++c)
    {
      boundary->GetPoint(ids->GetId(c), p[c].data());
    }
    volume += (p[0].dot(p[1].cross(p[2])) + p[0].dot(p[2].cross(p[3]))) / 6.0;
  }
  return volume;
}

TEST(ManyToManySweep, MeshesAPlateWithAPost)
{
  ManySweep sweep(surfaceOf(test::cubes({ 3, 3, 3 }, isPosted)));
  sweep.filter->SetSize(0.5);
  sweep.filter->Update();
  EXPECT_TRUE(sweep.events.errors.empty());
  EXPECT_TRUE(sweep.events.warnings.empty());
  vtkUnstructuredGrid* hexes = sweep.hexes();
  ASSERT_GT(hexes->GetNumberOfCells(), 0);
  EXPECT_EQ(valueOf(hexes, "NotCertified"), 0.0);
  EXPECT_GT(valueOf(hexes, "MinScaledJacobian"), 0.3);
  EXPECT_EQ(valueOf(hexes, "Regions"), 2.0);
  EXPECT_EQ(valueOf(hexes, "Levels"), 3.0);
  EXPECT_EQ(valueOf(hexes, "Size"), 0.5);
  EXPECT_NEAR(volumeInside(sweep.boundary()), 11.0, 1e-9);
  EXPECT_EQ(hexes->GetCellData()->GetArray("Validity")->GetRange()[1], 0.0);
  // Each face of the solid has its set.
  vtkNew<vtkSweepSets> sets;
  sets->SetInputConnection(0, sweep.filter->GetOutputPort(0));
  sets->SetInputConnection(1, sweep.filter->GetOutputPort(1));
  sets->RoleSetsOff();
  sets->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(sets->GetOutputDataObject(0));
  ASSERT_NE(blocks, nullptr);
  auto* sides = vtkMultiBlockDataSet::SafeDownCast(blocks->GetBlock(1));
  // Bottom, top of the plate, top of the post, four sides of each.
  EXPECT_EQ(sides->GetNumberOfBlocks(), 11U);
}

TEST(ManyToManySweep, SidesAreThoseOfTheHexahedraAlsoOfMirrorImages)
{
  constexpr int Sides[6][4] = { { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 },
    { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
  const auto leaning = [](int x, int y, int z) { return z == 0 || (x == 0 && y == 0); };
  vtkIdType cells = 0;
  for (const double sign : { 1.0, -1.0 })
  {
    ManySweep sweep(surfaceOf(test::cubes({ 3, 2, 2 }, leaning), { sign, 1.0, 1.0 }));
    sweep.filter->SetSweepDirection(0.0, 0.0, 2.0);
    sweep.filter->SetSize(0.5);
    sweep.filter->Update();
    vtkUnstructuredGrid* hexes = sweep.hexes();
    vtkUnstructuredGrid* boundary = sweep.boundary();
    cells = cells == 0 ? hexes->GetNumberOfCells() : cells;
    EXPECT_EQ(hexes->GetNumberOfCells(), cells);
    EXPECT_EQ(valueOf(hexes, "Inverted"), 0.0);
    EXPECT_EQ(valueOf(hexes, "SweepDirection", 2), 1.0);
    EXPECT_NEAR(volumeInside(boundary), 7.0, 1e-9);
    vtkDataArray* points = boundary->GetPointData()->GetArray("HexPointIds");
    for (vtkIdType q = 0; q < boundary->GetNumberOfCells(); ++q)
    {
      const auto hex =
        static_cast<vtkIdType>(boundary->GetCellData()->GetArray("HexId")->GetTuple1(q));
      const auto side =
        static_cast<int>(boundary->GetCellData()->GetArray("HexSide")->GetTuple1(q));
      vtkNew<vtkIdList> corners;
      hexes->GetCellPoints(hex, corners);
      vtkNew<vtkIdList> quad;
      boundary->GetCellPoints(q, quad);
      std::set<vtkIdType> own;
      std::set<vtkIdType> theirs;
      for (int c = 0; c < 4; ++c)
      {
        own.insert(static_cast<vtkIdType>(points->GetTuple1(quad->GetId(c))));
        theirs.insert(corners->GetId(Sides[side - 1][c]));
      }
      EXPECT_EQ(own, theirs);
    }
  }
}

TEST(ManyToManySweep, OneCapAtEitherEndIsSweptAsOneToOne)
{
  const Surface solid = surfaceOf(test::cubes({ 5, 3, 3 }, isRibbed));
  ManySweep sweep(solid);
  sweep.filter->Update();
  vtkNew<vtkOneToOneSweep> two;
  two->SetSolidData(solid);
  two->Update();
  EXPECT_EQ(sweep.hexes()->GetNumberOfCells(), two->GetOutput()->GetNumberOfCells());
  EXPECT_FALSE(sweep.hexes()->GetFieldData()->HasArray("SweepReportRegions"));
  sweep.filter->SetSweepDirection(0.0, 0.0, 1.0);
  sweep.filter->Update();
  EXPECT_EQ(valueOf(sweep.hexes(), "Regions"), 3.0);
  EXPECT_NEAR(volumeInside(sweep.boundary()), 21.0, 1e-9);
}

/// A cell in the plane where a coordinate has a value.
vtkIdType cellAt(vtkPolyData* solid, int axis, double value)
{
  vtkIdType cell = 0;
  const double* box = solid->GetCell(cell)->GetBounds();
  while (box[2 * axis] != value || box[2 * axis + 1] != value)
  {
    box = solid->GetCell(++cell)->GetBounds();
  }
  return cell;
}

vtkSmartPointer<vtkSelection> selectionOf(vtkIdType cell, int fieldType = vtkSelectionNode::CELL)
{
  vtkNew<vtkIdTypeArray> list;
  list->InsertNextValue(cell);
  vtkNew<vtkSelectionNode> node;
  node->SetContentType(vtkSelectionNode::INDICES);
  node->SetFieldType(fieldType);
  node->SetSelectionList(list);
  auto selection = vtkSmartPointer<vtkSelection>::New();
  selection->AddNode(node);
  return selection;
}

double faceOf(vtkPolyData* solid, vtkIdType cell)
{
  return solid->GetCellData()->GetArray("FaceId")->GetTuple1(cell);
}

TEST(ManyToManySweep, PickedCapsDecideTheDirection)
{
  const Surface solid = surfaceOf(test::cubes({ 5, 3, 3 }, isRibbed));
  // By itself the sweep goes along y.
  const vtkIdType ridge = cellAt(solid, 2, 3.0);
  ManySweep up(solid);
  up.filter->SetTargetSelectionData(selectionOf(ridge));
  up.filter->Update();
  EXPECT_TRUE(up.events.errors.empty());
  EXPECT_EQ(valueOf(up.hexes(), "Regions"), 3.0);
  EXPECT_EQ(valueOf(up.hexes(), "SweepDirection", 2), 1.0);
  EXPECT_NEAR(volumeInside(up.boundary()), 21.0, 1e-9);
  ManySweep down(solid);
  down.filter->SetSourceSelectionData(selectionOf(ridge));
  down.filter->SetTargetSelectionData(selectionOf(cellAt(solid, 2, 0.0)));
  down.filter->Update();
  EXPECT_TRUE(down.events.errors.empty());
  EXPECT_EQ(valueOf(down.hexes(), "SweepDirection", 2), -1.0);
  EXPECT_NEAR(volumeInside(down.boundary()), 21.0, 1e-9);
  // One cap at either end: as One To One Sweep between the picked ones.
  for (const double y : { 0.0, 3.0 })
  {
    const vtkIdType end = cellAt(solid, 1, y);
    down.filter->SetSourceSelectionData(selectionOf(end));
    down.filter->SetTargetSelectionData(nullptr);
    down.filter->Update();
    EXPECT_EQ(valueOf(down.hexes(), "SourceFaceIds"), faceOf(solid, end));
    EXPECT_FALSE(down.hexes()->GetFieldData()->HasArray("SweepReportRegions"));
  }
}

TEST(ManyToManySweep, PickedCapsThatNoDirectionHasAreRefused)
{
  const Surface solid = surfaceOf(test::cubes({ 5, 3, 3 }, isRibbed));
  const vtkIdType ridge = cellAt(solid, 2, 3.0);
  const vtkIdType side = cellAt(solid, 1, 0.0);
  const auto refused = [&](const std::function<void(vtkManyToManySweep*)>& set, const char* part) {
    ManySweep sweep(solid);
    set(sweep.filter);
    test::expectOneError(sweep.filter, part);
  };
  refused(
    [&](vtkManyToManySweep* filter) {
      filter->SetSourceSelectionData(selectionOf(ridge));
      filter->SetTargetSelectionData(selectionOf(side));
    },
    "there is no direction with face");
  refused(
    [&](vtkManyToManySweep* filter) {
      filter->SetSweepDirection(0.0, 0.0, 1.0);
      filter->SetSourceSelectionData(selectionOf(ridge));
    },
    "the given direction does not have face");
  refused(
    [&](vtkManyToManySweep* filter) {
      filter->SetSourceSelectionData(selectionOf(ridge, vtkSelectionNode::POINT));
    },
    "the source selection is of points or rows, not of cells");
  refused([&](vtkManyToManySweep* filter) { filter->SetTargetSelectionData(selectionOf(100000)); },
    "the target selection has no cells of the solid's surface");
}

TEST(ManyToManySweep, BodiesEachTakeTheirWay)
{
  vtkNew<vtkMultiBlockDataSet> both;
  both->SetBlock(0, surfaceOf(test::cubes({ 3, 3, 3 }, isPosted)));
  test::SolidInput other = test::box(2, 2, 2);
  other.points.col(0).array() += 10.0;
  for (Index& id : other.faceIds)
  {
    id += 100;
  }
  both->SetBlock(1, surfaceOf(other));
  ManySweep sweep(both);
  sweep.filter->SetSize(0.5);
  sweep.filter->Update();
  EXPECT_TRUE(sweep.events.errors.empty());
  EXPECT_NEAR(volumeInside(sweep.boundary()), 11.0 + 8.0, 1e-9);
  EXPECT_EQ(sweep.hexes()->GetCellData()->GetArray("VolumeId")->GetRange()[1], 2.0);
}

TEST(ManyToManySweep, WhatCannotBeSweptIsNamed)
{
  // Tops and bottoms of the post and the plate have one id.
  const auto oneId = [](const test::Cell&, int direction) { return direction > 4 ? 7 : direction; };
  ManySweep sweep(surfaceOf(test::cubes({ 3, 3, 3 }, isPosted, oneId)));
  sweep.filter->SetSweepDirection(0.0, 0.0, 1.0);
  sweep.filter->Update();
  ASSERT_EQ(sweep.events.errors.size(), 1U);
  EXPECT_NE(sweep.events.errors.front().find("face 7 faces both ends"), std::string::npos);
  EXPECT_EQ(sweep.hexes()->GetNumberOfCells(), 0);
  EXPECT_EQ(sweep.boundary()->GetNumberOfCells(), 0);
}

TEST(ManyToManySweep, PropertiesOutOfRangeAreErrors)
{
  const Surface solid = surfaceOf(test::cubes({ 3, 3, 3 }, isPosted));
  const auto errorOf = [&](const std::function<void(vtkManyToManySweep*)>& set) {
    ManySweep sweep(solid);
    set(sweep.filter);
    sweep.filter->Update();
    return sweep.events.errors.empty() ? std::string() : sweep.events.errors.front();
  };
  EXPECT_NE(errorOf([](auto* f) { f->SetSize(-1.0); }).find("Size"), std::string::npos);
  EXPECT_NE(errorOf([](auto* f) { f->SetDraftAngle(50.0); }).find("DraftAngle"), std::string::npos);
  EXPECT_NE(errorOf([](auto* f) { f->SetImprintTolerance(2.0); }).find("ImprintTolerance"),
    std::string::npos);
  EXPECT_NE(
    errorOf([](auto* f) { f->SetSweepDirection(HUGE_VAL, 0.0, 0.0); }).find("SweepDirection"),
    std::string::npos);
}
}
