// SPDX-License-Identifier: BSD-3-Clause
// vtkHexValidity against Verdict, and what it says about bad meshes.
#include "TestEvents.h"

#include "HexSweepArrays.h"

#include <vtkHexValidity.h>

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCellTypeSource.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkHexahedron.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkMeshQuality.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace TestHexValidity
{
using Corners = std::array<std::array<double, 3>, 8>;

constexpr Corners Cube = { { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } } };

void addHex(vtkUnstructuredGrid* grid, const Corners& corners)
{
  std::array<vtkIdType, 8> ids;
  for (std::size_t i = 0; i < 8; ++i)
  {
    ids[i] = grid->GetPoints()->InsertNextPoint(corners[i].data());
  }
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids.data());
}

vtkSmartPointer<vtkUnstructuredGrid> emptyGrid()
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  grid->SetPoints(points);
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> gridOf(std::initializer_list<Corners> hexes)
{
  auto grid = emptyGrid();
  for (const Corners& hex : hexes)
  {
    addHex(grid, hex);
  }
  return grid;
}

Corners pulled(Corners corners, double at)
{
  corners[6] = { at, at, at };
  return corners;
}

Corners swapped(const Corners& c)
{
  return { { c[4], c[5], c[6], c[7], c[0], c[1], c[2], c[3] } };
}

/// Cubes whose corners have been shaken: some stay valid, many do not.
vtkSmartPointer<vtkUnstructuredGrid> shakenCubes(int count, double amplitude)
{
  auto grid = emptyGrid();
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> shake(-amplitude, amplitude);
  for (int i = 0; i < count; ++i)
  {
    Corners corners = Cube;
    for (auto& corner : corners)
    {
      for (double& coordinate : corner)
      {
        coordinate += shake(generator);
      }
    }
    addHex(grid, corners);
  }
  return grid;
}

struct Judgement
{
  vtkNew<vtkHexValidity> filter;
  test::Events events;

  explicit Judgement(vtkDataSet* input, bool failIfInvalid = false)
    : events(filter)
  {
    this->filter->SetInputData(input);
    this->filter->SetFailIfInvalid(failIfInvalid);
    this->filter->Update();
  }

  vtkDataSet* output() { return this->filter->GetOutput(); }
  double scaledJacobian(vtkIdType cell)
  {
    return this->output()
      ->GetCellData()
      ->GetArray(hexsweep::arrays::ScaledJacobian)
      ->GetTuple1(cell);
  }
  double lowerBound(vtkIdType cell)
  {
    return this->output()
      ->GetCellData()
      ->GetArray(hexsweep::arrays::JacobianLowerBound)
      ->GetTuple1(cell);
  }
  int validity(vtkIdType cell)
  {
    return static_cast<int>(
      this->output()->GetCellData()->GetArray(hexsweep::arrays::Validity)->GetTuple1(cell));
  }
  double report(const std::string& name)
  {
    return this->output()
      ->GetFieldData()
      ->GetArray((hexsweep::reports::Prefix + name).c_str())
      ->GetTuple1(0);
  }
};

TEST(HexValidity, EqualsVerdictOnShakenCubes)
{
  const auto grid = shakenCubes(20000, 0.6);
  Judgement run(grid);
  vtkIdType inverted = 0;
  vtkIdType certified = 0;
  vtkIdType inside = 0;
  vtkIdType missed = 0;
  double leastBound = 1.0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const double verdict = vtkMeshQuality::HexScaledJacobian(grid->GetCell(cell));
    ASSERT_NEAR(run.scaledJacobian(cell), verdict, 1e-12) << "cell " << cell;
    const int validity = run.validity(cell);
    // What Verdict finds inverted is; what it finds valid need not be, between its nine points.
    ASSERT_TRUE(validity == vtkHexValidity::CERTIFIED ||
      validity == vtkHexValidity::INVERTED_CORNER || validity == vtkHexValidity::INVERTED_INSIDE);
    ASSERT_TRUE(verdict > 0.0 || validity != vtkHexValidity::CERTIFIED) << "cell " << cell;
    ASSERT_TRUE(verdict <= 0.0 || validity != vtkHexValidity::INVERTED_CORNER) << "cell " << cell;
    inverted += validity != vtkHexValidity::CERTIFIED;
    certified += validity == vtkHexValidity::CERTIFIED;
    inside += validity == vtkHexValidity::INVERTED_INSIDE;
    missed += verdict > 0.0 && validity == vtkHexValidity::INVERTED_INSIDE;
    leastBound = std::min(leastBound, run.lowerBound(cell));
  }
  ASSERT_GT(inverted, 1000);
  ASSERT_GT(certified, 1000);
  EXPECT_GT(missed, 10);
  EXPECT_EQ(run.report("Hexes"), grid->GetNumberOfCells());
  EXPECT_EQ(run.report("Inverted"), inverted);
  EXPECT_EQ(run.report("InvertedInside"), inside);
  EXPECT_EQ(run.report("Undecided"), 0);
  EXPECT_EQ(run.report("NotCertified"), inverted);
  EXPECT_EQ(run.report("MinJacobianLowerBound"), leastBound);
  EXPECT_EQ(run.events.errors.size(), 0u);
  EXPECT_EQ(run.events.warnings.size(), 1u);
}

TEST(HexValidity, ThreadsDoNotChangeABit)
{
  const auto grid = shakenCubes(70000, 0.3);
  vtkSMPTools::Initialize(1);
  Judgement one(grid);
  vtkSMPTools::Initialize(4);
  Judgement four(grid);
  vtkSMPTools::Initialize(0);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    ASSERT_EQ(one.scaledJacobian(cell), four.scaledJacobian(cell));
    ASSERT_EQ(one.lowerBound(cell), four.lowerBound(cell));
    ASSERT_EQ(one.validity(cell), four.validity(cell));
  }
  EXPECT_EQ(one.report("MeanScaledJacobian"), four.report("MeanScaledJacobian"));
}

TEST(HexValidity, WarningCountsAndNamesTheFirstTen)
{
  auto grid = gridOf({ Cube });
  for (int i = 0; i < 12; ++i)
  {
    addHex(grid, pulled(Cube, 0.5));
  }
  Judgement run(grid);
  ASSERT_EQ(run.events.warnings.size(), 1u);
  const std::string& text = run.events.warnings.front();
  EXPECT_NE(text.find("12 of 13 hexahedra are inverted"), std::string::npos) << text;
  EXPECT_NE(text.find("cell 1 at (0.4375, 0.4375, 0.4375)"), std::string::npos) << text;
  EXPECT_NE(text.find("cell 10 at"), std::string::npos) << text;
  EXPECT_EQ(text.find("cell 11 at"), std::string::npos) << text;
  EXPECT_EQ(run.validity(0), vtkHexValidity::CERTIFIED);
  EXPECT_EQ(run.validity(1), vtkHexValidity::INVERTED_CORNER);
  EXPECT_EQ(run.report("NotCertified"), 12);
  EXPECT_EQ(run.output()->GetNumberOfCells(), 13);
}

TEST(HexValidity, FailIfInvalidGivesAnErrorAndNothingElse)
{
  Judgement run(gridOf({ Cube, pulled(Cube, 0.5) }), true);
  ASSERT_EQ(run.events.errors.size(), 1u);
  EXPECT_NE(run.events.errors.front().find("1 of 2 hexahedra"), std::string::npos);
  EXPECT_EQ(run.output()->GetNumberOfCells(), 0);

  Judgement valid(gridOf({ Cube, Cube }), true);
  EXPECT_EQ(valid.events.errors.size(), 0u);
  EXPECT_EQ(valid.output()->GetNumberOfCells(), 2);
}

TEST(HexValidity, InsideOutMeshIsNamedAsSuch)
{
  Judgement run(gridOf({ swapped(Cube), swapped(Cube) }));
  ASSERT_EQ(run.events.warnings.size(), 1u);
  EXPECT_NE(run.events.warnings.front().find("inside out"), std::string::npos);
  EXPECT_EQ(run.report("Inverted"), 2);
  EXPECT_DOUBLE_EQ(run.report("MinScaledJacobian"), -1.0);
}

TEST(HexValidity, DegenerateHexIsNotPerfectAsInVerdict)
{
  Corners collapsed = Cube;
  collapsed[1] = collapsed[0];
  Corners lost = Cube;
  lost[2][1] = std::numeric_limits<double>::quiet_NaN();
  auto grid = gridOf({ collapsed, lost, Cube });
  ASSERT_GT(vtkMeshQuality::HexScaledJacobian(grid->GetCell(0)), 1.0); // the trap
  Judgement run(grid);
  EXPECT_EQ(run.validity(0), vtkHexValidity::DEGENERATE);
  EXPECT_EQ(run.validity(1), vtkHexValidity::DEGENERATE);
  EXPECT_EQ(run.validity(2), vtkHexValidity::CERTIFIED);
  EXPECT_LE(run.scaledJacobian(0), 0.0);
  EXPECT_TRUE(std::isnan(run.scaledJacobian(1)));
  EXPECT_EQ(run.report("Degenerate"), 2);
  ASSERT_EQ(run.events.warnings.size(), 1u);
  EXPECT_NE(run.events.warnings.front().find("2 are degenerate"), std::string::npos);
}

TEST(HexValidity, VoxelsAreJudgedAndTheOutputHasTheInputsType)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 3, 2);
  image->SetSpacing(1, 2, 3);
  Judgement run(image);
  ASSERT_TRUE(vtkImageData::SafeDownCast(run.output()));
  EXPECT_EQ(run.report("Hexes"), 6);
  EXPECT_EQ(run.report("Inverted"), 0);
  EXPECT_DOUBLE_EQ(run.report("MinScaledJacobian"), 1.0);
  EXPECT_EQ(run.validity(5), vtkHexValidity::CERTIFIED);
  EXPECT_NEAR(run.lowerBound(5), 6.0, 1e-11);
}

TEST(HexValidity, OtherCellsPassThrough)
{
  vtkNew<vtkCellTypeSource> wedges;
  wedges->SetCellType(VTK_WEDGE);
  wedges->SetBlocksDimensions(1, 1, 1);
  wedges->Update();
  vtkNew<vtkUnstructuredGrid> grid;
  grid->DeepCopy(wedges->GetOutput());
  const vtkIdType numberOfWedges = grid->GetNumberOfCells();
  addHex(grid, Cube);
  Judgement run(grid);
  EXPECT_EQ(run.validity(0), vtkHexValidity::NOT_JUDGED);
  EXPECT_TRUE(std::isnan(run.scaledJacobian(0)));
  EXPECT_EQ(run.validity(numberOfWedges), vtkHexValidity::CERTIFIED);
  EXPECT_EQ(run.report("Hexes"), 1);
  EXPECT_EQ(run.events.warnings.size(), 0u);

  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  Judgement surface(sphere->GetOutput());
  ASSERT_TRUE(vtkPolyData::SafeDownCast(surface.output()));
  EXPECT_EQ(surface.report("Hexes"), 0);
  EXPECT_EQ(surface.events.warnings.size(), 1u);
}

TEST(HexValidity, GhostCellsAreNotReported)
{
  auto grid = gridOf({ Cube, pulled(Cube, 0.5) });
  vtkUnsignedCharArray* ghosts = grid->AllocateCellGhostArray();
  ghosts->SetValue(1, vtkDataSetAttributes::DUPLICATECELL);
  Judgement run(grid);
  EXPECT_EQ(run.report("Hexes"), 1);
  EXPECT_EQ(run.report("Inverted"), 0);
  EXPECT_EQ(run.validity(1), vtkHexValidity::INVERTED_CORNER);
  EXPECT_EQ(run.events.warnings.size(), 0u);
}

TEST(HexValidity, EmptyInputIsOneError)
{
  Judgement run(emptyGrid());
  ASSERT_EQ(run.events.errors.size(), 1u);
  EXPECT_NE(run.events.errors.front().find("no cells"), std::string::npos);
  EXPECT_EQ(run.output()->GetNumberOfCells(), 0);
}

TEST(HexValidity, MissingInputIsOneError)
{
  vtkNew<vtkHexValidity> filter;
  test::Events events(filter);
  filter->Update();
  EXPECT_EQ(events.executiveErrors.size(), 1u);
}

TEST(HexValidity, PointAndCellDataAreKept)
{
  vtkNew<vtkCellTypeSource> block;
  block->SetCellType(VTK_HEXAHEDRON);
  block->SetBlocksDimensions(2, 1, 1);
  block->Update();
  Judgement run(block->GetOutput());
  EXPECT_EQ(run.output()->GetCellData()->GetNumberOfArrays(),
    block->GetOutput()->GetCellData()->GetNumberOfArrays() + 3);
  EXPECT_EQ(run.output()->GetPointData()->GetNumberOfArrays(),
    block->GetOutput()->GetPointData()->GetNumberOfArrays());
}

TEST(HexValidity, InvertedBetweenItsCornersIsNamedAsSuch)
{
  // A flat rectangle below, a tall one turned by 180 degrees above: every corner is positive.
  const Corners twisted = { { { -2, -0.05, 0 }, { 2, -0.05, 0 }, { 2, 0.05, 0 }, { -2, 0.05, 0 },
    { 0.5, 1, 1 }, { -0.5, 1, 1 }, { -0.5, -1, 1 }, { 0.5, -1, 1 } } };
  Judgement run(gridOf({ Cube, twisted }));
  EXPECT_EQ(run.validity(1), vtkHexValidity::INVERTED_INSIDE);
  EXPECT_LT(run.lowerBound(1), 0.0);
  ASSERT_EQ(run.events.warnings.size(), 1u);
  EXPECT_NE(run.events.warnings.front().find("inverted between its corners"), std::string::npos);
}

TEST(HexValidity, UndecidedHexesRaiseAWarning)
{
  // The section shrinks to a point a third of the way up and turns inside out and back: its
  // Jacobian is the square of that, never negative, and zero where no bisection comes.
  Corners touching = { { { -1, -1, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 }, { 2, 2, 1 },
    { -2, 2, 1 }, { -2, -2, 1 }, { 2, -2, 1 } } };
  Judgement run(gridOf({ Cube, touching }));
  EXPECT_EQ(run.validity(1), vtkHexValidity::UNDECIDED);
  EXPECT_EQ(run.report("Undecided"), 1);
  EXPECT_EQ(run.report("NotCertified"), 1);
  EXPECT_EQ(run.report("Inverted"), 0);
  ASSERT_EQ(run.events.warnings.size(), 1u);
  EXPECT_NE(run.events.warnings.front().find("1 of 2 hexahedra are undecided"), std::string::npos);
  EXPECT_NE(run.events.warnings.front().find("cell 1 at"), std::string::npos);
}

TEST(HexValidity, EveryKindOfDataSetGivesTheSame)
{
  // The same block as image, structured grid and unstructured grids with single and double
  // precision, 32-bit ids and voxels.
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 3, 3);
  image->SetSpacing(0.5, 0.25, 2.0);
  vtkNew<vtkStructuredGrid> structured;
  structured->SetDimensions(4, 3, 3);
  vtkNew<vtkPoints> doubles;
  doubles->SetDataTypeToDouble();
  vtkNew<vtkPoints> floats;
  floats->SetDataTypeToFloat();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    doubles->InsertNextPoint(image->GetPoint(i));
    floats->InsertNextPoint(image->GetPoint(i));
  }
  structured->SetPoints(floats);
  const auto unstructured = [&](vtkPoints* points, bool wideIds) {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetPoints(points);
    vtkNew<vtkCellArray> cells;
    if (wideIds)
    {
      cells->Use64BitStorage();
    }
    else
    {
      cells->Use32BitStorage();
    }
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < structured->GetNumberOfCells(); ++cell)
    {
      structured->GetCellPoints(cell, ids);
      cells->InsertNextCell(ids);
    }
    grid->SetCells(VTK_HEXAHEDRON, cells);
    return grid;
  };
  const auto wide = unstructured(doubles, true);
  const auto narrow = unstructured(floats, false);
  for (vtkDataSet* data : { static_cast<vtkDataSet*>(image), static_cast<vtkDataSet*>(structured),
         static_cast<vtkDataSet*>(wide), static_cast<vtkDataSet*>(narrow) })
  {
    Judgement run(data);
    EXPECT_EQ(run.report("Hexes"), 12) << data->GetClassName();
    EXPECT_EQ(run.report("NotCertified"), 0) << data->GetClassName();
    EXPECT_EQ(run.report("MinScaledJacobian"), 1.0) << data->GetClassName();
    EXPECT_NEAR(run.report("MinJacobianLowerBound"), 0.25, 1e-12) << data->GetClassName();
    EXPECT_EQ(run.events.warnings.size(), 0u);
  }
}

TEST(HexValidity, ProgressMovesAndAnAbortEmptiesTheOutput)
{
  const auto grid = shakenCubes(200000, 0.2);
  vtkNew<vtkHexValidity> filter;
  test::Events events(filter);
  filter->SetInputData(grid);
  std::vector<double> progress;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&progress);
  observer->SetCallback([](vtkObject* caller, unsigned long, void* client, void*) {
    static_cast<std::vector<double>*>(client)->push_back(
      vtkAlgorithm::SafeDownCast(caller)->GetProgress());
  });
  filter->AddObserver(vtkCommand::ProgressEvent, observer);
  filter->Update();
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_GE(std::set<double>(progress.begin(), progress.end()).size(), 4u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 200000);

  observer->SetCallback([](vtkObject* caller, unsigned long, void*, void*) {
    vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
  });
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(events.errors.size(), 0u);
}
}
