// SPDX-License-Identifier: BSD-3-Clause
// vtkHarmonicDiskMap with Koebe's iteration: domains, reports, rounds.
#include "DiskMapping.h"

#include "HexSweepArrays.h"

#include <vtkCallbackCommand.h>

#include <sstream>

namespace TestDiskMapKoebe
{
using test::Corners;
using test::diskPoint;
using test::expectOriginals;
using test::Grid;
using test::report;
using test::textReport;
using Map = test::DiskMapping;

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
