// SPDX-License-Identifier: BSD-3-Clause
// Caps that are picked in a view: selections of cells in place of face ids.
#include "BlockSolids.h"

#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>

namespace TestSelection
{
using test::Grid;
using test::Point;
using test::SolidSweep;

Grid blockAt(double x)
{
  const test::SolidBlock block = test::blockOf({ 2, 3, 4 }, [&](double u, double v, double w) {
    return Point{ x + u, 1.5 * v, 2.0 * w };
  });
  return test::blockFaces(block, test::allFaces());
}

vtkSmartPointer<vtkSelection> selectionOf(
  const std::vector<vtkIdType>& ids, int fieldType = vtkSelectionNode::CELL, int block = -1)
{
  vtkNew<vtkIdTypeArray> list;
  for (const vtkIdType id : ids)
  {
    list->InsertNextValue(id);
  }
  vtkNew<vtkSelectionNode> node;
  node->SetContentType(vtkSelectionNode::INDICES);
  node->SetFieldType(fieldType);
  node->SetSelectionList(list);
  if (block >= 0)
  {
    node->GetProperties()->Set(vtkSelectionNode::COMPOSITE_INDEX(), block);
  }
  auto selection = vtkSmartPointer<vtkSelection>::New();
  selection->AddNode(node);
  return selection;
}

/// A cell of a face.
vtkIdType cellOn(vtkUnstructuredGrid* solid, int face)
{
  vtkDataArray* ids = solid->GetCellData()->GetArray(hexsweep::arrays::FaceId);
  vtkIdType cell = 0;
  while (ids->GetTuple1(cell) != face)
  {
    ++cell;
  }
  return cell + 1; // not the first: an id that is off by one would show
}

void expectCaps(SolidSweep& sweep, int source, int target)
{
  vtkFieldData* reports = sweep.hexes()->GetFieldData();
  ASSERT_TRUE(reports->GetArray(hexsweep::reports::SourceFaceIds));
  EXPECT_EQ(reports->GetArray(hexsweep::reports::SourceFaceIds)->GetTuple1(0), source);
  EXPECT_EQ(reports->GetArray(hexsweep::reports::TargetFaceIds)->GetTuple1(0), target);
}

std::vector<Point> pointsOf(vtkUnstructuredGrid* grid)
{
  std::vector<Point> points;
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    points.push_back(test::pointOf(grid, p));
  }
  return points;
}

TEST(Selection, OfCellsIsTheSameAsNamingTheirFace)
{
  const Grid solid = blockAt(0.0);
  SolidSweep named(solid);
  named.filter->SetSize(0.5);
  named.filter->AddSourceFaceId(test::Left);
  named.filter->AddTargetFaceId(test::Right);
  named.filter->Update();
  SolidSweep picked(solid);
  picked.filter->SetSize(0.5);
  picked.filter->SetSourceSelectionData(selectionOf({ cellOn(solid, test::Left) }));
  picked.filter->SetTargetSelectionData(selectionOf({ cellOn(solid, test::Right) }));
  picked.filter->Update();
  EXPECT_EQ(picked.messages(), "");
  expectCaps(picked, test::Left, test::Right);
  EXPECT_EQ(pointsOf(picked.hexes()), pointsOf(named.hexes()));
  // Another selection is another sweep, and none the one that is found.
  picked.filter->SetSourceSelectionData(selectionOf({ cellOn(solid, test::Front) }));
  picked.filter->SetTargetSelectionData(nullptr);
  picked.filter->Update();
  expectCaps(picked, test::Front, test::Back);
}

TEST(Selection, OfABlockOfACollection)
{
  const Grid second = blockAt(3.0);
  vtkDataArray* ids = second->GetCellData()->GetArray(hexsweep::arrays::FaceId);
  for (vtkIdType c = 0; c < second->GetNumberOfCells(); ++c)
  {
    ids->SetTuple1(c, ids->GetTuple1(c) + 10);
  }
  vtkNew<vtkMultiBlockDataSet> both;
  both->SetBlock(0, blockAt(0.0));
  both->SetBlock(2, second); // block 1 is empty; flat indices: the root 0, the blocks 1, 2, 3
  SolidSweep sweep(blockAt(0.0));
  sweep.filter->SetSolidData(both);
  sweep.filter->SetSize(0.5);
  const vtkIdType cell = cellOn(second, 10 + test::Left);
  sweep.filter->SetSourceSelectionData(selectionOf({ cell }, vtkSelectionNode::CELL, 3));
  sweep.filter->Update();
  EXPECT_EQ(sweep.messages(), "");
  vtkDataArray* sources = sweep.hexes()->GetFieldData()->GetArray(hexsweep::reports::SourceFaceIds);
  ASSERT_EQ(sources->GetNumberOfTuples(), 2); // the other body's is found
  EXPECT_EQ(sources->GetTuple1(1), 10 + test::Left);
}

TEST(Selection, WithoutFaceIds)
{
  const Grid solid = blockAt(0.0);
  const vtkIdType cell = cellOn(solid, test::Front);
  solid->GetCellData()->Initialize();
  SolidSweep sweep(solid);
  sweep.filter->SetSize(0.5);
  sweep.filter->SetSourceSelectionData(selectionOf({ cell }));
  sweep.filter->Update();
  EXPECT_EQ(sweep.messages(), "");
  ASSERT_GT(sweep.hexes()->GetNumberOfCells(), 0);
  vtkDataArray* layers = sweep.hexes()->GetPointData()->GetArray(hexsweep::arrays::SweepLayer);
  for (vtkIdType p = 0; p < sweep.hexes()->GetNumberOfPoints(); ++p)
  {
    if (layers->GetTuple1(p) == 0.0)
    {
      EXPECT_NEAR(test::pointOf(sweep.hexes(), p)[1], 0.0, 1e-12); // the front is y = 0
    }
  }
}

TEST(Selection, OfWhatIsNoFaceIsRefused)
{
  const Grid solid = blockAt(0.0);
  const auto refused = [&](vtkSelection* selection, const char* part) {
    SolidSweep sweep(solid);
    sweep.filter->SetSourceSelectionData(selection);
    test::expectOneError(sweep.filter, part);
  };
  refused(selectionOf({ 0 }, vtkSelectionNode::POINT),
    "the source selection is of points or rows, not of cells");
  auto query = selectionOf({ 1 });
  query->GetNode(0)->SetContentType(vtkSelectionNode::QUERY);
  refused(query, "the source selection is no list of cells, but a query or a region");
  auto others = selectionOf({ 1 });
  others->GetNode(0)->GetProperties()->Set(vtkSelectionNode::INVERSE(), 1);
  refused(others, "the source selection is no list of cells");
  refused(selectionOf({}), "the source selection has no cells of the solid's surface");
  refused(selectionOf({ 100000 }), "the source selection has no cells of the solid's surface");
  refused(vtkSmartPointer<vtkSelection>::New(), "has no cells of the solid's surface");
}

TEST(Selection, OfTwoBodiesIsRefused)
{
  const Grid first = blockAt(0.0);
  const Grid second = blockAt(3.0);
  vtkNew<vtkMultiBlockDataSet> both;
  both->SetBlock(0, first);
  both->SetBlock(1, second);
  SolidSweep sweep(first);
  sweep.filter->SetSolidData(both);
  auto selection = selectionOf({ cellOn(first, test::Left) }, vtkSelectionNode::CELL, 1);
  selection->AddNode(
    selectionOf({ cellOn(second, test::Top) }, vtkSelectionNode::CELL, 2)->GetNode(0));
  sweep.filter->SetTargetSelectionData(selection);
  test::expectOneError(sweep.filter,
    "the target selection is on several bodies: face 3 of volume 1, and face 2 of volume 2");
}

TEST(Selection, OfVolumeCellsOnSeveralFacesTakesThoseOnOne)
{
  // 3 x 3 x 3 hexahedra: those in the corners are on three faces, one in the middle of a face on
  // that alone.
  SolidSweep block(blockAt(0.0));
  block.filter->SetNumberOfLayers(3);
  block.filter->SetQuadSize(0.3);
  block.filter->AddSourceFaceId(test::Bottom);
  block.filter->Update();
  Grid hexes = Grid::New();
  hexes->CopyStructure(block.hexes());
  vtkIdType corner = -1;
  vtkIdType middle = -1;
  const double* box = hexes->GetBounds();
  for (vtkIdType c = 0; c < hexes->GetNumberOfCells(); ++c)
  {
    const double* own = hexes->GetCell(c)->GetBounds();
    int sides = 0;
    for (int k = 0; k < 6; ++k)
    {
      sides += std::abs(own[k] - box[k]) < 1e-9;
    }
    corner = sides == 3 ? c : corner;
    middle = sides == 1 ? c : middle;
  }
  ASSERT_GE(corner, 0);
  ASSERT_GE(middle, 0);
  SolidSweep sweep(hexes);
  sweep.filter->SetSize(0.5);
  sweep.filter->SetSourceSelectionData(selectionOf({ corner, middle }));
  sweep.filter->Update();
  ASSERT_GT(sweep.hexes()->GetNumberOfCells(), 0) << sweep.messages();
  sweep.filter->SetSourceSelectionData(selectionOf({ corner }));
  test::expectOneError(sweep.filter, "each cell of the source selection is part of several faces");
}
}
