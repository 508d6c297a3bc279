// SPDX-License-Identifier: BSD-3-Clause
// Which loop of the target belongs to which of the source, and where they begin:
// vtkSweepQuadProjector without linking sides, and with loops that do not fit.
#include "QuadProjection.h"

#include "HexSweepArrays.h"

namespace TestQuadProjectorLoops
{
using test::Corners;
using test::Grid;
using test::report;
using test::SweepGrids;
using Projection = test::QuadProjection;

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
}
