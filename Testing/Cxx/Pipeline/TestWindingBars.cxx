// SPDX-License-Identifier: BSD-3-Clause
// Holes that turn about each other, through the filters, all settings at their defaults.
#include "CapGrids.h"

#include "HexSweepArrays.h"
#include "Support/WindingSweeps.h"

#include <vtkCageHexInterior.h>
#include <vtkCellType.h>
#include <vtkSweepQuadProjector.h>

namespace TestWindingBars
{
template <typename Cells>
vtkSmartPointer<vtkUnstructuredGrid> gridOf(
  const hexsweep::Points& points, const Cells& cells, int type)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (hexsweep::Index i = 0; i < points.rows(); ++i)
  {
    places->InsertNextPoint(points(i, 0), points(i, 1), points(i, 2));
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(places);
  for (hexsweep::Index c = 0; c < cells.rows(); ++c)
  {
    vtkIdType ids[4] = { 0, 0, 0, 0 };
    for (hexsweep::Index k = 0; k < cells.cols(); ++k)
    {
      ids[k] = cells(c, k);
    }
    grid->InsertNextCell(type, cells.cols(), ids);
  }
  return grid;
}

struct Bar
{
  vtkNew<vtkSweepQuadProjector> projector;
  vtkNew<vtkCageHexInterior> interior;
  test::Events projectorEvents;
  test::Events interiorEvents;

  explicit Bar(const test::WindingShape& shape)
    : projectorEvents(projector)
    , interiorEvents(interior)
  {
    const test::WindingSweep winding = test::windingSweep(shape);
    const auto source = gridOf(winding.sweep.source, winding.sweep.quads, VTK_QUAD);
    const auto sides = gridOf(winding.sweep.linkingPoints, winding.sweep.linkingQuads, VTK_QUAD);
    this->projector->SetInputData(0, source);
    this->projector->SetInputData(
      1, gridOf(winding.target.points, winding.target.triangles, VTK_TRIANGLE));
    this->projector->SetInputData(2, sides);
    this->interior->SetInputData(0, source);
    this->interior->SetInputConnection(1, this->projector->GetOutputPort());
    this->interior->SetInputData(2, sides);
  }
};

TEST(WindingBars, TwoHolesByHalfATurn)
{
  Bar bar(test::WindingShape{});
  bar.interior->Update();
  vtkUnstructuredGrid* quads = bar.projector->GetOutput();
  ASSERT_GT(quads->GetNumberOfCells(), 0);
  EXPECT_EQ(test::report(quads, hexsweep::reports::InvertedQuads), 0);
  EXPECT_NEAR(test::report(quads, hexsweep::reports::Winding), 180.0, 1e-6);
  EXPECT_TRUE(bar.projectorEvents.warnings.empty()) << bar.projectorEvents.warnings[0];
  vtkDataArray* validity =
    bar.interior->GetOutput()->GetCellData()->GetArray(hexsweep::arrays::Validity);
  ASSERT_NE(validity, nullptr);
  EXPECT_EQ(validity->GetNumberOfTuples(), quads->GetNumberOfCells() * 24);
  EXPECT_EQ(validity->GetRange()[1], 0.0);
  EXPECT_TRUE(bar.interiorEvents.warnings.empty()) << bar.interiorEvents.warnings[0];
}

TEST(WindingBars, WhatIsTooCoarseIsNamedByPlace)
{
  test::WindingShape coarse;
  coarse.cells = 6;
  coarse.degrees = 540.0;
  Bar bar(coarse);
  bar.projector->Update();
  ASSERT_FALSE(bar.projectorEvents.warnings.empty());
  EXPECT_NE(bar.projectorEvents.warnings[0].find(" at ("), std::string::npos)
    << bar.projectorEvents.warnings[0];
}
}
