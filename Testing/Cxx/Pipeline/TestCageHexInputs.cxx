// SPDX-License-Identifier: BSD-3-Clause
// vtkCageHexInterior: cells of any orientation, kind and precision mean the same cage.
#include "CageHexCase.h"

#include "HexSweepArrays.h"

#include <vtkIntArray.h>

namespace TestCageHexInputs
{
using hexsweep::Index;
using hexsweep::Points;
using hexsweep::Quads;
using test::countInverted;
using test::gridOf;
using test::pointsOf;
using test::someSweep;
using test::Sweep;
using Case = test::CageHexCase;

TEST(CageHexInterior, BothOrientationsOfTheSourceGiveRightHandedHexes)
{
  for (const bool turned : { false, true })
  {
    Sweep sweep = someSweep();
    if (turned)
    {
      sweep.quads = sweep.quads.rowwise().reverse().eval();
    }
    Case input(sweep);
    vtkUnstructuredGrid* output = input.run();
    ASSERT_EQ(output->GetNumberOfCells(), 5 * sweep.quads.rows());
    EXPECT_EQ(countInverted(output), 0);
    EXPECT_EQ(input.report("Inverted"), 0);
    EXPECT_EQ(input.events.errors.size() + input.events.warnings.size(), 0u);
  }
}

/// The same quads, each beginning elsewhere, every second one turned over.
Quads disordered(const Quads& quads)
{
  Quads result = quads;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (int c = 0; c < 4; ++c)
    {
      result(q, c) = quads(q, (q + (q % 2 ? 1 : 3) * c) % 4);
    }
  }
  return result;
}

TEST(CageHexInterior, OrientationOfTargetAndLinkingCellsDoesNotMatter)
{
  const Sweep sweep = someSweep();
  Case plain(sweep);
  Sweep other = sweep;
  test::cutLinkingSides(other);
  test::disorderLinkingSides(other);
  Case mixed(other);
  mixed.target = gridOf(sweep.target, disordered(sweep.quads));
  vtkUnstructuredGrid* a = plain.run();
  vtkUnstructuredGrid* b = mixed.run();
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_EQ(a->GetPoint(i)[c], b->GetPoint(i)[c]);
    }
  }
  EXPECT_EQ(mixed.events.errors.size() + mixed.events.warnings.size(), 0u);
}

TEST(CageHexInterior, PolyDataGivesTheSameMesh)
{
  const Sweep sweep = someSweep();
  Case grid(sweep);
  Case poly(sweep);
  poly.source = gridOf<vtkPolyData>(sweep.source, sweep.quads);
  poly.target = gridOf<vtkPolyData>(sweep.target, sweep.quads);
  poly.linking = gridOf<vtkPolyData>(sweep.linkingPoints, sweep.linkingQuads);
  vtkUnstructuredGrid* a = grid.run();
  vtkUnstructuredGrid* b = poly.run();
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_EQ(a->GetPoint(i)[c], b->GetPoint(i)[c]);
    }
  }
}

TEST(CageHexInterior, VertexAndLineCellsAreIgnored)
{
  const Sweep sweep = someSweep();
  Case input(sweep);
  auto mixed = vtkSmartPointer<vtkUnstructuredGrid>::New();
  mixed->SetPoints(pointsOf(sweep.source));
  const vtkIdType line[2] = { 0, 1 };
  mixed->InsertNextCell(VTK_VERTEX, 1, line);
  mixed->InsertNextCell(VTK_LINE, 2, line);
  vtkNew<vtkIntArray> number;
  number->SetName("Number");
  number->InsertNextValue(-1);
  number->InsertNextValue(-1);
  for (Index q = 0; q < sweep.quads.rows(); ++q)
  {
    const vtkIdType ids[4] = { sweep.quads(q, 0), sweep.quads(q, 1), sweep.quads(q, 2),
      sweep.quads(q, 3) };
    mixed->InsertNextCell(VTK_QUAD, 4, ids);
    number->InsertNextValue(static_cast<int>(q));
  }
  mixed->GetCellData()->AddArray(number);
  input.source = mixed;
  vtkUnstructuredGrid* output = input.run();
  const Index m = sweep.quads.rows();
  ASSERT_EQ(output->GetNumberOfCells(), 5 * m);
  // Ids are those of the input, where the quads begin at 2.
  EXPECT_EQ(output->GetCellData()->GetArray(hexsweep::arrays::SourceCellIds)->GetTuple1(m + 3), 5);
  EXPECT_EQ(output->GetCellData()->GetArray("Number")->GetTuple1(m + 3), 3);
}

TEST(CageHexInterior, PointsOfNoQuadKeepTheirPlace)
{
  Sweep sweep = someSweep();
  const Index n = sweep.source.rows();
  for (Points* points : { &sweep.source, &sweep.target })
  {
    points->conservativeResize(n + 1, 3);
    points->row(n) << 1, 2, points == &sweep.source ? 3 : 8;
  }
  Case input(sweep);
  vtkUnstructuredGrid* output = input.run();
  ASSERT_EQ(output->GetNumberOfPoints(), 6 * (n + 1));
  EXPECT_EQ(countInverted(output), 0);
  double before = 2.0;
  for (Index k = 0; k <= 5; ++k)
  {
    const double z = output->GetPoint(k * (n + 1) + n)[2];
    EXPECT_GT(z, before);
    before = z;
  }
  EXPECT_EQ(before, 8.0);
}

TEST(CageHexInterior, SingleAndDoublePrecisionInputsFitTogether)
{
  // As when one of the files was written in single precision.
  const Sweep sweep = someSweep();
  Case input(sweep);
  vtkNew<vtkPoints> rounded;
  rounded->SetDataTypeToFloat();
  rounded->DeepCopy(input.linking->GetPoints());
  ASSERT_EQ(rounded->GetDataType(), VTK_FLOAT);
  input.linking->SetPoints(rounded);
  vtkUnstructuredGrid* output = input.run();
  EXPECT_EQ(input.events.errors.size() + input.events.warnings.size(), 0u);
  EXPECT_EQ(countInverted(output), 0);
}

TEST(CageHexInterior, EmptyPieceOfAnotherRankIsSilent)
{
  Case input(someSweep());
  input.source = input.target = input.linking = vtkSmartPointer<vtkUnstructuredGrid>::New();
  input.filter->SetSourceQuadsData(input.source);
  input.filter->SetTargetQuadsData(input.target);
  input.filter->SetLinkingSidesData(input.linking);
  input.filter->UpdatePiece(1, 2, 0);
  EXPECT_EQ(input.events.errors.size() + input.events.warnings.size(), 0u);
  EXPECT_EQ(input.filter->GetOutput()->GetNumberOfCells(), 0);
}
}
