// SPDX-License-Identifier: BSD-3-Clause
// vtkSweepQuadProjector: cells of any order, orientation, kind and precision mean the same sweep.
#include "QuadProjection.h"

#include "HexSweepArrays.h"

namespace TestQuadProjectorInputs
{
using test::Corners;
using test::Grid;
using test::report;
using test::SweepGrids;
using Projection = test::QuadProjection;

TEST(SweepQuadProjector, WithoutSourceSurfaceTheQuadsAreTheirOwn)
{
  for (const char* name : { "ubend", "taper10", "twist270_L" })
  {
    SweepGrids sweep = test::readCase(name);
    Projection full(sweep);
    sweep.sourceSurface = nullptr;
    Projection own(sweep);
    vtkUnstructuredGrid* output = own.raw().run();
    EXPECT_EQ(report(output, hexsweep::reports::InvertedQuads), 0) << name;
    EXPECT_LT(test::greatestDistance(output, full.raw().run()), 0.1 * test::sizeOf(output)) << name;
    // Two triangles a quad, which know their quad.
    auto* source = vtkUnstructuredGrid::SafeDownCast(own.filter->GetOutputDataObject(1));
    vtkDataArray* ids = source->GetCellData()->GetArray(hexsweep::arrays::OriginalCellIds);
    ASSERT_NE(ids, nullptr);
    double range[2];
    ids->GetRange(range);
    EXPECT_EQ(range[0], 0.0);
    EXPECT_EQ(range[1], static_cast<double>(sweep.sourceQuads->GetNumberOfCells() - 1));
  }
}

TEST(SweepQuadProjector, EitherOrientationOfTheSourceQuads)
{
  for (const bool surface : { true, false })
  {
    for (const char* name : { "ubend", "taper10" })
    {
      SweepGrids sweep = test::readCase(name);
      if (!surface)
      {
        sweep.sourceSurface = nullptr;
      }
      Projection plain(sweep);
      sweep.sourceQuads = test::turnedOver(sweep.sourceQuads);
      Projection turned(sweep);
      vtkUnstructuredGrid* output = turned.raw().run();
      EXPECT_LT(test::greatestDistance(plain.raw().run(), output), 1e-12 * test::sizeOf(output));
      EXPECT_EQ(report(output, hexsweep::reports::InvertedQuads), 0);
      for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
      {
        ASSERT_EQ(test::cornersOf(output, c), test::cornersOf(sweep.sourceQuads, c));
      }
    }
  }
}

TEST(SweepQuadProjector, AnyOrderAndOrientationOfTargetAndLinkingCells)
{
  for (const char* name : { "ubend", "taper10" })
  {
    const SweepGrids sweep = test::readCase(name);
    Projection plain(sweep);
    for (unsigned seed = 1; seed <= 3; ++seed)
    {
      SweepGrids disordered = sweep;
      disordered.targetSurface =
        test::anyOrientation(test::shuffledCells(sweep.targetSurface, seed), seed + 10);
      disordered.sourceSurface =
        test::anyOrientation(test::shuffledCells(sweep.sourceSurface, seed), seed + 20);
      disordered.linkingSides =
        test::anyOrientation(test::shuffledCells(sweep.linkingSides, seed), seed + 30);
      Projection other(disordered);
      vtkUnstructuredGrid* output = other.raw().run();
      EXPECT_LT(test::greatestDistance(plain.raw().run(), output), 1e-11 * test::sizeOf(output))
        << name;
      EXPECT_EQ(report(output, hexsweep::reports::InvertedQuads), 0);
    }
  }
}

TEST(SweepQuadProjector, VerticesAndLinesAreIgnored)
{
  const SweepGrids sweep = test::readCase("ubend");
  Projection plain(sweep);
  const SweepGrids mixed{ test::withVerticesAndLines(sweep.sourceQuads),
    test::withVerticesAndLines(sweep.sourceSurface),
    test::withVerticesAndLines(sweep.targetSurface),
    test::withVerticesAndLines(sweep.linkingSides) };
  Projection other(mixed);
  vtkUnstructuredGrid* output = other.run();
  EXPECT_EQ(test::greatestDistance(plain.run(), output), 0.0);
  ASSERT_EQ(output->GetNumberOfCells(), sweep.sourceQuads->GetNumberOfCells());
  // Cell data of the quads: the vertex came first, a line after the first quad.
  EXPECT_EQ(output->GetCellData()->GetArray("Number")->GetTuple1(0), 1.0);
  EXPECT_EQ(output->GetCellData()->GetArray("Number")->GetTuple1(1), 3.0);
}

TEST(SweepQuadProjector, PolyDataGivesTheSamePoints)
{
  const SweepGrids sweep = test::readCase("taper10");
  Projection plain(sweep);
  vtkNew<vtkSweepQuadProjector> filter;
  filter->SetInputData(0, test::polyData(sweep.sourceQuads));
  filter->SetInputData(1, test::polyData(sweep.targetSurface));
  filter->SetInputData(2, test::polyData(sweep.linkingSides));
  filter->SetInputData(3, test::polyData(sweep.sourceSurface));
  filter->Update();
  test::expectSameBits(plain.run(), filter->GetOutput());
}

TEST(SweepQuadProjector, QuadsStoredAsPolygonsAndPixels)
{
  const SweepGrids sweep = test::readCase("ubend");
  Projection plain(sweep);
  for (const int type : { VTK_POLYGON, VTK_PIXEL })
  {
    SweepGrids other = sweep;
    std::vector<std::array<double, 3>> points;
    for (vtkIdType i = 0; i < sweep.sourceQuads->GetNumberOfPoints(); ++i)
    {
      points.push_back(test::pointOf(sweep.sourceQuads, i));
    }
    std::vector<Corners> cells;
    for (vtkIdType c = 0; c < sweep.sourceQuads->GetNumberOfCells(); ++c)
    {
      cells.push_back(test::cornersOf(sweep.sourceQuads, c));
      if (type == VTK_PIXEL)
      {
        std::swap(cells.back()[2], cells.back()[3]);
      }
    }
    other.sourceQuads = test::gridOf(points, cells, type);
    Projection projection(other);
    vtkUnstructuredGrid* output = projection.run();
    EXPECT_EQ(test::greatestDistance(plain.run(), output), 0.0);
    EXPECT_EQ(test::cornersOf(output, 5), test::cornersOf(sweep.sourceQuads, 5));
  }
}

TEST(SweepQuadProjector, SinglePrecisionFilesWork)
{
  for (const char* name : { "ubend", "taper10" })
  {
    const SweepGrids sweep = test::readCase(name);
    Projection plain(sweep);
    Projection rounded(
      { test::singlePrecision(sweep.sourceQuads), test::singlePrecision(sweep.sourceSurface),
        test::singlePrecision(sweep.targetSurface), test::singlePrecision(sweep.linkingSides) });
    vtkUnstructuredGrid* output = rounded.raw().run();
    EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
    EXPECT_EQ(report(output, hexsweep::reports::InvertedQuads), 0);
    // Rounding of coordinates, 1e-7, over edges of a fiftieth of the size.
    EXPECT_LT(test::greatestDistance(plain.raw().run(), output), 1e-4 * test::sizeOf(output))
      << name;
    rounded.filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
    EXPECT_EQ(rounded.run()->GetPoints()->GetDataType(), VTK_FLOAT);
  }
}

/// A point that no cell uses, and that is no place, before all others.
Grid withUnusedPoint(vtkUnstructuredGrid* grid)
{
  std::vector<std::array<double, 3>> points{ { 1e5, std::nan(""), 3.0 } };
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    points.push_back(test::pointOf(grid, i));
  }
  std::vector<Corners> cells;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    cells.push_back(test::cornersOf(grid, c));
    for (vtkIdType& corner : cells.back())
    {
      ++corner;
    }
  }
  return test::gridOf(points, cells, grid->GetCellType(0));
}

TEST(SweepQuadProjector, UnusedPointsKeepTheirNumber)
{
  const SweepGrids sweep = test::readCase("ubend");
  Projection plain(sweep);
  vtkUnstructuredGrid* expected = nullptr;
  const SweepGrids padded{ withUnusedPoint(sweep.sourceQuads), withUnusedPoint(sweep.sourceSurface),
    withUnusedPoint(sweep.targetSurface), withUnusedPoint(sweep.linkingSides) };
  for (const bool affine : { false, true })
  {
    plain.filter->SetMethod(
      affine ? vtkSweepQuadProjector::AFFINE_LEAST_SQUARES : vtkSweepQuadProjector::HARMONIC);
    expected = plain.run();
    Projection other(padded);
    other.filter->SetMethod(plain.filter->GetMethod());
    vtkUnstructuredGrid* output = other.run();
    ASSERT_EQ(output->GetNumberOfPoints(), expected->GetNumberOfPoints() + 1);
    for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
    {
      EXPECT_EQ(test::pointOf(output, i + 1), test::pointOf(expected, i));
    }
    EXPECT_EQ(report(output, hexsweep::reports::MinScaledJacobian),
      report(expected, hexsweep::reports::MinScaledJacobian));
  }
}
}
