// SPDX-License-Identifier: BSD-3-Clause
// Disk maps of vtkSweepQuadProjector: those that it hands out, and those that it is given.
#include "QuadProjection.h"

#include "HexSweepArrays.h"

#include <vtkHarmonicDiskMap.h>

#include <cstdio>
#include <limits>

namespace TestQuadProjectorMaps
{
using test::Corners;
using test::expectOneError;
using test::Grid;
using test::report;
using test::SweepGrids;
using Projection = test::QuadProjection;

TEST(SweepQuadProjector, OutputsOfTheMapsEqualTheDiskMapFilters)
{
  for (const SweepGrids& sweep : { test::readCase("taper10"), test::plateSweep(3) })
  {
    Projection projection(sweep);
    projection.run();
    const SweepGrids maps = withMaps(sweep);
    for (const auto& [port, expected] :
      { std::make_pair(1, maps.sourceSurface), std::make_pair(2, maps.targetSurface) })
    {
      auto* output =
        vtkUnstructuredGrid::SafeDownCast(projection.filter->GetOutputDataObject(port));
      test::expectSameBits(output, expected);
      for (const char* name : { hexsweep::arrays::DiskMapDomain, hexsweep::reports::Method })
      {
        EXPECT_EQ(test::textReport(output, name), test::textReport(expected, name));
      }
      EXPECT_EQ(
        output->GetFieldData()->GetArray(hexsweep::arrays::HoleCircles)->GetNumberOfTuples(),
        expected->GetFieldData()->GetArray(hexsweep::arrays::HoleCircles)->GetNumberOfTuples());
    }
  }
}

TEST(SweepQuadProjector, MapsFromTheInputAreHandedOn)
{
  const SweepGrids maps = withMaps(test::plateSweep(3));
  Projection projection(maps);
  projection.filter->SetDiskMapsToFromInput();
  projection.run();
  for (const auto& [port, expected] :
    { std::make_pair(1, maps.sourceSurface), std::make_pair(2, maps.targetSurface) })
  {
    auto* output = vtkUnstructuredGrid::SafeDownCast(projection.filter->GetOutputDataObject(port));
    EXPECT_EQ(test::greatestDistance(output, expected), 0.0);
    for (const char* name : { hexsweep::arrays::DiskMapDomain, hexsweep::reports::Method })
    {
      EXPECT_EQ(test::textReport(output, name), test::textReport(expected, name));
    }
    vtkDataArray* circles = output->GetFieldData()->GetArray(hexsweep::arrays::HoleCircles);
    vtkDataArray* wanted = expected->GetFieldData()->GetArray(hexsweep::arrays::HoleCircles);
    ASSERT_EQ(circles->GetNumberOfTuples(), wanted->GetNumberOfTuples());
    for (vtkIdType h = 0; h < wanted->GetNumberOfTuples(); ++h)
    {
      EXPECT_EQ(circles->GetComponent(h, 2), wanted->GetComponent(h, 2));
    }
  }
}

TEST(SweepQuadProjector, AFlipPlantedInAGivenMapIsFoundAndNamed)
{
  for (const int holes : { 0, 3 })
  {
    for (const bool onSource : { true, false })
    {
      SweepGrids sweep = withMaps(test::plateSweep(holes));
      Grid tampered = Grid::New();
      tampered->DeepCopy(onSource ? sweep.sourceSurface : sweep.targetSurface);
      (onSource ? sweep.sourceSurface : sweep.targetSurface) = tampered;
      vtkDataArray* disk = tampered->GetPointData()->GetArray(hexsweep::arrays::DiskCoordinates);
      // One inner node is drawn across the far side of one of its triangles.
      const auto boundary = test::boundaryOf(tampered);
      vtkIdType first = -1;
      std::array<double, 3> middle{};
      const auto area = [&](vtkIdType cell) {
        const Corners c = test::cornersOf(tampered, cell);
        double p[3][3];
        for (std::size_t i = 0; i < 3; ++i)
        {
          disk->GetTuple(c[i], p[i]);
        }
        return (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) -
          (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
      };
      const double sign = area(0) > 0.0 ? 1.0 : -1.0;
      for (vtkIdType t = 0; first < 0 && t < tampered->GetNumberOfCells(); ++t)
      {
        const Corners c = test::cornersOf(tampered, t);
        if (!boundary.count(c[0]) && !boundary.count(c[1]) && !boundary.count(c[2]))
        {
          double p[3][3];
          for (std::size_t i = 0; i < 3; ++i)
          {
            disk->GetTuple(c[i], p[i]);
          }
          for (int k = 0; k < 2; ++k)
          {
            disk->SetComponent(c[0], k, 0.55 * (p[1][k] + p[2][k]) - 0.1 * p[0][k]);
          }
          first = t;
        }
      }
      ASSERT_GE(first, 0);
      vtkIdType flips = 0;
      first = -1;
      for (vtkIdType t = 0; t < tampered->GetNumberOfCells(); ++t)
      {
        if (!(sign * area(t) > 0.0))
        {
          ++flips;
          first = first < 0 ? t : first;
        }
      }
      ASSERT_GT(flips, 0);
      for (const vtkIdType i : test::cornersOf(tampered, first))
      {
        for (std::size_t c = 0; c < 3; ++c)
        {
          middle[c] += test::pointOf(tampered, i)[c] / 3.0;
        }
      }

      Projection projection(sweep);
      projection.filter->SetDiskMapsToFromInput();
      vtkUnstructuredGrid* output = projection.run();
      EXPECT_EQ(report(output, hexsweep::reports::FlipsAfter), static_cast<double>(flips));
      ASSERT_FALSE(projection.events.warnings.empty());
      const std::string& warning = projection.events.warnings[0];
      EXPECT_NE(
        warning.find(std::to_string(flips) + " of " + std::to_string(tampered->GetNumberOfCells()) +
          " triangles of the " + (onSource ? "source" : "target") + " surface are flipped"),
        std::string::npos)
        << warning;
      char place[64];
      std::snprintf(place, sizeof(place), "(%.5g", middle[0]);
      EXPECT_NE(warning.find(place), std::string::npos) << warning << ", expected at " << place;
    }
  }
}

TEST(SweepQuadProjector, PaperHarmonicMakesItsOwnMaps)
{
  Projection projection(withMaps(test::readCase("taper10")));
  projection.filter->SetMethodToPaperHarmonic();
  projection.filter->SetDiskMapsToFromInput();
  expectOneError(projection.filter, "PaperHarmonic makes disk maps of its own");
}

TEST(SweepQuadProjector, FromInputWithoutMaps)
{
  SweepGrids sweep = test::readCase("taper10");
  Projection none(sweep);
  none.filter->SetDiskMapsToFromInput();
  expectOneError(none.filter, "no point array DiskCoordinates");

  const SweepGrids maps = withMaps(sweep);
  SweepGrids half = maps;
  half.targetSurface = sweep.targetSurface;
  Projection noTarget(half);
  noTarget.filter->SetDiskMapsToFromInput();
  expectOneError(noTarget.filter, "target surface has no point array");

  half = maps;
  half.sourceSurface = nullptr;
  Projection noSource(half);
  noSource.filter->SetDiskMapsToFromInput();
  expectOneError(noSource.filter, "source surface is missing");
}

TEST(SweepQuadProjector, FromInputWithMapsThatDoNotShareTheirLoops)
{
  for (const char* name : { "ubend", "taper10" })
  {
    SweepGrids sweep = withMaps(test::readCase(name));
    // The target's canonical map, made without its partner.
    vtkNew<vtkHarmonicDiskMap> alone;
    alone->SetInputData(0, test::readGrid(std::string(name) + "/target_surface"));
    alone->Update();
    sweep.targetSurface = alone->GetOutput();
    Projection projection(sweep);
    projection.filter->SetDiskMapsToFromInput();
    expectOneError(projection.filter, "do not share their loops");
  }
  SweepGrids mixed = withMaps(test::readCase("ubend"));
  mixed.targetSurface = withMaps(test::readCase("taper10")).targetSurface;
  Projection projection(mixed);
  projection.filter->SetDiskMapsToFromInput();
  test::Events events(projection.filter);
  projection.filter->Update();
  EXPECT_EQ(events.errors.size(), 1u);
  EXPECT_TRUE(test::isEmpty(projection.filter));
}

TEST(SweepQuadProjector, FromInputWithBrokenCoordinates)
{
  SweepGrids sweep = withMaps(test::readCase("ubend"));
  sweep.targetSurface->GetPointData()
    ->GetArray(hexsweep::arrays::DiskCoordinates)
    ->SetComponent(3, 0, std::numeric_limits<double>::quiet_NaN());
  Projection projection(sweep);
  projection.filter->SetDiskMapsToFromInput();
  expectOneError(projection.filter, "not finite");
}
}
