// SPDX-License-Identifier: BSD-3-Clause
// vtkHarmonicDiskMap: cells of any kind, orientation and precision mean the same cap.
#include "DiskMapping.h"

#include "HexSweepArrays.h"

#include <vtkTriangle.h>

namespace TestDiskMapInputs
{
using test::Corners;
using test::diskPoint;
using test::expectOriginals;
using test::greatestDiskDistance;
using test::Grid;
using test::idOf;
using test::report;
using Map = test::DiskMapping;

TEST(HarmonicDiskMap, VertexAndLineCellsAreIgnoredAndCounted)
{
  const Grid plain = test::readGrid("ubend/target_surface");
  const Grid mixed = test::withVerticesAndLines(plain);
  Map map(mixed);
  vtkUnstructuredGrid* output = map.run();
  EXPECT_EQ(report(output, hexsweep::reports::IgnoredCells), 3);
  expectOriginals(output, mixed);
  Map reference(plain);
  EXPECT_EQ(greatestDiskDistance(output, reference.run()), 0.0);
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    EXPECT_EQ(output->GetCellData()->GetArray("Number")->GetTuple1(c),
      static_cast<double>(idOf(output->GetCellData(), hexsweep::arrays::OriginalCellIds, c)));
  }
}

TEST(HarmonicDiskMap, PolyDataGivesTheSameMap)
{
  const Grid grid = test::readGrid("taper10/target_surface");
  Map fromGrid(grid);
  Map fromPolyData(test::polyData(grid));
  test::expectSameBits(fromGrid.run(), fromPolyData.run());
}

TEST(HarmonicDiskMap, StripsQuadsAndPolygons)
{
  // One plane plate as triangle strips, as quads, as hexagons with corners of 180 degrees.
  const int n = 6;
  std::vector<std::array<double, 3>> points;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      points.push_back({ 1.0 * i, 1.5 * j, 0.0 });
    }
  }
  const auto at = [](int i, int j) { return static_cast<vtkIdType>(j * (n + 1) + i); };
  vtkNew<vtkCellArray> strips;
  std::vector<Corners> triangles;
  std::vector<Corners> quads;
  std::vector<Corners> hexagons;
  for (int j = 0; j < n; ++j)
  {
    Corners strip;
    for (int i = 0; i <= n; ++i)
    {
      strip.push_back(at(i, j + 1));
      strip.push_back(at(i, j));
    }
    strips->InsertNextCell(static_cast<vtkIdType>(strip.size()), strip.data());
    for (int i = 0; i < n; ++i)
    {
      triangles.push_back({ at(i, j + 1), at(i, j), at(i + 1, j + 1) });
      triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      quads.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
      if (i % 2 == 0)
      {
        hexagons.push_back({ at(i, j), at(i + 1, j), at(i + 2, j), at(i + 2, j + 1),
          at(i + 1, j + 1), at(i, j + 1) });
      }
    }
  }
  Map reference(test::gridOf(points, triangles, VTK_TRIANGLE));
  vtkUnstructuredGrid* expected = reference.run();

  vtkNew<vtkPolyData> stripData;
  stripData->SetPoints(test::gridOf(points, quads, VTK_QUAD)->GetPoints());
  stripData->SetStrips(strips);
  Map fromStrips(stripData);
  vtkUnstructuredGrid* output = fromStrips.run();
  EXPECT_LT(greatestDiskDistance(output, expected), 1e-14);
  EXPECT_EQ(output->GetNumberOfCells(), expected->GetNumberOfCells());
  EXPECT_EQ(
    idOf(output->GetCellData(), hexsweep::arrays::OriginalCellIds, output->GetNumberOfCells() - 1),
    n - 1);

  Map fromQuads(test::gridOf(points, quads, VTK_QUAD));
  EXPECT_EQ(fromQuads.run()->GetNumberOfCells(), expected->GetNumberOfCells());
  expectOriginals(fromQuads.run(), test::gridOf(points, quads, VTK_QUAD));

  const Grid polygons = test::gridOf(points, hexagons, VTK_POLYGON);
  Map fromPolygons(polygons);
  output = fromPolygons.run();
  double area = 0.0;
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    const Corners t = test::cornersOf(output, c);
    area += vtkTriangle::TriangleArea(test::pointOf(output, t[0]).data(),
      test::pointOf(output, t[1]).data(), test::pointOf(output, t[2]).data());
  }
  EXPECT_NEAR(area, 1.5 * n * n, 1e-12);
  EXPECT_EQ(report(output, hexsweep::reports::FlipsAfter), 0);
}

TEST(HarmonicDiskMap, OneConcavePolygonIsACap)
{
  // An L with nodes in the middle of its edges, its points not the first of the data set.
  const std::vector<std::array<double, 3>> points{ { 9, 9, 9 }, { 8, 8, 8 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 2, 0, 1 }, { 2, 1, 1 }, { 1, 1, 1 }, { 1, 2, 1 }, { 0, 2, 1 }, { 0, 1, 1 } };
  const Grid input = test::gridOf(points, { { 2, 3, 4, 5, 6, 7, 8, 9 } }, VTK_POLYGON);
  Map map(input);
  vtkUnstructuredGrid* output = map.run();
  double area = 0.0;
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    const Corners t = test::cornersOf(output, c);
    area += vtkTriangle::TriangleArea(test::pointOf(output, t[0]).data(),
      test::pointOf(output, t[1]).data(), test::pointOf(output, t[2]).data());
    EXPECT_EQ(idOf(output->GetCellData(), hexsweep::arrays::OriginalCellIds, c), 0);
  }
  EXPECT_NEAR(area, 3.0, 1e-14);
  EXPECT_EQ(report(output, hexsweep::reports::FlipsAfter), 0);
  EXPECT_EQ(test::boundaryOf(output).size(), 8u);
}

TEST(HarmonicDiskMap, AnyOrientationOfTheCells)
{
  const test::SweepGrids sweep = test::readCase("taper10");
  Map plain(sweep.sourceSurface, sweep.targetSurface, sweep.linkingSides);
  Map turned(test::turnedOver(sweep.sourceSurface), test::anyOrientation(sweep.targetSurface, 2),
    test::anyOrientation(sweep.linkingSides, 3));
  EXPECT_LT(greatestDiskDistance(plain.run(), turned.run()), 1e-11);
  Map alone(test::anyOrientation(sweep.sourceSurface, 4));
  EXPECT_EQ(report(alone.run(), hexsweep::reports::FlipsAfter), 0);
}

TEST(HarmonicDiskMap, SinglePrecisionFilesWork)
{
  for (const char* name : { "ubend", "taper10" })
  {
    const test::SweepGrids sweep = test::readCase(name);
    Map plain(sweep.sourceSurface, sweep.targetSurface, sweep.linkingSides);
    Map rounded(test::singlePrecision(sweep.sourceSurface),
      test::singlePrecision(sweep.targetSurface), test::singlePrecision(sweep.linkingSides));
    vtkUnstructuredGrid* output = rounded.run();
    EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
    EXPECT_LT(greatestDiskDistance(plain.run(), output), 1e-4) << name;
  }
}

TEST(HarmonicDiskMap, NoPointIsLookedAtThatNoCellUses)
{
  Grid input = test::readGrid("ubend/target_surface");
  Map plain(input);
  vtkUnstructuredGrid* expected = plain.run();
  Grid more = Grid::New();
  more->DeepCopy(input);
  const double bad[3] = { std::nan(""), 1e300, 0.0 };
  more->GetPoints()->InsertNextPoint(bad);
  Map map(more);
  vtkUnstructuredGrid* output = map.run();
  EXPECT_EQ(output->GetNumberOfPoints(), expected->GetNumberOfPoints() + 1);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(diskPoint(output, i), diskPoint(expected, i));
  }
}
}
