// SPDX-License-Identifier: BSD-3-Clause
// One rule for all filters: what means nothing is an error at run that names what does; what is
// missing is named; reports say what ran.
#include "CapGrids.h"
#include "Core/Interior/InteriorStarts.h"
#include "HexSweepArrays.h"
#include "SolidGrids.h"

#include <vtkCageHexInterior.h>
#include <vtkFieldData.h>
#include <vtkHarmonicDiskMap.h>
#include <vtkLinkingSideMesher.h>
#include <vtkOneToOneSweep.h>
#include <vtkSweepQuadProjector.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace TestChoices
{
using test::expectOneError;
namespace reports = hexsweep::reports;

/// Numbers beside those that exist, each of which must be refused by name.
void expectRefused(vtkAlgorithm* filter, const std::function<void(int)>& set, int count,
  const std::string& property, const std::string& last)
{
  for (const int value : { -1, count })
  {
    set(value);
    expectOneError(filter, property + " " + std::to_string(value) + " does not exist");
    filter->Modified();
    expectOneError(filter, " or " + last + " (" + std::to_string(count - 1) + ").");
  }
  set(0);
}

test::SweepGrids caps()
{
  return test::plateSweep(1);
}

TEST(Choices, OfTheDiskMap)
{
  const test::SweepGrids sweep = caps();
  vtkNew<vtkHarmonicDiskMap> filter;
  filter->SetInputData(sweep.sourceSurface);
  expectRefused(
    filter, [&](int v) { filter->SetWeights(v); }, 2, "Weights", "MeanValue");
  expectRefused(
    filter, [&](int v) { filter->SetImproveTriangulation(v); }, 3, "ImproveTriangulation", "On");
  expectRefused(
    filter, [&](int v) { filter->SetHoleTreatment(v); }, 3, "HoleTreatment", "Filled");
  expectRefused(
    filter, [&](int v) { filter->SetOutputPointsPrecision(v); }, 3, "OutputPointsPrecision",
    "Default");
}

TEST(Choices, OfTheProjector)
{
  const test::SweepGrids sweep = caps();
  vtkNew<vtkSweepQuadProjector> filter;
  filter->SetSourceQuadsData(sweep.sourceQuads);
  filter->SetTargetSurfaceData(sweep.targetSurface);
  filter->SetSourceSurfaceData(sweep.sourceSurface);
  expectRefused(
    filter, [&](int v) { filter->SetMethod(v); }, 3, "Method", "AffineLeastSquares");
  expectRefused(
    filter, [&](int v) { filter->SetDiskMaps(v); }, 2, "DiskMaps", "FromInput");
  expectRefused(
    filter, [&](int v) { filter->SetWeights(v); }, 2, "Weights", "MeanValue");
  expectRefused(
    filter, [&](int v) { filter->SetImproveTriangulation(v); }, 3, "ImproveTriangulation", "On");
  expectRefused(
    filter, [&](int v) { filter->SetOutputPointsPrecision(v); }, 3, "OutputPointsPrecision",
    "Default");
}

TEST(Choices, OfTheSolidSweep)
{
  vtkNew<vtkOneToOneSweep> filter;
  filter->SetSolidData(test::solidGrid("wing"));
  filter->AddSourceFaceId(3);
  const std::vector<std::string> methods = hexsweep::interiorMethodNames();
  expectRefused(
    filter, [&](int v) { filter->SetMethod(v); }, static_cast<int>(methods.size()), "Method",
    methods.back());
  expectRefused(
    filter, [&](int v) { filter->SetProjectionMethod(v); }, 3, "ProjectionMethod",
    "AffineLeastSquares");
  expectRefused(
    filter, [&](int v) { filter->SetWeights(v); }, 2, "Weights", "MeanValue");
  expectRefused(
    filter, [&](int v) { filter->SetImproveTriangulation(v); }, 3, "ImproveTriangulation", "On");
  for (const double angle : { 0.0, 180.0, std::numeric_limits<double>::quiet_NaN() })
  {
    filter->SetFeatureAngle(angle);
    expectOneError(filter, "FeatureAngle");
  }
  filter->SetFeatureAngle(30.0);
  filter->SetNumberOfLayers(-1);
  expectOneError(filter, "the number of layers is -1");
  filter->SetLayerSize(-1.0);
  expectOneError(filter, "the layer size is -1");
  filter->SetLayerSize(1.0);
  filter->SetGrowthRatio(0.0);
  expectOneError(filter, "the growth ratio is 0");
}

TEST(Choices, MissingInputsAreNamed)
{
  vtkNew<vtkHarmonicDiskMap> map;
  expectOneError(map, "the input surface is missing");
  vtkNew<vtkSweepQuadProjector> projector;
  expectOneError(projector, "the source quads are missing");
  projector->SetSourceQuadsData(caps().sourceQuads);
  expectOneError(projector, "the target surface is missing");
  vtkNew<vtkLinkingSideMesher> mesher;
  expectOneError(mesher, "the source quads are missing");
  mesher->SetSourceQuadsData(caps().sourceQuads);
  expectOneError(mesher, "missing");
  vtkNew<vtkOneToOneSweep> solid;
  expectOneError(solid, "the solid is missing");
  vtkNew<vtkCageHexInterior> interior;
  expectOneError(interior, "the source quads are missing");
}

TEST(Choices, WeightsOfTheProjectorAreReportedAndMatter)
{
  const test::SweepGrids sweep = caps();
  vtkNew<vtkSweepQuadProjector> filter;
  filter->SetSourceQuadsData(sweep.sourceQuads);
  filter->SetTargetSurfaceData(sweep.targetSurface);
  filter->SetSourceSurfaceData(sweep.sourceSurface);
  filter->EnsureValidOff();
  filter->ImproveQualityOff();
  filter->SetImproveTriangulationToOff();
  filter->Update();
  test::Grid cotangent = test::Grid::New();
  cotangent->DeepCopy(filter->GetOutput());
  EXPECT_EQ(test::textReport(cotangent, reports::Weights), "Cotangent");
  EXPECT_EQ(test::textReport(cotangent, reports::Method), "Harmonic");
  filter->SetWeightsToMeanValue();
  filter->Update();
  EXPECT_EQ(test::textReport(filter->GetOutput(), reports::Weights), "MeanValue");
  double difference = 0.0;
  for (vtkIdType i = 0; i < cotangent->GetNumberOfPoints(); ++i)
  {
    double a[3];
    double b[3];
    cotangent->GetPoint(i, a);
    filter->GetOutput()->GetPoint(i, b);
    difference = std::max(difference, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
  }
  EXPECT_GT(difference, 1e-9);
}

TEST(Choices, TheSolidSweepProjectsAsAsked)
{
  vtkNew<vtkOneToOneSweep> filter;
  filter->SetSolidData(test::solidGrid("wing"));
  filter->AddSourceFaceId(3);
  filter->AddTargetFaceId(4);
  filter->SetNumberOfLayers(4);
  filter->Update();
  auto* output = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(test::textReport(output, reports::Projection), "Harmonic");
  filter->SetProjectionMethodToAffineLeastSquares();
  filter->Update();
  output = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_GT(output->GetNumberOfCells(), 0);
  EXPECT_EQ(test::textReport(output, reports::Projection), "AffineLeastSquares");
  EXPECT_FALSE(output->GetFieldData()->HasArray(reports::Weights));
}
}
