// SPDX-License-Identifier: BSD-3-Clause
// What vtkCageHexInterior says about hexahedra that are bad, why, and what helps.
#include "CageHexCase.h"

#include "HexSweepArrays.h"

namespace TestCageHexWarnings
{
using hexsweep::Index;
using test::countInverted;
using test::someSweep;
using test::Sweep;
using Case = test::CageHexCase;

TEST(CageHexInterior, InvertedHexesRaiseOneWarning)
{
  Sweep sweep = someSweep();
  // Fold the target: one inner node goes far beyond its neighbours.
  Index inner = -1;
  for (Index i = 0; i < sweep.source.rows() && inner < 0; ++i)
  {
    const double x = sweep.cap(i, 0);
    const double y = sweep.cap(i, 1);
    if (x > 0.2 && x < 0.5 && y > 0.2 && y < 0.8)
    {
      inner = i;
    }
  }
  ASSERT_GE(inner, 0);
  sweep.target.row(inner) = sweep.target.row(0);
  Case input(sweep);
  vtkUnstructuredGrid* output = input.run();
  const vtkIdType inverted = countInverted(output);
  ASSERT_GT(inverted, 0);
  EXPECT_EQ(input.report("Inverted"), inverted);
  EXPECT_EQ(input.events.errors.size(), 0u);
  ASSERT_EQ(input.events.warnings.size(), 1u);
  const std::string& text = input.events.warnings.front();
  EXPECT_NE(text.find(std::to_string(inverted) + " of " +
              std::to_string(output->GetNumberOfCells()) + " hexahedra are inverted"),
    std::string::npos)
    << text;
  EXPECT_NE(text.find("  cell "), std::string::npos) << text;

  Case failing(sweep);
  failing.filter->FailIfInvalidOn();
  failing.expectError("hexahedra are inverted");
}

/// A straight sweep.
Sweep straightSweep(int nx = 12, int ny = 9, int layers = 6)
{
  return test::makeSweep(nx, ny, false, test::evenLayers(layers),
    [](double x, double y, double t) { return Eigen::RowVector3d(x, y, 2 * t); });
}

/// Points of the linking sides at the foot (0, y) of a column, by height.
std::vector<Index> columnAt(const Sweep& sweep, double leastY)
{
  std::vector<Index> column;
  for (Index i = 0; i < sweep.linkingPoints.rows(); ++i)
  {
    const Eigen::RowVector3d p = sweep.linkingPoints.row(i);
    if (p[0] == 0.0 && p[1] > leastY && p[1] < leastY + 0.1)
    {
      column.push_back(i);
    }
  }
  std::sort(column.begin(), column.end(),
    [&](Index a, Index b) { return sweep.linkingPoints(a, 2) < sweep.linkingPoints(b, 2); });
  return column;
}

void expectConflicts(const Sweep& sweep, const std::vector<std::string>& parts)
{
  Case input(sweep);
  vtkUnstructuredGrid* output = input.run();
  EXPECT_TRUE(input.events.errors.empty()) << input.events.errors[0];
  const double conflicts = input.report("CornerConflicts");
  EXPECT_GT(conflicts, 0);
  EXPECT_GT(input.report("NotCertified"), 0);
  // Everything else is mended, and at the first start or a rival of it.
  EXPECT_LE(input.report("NotCertified"), conflicts);
  vtkAbstractArray* steps = output->GetFieldData()->GetAbstractArray(hexsweep::reports::Steps);
  EXPECT_LE(steps->GetNumberOfValues(), 5);
  for (vtkIdType i = 0; i < steps->GetNumberOfValues(); ++i)
  {
    EXPECT_NE(steps->GetVariantValue(i).ToString(), "LayerMarch"); // the next start
  }
  EXPECT_LE(input.report("FloorScaledJacobian"), 0.0);
  ASSERT_EQ(input.events.warnings.size(), 1u);
  const std::string& text = input.events.warnings.front();
  const std::string count =
    "alone make " + std::to_string(static_cast<int>(conflicts)) + " hexahedra bad";
  EXPECT_NE(text.find(count), std::string::npos) << text;
  for (const std::string& part : parts)
  {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in: " << text;
  }
  EXPECT_EQ(text.find("EnsureValid"), std::string::npos) << text;
  EXPECT_EQ(text.find("Automatic"), std::string::npos) << text;
}

TEST(CageHexInterior, WhatTheBoundaryForbidsIsCountedAndNamed)
{
  Sweep folded = straightSweep();
  for (Index i = 0; i < folded.target.rows(); ++i)
  {
    if (std::hypot(folded.cap(i, 0) - 1.0, folded.cap(i, 1) - 0.5) < 0.1)
    {
      folded.target.row(i) += Eigen::RowVector3d(0.25, 0.0, 0.0);
      break;
    }
  }
  expectConflicts(folded, { "the target quads fold", "correct the target quads" });

  Sweep back = straightSweep();
  const std::vector<Index> column = columnAt(back, 0.4);
  ASSERT_EQ(column.size(), 7u);
  back.linkingPoints(column[3], 2) = back.linkingPoints(column[2], 2) - 0.2;
  expectConflicts(back, { "a linking side folds", "mesh this linking side anew" });

  Sweep collapsed = straightSweep();
  collapsed.linkingPoints.row(column[3]) = collapsed.linkingPoints.row(column[2]);
  expectConflicts(collapsed, { "points of a linking side coincide", "move them apart" });
}

TEST(CageHexInterior, AdviceFitsTheSettings)
{
  Sweep sweep = straightSweep(6, 5, 3);
  for (Index i = 0; i < sweep.target.rows(); ++i)
  {
    // Bulges, so that the fold is no proof.
    const double x = sweep.cap(i, 0);
    const double y = sweep.cap(i, 1);
    sweep.target(i, 2) += 0.6 * x * (2 - x) * y * (1 - y);
  }
  for (Index i = 0; i < sweep.target.rows(); ++i)
  {
    if (std::hypot(sweep.cap(i, 0) - 0.5, sweep.cap(i, 1) - 0.3) < 0.2)
    {
      sweep.target.row(i) += Eigen::RowVector3d(0.5, 0.01, 0.0);
      break;
    }
  }
  const auto textOf = [&](bool ensureValid, bool automatic) -> std::string {
    Case input(sweep);
    input.filter->SetEnsureValid(ensureValid);
    if (!automatic)
    {
      input.filter->SetMethodToBlend();
    }
    input.run();
    EXPECT_EQ(input.events.warnings.size(), 1u);
    return input.events.warnings.empty() ? "" : input.events.warnings.front();
  };
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  const std::string off = textOf(false, true);
  EXPECT_TRUE(has(off, "switch EnsureValid on")) << off;
  const std::string one = textOf(true, false);
  EXPECT_TRUE(has(one, "method Automatic") && !has(one, "EnsureValid")) << one;
  const std::string all = textOf(true, true);
  EXPECT_TRUE(has(all, "check the target quads") && !has(all, "Automatic")) << all;
}

TEST(CageHexInterior, WhatSinglePrecisionSpoilsIsNamed)
{
  // A layer is lower than a unit of the last place there.
  Sweep sweep = test::makeSweep(6, 5, false, test::evenLayers(4),
    [](double x, double y, double t) { return Eigen::RowVector3d(x, y, 1e6 + 0.1 * t); });
  Case precise(sweep);
  precise.run();
  EXPECT_TRUE(precise.events.warnings.empty());
  EXPECT_EQ(precise.report("NotCertified"), 0);
  Case single(sweep);
  single.filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  single.run();
  EXPECT_GT(single.report("NotCertified"), 0);
  ASSERT_EQ(single.events.warnings.size(), 1u);
  const std::string& text = single.events.warnings.front();
  EXPECT_NE(text.find("single precision is too coarse"), std::string::npos) << text;
  EXPECT_NE(text.find("set OutputPointsPrecision to double"), std::string::npos) << text;
}
}
