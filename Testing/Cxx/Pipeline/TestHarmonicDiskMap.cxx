// SPDX-License-Identifier: BSD-3-Clause
// vtkHarmonicDiskMap: what it takes, what it carries, what it refuses.
#include "CapGrids.h"

#include "HexSweepArrays.h"

#include <vtkHarmonicDiskMap.h>

#include <vtkCallbackCommand.h>
#include <vtkIdTypeArray.h>
#include <vtkSphereSource.h>
#include <vtkTriangle.h>

#include <algorithm>
#include <sstream>

namespace TestHarmonicDiskMap
{
using test::Corners;
using test::expectOneError;
using test::Grid;
using test::report;
using test::textReport;

struct Map
{
  vtkNew<vtkHarmonicDiskMap> filter;
  test::Events events;

  explicit Map(
    vtkDataObject* input, vtkDataObject* partner = nullptr, vtkDataObject* linking = nullptr)
    : events(filter)
  {
    this->filter->SetInputData(0, input);
    if (partner)
    {
      this->filter->SetInputData(1, partner);
    }
    if (linking)
    {
      this->filter->SetInputData(2, linking);
    }
  }
  vtkUnstructuredGrid* run()
  {
    this->filter->Update();
    EXPECT_TRUE(this->events.errors.empty()) << this->events.errors[0];
    EXPECT_TRUE(this->events.warnings.empty()) << this->events.warnings[0];
    return this->filter->GetOutput();
  }
};

std::array<double, 3> diskPoint(vtkDataSet* output, vtkIdType i)
{
  std::array<double, 3> p;
  output->GetPointData()->GetArray(hexsweep::arrays::DiskCoordinates)->GetTuple(i, p.data());
  return p;
}

double greatestDiskDistance(vtkDataSet* a, vtkDataSet* b)
{
  EXPECT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  double greatest = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    greatest = std::max(greatest, test::distance(diskPoint(a, i), diskPoint(b, i)));
  }
  return greatest;
}

vtkIdType idOf(vtkDataSetAttributes* data, const char* name, vtkIdType i)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(data->GetArray(name));
  EXPECT_NE(ids, nullptr) << name;
  return ids ? ids->GetValue(i) : -2;
}

/// Every triangle is part of the input cell that it names; original points come first.
void expectOriginals(vtkUnstructuredGrid* output, vtkDataSet* input)
{
  ASSERT_GE(output->GetNumberOfPoints(), input->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const bool original = i < input->GetNumberOfPoints();
    EXPECT_EQ(
      idOf(output->GetPointData(), hexsweep::arrays::OriginalPointIds, i), original ? i : -1);
    if (original)
    {
      EXPECT_EQ(test::pointOf(output, i), test::pointOf(input, i));
    }
  }
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    ASSERT_EQ(output->GetCellType(c), VTK_TRIANGLE);
    const vtkIdType origin = idOf(output->GetCellData(), hexsweep::arrays::OriginalCellIds, c);
    ASSERT_GE(origin, 0);
    ASSERT_LT(origin, input->GetNumberOfCells());
    vtkCell* cell = input->GetCell(origin);
    std::array<double, 3> center{ 0, 0, 0 };
    for (const vtkIdType p : test::cornersOf(output, c))
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        center[k] += test::pointOf(output, p)[k] / 3.0;
      }
    }
    double closest[3];
    double parametric[3];
    double weights[32];
    double distance2 = 0.0;
    int subId = 0;
    const int status =
      cell->EvaluatePosition(center.data(), closest, subId, parametric, distance2, weights);
    EXPECT_EQ(status, 1);
    EXPECT_LT(distance2, 1e-20 * input->GetLength() * input->GetLength());
  }
}

Grid moebiusStrip()
{
  std::vector<std::array<double, 3>> points;
  std::vector<Corners> quads;
  const vtkIdType n = 9;
  for (vtkIdType i = 0; i < n; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * static_cast<double>(i) / static_cast<double>(n);
    for (const double side : { -0.3, 0.3 })
    {
      const double r = 1.0 + side * std::cos(angle / 2.0);
      points.push_back({ r * std::cos(angle), r * std::sin(angle), side * std::sin(angle / 2.0) });
    }
    const bool last = i + 1 == n;
    quads.push_back({ 2 * i, last ? 1 : 2 * i + 2, last ? 0 : 2 * i + 3, 2 * i + 1 });
  }
  return test::gridOf(points, quads, VTK_QUAD);
}

TEST(HarmonicDiskMap, OneLoopAlone)
{
  const Grid input = test::readGrid("ubend/target_surface");
  Map map(input);
  vtkUnstructuredGrid* output = map.run();
  expectOriginals(output, input);
  EXPECT_EQ(textReport(output, hexsweep::arrays::DiskMapDomain), "Disk");
  EXPECT_EQ(textReport(output, hexsweep::reports::Method), "Cotangent");
  EXPECT_EQ(report(output, hexsweep::reports::FlipsAfter), 0);
  EXPECT_EQ(report(output, hexsweep::reports::IgnoredCells), 0);
  EXPECT_EQ(
    output->GetFieldData()->GetArray(hexsweep::arrays::HoleCircles)->GetNumberOfTuples(), 0);
  std::set<vtkIdType> rim;
  for (const auto& side : test::boundaryOf(output))
  {
    rim.insert(side.first);
  }
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const auto p = diskPoint(output, i);
    EXPECT_EQ(p[2], 0.0);
    const double r = std::hypot(p[0], p[1]);
    if (rim.count(i))
    {
      EXPECT_NEAR(r, 1.0, 1e-14);
    }
    else
    {
      EXPECT_LT(r, 1.0);
    }
  }
}

TEST(HarmonicDiskMap, TreatmentsAndWeightsOfACapWithAHole)
{
  const Grid input = test::readGrid("taper10/target_surface");
  for (const bool filled : { false, true })
  {
    for (const bool meanValue : { false, true })
    {
      Map map(input);
      filled ? map.filter->SetHoleTreatmentToFilled() : map.filter->SetHoleTreatmentToArcLength();
      meanValue ? map.filter->SetWeightsToMeanValue() : map.filter->SetWeightsToCotangent();
      vtkUnstructuredGrid* output = map.run();
      expectOriginals(output, input);
      EXPECT_EQ(textReport(output, hexsweep::arrays::DiskMapDomain), filled ? "Disk" : "Circles");
      EXPECT_EQ(
        textReport(output, hexsweep::reports::Method), meanValue ? "MeanValue" : "Cotangent");
      EXPECT_EQ(report(output, hexsweep::reports::FlipsAfter), 0);
      vtkDataArray* circles = output->GetFieldData()->GetArray(hexsweep::arrays::HoleCircles);
      ASSERT_EQ(circles->GetNumberOfTuples(), filled ? 0 : 1);
      for (const auto& side : test::boundaryOf(output))
      {
        const auto p = diskPoint(output, side.first);
        const bool onRim = std::abs(std::hypot(p[0], p[1]) - 1.0) < 1e-13;
        if (!filled && !onRim)
        {
          EXPECT_NEAR(
            std::hypot(p[0] - circles->GetComponent(0, 0), p[1] - circles->GetComponent(0, 1)),
            circles->GetComponent(0, 2), 1e-14);
        }
      }
    }
  }
}

TEST(HarmonicDiskMap, WithAPartnerBothCapsShareTheirLoops)
{
  const std::map<std::string, std::string> domains{ { "ubend", "Disk" }, { "taper10", "Annulus" } };
  for (const auto& [name, domain] : domains)
  {
    const test::SweepGrids sweep = test::readCase(name);
    Map one(sweep.sourceSurface, sweep.targetSurface, sweep.linkingSides);
    Map other(sweep.targetSurface, sweep.sourceSurface, sweep.linkingSides);
    vtkUnstructuredGrid* source = one.run();
    vtkUnstructuredGrid* target = other.run();
    expectOriginals(source, sweep.sourceSurface);
    expectOriginals(target, sweep.targetSurface);
    EXPECT_EQ(textReport(source, hexsweep::arrays::DiskMapDomain), domain);
    EXPECT_EQ(textReport(target, hexsweep::arrays::DiskMapDomain), domain);
    const auto sourceRim = test::boundaryOf(source);
    const auto targetRim = test::boundaryOf(target);
    ASSERT_EQ(sourceRim.size(), targetRim.size());
    for (const auto& side : sourceRim)
    {
      double nearest = 1.0;
      for (const auto& opposite : targetRim)
      {
        nearest = std::min(nearest,
          test::distance(diskPoint(source, side.first), diskPoint(target, opposite.first)));
      }
      EXPECT_LT(nearest, 1e-13);
    }
  }
}

TEST(HarmonicDiskMap, ThePartnerOutputIsWhatAFilterOfItsOwnGives)
{
  const std::vector<std::pair<std::string, test::SweepGrids>> sweeps{ { "ubend",
                                                                        test::readCase("ubend") },
    { "taper10", test::readCase("taper10") }, { "three holes", test::plateSweep(3) } };
  for (const auto& [name, sweep] : sweeps)
  {
    SCOPED_TRACE(name);
    for (const bool disk : { false, true })
    {
      Map both(sweep.sourceSurface, sweep.targetSurface, sweep.linkingSides);
      Map other(sweep.targetSurface, sweep.sourceSurface, sweep.linkingSides);
      both.filter->SetOutputDisk(disk);
      other.filter->SetOutputDisk(disk);
      both.run();
      vtkUnstructuredGrid* expected = other.run();
      vtkUnstructuredGrid* partner = both.filter->GetOutput(1);
      ASSERT_GT(partner->GetNumberOfCells(), 0);
      test::expectSameBits(partner, expected);
      EXPECT_EQ(textReport(partner, hexsweep::arrays::DiskMapDomain),
        textReport(expected, hexsweep::arrays::DiskMapDomain));
      if (!disk)
      {
        expectOriginals(partner, sweep.targetSurface);
      }
    }
  }
}

TEST(HarmonicDiskMap, WithoutAPartnerItsOutputIsEmpty)
{
  const test::SweepGrids sweep = test::readCase("taper10");
  Map map(sweep.sourceSurface, sweep.targetSurface, sweep.linkingSides);
  map.run();
  ASSERT_GT(map.filter->GetOutput(1)->GetNumberOfCells(), 0);
  map.filter->SetInputData(1, nullptr);
  EXPECT_GT(map.run()->GetNumberOfCells(), 0);
  EXPECT_EQ(map.filter->GetOutput(1)->GetNumberOfPoints(), 0);
  EXPECT_EQ(map.filter->GetOutput(1)->GetNumberOfCells(), 0);
}

TEST(HarmonicDiskMap, WithoutLinkingSidesTheChosenStartsAreReported)
{
  const test::SweepGrids sweep = test::readCase("taper10");
  Map matched(sweep.sourceSurface, sweep.targetSurface);
  vtkDataArray* starts = matched.run()->GetFieldData()->GetArray(hexsweep::reports::LoopStarts);
  ASSERT_NE(starts, nullptr);
  EXPECT_EQ(starts->GetNumberOfTuples(),
    static_cast<vtkIdType>(
      matched.run()->GetFieldData()->GetArray(hexsweep::arrays::HoleCircles)->GetNumberOfTuples()) +
      1);
  Map linked(sweep.sourceSurface, sweep.targetSurface, sweep.linkingSides);
  EXPECT_EQ(linked.run()->GetFieldData()->GetArray(hexsweep::reports::LoopStarts), nullptr);
}

TEST(HarmonicDiskMap, AStartThatIsAGuessRaisesAWarning)
{
  const std::vector<Corners> square{ { 0, 1, 2, 3 } };
  const Grid cap =
    test::gridOf({ { 1, 1, 0 }, { -1, 1, 0 }, { -1, -1, 0 }, { 1, -1, 0 } }, square, VTK_QUAD);
  const double r = std::sqrt(2.0);
  const Grid partner =
    test::gridOf({ { r, 0, 3 }, { 0, r, 3 }, { -r, 0, 3 }, { 0, -r, 3 } }, square, VTK_QUAD);
  Map map(cap, partner);
  map.filter->Update();
  EXPECT_TRUE(map.events.errors.empty());
  ASSERT_EQ(map.events.warnings.size(), 1u);
  EXPECT_NE(map.events.warnings[0].find("connect LinkingSides"), std::string::npos);
}

TEST(HarmonicDiskMap, CirclesForMoreLoops)
{
  const test::SweepGrids sweep = test::plateSweep(3);
  Map map(sweep.sourceSurface, sweep.targetSurface, sweep.linkingSides);
  vtkUnstructuredGrid* output = map.run();
  EXPECT_EQ(textReport(output, hexsweep::arrays::DiskMapDomain), "Circles");
  EXPECT_EQ(
    output->GetFieldData()->GetArray(hexsweep::arrays::HoleCircles)->GetNumberOfTuples(), 3);
}

TEST(HarmonicDiskMap, DataAreCarried)
{
  const test::SweepGrids sweep = test::readCase("taper10");
  const Grid input = test::withData(sweep.sourceSurface);
  Map map(input, sweep.targetSurface, sweep.linkingSides);
  vtkUnstructuredGrid* output = map.run();
  vtkDataArray* points = output->GetPointData()->GetArray("PointNumber");
  vtkDataArray* cells = output->GetCellData()->GetArray("CellNumber");
  ASSERT_NE(points, nullptr);
  ASSERT_NE(cells, nullptr);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(
      points->GetTuple1(i), i < input->GetNumberOfPoints() ? 100.0 + static_cast<double>(i) : 0.0);
  }
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    EXPECT_EQ(cells->GetTuple1(c),
      1000.0 +
        static_cast<double>(idOf(output->GetCellData(), hexsweep::arrays::OriginalCellIds, c)));
  }
  EXPECT_EQ(report(output, "Note"), 7.0);
  // The input is not written to.
  EXPECT_EQ(input->GetPointData()->GetNumberOfArrays(), 1);
  EXPECT_EQ(input->GetFieldData()->GetNumberOfArrays(), 1);
}

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

TEST(HarmonicDiskMap, OutputDiskAndPrecision)
{
  const Grid input = test::readGrid("taper10/target_surface");
  Map plain(input);
  Map disk(input);
  disk.filter->OutputDiskOn();
  vtkUnstructuredGrid* expected = plain.run();
  vtkUnstructuredGrid* output = disk.run();
  vtkDataArray* surface = output->GetPointData()->GetArray(hexsweep::arrays::SurfacePoints);
  ASSERT_NE(surface, nullptr);
  EXPECT_EQ(expected->GetPointData()->GetArray(hexsweep::arrays::SurfacePoints), nullptr);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> p;
    surface->GetTuple(i, p.data());
    EXPECT_EQ(p, test::pointOf(expected, i));
    EXPECT_EQ(test::pointOf(output, i), diskPoint(expected, i));
  }
  plain.filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  EXPECT_EQ(plain.run()->GetPoints()->GetDataType(), VTK_FLOAT);
}

TEST(HarmonicDiskMap, TwiceGivesTheSameBits)
{
  const test::SweepGrids sweep = test::readCase("taper10");
  Map map(sweep.sourceSurface, sweep.targetSurface, sweep.linkingSides);
  vtkNew<vtkUnstructuredGrid> first;
  first->DeepCopy(map.run());
  map.filter->Modified();
  test::expectSameBits(first, map.run());
}

TEST(HarmonicDiskMap, AbortEmptiesTheOutput)
{
  const test::SweepGrids sweep = test::readCase("taper10");
  Map map(sweep.sourceSurface, sweep.targetSurface, sweep.linkingSides);
  for (const double fraction : { 0.0, 0.3, 0.7 })
  {
    test::expectEmptyWhenAborted(map.filter, fraction);
  }
  EXPECT_GT(map.run()->GetNumberOfCells(), 0);
  Map alone(sweep.sourceSurface);
  test::expectEmptyWhenAborted(alone.filter, 0.0);
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

TEST(HarmonicDiskMap, MissingInput)
{
  vtkNew<vtkHarmonicDiskMap> filter;
  test::expectOneError(filter, "the input surface is missing");
}

TEST(HarmonicDiskMap, EmptyInput)
{
  Map map(test::emptyGrid());
  expectOneError(map.filter, "the input surface is empty");
  const Grid points = test::readGrid("ubend/target_surface");
  Grid noCells = Grid::New();
  noCells->SetPoints(points->GetPoints());
  Map noCellsMap(noCells);
  expectOneError(noCellsMap.filter, "no cells");
  Map vertices(test::gridOf({ { 0, 0, 0 } }, { { 0 } }, VTK_VERTEX));
  expectOneError(vertices.filter, "no surface cells");
}

TEST(HarmonicDiskMap, EmptyPartnerAndLinkingSides)
{
  const test::SweepGrids sweep = test::readCase("ubend");
  Map partner(sweep.sourceSurface, test::emptyGrid());
  expectOneError(partner.filter, "the partner surface is empty");
  Map linking(sweep.sourceSurface, sweep.targetSurface, test::emptyGrid());
  expectOneError(linking.filter, "the linking sides are empty");
}

TEST(HarmonicDiskMap, ClosedSurface)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  Map map(sphere->GetOutput());
  expectOneError(map.filter, "closed surface");
  const test::SweepGrids sweep = test::readCase("ubend");
  Map partner(sweep.sourceSurface, sphere->GetOutput(), sweep.linkingSides);
  expectOneError(partner.filter, "closed surface");
}

TEST(HarmonicDiskMap, NotANumber)
{
  const test::SweepGrids sweep = test::readCase("ubend");
  Map map(test::withNaN(sweep.sourceSurface));
  expectOneError(map.filter, "not a finite number");
  Map partner(sweep.sourceSurface, test::withNaN(sweep.targetSurface), sweep.linkingSides);
  expectOneError(partner.filter, "not a finite number");
  Map linking(sweep.sourceSurface, sweep.targetSurface, test::withNaN(sweep.linkingSides));
  expectOneError(linking.filter, "not a finite number");
}

TEST(HarmonicDiskMap, MoebiusStrip)
{
  Map map(moebiusStrip());
  expectOneError(map.filter, "Moebius");
}

TEST(HarmonicDiskMap, SurfacesThatAreNoManifold)
{
  const std::vector<std::array<double, 3>> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
    { 0, 0, 1 }, { 0, -1, 0 }, { -1, 0, 0 } };
  Map edge(test::gridOf(points, { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } }, VTK_TRIANGLE));
  expectOneError(edge.filter, "more than two faces");
  Map point(test::gridOf(points, { { 0, 1, 2 }, { 0, 4, 5 } }, VTK_TRIANGLE));
  expectOneError(point.filter, "point 0");
  Map pieces(test::gridOf(points, { { 0, 1, 2 }, { 3, 4, 5 } }, VTK_TRIANGLE));
  expectOneError(pieces.filter, "the input surface falls into 2 pieces");
  Map collapsed(test::gridOf(points, { { 0, 1, 1 } }, VTK_TRIANGLE));
  expectOneError(collapsed.filter, "twice");
  Map flat(test::gridOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, { { 0, 1, 2 } }, VTK_TRIANGLE));
  expectOneError(flat.filter, "no area");
}

TEST(HarmonicDiskMap, ACellWithoutAreaIsNamedAsTheUserSeesIt)
{
  // The vertex cell counts: cell 2 is the third of the data set, the second triangle.
  const Grid good = test::readCase("taper10").sourceSurface;
  Grid flat =
    test::gridOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 2, 0 } }, {}, VTK_TRIANGLE);
  for (const Corners& corners : { Corners{ 0 }, Corners{ 0, 1, 2 }, Corners{ 0, 2, 3 } })
  {
    flat->InsertNextCell(corners.size() == 1 ? VTK_VERTEX : VTK_TRIANGLE,
      static_cast<vtkIdType>(corners.size()), corners.data());
  }
  Map input(flat);
  expectOneError(input.filter, "the input surface: cell 2 at (0, 1, 0) has no area");
  Map partner(good, flat);
  expectOneError(partner.filter, "the partner surface: cell 2 at (0, 1, 0) has no area");
}

TEST(HarmonicDiskMap, CellsThatAreNoSurface)
{
  const std::vector<std::array<double, 3>> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
    { 0, 0, 1 }, { 0.5, 0.5, 0 }, { 0, 0.5, 0.1 } };
  Map volume(test::gridOf(points, { { 0, 1, 2, 3 } }, VTK_TETRA));
  expectOneError(volume.filter, "volume cell");
  Map quadratic(test::gridOf(points, { { 0, 1, 2, 3, 4, 5 } }, VTK_QUADRATIC_TRIANGLE));
  expectOneError(quadratic.filter, "linearise");
}

TEST(HarmonicDiskMap, DifferentNumbersOfHoles)
{
  const test::SweepGrids one = test::readCase("ubend");
  const test::SweepGrids two = test::readCase("taper10");
  Map map(one.sourceSurface, two.targetSurface, one.linkingSides);
  test::Events events(map.filter);
  map.filter->Update();
  EXPECT_EQ(events.errors.size(), 1u);
  EXPECT_TRUE(test::isEmpty(map.filter));
  Map byShape(one.sourceSurface, two.targetSurface);
  expectOneError(byShape.filter, "the input surface has 1 boundary loop(s), the partner surface 2");
}

TEST(HarmonicDiskMap, LoopsThatDoNotMatch)
{
  const test::SweepGrids sweep = test::readCase("ubend");
  // Linking sides that are a bit too wide, and those of another volume.
  const Grid wide = test::changedPoints(
    sweep.linkingSides, [](vtkIdType, std::array<double, 3>& p) { p[0] *= 1.2; });
  Map map(sweep.sourceSurface, sweep.targetSurface, wide);
  expectOneError(map.filter, "a loop of the linking sides does not lie on the boundary of the ");
  Map other(sweep.sourceSurface, sweep.targetSurface, test::readGrid("c_open/linking_quads"));
  test::Events events(other.filter);
  other.filter->Update();
  EXPECT_EQ(events.errors.size(), 1u);
  EXPECT_TRUE(test::isEmpty(other.filter));
}

TEST(HarmonicDiskMap, ErrorsDoNotLast)
{
  Map map(test::withNaN(test::readGrid("ubend/target_surface")));
  expectOneError(map.filter, "not a finite number");
  map.filter->SetInputData(test::readGrid("ubend/target_surface"));
  map.filter->Update();
  EXPECT_GT(map.filter->GetOutput()->GetNumberOfCells(), 0);
}

std::vector<double> reports(vtkDataSet* data, const std::string& name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name.c_str());
  EXPECT_NE(array, nullptr) << name;
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetTuple1(i));
  }
  return values;
}

bool hasReport(vtkDataSet* data, const std::string& name)
{
  return data->GetFieldData()->GetAbstractArray(name.c_str()) != nullptr;
}

/// Every boundary node lies on the unit circle or on one of HoleCircles; each circle has nodes.
void expectLoopsOnCircles(vtkUnstructuredGrid* output)
{
  vtkDataArray* circles = output->GetFieldData()->GetArray(hexsweep::arrays::HoleCircles);
  ASSERT_NE(circles, nullptr);
  std::vector<std::array<double, 3>> all{ { 0.0, 0.0, 1.0 } };
  for (vtkIdType h = 0; h < circles->GetNumberOfTuples(); ++h)
  {
    all.push_back(
      { circles->GetComponent(h, 0), circles->GetComponent(h, 1), circles->GetComponent(h, 2) });
  }
  std::vector<int> nodes(all.size(), 0);
  for (const auto& side : test::boundaryOf(output))
  {
    const auto p = diskPoint(output, side.first);
    const auto on = std::find_if(all.begin(), all.end(), [&](const std::array<double, 3>& c) {
      return std::abs(std::hypot(p[0] - c[0], p[1] - c[1]) - c[2]) < 1e-13;
    });
    ASSERT_NE(on, all.end()) << "point " << side.first;
    ++nodes[static_cast<std::size_t>(on - all.begin())];
  }
  for (const int count : nodes)
  {
    EXPECT_GE(count, 3);
  }
}

/// The area of all triangles in the disk.
double diskArea(vtkUnstructuredGrid* output)
{
  double area = 0.0;
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    const Corners t = test::cornersOf(output, c);
    const auto p = diskPoint(output, t[0]);
    const auto q = diskPoint(output, t[1]);
    const auto r = diskPoint(output, t[2]);
    area += 0.5 * std::abs((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
  }
  return area;
}

TEST(HarmonicDiskMap, KoebeIsTheDefault)
{
  vtkNew<vtkHarmonicDiskMap> filter;
  EXPECT_EQ(filter->GetHoleTreatment(), vtkHarmonicDiskMap::KOEBE);
  EXPECT_EQ(filter->GetTolerance(), 1e-10);
  EXPECT_EQ(filter->GetMaximumIterations(), 20);
  filter->SetTolerance(-1.0);
  EXPECT_EQ(filter->GetTolerance(), 0.0);
  filter->SetTolerance(2.0);
  EXPECT_EQ(filter->GetTolerance(), 1.0);
  filter->SetMaximumIterations(0);
  EXPECT_EQ(filter->GetMaximumIterations(), 1);
  filter->SetHoleTreatmentToArcLength();
  EXPECT_EQ(filter->GetHoleTreatment(), vtkHarmonicDiskMap::ARC_LENGTH);
  filter->SetHoleTreatmentToKoebe();
  EXPECT_EQ(filter->GetHoleTreatment(), vtkHarmonicDiskMap::KOEBE);
  std::ostringstream text;
  filter->Print(text);
  EXPECT_NE(text.str().find("MaximumIterations: 1"), std::string::npos);
  EXPECT_NE(text.str().find("Tolerance: 1"), std::string::npos);
}

TEST(HarmonicDiskMap, KoebeOnThreeHoles)
{
  const Grid input = test::plateSweep(3).sourceSurface;
  Map map(input);
  vtkUnstructuredGrid* output = map.run();
  expectOriginals(output, input);
  EXPECT_EQ(textReport(output, hexsweep::arrays::DiskMapDomain), "Circles");
  EXPECT_EQ(report(output, hexsweep::reports::Loops), 4);
  EXPECT_EQ(
    output->GetFieldData()->GetArray(hexsweep::arrays::HoleCircles)->GetNumberOfTuples(), 3);
  expectLoopsOnCircles(output);

  EXPECT_EQ(report(output, hexsweep::reports::FlipsAfter), 0);
  EXPECT_EQ(report(output, hexsweep::reports::KoebeConverged), 1);
  const std::vector<double> changes = reports(output, hexsweep::reports::KoebeChanges);
  ASSERT_FALSE(changes.empty());
  EXPECT_EQ(
    report(output, hexsweep::reports::KoebeRounds), static_cast<double>(changes.size() + 1));
  for (std::size_t k = 0; k < changes.size(); ++k)
  {
    EXPECT_EQ(changes[k] <= 1e-10, k + 1 == changes.size());
  }
  const std::vector<double> circularity = reports(output, hexsweep::reports::Circularity);
  ASSERT_EQ(circularity.size(), 4u);
  for (const double c : circularity)
  {
    EXPECT_GT(c, 0.0);
    EXPECT_LT(c, 0.2);
  }
}

TEST(HarmonicDiskMap, KoebeOnTheSpongecake)
{
  Map map(test::readGrid("fig9_spongecake/target_surface"));
  vtkUnstructuredGrid* output = map.run();
  EXPECT_EQ(
    output->GetFieldData()->GetArray(hexsweep::arrays::HoleCircles)->GetNumberOfTuples(), 37);
  EXPECT_LE(report(output, hexsweep::reports::KoebeRounds), 6);
  EXPECT_EQ(report(output, hexsweep::reports::KoebeConverged), 1);
  EXPECT_EQ(report(output, hexsweep::reports::FlipsAfter), 0);
  expectLoopsOnCircles(output);
}

TEST(HarmonicDiskMap, KoebeDistortsAnglesLeast)
{
  const Grid input = test::plateSweep(3).sourceSurface;
  Map koebe(input);
  Map arcLength(input);
  arcLength.filter->SetHoleTreatmentToArcLength();
  Map filled(input);
  filled.filter->SetHoleTreatmentToFilled();
  vtkUnstructuredGrid* best = koebe.run();
  for (vtkUnstructuredGrid* other : { arcLength.run(), filled.run() })
  {
    EXPECT_LT(report(best, hexsweep::reports::MeanAngleDistortion),
      report(other, hexsweep::reports::MeanAngleDistortion));
    EXPECT_FALSE(hasReport(other, hexsweep::reports::KoebeRounds));
    EXPECT_FALSE(hasReport(other, hexsweep::reports::Circularity));
    // How much the energy exceeds the area says how far a map is from a conformal one.
    EXPECT_LT(report(best, hexsweep::reports::DirichletEnergy) / diskArea(best),
      report(other, hexsweep::reports::DirichletEnergy) / diskArea(other));
  }
  for (vtkUnstructuredGrid* output : { best, arcLength.run(), filled.run() })
  {
    EXPECT_GE(report(output, hexsweep::reports::DirichletEnergy), diskArea(output));
    EXPECT_LE(report(output, hexsweep::reports::MeanAngleDistortion),
      report(output, hexsweep::reports::WorstAngleDistortion));
    EXPECT_LE(report(output, hexsweep::reports::WorstAngleDistortion), 180.0);
  }
  EXPECT_LT(report(best, hexsweep::reports::DirichletEnergy), 1.1 * diskArea(best));
}

TEST(HarmonicDiskMap, KoebeOnOneHoleIsAnAnnulus)
{
  const Grid input = test::plateSweep(1).sourceSurface;
  Map map(input);
  vtkUnstructuredGrid* output = map.run();
  EXPECT_EQ(textReport(output, hexsweep::arrays::DiskMapDomain), "Circles");
  expectLoopsOnCircles(output);
  vtkDataArray* circles = output->GetFieldData()->GetArray(hexsweep::arrays::HoleCircles);
  ASSERT_EQ(circles->GetNumberOfTuples(), 1);
  EXPECT_EQ(circles->GetComponent(0, 0), 0.0);
  EXPECT_EQ(circles->GetComponent(0, 1), 0.0);
  EXPECT_EQ(report(output, hexsweep::reports::KoebeRounds), 1);
  EXPECT_EQ(report(output, hexsweep::reports::KoebeConverged), 1);
  // A conformal map's energy is the area of its image; polygons lie inside their circles.
  const double r = circles->GetComponent(0, 2);
  const double area = std::acos(-1.0) * (1.0 - r * r);
  EXPECT_GT(report(output, hexsweep::reports::DirichletEnergy), 0.95 * area);
  EXPECT_LT(report(output, hexsweep::reports::DirichletEnergy), 1.1 * area);
}

TEST(HarmonicDiskMap, KoebeThatIsCutShortWarns)
{
  Map map(test::plateSweep(3).sourceSurface);
  map.filter->SetMaximumIterations(1);
  map.filter->Update();
  EXPECT_TRUE(map.events.errors.empty());
  ASSERT_EQ(map.events.warnings.size(), 1u);
  EXPECT_NE(map.events.warnings[0].find("MaximumIterations"), std::string::npos);
  vtkUnstructuredGrid* output = map.filter->GetOutput();
  EXPECT_GT(output->GetNumberOfCells(), 0);
  EXPECT_EQ(report(output, hexsweep::reports::KoebeConverged), 0);
  EXPECT_EQ(report(output, hexsweep::reports::KoebeRounds), 1);
  EXPECT_TRUE(reports(output, hexsweep::reports::KoebeChanges).empty());
  expectLoopsOnCircles(output);

  // A loose tolerance needs fewer rounds than a strict one, and no warning.
  Map loose(test::plateSweep(3).sourceSurface);
  loose.filter->SetTolerance(1e-2);
  Map strict(test::plateSweep(3).sourceSurface);
  strict.filter->SetTolerance(1e-16);
  EXPECT_LT(report(loose.run(), hexsweep::reports::KoebeRounds),
    report(strict.run(), hexsweep::reports::KoebeRounds));
}

TEST(HarmonicDiskMap, KoebeReportsProgressAndAborts)
{
  Map map(test::plateSweep(3).sourceSurface);
  std::vector<double> fractions;
  const auto record = [](vtkObject* caller, unsigned long, void* data, void*) {
    static_cast<std::vector<double>*>(data)->push_back(
      vtkAlgorithm::SafeDownCast(caller)->GetProgress());
  };
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(record);
  observer->SetClientData(&fractions);
  const unsigned long tag = map.filter->AddObserver(vtkCommand::ProgressEvent, observer);
  map.run();
  map.filter->RemoveObserver(tag);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  // The rounds are seen one by one.
  const auto within = std::count_if(
    fractions.begin(), fractions.end(), [](double f) { return f > 0.27 && f < 0.75; });
  EXPECT_GE(within, 2);
  for (const double fraction : { 0.0, 0.2, 0.27, 0.3 })
  {
    test::expectEmptyWhenAborted(map.filter, fraction);
  }
  map.filter->Modified();
  EXPECT_GT(map.run()->GetNumberOfCells(), 0);
}

TEST(HarmonicDiskMap, UnknownHoleTreatmentIsAnError)
{
  Map map(test::plateSweep(3).sourceSurface);
  map.filter->SetHoleTreatment(7);
  expectOneError(map.filter, "HoleTreatment 7 does not exist");
}

TEST(HarmonicDiskMap, KoebeTakesMeanValueWeights)
{
  // The circles come from the surface's own metric whatever fills them.
  Map cotangent(test::plateSweep(3).sourceSurface);
  Map meanValue(test::plateSweep(3).sourceSurface);
  meanValue.filter->SetWeightsToMeanValue();
  vtkDataArray* expected = cotangent.run()->GetFieldData()->GetArray(hexsweep::arrays::HoleCircles);
  vtkUnstructuredGrid* output = meanValue.run();
  EXPECT_EQ(textReport(output, hexsweep::reports::Method), "MeanValue");
  vtkDataArray* circles = output->GetFieldData()->GetArray(hexsweep::arrays::HoleCircles);
  for (vtkIdType h = 0; h < 3; ++h)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(circles->GetComponent(h, c), expected->GetComponent(h, c));
    }
  }
  expectLoopsOnCircles(output);
}
}
