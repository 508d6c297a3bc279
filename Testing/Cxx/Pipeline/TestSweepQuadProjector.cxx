// SPDX-License-Identifier: BSD-3-Clause
// vtkSweepQuadProjector: where nodes go, what it carries, what it refuses.
#include "CapGrids.h"

#include "HexSweepArrays.h"

#include <vtkHarmonicDiskMap.h>
#include <vtkSweepQuadProjector.h>

#include <vtkMeshQuality.h>
#include <vtkSphereSource.h>

#include <cstdio>
#include <limits>

namespace TestSweepQuadProjector
{
using test::Corners;
using test::expectOneError;
using test::Grid;
using test::report;
using test::SweepGrids;

struct Projection
{
  vtkNew<vtkSweepQuadProjector> filter;
  test::Events events;

  explicit Projection(const SweepGrids& sweep)
    : events(filter)
  {
    const vtkSmartPointer<vtkUnstructuredGrid> ports[4] = { sweep.sourceQuads, sweep.targetSurface,
      sweep.linkingSides, sweep.sourceSurface };
    for (int port = 0; port < 4; ++port)
    {
      if (ports[port])
      {
        this->filter->SetInputData(port, ports[port]);
      }
    }
  }
  /// The projection alone: untangling and polishing blow rounding up.
  Projection& raw()
  {
    this->filter->EnsureValidOff();
    this->filter->ImproveQualityOff();
    return *this;
  }
  vtkUnstructuredGrid* run()
  {
    this->filter->Update();
    EXPECT_TRUE(this->events.errors.empty()) << this->events.errors[0];
    return this->filter->GetOutput();
  }
};

/// The end of each linking column, by the place of its beginning: walked over edges here.
std::map<std::array<double, 3>, std::array<double, 3>> columnEnds(const SweepGrids& sweep)
{
  vtkUnstructuredGrid* linking = sweep.linkingSides;
  // Points that coincide are one.
  std::map<std::array<double, 3>, vtkIdType> numbers;
  std::vector<std::array<double, 3>> places;
  std::vector<Corners> quads;
  for (vtkIdType c = 0; c < linking->GetNumberOfCells(); ++c)
  {
    quads.emplace_back();
    for (const vtkIdType p : test::cornersOf(linking, c))
    {
      const auto place = test::pointOf(linking, p);
      const auto known = numbers.emplace(place, static_cast<vtkIdType>(places.size()));
      if (known.second)
      {
        places.push_back(place);
      }
      quads.back().push_back(known.first->second);
    }
  }
  std::map<vtkIdType, std::set<vtkIdType>> neighbors;
  std::map<vtkIdType, std::set<std::size_t>> quadsAt;
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      const vtkIdType a = quads[q][i];
      const vtkIdType b = quads[q][(i + 1) % 4];
      neighbors[a].insert(b);
      neighbors[b].insert(a);
      quadsAt[a].insert(q);
    }
  }
  std::set<vtkIdType> first;
  for (const auto& side : test::boundaryOf(sweep.sourceQuads))
  {
    const auto found = numbers.find(test::pointOf(sweep.sourceQuads, side.first));
    EXPECT_NE(found, numbers.end());
    first.insert(found->second);
  }
  std::map<std::array<double, 3>, std::array<double, 3>> ends;
  for (const vtkIdType start : first)
  {
    std::set<vtkIdType> before = first;
    vtkIdType last = -1;
    vtkIdType here = start;
    for (;;)
    {
      // Straight on: no ring-mate of the first ring, no quad in common with where we came from.
      vtkIdType next = -1;
      for (const vtkIdType n : neighbors[here])
      {
        bool straight = !first.count(n);
        if (last >= 0)
        {
          for (const std::size_t q : quadsAt[n])
          {
            straight = straight && !quadsAt[last].count(q);
          }
          straight = straight && n != last;
        }
        next = straight ? n : next;
      }
      if (next < 0)
      {
        break;
      }
      last = here;
      here = next;
    }
    ends[places[static_cast<std::size_t>(start)]] = places[static_cast<std::size_t>(here)];
  }
  return ends;
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

SweepGrids withMaps(const SweepGrids& sweep)
{
  SweepGrids mapped = sweep;
  vtkNew<vtkHarmonicDiskMap> source;
  source->SetInputData(0, sweep.sourceSurface);
  source->SetInputData(1, sweep.targetSurface);
  source->SetInputData(2, sweep.linkingSides);
  source->Update();
  mapped.sourceSurface = source->GetOutput();
  vtkNew<vtkHarmonicDiskMap> target;
  target->SetInputData(0, sweep.targetSurface);
  target->SetInputData(1, sweep.sourceSurface);
  target->SetInputData(2, sweep.linkingSides);
  target->Update();
  mapped.targetSurface = target->GetOutput();
  return mapped;
}

TEST(SweepQuadProjector, NoQuadIsInvertedOnTheEasyCases)
{
  for (const char* name : { "ubend", "c_open", "taper10", "twist270_L", "gear_round" })
  {
    Projection projection(test::readCase(name));
    EXPECT_EQ(report(projection.run(), hexsweep::reports::InvertedQuads), 0) << name;
    vtkUnstructuredGrid* output = projection.raw().run();
    EXPECT_EQ(report(output, hexsweep::reports::InvertedQuads), 0) << name;
    EXPECT_EQ(report(output, hexsweep::reports::FlipsAfter), 0) << name;
    EXPECT_EQ(report(output, hexsweep::reports::Outside), 0) << name;
    EXPECT_GT(report(output, hexsweep::reports::MinScaledJacobian), 0.0) << name;
    EXPECT_EQ(test::textReport(output, hexsweep::reports::Method), "Harmonic");
    EXPECT_TRUE(projection.events.warnings.empty());
  }
}

TEST(SweepQuadProjector, FewQuadsAreInvertedInThePapersFigures)
{
  const std::map<std::string, double> most{ { "fig7_growing_hole", 3 },
    { "fig8_concave_twisted_hole", 7 }, { "fig9_spongecake", 670 } };
  for (const auto& [name, count] : most)
  {
    Projection projection(test::readCase(name));
    vtkUnstructuredGrid* output = projection.raw().run();
    const double inverted = report(output, hexsweep::reports::InvertedQuads);
    EXPECT_LE(inverted, count) << name;
    EXPECT_EQ(report(output, hexsweep::reports::FlipsAfter), 0) << name;
    // Said aloud, with the number, if there are any.
    ASSERT_EQ(projection.events.warnings.size(), inverted > 0 ? 1u : 0u);
    if (inverted > 0)
    {
      EXPECT_NE(
        projection.events.warnings[0].find(std::to_string(static_cast<int>(inverted)) + " of "),
        std::string::npos);
    }
    vtkDataArray* jacobian = output->GetCellData()->GetArray(hexsweep::arrays::ScaledJacobian);
    double found = 0.0;
    for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
    {
      found += jacobian->GetTuple1(c) > 0.0 ? 0.0 : 1.0;
    }
    EXPECT_EQ(found, inverted);
  }
}

TEST(SweepQuadProjector, BoundaryNodesLieOnTheLastRingAndInteriorOnesOnTheTarget)
{
  for (const char* name : { "ubend", "c_open", "taper10", "twist270_L" })
  {
    const SweepGrids sweep = test::readCase(name);
    Projection projection(sweep);
    vtkUnstructuredGrid* output = projection.run();
    SCOPED_TRACE(name);
    test::expectOnTarget(output, sweep, columnEnds(sweep));
  }
}

TEST(SweepQuadProjector, ScaledJacobianEqualsVerdictOnAPlaneTarget)
{
  Projection projection(test::readCase("taper10"));
  vtkUnstructuredGrid* output = projection.run();
  double low = 1.0;
  double sum = 0.0;
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    const double verdict = vtkMeshQuality::QuadScaledJacobian(output->GetCell(c));
    EXPECT_NEAR(output->GetCellData()->GetArray(hexsweep::arrays::ScaledJacobian)->GetTuple1(c),
      verdict, 1e-9);
    low = std::min(low, verdict);
    sum += verdict;
  }
  EXPECT_NEAR(report(output, hexsweep::reports::MinScaledJacobian), low, 1e-9);
  EXPECT_NEAR(report(output, hexsweep::reports::MeanScaledJacobian),
    sum / static_cast<double>(output->GetNumberOfCells()), 1e-9);
}

TEST(SweepQuadProjector, CellsAndDataAreCarried)
{
  SweepGrids sweep = test::readCase("taper10");
  sweep.sourceQuads = test::withData(sweep.sourceQuads);
  Projection projection(sweep);
  vtkUnstructuredGrid* output = projection.run();
  ASSERT_EQ(output->GetNumberOfCells(), sweep.sourceQuads->GetNumberOfCells());
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    EXPECT_EQ(output->GetCellType(c), VTK_QUAD);
    EXPECT_EQ(test::cornersOf(output, c), test::cornersOf(sweep.sourceQuads, c));
    EXPECT_EQ(
      output->GetCellData()->GetArray("CellNumber")->GetTuple1(c), 1000.0 + static_cast<double>(c));
  }
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(output->GetPointData()->GetArray("PointNumber")->GetTuple1(i),
      100.0 + static_cast<double>(i));
  }
  EXPECT_EQ(report(output, "Note"), 7.0);
  EXPECT_EQ(sweep.sourceQuads->GetFieldData()->GetNumberOfArrays(), 1);
  EXPECT_EQ(sweep.sourceQuads->GetCellData()->GetNumberOfArrays(), 1);
}

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

TEST(SweepQuadProjector, VerdictsAreAboutTheCoordinatesAsStored)
{
  // Far from the origin single precision spoils the quads: the plane target lets Verdict judge.
  const SweepGrids sweep = test::readCase("taper10");
  const auto moved = [](vtkUnstructuredGrid* grid) {
    auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
    result->DeepCopy(grid);
    for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
    {
      double p[3];
      result->GetPoint(i, p);
      result->GetPoints()->SetPoint(i, p[0] + 1e5, p[1], p[2]);
    }
    return result;
  };
  Projection projection({ moved(sweep.sourceQuads), moved(sweep.sourceSurface),
    moved(sweep.targetSurface), moved(sweep.linkingSides) });
  projection.filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  vtkUnstructuredGrid* output = projection.run();
  ASSERT_GT(output->GetNumberOfCells(), 0);
  vtkDataArray* jacobian = output->GetCellData()->GetArray(hexsweep::arrays::ScaledJacobian);
  for (vtkIdType q = 0; q < output->GetNumberOfCells(); ++q)
  {
    EXPECT_NEAR(
      jacobian->GetTuple1(q), vtkMeshQuality::QuadScaledJacobian(output->GetCell(q)), 1e-6)
      << "quad " << q;
  }
}

TEST(SweepQuadProjector, AMethodThatDoesNotExistIsAnError)
{
  Projection projection(test::readCase("ubend"));
  for (const int method : { -1, 3 })
  {
    projection.filter->SetMethod(method);
    expectOneError(projection.filter, "Method " + std::to_string(method) + " does not exist");
  }
}

TEST(SweepQuadProjector, PiecesOfOtherRanks)
{
  auto nothing = vtkSmartPointer<vtkUnstructuredGrid>::New();
  Projection idle({ nothing, nothing, nothing, nothing });
  test::Events silent(idle.filter);
  idle.filter->UpdatePiece(1, 2, 0);
  EXPECT_EQ(silent.errors.size() + silent.warnings.size(), 0u);
  EXPECT_TRUE(test::isEmpty(idle.filter));

  SweepGrids split = test::readCase("ubend");
  split.sourceQuads = nothing;
  Projection part(split);
  test::Events events(part.filter);
  part.filter->UpdatePiece(1, 2, 0);
  ASSERT_EQ(events.errors.size(), 1u);
  EXPECT_NE(events.errors[0].find("target surface"), std::string::npos) << events.errors[0];
  EXPECT_NE(events.errors[0].find("several ranks"), std::string::npos) << events.errors[0];
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

TEST(SweepQuadProjector, AffineLeastSquaresIsTheTraditionalMethod)
{
  Projection projection(test::readCase("taper10"));
  projection.filter->SetMethodToAffineLeastSquares();
  vtkUnstructuredGrid* output = projection.run();
  EXPECT_EQ(test::textReport(output, hexsweep::reports::Method), "AffineLeastSquares");
  for (const int port : { 1, 2 })
  {
    EXPECT_EQ(
      vtkDataSet::SafeDownCast(projection.filter->GetOutputDataObject(port))->GetNumberOfCells(),
      0);
  }
  const auto ends = columnEnds(test::readCase("taper10"));
  const Grid source = test::readGrid("taper10/source_quads");
  for (const auto& side : test::boundaryOf(source))
  {
    EXPECT_EQ(test::pointOf(output, side.first), ends.at(test::pointOf(source, side.first)));
  }
  // A taper is an affine map: the traditional method is right here.
  EXPECT_EQ(report(output, hexsweep::reports::InvertedQuads), 0);
}

TEST(SweepQuadProjector, PaperHarmonicNamesTheNitscheBoundWhereItFolds)
{
  // The hole of Fig. 7 grows from 0.3 of the width to most of it.
  Projection growing(test::readCase("fig7_growing_hole"));
  growing.raw().filter->SetMethodToPaperHarmonic();
  vtkUnstructuredGrid* output = growing.run();
  EXPECT_EQ(test::textReport(output, hexsweep::reports::Method), "PaperHarmonic");
  EXPECT_LT(report(output, hexsweep::reports::NitscheRatio), 1.0);
  const auto flips = static_cast<int>(report(output, hexsweep::reports::FlipsAfter));
  EXPECT_GT(flips, 0);
  ASSERT_GE(growing.events.warnings.size(), 2u);
  EXPECT_NE(growing.events.warnings[0].find(std::to_string(flips) + " of "), std::string::npos);
  const std::string& nitsche = growing.events.warnings[1];
  EXPECT_NE(nitsche.find("Nitsche bound is violated"), std::string::npos) << nitsche;
  EXPECT_NE(nitsche.find(std::to_string(flips) + " triangles"), std::string::npos) << nitsche;

  // A taper changes no shape: nothing folds, nothing is said.
  Projection taper(test::readCase("taper10"));
  taper.raw().filter->SetMethodToPaperHarmonic();
  output = taper.run();
  EXPECT_GT(report(output, hexsweep::reports::NitscheRatio), 1.0);
  EXPECT_EQ(report(output, hexsweep::reports::FlipsAfter), 0);
  EXPECT_EQ(report(output, hexsweep::reports::InvertedQuads), 0);
  EXPECT_TRUE(taper.events.warnings.empty());
}

TEST(SweepQuadProjector, PaperHarmonicWithAnyNumberOfHoles)
{
  for (int holes = 0; holes <= 3; ++holes)
  {
    const SweepGrids sweep = test::plateSweep(holes);
    Projection projection(sweep);
    projection.filter->SetMethodToPaperHarmonic();
    vtkUnstructuredGrid* output = projection.run();
    EXPECT_EQ(report(output, hexsweep::reports::InvertedQuads), 0) << holes;
    EXPECT_EQ(output->GetFieldData()->HasArray(hexsweep::reports::NitscheRatio), holes == 1);
    const auto ends = columnEnds(sweep);
    for (const auto& side : test::boundaryOf(sweep.sourceQuads))
    {
      EXPECT_EQ(
        test::pointOf(output, side.first), ends.at(test::pointOf(sweep.sourceQuads, side.first)));
    }
    // Unlike the common domain, the target's map does not depend on the source's shape.
    auto* target = vtkUnstructuredGrid::SafeDownCast(projection.filter->GetOutputDataObject(2));
    EXPECT_EQ(
      test::textReport(target, hexsweep::arrays::DiskMapDomain), holes == 0 ? "Disk" : "Circles");
  }
}

TEST(SweepQuadProjector, PaperHarmonicMakesItsOwnMaps)
{
  Projection projection(withMaps(test::readCase("taper10")));
  projection.filter->SetMethodToPaperHarmonic();
  projection.filter->SetDiskMapsToFromInput();
  expectOneError(projection.filter, "PaperHarmonic makes disk maps of its own");
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

TEST(SweepQuadProjector, WithoutLinkingSidesTheChosenStartsAreReported)
{
  SweepGrids sweep = test::plateSweep(3);
  sweep.linkingSides = nullptr;
  Projection projection(sweep);
  vtkUnstructuredGrid* output = projection.run();
  vtkDataArray* starts = output->GetFieldData()->GetArray(hexsweep::reports::LoopStarts);
  ASSERT_NE(starts, nullptr);
  EXPECT_EQ(starts->GetNumberOfTuples(), 4);
}

/// Quads of a rectangle, n a side, about the origin at a height, turned in its plane.
Grid rectangleQuads(
  double width, double depth, vtkIdType n, double height, double degrees, double scale)
{
  const double angle = degrees * std::acos(-1.0) / 180.0;
  std::vector<std::array<double, 3>> points;
  std::vector<Corners> quads;
  for (vtkIdType j = 0; j <= n; ++j)
  {
    for (vtkIdType i = 0; i <= n; ++i)
    {
      const double x = width * (static_cast<double>(i) / static_cast<double>(n) - 0.5);
      const double y = depth * (static_cast<double>(j) / static_cast<double>(n) - 0.5);
      points.push_back({ scale * (x * std::cos(angle) - y * std::sin(angle)),
        scale * (x * std::sin(angle) + y * std::cos(angle)), scale * height });
      if (i < n && j < n)
      {
        const vtkIdType p = j * (n + 1) + i;
        quads.push_back({ p, p + 1, p + n + 2, p + n + 1 });
      }
    }
  }
  return test::gridOf(points, quads, VTK_QUAD);
}

TEST(SweepQuadProjector, WithoutLinkingSidesASquareBecomesARectangle)
{
  // Stretching a square keeps its grid: every node is known.
  for (const double depth : { 1.0, 1.5, 3.0 })
  {
    for (const double degrees : { 0.0, 20.0 })
    {
      for (const double scale : { 1e-6, 1.0, 1e6 })
      {
        Projection projection({ rectangleQuads(1, 1, 8, 0.0, 0.0, scale), nullptr,
          rectangleQuads(1, depth, 11, 2.0, degrees, scale), nullptr });
        vtkUnstructuredGrid* output = projection.run();
        const Grid expected = rectangleQuads(1, depth, 8, 2.0, degrees, scale);
        EXPECT_EQ(report(output, hexsweep::reports::InvertedQuads), 0);
        for (const vtkIdType corner : { 0, 8, 72, 80 })
        {
          EXPECT_LT(test::distance(test::pointOf(output, corner), test::pointOf(expected, corner)),
            1e-12 * scale);
        }
        EXPECT_LT(test::greatestDistance(output, expected), 0.05 * scale) << depth << degrees;
        EXPECT_TRUE(projection.events.warnings.empty()) << projection.events.warnings[0];
      }
    }
  }
}

TEST(SweepQuadProjector, AStartThatIsAGuessRaisesAWarning)
{
  Projection projection({ rectangleQuads(1, 1, 8, 0.0, 0.0, 1.0), nullptr,
    rectangleQuads(1, 1, 8, 2.0, 45.0, 1.0), nullptr });
  vtkUnstructuredGrid* output = projection.run();
  EXPECT_EQ(report(output, hexsweep::reports::InvertedQuads), 0);
  ASSERT_EQ(projection.events.warnings.size(), 1u);
  const std::string& warning = projection.events.warnings[0];
  EXPECT_NE(warning.find("loop 0 (the outer one, around (0, 0, 0))"), std::string::npos) << warning;
  EXPECT_NE(warning.find("connect LinkingSides"), std::string::npos) << warning;
}

TEST(SweepQuadProjector, WithoutLinkingSidesTheCasesComeOutAsWithThem)
{
  // Straight sweeps and arcs, without a twist: the linking sides say nothing that shape does not.
  for (const char* name : { "taper10", "c_open", "ubend" })
  {
    SweepGrids sweep = test::readCase(name);
    const auto ends = columnEnds(sweep);
    sweep.linkingSides = nullptr;
    Projection projection(sweep);
    vtkUnstructuredGrid* output = projection.run();
    EXPECT_EQ(report(output, hexsweep::reports::InvertedQuads), 0) << name;
    double farthest = 0.0;
    for (const auto& side : test::boundaryOf(sweep.sourceQuads))
    {
      farthest = std::max(farthest,
        test::distance(test::pointOf(output, side.first),
          ends.at(test::pointOf(sweep.sourceQuads, side.first))));
    }
    EXPECT_LT(farthest, 0.01 * test::sizeOf(sweep.targetSurface)) << name;
  }
}

TEST(SweepQuadProjector, TwiceGivesTheSameBits)
{
  Projection projection(test::readCase("taper10"));
  vtkNew<vtkUnstructuredGrid> first;
  first->DeepCopy(projection.run());
  projection.filter->Modified();
  test::expectSameBits(first, projection.run());
}

TEST(SweepQuadProjector, AbortEmptiesAllOutputs)
{
  Projection projection(test::readCase("taper10"));
  for (const double fraction : { 0.0, 0.2, 0.5, 0.7 })
  {
    test::expectEmptyWhenAborted(projection.filter, fraction);
  }
  EXPECT_GT(projection.run()->GetNumberOfCells(), 0);
}

TEST(SweepQuadProjector, MissingPorts)
{
  const SweepGrids sweep = test::readCase("ubend");
  Projection noQuads({ nullptr, sweep.sourceSurface, sweep.targetSurface, sweep.linkingSides });
  expectOneError(noQuads.filter, "the source quads are missing");
  Projection noTarget({ sweep.sourceQuads, sweep.sourceSurface, nullptr, sweep.linkingSides });
  expectOneError(noTarget.filter, "the target surface is missing");
}

TEST(SweepQuadProjector, EmptyInputs)
{
  const char* names[4] = { "source quads", "target surface", "linking sides", "source surface" };
  for (int port = 0; port < 4; ++port)
  {
    Projection projection(test::readCase("ubend"));
    projection.filter->SetInputData(port, test::emptyGrid());
    expectOneError(projection.filter,
      std::string("the ") + names[port] + (port % 2 == 0 ? " are empty" : " is empty"));
  }
}

TEST(SweepQuadProjector, NotANumber)
{
  const SweepGrids sweep = test::readCase("ubend");
  const Grid bad[4] = { test::withNaN(sweep.sourceQuads), test::withNaN(sweep.targetSurface),
    test::withNaN(sweep.linkingSides), test::withNaN(sweep.sourceSurface) };
  for (int port = 0; port < 4; ++port)
  {
    Projection projection(sweep);
    projection.filter->SetInputData(port, bad[port]);
    expectOneError(projection.filter, "not a finite number");
  }
}

TEST(SweepQuadProjector, SourceThatIsNotAllQuads)
{
  SweepGrids sweep = test::readCase("ubend");
  sweep.sourceQuads = sweep.sourceSurface;
  Projection triangles(sweep);
  expectOneError(triangles.filter, "not a quad");
  sweep = test::readCase("ubend");
  std::swap(sweep.linkingSides, sweep.targetSurface);
  Projection swapped(sweep);
  expectOneError(swapped.filter, "not a quad");
}

TEST(SweepQuadProjector, MixedOrientationOfTheSourceQuads)
{
  SweepGrids sweep = test::readCase("ubend");
  sweep.sourceQuads = test::changedCells(sweep.sourceQuads, [](vtkIdType c, Corners& corners) {
    if (c == 7)
    {
      std::reverse(corners.begin(), corners.end());
    }
  });
  Projection projection(sweep);
  expectOneError(projection.filter, "opposite orientation");
}

TEST(SweepQuadProjector, ClosedSurfaces)
{
  SweepGrids sweep = test::readCase("ubend");
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  Projection target(sweep);
  target.filter->SetInputData(1, sphere->GetOutput());
  expectOneError(target.filter, "closed surface");
  Projection source(sweep);
  source.filter->SetInputData(3, sphere->GetOutput());
  expectOneError(source.filter, "closed surface");

  const std::vector<std::array<double, 3>> corners{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 },
    { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  const Grid box = test::gridOf(corners,
    { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 },
      { 3, 0, 4, 7 } },
    VTK_QUAD);
  sweep.sourceQuads = box;
  Projection quads(sweep);
  expectOneError(quads.filter, "closed surface");
  Projection linking(test::readCase("ubend"));
  linking.filter->SetInputData(2, box);
  expectOneError(linking.filter, "linking sides");
}

TEST(SweepQuadProjector, LoopsThatDoNotMatch)
{
  const SweepGrids sweep = test::readCase("ubend");
  for (const int port : { 1, 2, 3 })
  {
    Projection projection(sweep);
    vtkUnstructuredGrid* grids[4] = { nullptr, sweep.targetSurface, sweep.linkingSides,
      sweep.sourceSurface };
    projection.filter->SetInputData(port,
      test::changedPoints(grids[port], [](vtkIdType, std::array<double, 3>& p) { p[0] *= 1.2; }));
    test::Events events(projection.filter);
    projection.filter->Update();
    EXPECT_EQ(events.errors.size(), 1u) << port;
    EXPECT_TRUE(test::isEmpty(projection.filter)) << port;
  }
  Projection other(sweep);
  other.filter->SetInputData(2, test::readGrid("c_open/linking_quads"));
  test::Events events(other.filter);
  other.filter->Update();
  EXPECT_EQ(events.errors.size(), 1u);
  EXPECT_TRUE(test::isEmpty(other.filter));
}

TEST(SweepQuadProjector, ASurfaceThatIsALittleOffRaisesAWarning)
{
  // Less than a quarter of an edge is no error.
  const SweepGrids plate = test::plateSweep(1);
  const double edge =
    test::distance(test::pointOf(plate.sourceQuads, plate.sourceQuads->GetCell(0)->GetPointId(0)),
      test::pointOf(plate.sourceQuads, plate.sourceQuads->GetCell(0)->GetPointId(1)));
  for (const int port : { 1, 3 })
  {
    for (const std::size_t direction : { 0u, 2u })
    {
      Projection projection(plate);
      vtkUnstructuredGrid* cap = port == 1 ? plate.targetSurface : plate.sourceSurface;
      projection.filter->SetInputData(port,
        test::changedPoints(
          cap, [&](vtkIdType, std::array<double, 3>& p) { p[direction] += 0.1 * edge; }));
      projection.run();
      ASSERT_EQ(projection.events.warnings.size(), 1u) << port << direction;
      EXPECT_NE(projection.events.warnings[0].find(port == 1
                    ? "the boundary of the target surface is not the last ring"
                    : "the boundary of the source surface is not the boundary of the source quads"),
        std::string::npos)
        << projection.events.warnings[0];
    }
  }
}

TEST(SweepQuadProjector, FacetsOfOneCurveRaiseNoWarning)
{
  for (const char* name : { "c_open", "fig7_growing_hole", "fig8_concave_twisted_hole",
         "fig9_spongecake", "gear_round", "taper10", "twist270_L", "ubend" })
  {
    Projection projection(test::readCase(name));
    projection.raw().run();
    for (const std::string& warning : projection.events.warnings)
    {
      EXPECT_EQ(warning.find("the boundary of the"), std::string::npos) << name << ": " << warning;
    }
  }
}

TEST(SweepQuadProjector, DifferentNumbersOfHoles)
{
  const SweepGrids one = test::readCase("ubend");
  const SweepGrids two = test::readCase("taper10");
  for (const bool linked : { true, false })
  {
    for (const int port : { 1, 3 })
    {
      SweepGrids mixed = one;
      (port == 1 ? mixed.targetSurface : mixed.sourceSurface) =
        port == 1 ? two.targetSurface : two.sourceSurface;
      if (!linked)
      {
        mixed.linkingSides = nullptr;
      }
      Projection projection(mixed);
      test::Events events(projection.filter);
      projection.filter->Update();
      EXPECT_EQ(events.errors.size(), 1u) << linked << port;
      EXPECT_TRUE(test::isEmpty(projection.filter));
    }
  }
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
