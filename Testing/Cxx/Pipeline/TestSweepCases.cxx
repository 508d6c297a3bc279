// SPDX-License-Identifier: BSD-3-Clause
// From the files of each case to quads and hexes, all settings at their defaults.
#include "CapGrids.h"

#include "HexSweepArrays.h"

#include <vtkCageHexInterior.h>
#include <vtkSweepQuadProjector.h>

#include <vtkMeshQuality.h>

#include <algorithm>
#include <string>
#include <vector>

namespace TestSweepCases
{
using test::report;

/// Least and mean scaled Jacobian of the quads and of the hexes that a first, plain implementation
/// of the same methods reached. gear_round's minimum is that of a corner between fixed edges.
struct Reached
{
  const char* name;
  double quadMinimum, quadMean, hexMinimum, hexMean;
};

void PrintTo(const Reached& reached, std::ostream* os)
{
  *os << reached.name;
}

class SweepCases : public testing::TestWithParam<Reached>
{
};

constexpr double LeastShare = 0.95; // of a minimum
constexpr double MeanRoom = 0.005;

/// Quads and hexes of a sweep, all settings at their defaults.
struct Swept
{
  vtkNew<vtkSweepQuadProjector> projector;
  vtkNew<vtkCageHexInterior> interior;
  test::Events projectorEvents;
  test::Events interiorEvents;

  explicit Swept(const test::SweepGrids& sweep)
    : projectorEvents(projector)
    , interiorEvents(interior)
  {
    this->projector->SetInputData(0, sweep.sourceQuads);
    this->projector->SetInputData(1, sweep.targetSurface);
    this->projector->SetInputData(2, sweep.linkingSides);
    this->projector->SetInputData(3, sweep.sourceSurface);
    this->interior->SetInputData(0, sweep.sourceQuads);
    this->interior->SetInputConnection(1, this->projector->GetOutputPort());
    this->interior->SetInputData(2, sweep.linkingSides);
    this->interior->Update();
  }
};

struct HexCount
{
  vtkIdType hexes = 0;
  vtkIdType inverted = 0;
  vtkIdType notCertified = 0;
  double minimum = 1.0;
  double mean = 0.0;
};

/// By Verdict, but for the certificates.
HexCount count(vtkUnstructuredGrid* grid)
{
  HexCount result;
  vtkDataArray* validity = grid->GetCellData()->GetArray(hexsweep::arrays::Validity);
  result.hexes = grid->GetNumberOfCells();
  for (vtkIdType h = 0; h < result.hexes; ++h)
  {
    const double quality = vtkMeshQuality::HexScaledJacobian(grid->GetCell(h));
    EXPECT_LE(quality, 1.0 + 1e-12) << "Verdict's mark of a collapsed edge";
    result.inverted += quality <= 0.0;
    result.notCertified += validity->GetTuple1(h) != 0.0;
    result.minimum = std::min(result.minimum, quality);
    result.mean += quality / static_cast<double>(result.hexes);
  }
  return result;
}

TEST_P(SweepCases, EveryElementIsValid)
{
  const Reached& reached = GetParam();
  Swept swept(test::readCase(reached.name));
  vtkUnstructuredGrid* quads = swept.projector->GetOutput();
  ASSERT_GT(quads->GetNumberOfCells(), 0);
  EXPECT_TRUE(swept.projectorEvents.warnings.empty()) << swept.projectorEvents.warnings[0];
  EXPECT_EQ(report(quads, hexsweep::reports::InvertedQuads), 0);
  EXPECT_EQ(report(quads, hexsweep::reports::FlipsAfter), 0);
  EXPECT_GE(report(quads, hexsweep::reports::MinScaledJacobian), LeastShare * reached.quadMinimum);
  EXPECT_GE(report(quads, hexsweep::reports::MeanScaledJacobian), reached.quadMean - MeanRoom);

  const HexCount hexes = count(swept.interior->GetOutput());
  ASSERT_GT(hexes.hexes, 0);
  EXPECT_EQ(hexes.inverted, 0);
  EXPECT_EQ(hexes.notCertified, 0);
  EXPECT_GE(hexes.minimum, LeastShare * reached.hexMinimum);
  EXPECT_GE(hexes.mean, reached.hexMean - MeanRoom);
  EXPECT_TRUE(swept.interiorEvents.warnings.empty()) << swept.interiorEvents.warnings[0];
}

INSTANTIATE_TEST_SUITE_P(Data, SweepCases,
  testing::Values(Reached{ "fig7_growing_hole", 0.200, 0.766, 0.19, 0.88 },
    Reached{ "fig8_concave_twisted_hole", 0.074, 0.751, 0.07, 0.88 },
    Reached{ "fig9_spongecake", 0.049, 0.600, 0.04, 0.77 },
    Reached{ "ubend", 0.706, 0.960, 0.68, 0.96 }, Reached{ "twist270_L", 0.651, 0.960, 0.54, 0.81 },
    Reached{ "taper10", 0.369, 0.903, 0.30, 0.87 },
    Reached{ "gear_round", 0.039, 0.826, 0.04, 0.90 },
    Reached{ "c_open", 0.797, 0.994, 0.73, 0.97 },
    Reached{ "hole_moves", 0.135, 0.484, 0.14, 0.78 },
    Reached{ "holes40", 0.087, 0.900, 0.08, 0.91 },
    Reached{ "fine_coarse", 0.565, 0.922, 0.54, 0.94 },
    Reached{ "hole_twist120", 0.091, 0.633, 0.08, 0.78 },
    Reached{ "chord_mismatch", 0.374, 0.889, 0.35, 0.89 }),
  [](const testing::TestParamInfo<Reached>& test) { return std::string(test.param.name); });

/// A surface over the plane: height of the place (u, v), both in [-1, 1], the radius being 1.
struct Bend
{
  const char* name;
  double (*height)(double u, double v);
  double atSource;
  double atTarget;
};

double sphere(double u, double v)
{
  return std::sqrt(1.25 * 1.25 - std::min(u * u + v * v, 1.5)) - 1.25;
}
double saddle(double u, double v)
{
  return 0.45 * (u * u - v * v);
}
double cone(double u, double v)
{
  return -0.6 * std::hypot(u, v);
}

/// A sweep along z, both caps bent onto the surface, rings and linking sides with them.
test::SweepGrids bent(const test::SweepGrids& sweep, const Bend& bend)
{
  const double* source = sweep.sourceQuads->GetBounds();
  const double from = source[4];
  const double to = sweep.targetSurface->GetBounds()[4];
  const double middle[2] = { 0.5 * (source[0] + source[1]), 0.5 * (source[2] + source[3]) };
  const double radius = 0.5 * std::hypot(source[1] - source[0], source[3] - source[2]);
  const auto change = [&](vtkIdType, std::array<double, 3>& p) {
    const double t = (p[2] - from) / (to - from);
    const double amount = (1.0 - t) * bend.atSource + t * bend.atTarget;
    p[2] += amount * radius * bend.height((p[0] - middle[0]) / radius, (p[1] - middle[1]) / radius);
  };
  return { test::changedPoints(sweep.sourceQuads, change),
    test::changedPoints(sweep.sourceSurface, change),
    test::changedPoints(sweep.targetSurface, change),
    test::changedPoints(sweep.linkingSides, change) };
}

void PrintTo(const Bend& bend, std::ostream* os)
{
  *os << bend.name;
}

/// Least and mean scaled Jacobian that the hexes of a bent case have reached.
struct BentReached
{
  const char* name;
  const char* bend;
  double minimum, mean;
};

BentReached bentReached(const std::string& name, const std::string& bend)
{
  static const std::vector<BentReached> all{ { "c_open", "sphere", 0.090, 0.900 },
    { "c_open", "saddle", 0.682, 0.922 }, { "c_open", "cone", 0.693, 0.921 },
    { "c_open", "sphereOneCap", 0.189, 0.960 }, { "c_open", "saddleOpposite", 0.679, 0.954 },
    { "c_open", "coneOpposite", 0.642, 0.944 },
    { "fig8_concave_twisted_hole", "sphere", 0.131, 0.849 },
    { "fig8_concave_twisted_hole", "saddle", 0.114, 0.813 },
    { "fig8_concave_twisted_hole", "cone", 0.107, 0.823 },
    { "fig8_concave_twisted_hole", "sphereOneCap", 0.164, 0.880 },
    { "fig8_concave_twisted_hole", "saddleOpposite", 0.170, 0.877 },
    { "fig8_concave_twisted_hole", "coneOpposite", 0.156, 0.873 },
    { "gear_round", "sphere", 0.039, 0.878 }, { "gear_round", "saddle", 0.031, 0.865 },
    { "gear_round", "cone", 0.039, 0.846 }, { "gear_round", "sphereOneCap", 0.039, 0.913 },
    { "gear_round", "saddleOpposite", 0.036, 0.912 },
    { "gear_round", "coneOpposite", 0.039, 0.905 }, { "hole_twist120", "sphere", 0.211, 0.720 },
    { "hole_twist120", "saddle", 0.170, 0.719 }, { "hole_twist120", "cone", 0.176, 0.719 },
    { "hole_twist120", "sphereOneCap", 0.189, 0.778 },
    { "hole_twist120", "saddleOpposite", 0.161, 0.779 },
    { "hole_twist120", "coneOpposite", 0.194, 0.777 } };
  const auto found = std::find_if(all.begin(), all.end(),
    [&](const BentReached& reached) { return name == reached.name && bend == reached.bend; });
  EXPECT_NE(found, all.end()) << name << " " << bend;
  return found == all.end() ? BentReached{ "", "", 1.0, 1.0 } : *found;
}

class BentSweeps : public testing::TestWithParam<std::tuple<const char*, Bend>>
{
};

TEST_P(BentSweeps, EveryElementIsValid)
{
  const auto& [name, bend] = GetParam();
  Swept swept(bent(test::readCase(name), bend));
  ASSERT_GT(swept.projector->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(report(swept.projector->GetOutput(), hexsweep::reports::InvertedQuads), 0);
  const HexCount hexes = count(swept.interior->GetOutput());
  ASSERT_GT(hexes.hexes, 0);
  EXPECT_EQ(hexes.inverted, 0);
  EXPECT_EQ(hexes.notCertified, 0);
  const BentReached reached = bentReached(name, bend.name);
  EXPECT_GE(hexes.minimum, LeastShare * reached.minimum);
  EXPECT_GE(hexes.mean, reached.mean - MeanRoom);
}

INSTANTIATE_TEST_SUITE_P(Data, BentSweeps,
  testing::Combine(
    testing::Values("c_open", "fig8_concave_twisted_hole", "gear_round", "hole_twist120"),
    testing::Values(Bend{ "sphere", sphere, 0.8, 0.8 }, Bend{ "saddle", saddle, 0.8, 0.8 },
      Bend{ "cone", cone, 0.8, 0.8 }, Bend{ "sphereOneCap", sphere, 0.0, 0.5 },
      Bend{ "saddleOpposite", saddle, -0.4, 0.4 }, Bend{ "coneOpposite", cone, -0.4, 0.4 })),
  [](const auto& test) {
    return std::string(std::get<0>(test.param)) + "_" + std::get<1>(test.param).name;
  });
}
