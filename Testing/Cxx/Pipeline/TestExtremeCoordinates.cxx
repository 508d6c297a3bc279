// SPDX-License-Identifier: BSD-3-Clause
// Coordinates that cannot be computed with: each filter that makes something of a surface refuses
// them.
#include "EveryFilter.h"

#include <vtkAssemblySweep.h>
#include <vtkHexValidity.h>
#include <vtkManyToManySweep.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOneToOneSweep.h>

#include <cmath>
#include <limits>

namespace TestExtremeCoordinates
{
using namespace test;

using Change = std::function<double(double)>;

vtkSmartPointer<vtkDataObject> changed(vtkDataObject* input, const Change& change)
{
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(input))
  {
    const auto copy = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    for (unsigned int b = 0; b < blocks->GetNumberOfBlocks(); ++b)
    {
      copy->SetBlock(b, vtkDataSet::SafeDownCast(changed(blocks->GetBlock(b), change)));
    }
    return copy;
  }
  return changedPoints(
    vtkUnstructuredGrid::SafeDownCast(input), [&](vtkIdType, std::array<double, 3>& place) {
      std::transform(place.begin(), place.end(), place.begin(), change);
    });
}

struct Extreme
{
  const char* name;
  Change change;
  const char* message;
};

std::vector<Extreme> extremes()
{
  return { { "volumes overflow", [](double x) { return 1e60 * x; }, "is too far out" },
    { "squares overflow", [](double x) { return 1e156 * x; }, "is too far out" },
    { "as large as numbers are", [](double x) { return 1e307 * x; }, "is too far out" },
    { "infinite", [](double x) { return x / 0.0; }, "not a finite number" },
    { "volumes underflow", [](double x) { return 1e-60 * x; }, "it has a size of " },
    { "squares underflow", [](double x) { return 1e-170 * x; }, "it has a size of " },
    { "all digits lost", [](double x) { return 1e15 + x; }, "nearer to the origin" } };
}

class ExtremeCoordinates : public testing::TestWithParam<std::size_t>
{
};

TEST_P(ExtremeCoordinates, AreRefusedOnEveryPort)
{
  const FilterUse& use = everyFilter()[GetParam()];
  if (use.name == "HexValidity" || use.name == "SweepSets")
  {
    GTEST_SKIP() << "judges and sorts whatever there is";
  }
  for (std::size_t port = 0; port < use.inputs.size(); ++port)
  {
    for (const Extreme& extreme : extremes())
    {
      SCOPED_TRACE(use.name + ", " + extreme.name + " on port " + std::to_string(port));
      const vtkSmartPointer<vtkAlgorithm> filter =
        use.on(port, changed(use.inputs[port], extreme.change));
      Events events(filter);
      filter->Update();
      ASSERT_EQ(events.errors.size(), 1u);
      EXPECT_NE(events.errors[0].find(extreme.message), std::string::npos) << events.errors[0];
      EXPECT_EQ(events.errors[0].find("-nan"), std::string::npos) << events.errors[0];
      EXPECT_FALSE(hasOutput(filter));
    }
  }
}

TEST_P(ExtremeCoordinates, AllButDoPass)
{
  const FilterUse& use = everyFilter()[GetParam()];
  for (const double factor : { 1e-40, 1e40 })
  {
    SCOPED_TRACE(use.name + ", times " + std::to_string(factor));
    const vtkSmartPointer<vtkAlgorithm> filter = use.make();
    // Sizes are lengths; none is the sweep's own choice.
    if (auto* sweep = vtkOneToOneSweep::SafeDownCast(filter))
    {
      sweep->SetSize(0.0);
    }
    if (auto* sweep = vtkManyToManySweep::SafeDownCast(filter))
    {
      sweep->SetSize(0.3 * factor);
    }
    if (auto* sweep = vtkAssemblySweep::SafeDownCast(filter))
    {
      sweep->SetSize(0.3 * factor);
    }
    for (std::size_t port = 0; port < use.inputs.size(); ++port)
    {
      filter->SetInputDataObject(static_cast<int>(port),
        changed(use.inputs[port], [factor](double x) { return factor * x; }));
    }
    Events events(filter);
    filter->Update();
    EXPECT_TRUE(events.errors.empty()) << events.errors.front();
    EXPECT_TRUE(hasOutput(filter));
  }
}

INSTANTIATE_TEST_SUITE_P(Filters, ExtremeCoordinates, testing::Range<std::size_t>(0, 13));

TEST(ExtremeCoordinates, WhatDoesNotFitIntoSinglePrecisionIsRefused)
{
  const FilterUse& use = filterUse("OneToOneSweep");
  const vtkSmartPointer<vtkAlgorithm> filter = use.make();
  auto* sweep = vtkOneToOneSweep::SafeDownCast(filter);
  ASSERT_NE(sweep, nullptr);
  sweep->SetSize(0.0);
  sweep->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  filter->SetInputDataObject(0, changed(use.inputs[0], [](double x) { return 3e38 * x; }));
  expectOneError(filter, "single precision");
}

TEST(ExtremeCoordinates, HexahedraOfAnySizeAreJudged)
{
  const FilterUse& use = filterUse("HexValidity");
  auto* given = vtkDataSet::SafeDownCast(use.inputs[0]);
  ASSERT_GT(given->GetNumberOfCells(), 0);
  for (const double factor : { 1e-100, 1e100 })
  {
    const vtkSmartPointer<vtkAlgorithm> filter =
      use.on(0, changed(use.inputs[0], [factor](double x) { return factor * x; }));
    Events events(filter);
    filter->Update();
    EXPECT_TRUE(events.errors.empty());
    auto* hexes = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    EXPECT_EQ(report(hexes, "SweepReportHexes"), static_cast<double>(given->GetNumberOfCells()));
    EXPECT_EQ(report(hexes, "SweepReportNotCertified"), 0.0);
  }
}
}
