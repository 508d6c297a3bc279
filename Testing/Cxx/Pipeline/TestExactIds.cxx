// SPDX-License-Identifier: BSD-3-Clause
// Face ids of any size: none is rounded to another one on its way from the solid to the sets.
#include "BlockSolids.h"

#include <vtkMultiBlockDataSet.h>
#include <vtkSweepSets.h>
#include <vtkTypeUInt64Array.h>

#include <limits>

namespace TestExactIds
{
using namespace test;

constexpr vtkIdType Least = std::numeric_limits<vtkIdType>::min();
constexpr vtkIdType BeyondDouble = vtkIdType{ 1 } << 53;

Grid blockWithIds(const std::map<vtkIdType, vtkIdType>& ids)
{
  const Grid block = blockFaces(blockOf({ 2, 2, 3 },
                                  [](double x, double y, double z) {
                                    return Point{ x, y, 1.5 * z };
                                  }),
    allFaces());
  vtkDataArray* given = block->GetCellData()->GetArray("FaceId");
  vtkNew<vtkIdTypeArray> changed;
  changed->SetName("FaceId");
  for (vtkIdType c = 0; c < block->GetNumberOfCells(); ++c)
  {
    const auto id = static_cast<vtkIdType>(given->GetTuple1(c));
    const auto other = ids.find(id);
    changed->InsertNextValue(other == ids.end() ? id : other->second);
  }
  block->GetCellData()->AddArray(changed);
  return block;
}

TEST(ExactIds, AreThoseOfTheSolidInSweepAndSets)
{
  SolidSweep sweep(
    blockWithIds({ { Bottom, Least }, { Left, BeyondDouble }, { Right, BeyondDouble + 1 } }));
  sweep.filter->AddSourceFaceId(Least);
  sweep.filter->SetSize(0.5);
  vtkNew<vtkSweepSets> sets;
  sets->SetHexesConnection(sweep.filter->GetOutputPort(0));
  sets->SetBoundaryConnection(sweep.filter->GetOutputPort(1));
  sets->RoleSetsOff();
  sets->Update();
  EXPECT_TRUE(sweep.events.errors.empty()) << sweep.messages();
  std::set<vtkIdType> found;
  auto* ids = vtkIdTypeArray::SafeDownCast(sweep.boundary()->GetCellData()->GetArray("BoundaryId"));
  ASSERT_TRUE(ids);
  for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
  {
    found.insert(ids->GetValue(i));
  }
  EXPECT_EQ(
    found, (std::set<vtkIdType>{ Least, Top, Front, Back, BeyondDouble, BeyondDouble + 1 }));
  auto* sides = vtkMultiBlockDataSet::SafeDownCast(sets->GetOutput()->GetBlock(1));
  ASSERT_TRUE(sides);
  EXPECT_EQ(sides->GetNumberOfBlocks(), 6u);
}

TEST(ExactIds, ThoseThatDoNotFitAreRefused)
{
  const Grid block = blockWithIds({});
  vtkNew<vtkTypeUInt64Array> ids;
  ids->SetName("FaceId");
  ids->SetNumberOfValues(block->GetNumberOfCells());
  ids->FillValue(std::numeric_limits<vtkTypeUInt64>::max());
  block->GetCellData()->AddArray(ids);
  SolidSweep sweep(block);
  expectOneError(sweep.filter, "are too large or not whole");
}
}
