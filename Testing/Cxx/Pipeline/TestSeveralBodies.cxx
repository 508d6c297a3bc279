// SPDX-License-Identifier: BSD-3-Clause
// Solids that consist of several bodies.
#include "BlockSolids.h"

#include <vtkAppendFilter.h>
#include <vtkFieldData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkSweepCandidates.h>
#include <vtkSweepSets.h>
#include <vtkTable.h>

namespace TestSeveralBodies
{
using test::Grid;
using test::Point;
using test::SolidSweep;

/// A block of 2 x 2 x 2 facets on each side, with a corner at (x, 0, 0), faces 10 i + 1 to 10 i
/// + 6.
Grid blockAt(double x, const Point& size, int number)
{
  const test::SolidBlock block = test::blockOf({ 2, 2, 2 }, [&](double u, double v, double w) {
    return Point{ x + size[0] * u, size[1] * v, size[2] * w };
  });
  Grid grid = test::blockFaces(block, test::allFaces());
  vtkDataArray* ids = grid->GetCellData()->GetArray(hexsweep::arrays::FaceId);
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    ids->SetTuple1(c, ids->GetTuple1(c) + 10 * number);
  }
  return grid;
}

Grid together(const std::vector<Grid>& grids)
{
  vtkNew<vtkAppendFilter> append;
  for (const Grid& grid : grids)
  {
    append->AddInputData(grid);
  }
  append->Update();
  Grid result = Grid::New();
  result->ShallowCopy(append->GetOutput());
  return result;
}

void setVolume(vtkUnstructuredGrid* grid, vtkIdType id)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(hexsweep::arrays::VolumeId);
  ids->SetNumberOfValues(grid->GetNumberOfCells());
  ids->FillValue(id);
  grid->GetCellData()->AddArray(ids);
}

/// A ball cut in two: no way to sweep it.
Grid ballAt(double x, int number)
{
  const test::SolidBlock block = test::blockOf({ 6, 6, 6 }, [&](double u, double v, double w) {
    const Point p{ 2.0 * u - 1.0, 2.0 * v - 1.0, 2.0 * w - 1.0 };
    const double norm = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    const double scale = norm > 0.0 ? 1.0 / norm : 0.0;
    return Point{ x + p[0] * scale, p[1] * scale, p[2] * scale };
  });
  Grid grid = test::blockFaces(block, test::allFaces());
  vtkDataArray* ids = grid->GetCellData()->GetArray(hexsweep::arrays::FaceId);
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    ids->SetTuple1(c, 10 * number);
  }
  return grid;
}

std::map<vtkIdType, vtkIdType> hexesOfVolumes(vtkUnstructuredGrid* hexes)
{
  std::map<vtkIdType, vtkIdType> counts;
  vtkDataArray* ids = hexes->GetCellData()->GetArray(hexsweep::arrays::VolumeId);
  for (vtkIdType h = 0; ids && h < hexes->GetNumberOfCells(); ++h)
  {
    ++counts[static_cast<vtkIdType>(ids->GetTuple1(h))];
  }
  return counts;
}

TEST(SeveralBodies, AreSweptOneAfterTheOther)
{
  const Grid first = blockAt(0.0, { 1.0, 1.0, 1.0 }, 1);
  const Grid second = blockAt(3.0, { 1.0, 2.0, 3.0 }, 2);
  SolidSweep sweep(together({ first, second }));
  sweep.filter->SetSize(0.25);
  sweep.filter->Update();
  EXPECT_EQ(sweep.messages(), "");
  const std::map<vtkIdType, vtkIdType> counts = hexesOfVolumes(sweep.hexes());
  ASSERT_EQ(counts.size(), 2u);
  vtkIdType alone = 0;
  for (const auto& [grid, volume] : { std::pair(first, 1), std::pair(second, 2) })
  {
    SolidSweep one(grid);
    one.filter->SetSize(0.25);
    one.filter->Update();
    EXPECT_EQ(one.hexes()->GetNumberOfCells(), counts.at(volume));
    alone += one.hexes()->GetNumberOfPoints();
  }
  EXPECT_EQ(sweep.hexes()->GetNumberOfPoints(), alone);
  EXPECT_NEAR(test::enclosedVolume(sweep.boundary()), 1.0 + 6.0, 1e-12);
  vtkFieldData* reports = sweep.hexes()->GetFieldData();
  ASSERT_EQ(reports->GetArray(hexsweep::reports::VolumeIds)->GetNumberOfTuples(), 2);
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_EQ(reports->GetArray(hexsweep::reports::VolumeIds)->GetTuple1(i), i + 1);
    EXPECT_EQ(reports->GetArray(hexsweep::reports::Hexes)->GetTuple1(i), counts.at(i + 1));
    EXPECT_EQ(reports->GetArray(hexsweep::reports::NotCertified)->GetTuple1(i), 0.0);
  }
}

TEST(SeveralBodies, TheBoundaryCountsOn)
{
  SolidSweep sweep(
    together({ blockAt(0.0, { 1.0, 1.0, 1.0 }, 1), blockAt(3.0, { 1.0, 2.0, 3.0 }, 2) }));
  sweep.filter->SetSize(0.5);
  sweep.filter->Update();
  vtkUnstructuredGrid* boundary = sweep.boundary();
  vtkDataArray* hexIds = boundary->GetCellData()->GetArray(hexsweep::arrays::HexId);
  vtkDataArray* pointIds = boundary->GetPointData()->GetArray(hexsweep::arrays::HexPointIds);
  vtkDataArray* faces = boundary->GetCellData()->GetArray(hexsweep::arrays::BoundaryId);
  vtkDataArray* volumes = boundary->GetCellData()->GetArray(hexsweep::arrays::VolumeId);
  ASSERT_TRUE(volumes);
  for (vtkIdType p = 0; p < boundary->GetNumberOfPoints(); ++p)
  {
    ASSERT_EQ(test::pointOf(boundary, p),
      test::pointOf(sweep.hexes(), static_cast<vtkIdType>(pointIds->GetTuple1(p))));
  }
  for (vtkIdType q = 0; q < boundary->GetNumberOfCells(); ++q)
  {
    const test::Corners hex =
      test::cornersOf(sweep.hexes(), static_cast<vtkIdType>(hexIds->GetTuple1(q)));
    for (const vtkIdType p : test::cornersOf(boundary, q))
    {
      ASSERT_NE(std::find(hex.begin(), hex.end(), static_cast<vtkIdType>(pointIds->GetTuple1(p))),
        hex.end());
    }
    ASSERT_EQ(static_cast<int>(faces->GetTuple1(q)) / 10, volumes->GetTuple1(q));
  }
}

TEST(SeveralBodies, VolumeIdsOfTheFileCountAndPick)
{
  const Grid first = blockAt(0.0, { 1.0, 1.0, 1.0 }, 1);
  const Grid second = blockAt(1.0, { 1.0, 1.0, 1.0 }, 2); // touches the first one
  SolidSweep alone(first);
  alone.filter->SetSize(0.5);
  alone.filter->Update();
  const vtkIdType count = alone.hexes()->GetNumberOfCells();
  ASSERT_GE(count, 8);
  setVolume(first, 40);
  setVolume(second, 7);
  const Grid both = together({ first, second });
  SolidSweep sweep(both);
  sweep.filter->SetSize(0.5);
  sweep.filter->Update();
  EXPECT_EQ(sweep.messages(), "");
  EXPECT_EQ(
    hexesOfVolumes(sweep.hexes()), (std::map<vtkIdType, vtkIdType>{ { 7, count }, { 40, count } }));
  sweep.filter->AddVolumeId(40);
  sweep.filter->Update();
  EXPECT_EQ(hexesOfVolumes(sweep.hexes()), (std::map<vtkIdType, vtkIdType>{ { 40, count } }));
  EXPECT_NEAR(test::enclosedVolume(sweep.boundary()), 1.0, 1e-12);
  sweep.filter->AddVolumeId(3);
  test::expectOneError(sweep.filter, "no volume 3. It has volumes 7 and 40");
}

TEST(SeveralBodies, NamedFacesCountForTheBodiesThatHaveThem)
{
  SolidSweep sweep(
    together({ blockAt(0.0, { 1.0, 1.0, 1.0 }, 1), blockAt(3.0, { 1.0, 2.0, 3.0 }, 2) }));
  sweep.filter->SetSize(0.5);
  sweep.name({ 13, 25 }, {});
  sweep.filter->Update();
  vtkDataArray* sources = sweep.hexes()->GetFieldData()->GetArray(hexsweep::reports::SourceFaceIds);
  ASSERT_EQ(sources->GetNumberOfTuples(), 2);
  EXPECT_EQ(sources->GetTuple1(0), 13.0);
  EXPECT_EQ(sources->GetTuple1(1), 25.0);
  sweep.filter->AddSourceFaceId(99);
  test::expectOneError(sweep.filter, "no volume that is to be swept has a face 99");
}

TEST(SeveralBodies, OneThatCannotBeSweptIsNamedBesideThoseThatCan)
{
  SolidSweep sweep(together(
    { blockAt(0.0, { 1.0, 1.0, 1.0 }, 1), ballAt(4.0, 2), blockAt(6.0, { 1.0, 2.0, 3.0 }, 3) }));
  sweep.filter->SetSize(0.5);
  test::expectOneError(sweep.filter,
    "1 volume of the solid cannot be swept, those that can are 1 and 3 (set VolumeIds to sweep "
    "them "
    "alone): volume 2: no way to sweep");
}

TEST(SeveralBodies, OneThatIsOpenIsNamedBesideThoseThatCanBeSwept)
{
  const Grid open =
    test::cellsWith(blockAt(4.0, { 1.0, 1.0, 1.0 }, 2), hexsweep::arrays::FaceId, 20.0 + test::Top);
  SolidSweep sweep(together({ blockAt(0.0, { 1.0, 1.0, 1.0 }, 1), open }));
  sweep.filter->SetSize(0.5);
  test::expectOneError(sweep.filter,
    "those that can are 1 (set VolumeIds to sweep them alone): volume 2: the solid is open");
  sweep.filter->AddVolumeId(1);
  sweep.filter->Update();
  EXPECT_GT(sweep.hexes()->GetNumberOfCells(), 0);
}

TEST(SeveralBodies, FacesFoundByAngleKeepTheirIdsWhenSomeArePicked)
{
  const Grid both =
    together({ blockAt(0.0, { 1.0, 1.0, 1.0 }, 1), blockAt(3.0, { 1.0, 2.0, 3.0 }, 2) });
  both->GetCellData()->RemoveArray(hexsweep::arrays::FaceId);
  SolidSweep sweep(both);
  sweep.filter->SetSize(0.5);
  sweep.filter->AddVolumeId(2);
  sweep.name({ 8 }, {});
  sweep.filter->Update();
  EXPECT_EQ(sweep.messages(), "");
  EXPECT_EQ(test::report(sweep.hexes(), hexsweep::reports::SourceFaceIds), 8.0);
}

TEST(SeveralBodies, TheInputStaysAsItIs)
{
  const Grid both =
    together({ blockAt(0.0, { 1.0, 1.0, 1.0 }, 1), blockAt(3.0, { 1.0, 2.0, 3.0 }, 2) });
  vtkNew<vtkIdTypeArray> old;
  old->SetName("SweepReportOld");
  old->InsertNextValue(4);
  both->GetFieldData()->AddArray(old);
  SolidSweep sweep(both);
  sweep.filter->SetSize(0.5);
  sweep.filter->Update();
  ASSERT_GT(sweep.hexes()->GetNumberOfCells(), 0);
  EXPECT_EQ(old->GetNumberOfTuples(), 1);
}

TEST(SeveralBodies, AreListedWithTheirCandidates)
{
  vtkNew<vtkSweepCandidates> candidates;
  candidates->SetInputData(
    together({ blockAt(0.0, { 1.0, 1.0, 1.0 }, 1), blockAt(3.0, { 1.0, 2.0, 3.0 }, 2) }));
  candidates->Update();
  vtkTable* table = vtkTable::SafeDownCast(candidates->GetOutputDataObject(0));
  std::map<vtkIdType, vtkIdType> rows;
  for (vtkIdType r = 0; r < table->GetNumberOfRows(); ++r)
  {
    const vtkIdType volume = table->GetValueByName(r, "VolumeId").ToLongLong();
    EXPECT_EQ(table->GetValueByName(r, "Rank").ToLongLong(), ++rows[volume]);
    EXPECT_EQ(table->GetValueByName(r, "SourceFaceIds").ToInt() / 10, volume);
  }
  EXPECT_GE(rows[1], 3);
  EXPECT_GE(rows[2], 3);
}

TEST(SeveralBodies, GiveAnExodusBlockEach)
{
  SolidSweep sweep(
    together({ blockAt(0.0, { 1.0, 1.0, 1.0 }, 1), blockAt(3.0, { 1.0, 2.0, 3.0 }, 2) }));
  sweep.filter->SetSize(0.5);
  vtkNew<vtkSweepSets> sets;
  sets->SetInputConnection(0, sweep.filter->GetOutputPort(0));
  sets->SetInputConnection(1, sweep.filter->GetOutputPort(1));
  sets->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(sets->GetOutputDataObject(0));
  ASSERT_TRUE(blocks);
  auto* elements = vtkMultiBlockDataSet::SafeDownCast(blocks->GetBlock(0));
  ASSERT_TRUE(elements);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(elements->GetBlock(0));
  ASSERT_TRUE(grid);
  vtkDataArray* ids = grid->GetCellData()->GetArray("ObjectId");
  ASSERT_TRUE(ids);
  EXPECT_EQ(ids->GetRange()[0], 1.0);
  EXPECT_EQ(ids->GetRange()[1], 2.0);
}

TEST(SeveralBodies, SourceQuadsNeedOneVolume)
{
  const Grid first = blockAt(0.0, { 1.0, 1.0, 1.0 }, 1);
  SolidSweep alone(first);
  alone.filter->SetSize(0.5);
  alone.filter->Update();
  const Grid quads = test::cellsWith(alone.boundary(), hexsweep::arrays::BoundaryPart, 0.0);
  SolidSweep sweep(together({ first, blockAt(3.0, { 1.0, 2.0, 3.0 }, 2) }), quads);
  sweep.filter->SetSize(0.5);
  test::expectOneError(sweep.filter, "Name the one that they lie on (VolumeIds)");
  sweep.filter->AddVolumeId(1);
  sweep.filter->Update();
  EXPECT_EQ(sweep.hexes()->GetNumberOfCells(), alone.hexes()->GetNumberOfCells());
}
}
