// SPDX-License-Identifier: BSD-3-Clause
// vtkHarmonicDiskMap: maps of one cap and of two, and what it carries.
#include "DiskMapping.h"

#include "HexSweepArrays.h"

namespace TestHarmonicDiskMap
{
using test::Corners;
using test::diskPoint;
using test::expectOriginals;
using test::Grid;
using test::idOf;
using test::report;
using test::textReport;
using Map = test::DiskMapping;

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
}
