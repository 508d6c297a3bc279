// SPDX-License-Identifier: BSD-3-Clause
// An assembly of which no volume can be filled is an error, and not an empty mesh.
#include "EveryFilter.h"

#include <vtkAssemblySweep.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

namespace TestAssemblyWithoutHexes
{
using test::Corners;
using test::Events;
using test::Grid;

/// The solid with a corner of its first cell moved off its neighbours.
Grid opened(vtkUnstructuredGrid* solid)
{
  const Grid torn = test::deepCopy(solid);
  double place[3];
  torn->GetPoint(test::cornersOf(torn, 0).front(), place);
  const vtkIdType apart = torn->GetPoints()->InsertNextPoint(place[0], place[1], place[2] - 0.1);
  return test::changedCells(torn, [&](vtkIdType cell, Corners& corners) {
    if (cell == 0)
    {
      corners.front() = apart;
    }
  });
}

/// The assembly of two blocks, so many of them open.
vtkSmartPointer<vtkAlgorithm> sweepOf(unsigned int open)
{
  const test::FilterUse& use = test::filterUse("AssemblySweep");
  auto* given = vtkMultiBlockDataSet::SafeDownCast(use.inputs.front());
  vtkNew<vtkMultiBlockDataSet> pair;
  for (unsigned int b = 0; b < 2; ++b)
  {
    auto* solid = vtkUnstructuredGrid::SafeDownCast(given->GetBlock(b));
    pair->SetBlock(b, b < open ? opened(solid) : Grid(solid));
  }
  return use.on(0, pair);
}

/// A block that can be planned, and not filled: a triangle of its cap of face 6 is there twice, and
/// a side has a spike.
Grid brokenBlock(vtkUnstructuredGrid* block)
{
  const Grid grid = test::changedPoints(block, [](vtkIdType, std::array<double, 3>& place) {
    const bool isTip = place == std::array<double, 3>{ 0.5, 1.0, 0.5 };
    place[1] = isTip ? 3.4 : place[1];
  });
  const vtkIdType doubled[] = { 31, 35, 34 };
  grid->InsertNextCell(VTK_TRIANGLE, 3, doubled);
  grid->GetCellData()->GetArray("FaceId")->InsertNextTuple1(6.0);
  return grid;
}

TEST(AssemblySweep, WithoutAnyHexahedronFailsInWords)
{
  const test::FilterUse& use = test::filterUse("AssemblySweep");
  auto* given = vtkMultiBlockDataSet::SafeDownCast(use.inputs.front());
  vtkNew<vtkMultiBlockDataSet> one;
  one->SetBlock(0, brokenBlock(vtkUnstructuredGrid::SafeDownCast(given->GetBlock(0))));
  const vtkSmartPointer<vtkAlgorithm> sweep = use.on(0, one);
  vtkAssemblySweep::SafeDownCast(sweep)->SetSize(0.52);
  const Events events(sweep);
  sweep->Update();
  EXPECT_FALSE(test::hasOutput(sweep));
  ASSERT_EQ(events.errors.size(), 1U);
  EXPECT_NE(
    events.errors.front().find("no volume of the assembly has hexahedra"), std::string::npos)
    << events.errors.front();
}

TEST(AssemblySweep, KeepsTheVolumesThatCanBeSwept)
{
  const vtkSmartPointer<vtkAlgorithm> sweep = sweepOf(1);
  const Events events(sweep);
  sweep->Update();
  EXPECT_TRUE(test::hasOutput(sweep));
  EXPECT_TRUE(events.errors.empty());
  EXPECT_FALSE(events.warnings.empty());
}
}
