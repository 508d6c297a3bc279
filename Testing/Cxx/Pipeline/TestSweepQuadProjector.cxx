// SPDX-License-Identifier: BSD-3-Clause
// vtkSweepQuadProjector: where nodes go, by each method, and what it carries.
#include "QuadProjection.h"

#include "HexSweepArrays.h"

#include <vtkMeshQuality.h>

namespace TestSweepQuadProjector
{
using test::expectOneError;
using test::Grid;
using test::report;
using test::SweepGrids;
using Projection = test::QuadProjection;

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

TEST(SweepQuadProjector, AMethodThatDoesNotExistIsAnError)
{
  Projection projection(test::readCase("ubend"));
  for (const int method : { -1, 3 })
  {
    projection.filter->SetMethod(method);
    expectOneError(projection.filter, "Method " + std::to_string(method) + " does not exist");
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
}
