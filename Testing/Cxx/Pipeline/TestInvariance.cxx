// SPDX-License-Identifier: BSD-3-Clause
// The projection does not know the unit of length, the axes, or the origin.
#include "CapGrids.h"

#include "HexSweepArrays.h"

#include <vtkSweepQuadProjector.h>

#include <Eigen/Geometry>

namespace TestInvariance
{
using test::Grid;
using test::report;
using test::SweepGrids;

/// x -> scale * turn x + offset, and back.
struct Motion
{
  std::string name;
  double scale;
  Eigen::Matrix3d turn;
  Eigen::Vector3d offset;

  Grid apply(vtkUnstructuredGrid* grid) const
  {
    return test::changedPoints(grid, [this](vtkIdType, std::array<double, 3>& p) {
      Eigen::Map<Eigen::Vector3d> x(p.data());
      x = (this->scale * (this->turn * x) + this->offset).eval();
    });
  }
  Grid undo(vtkUnstructuredGrid* grid) const
  {
    return test::changedPoints(grid, [this](vtkIdType, std::array<double, 3>& p) {
      Eigen::Map<Eigen::Vector3d> x(p.data());
      x = (this->turn.transpose() * (x - this->offset) / this->scale).eval();
    });
  }
  SweepGrids apply(const SweepGrids& sweep) const
  {
    return { this->apply(sweep.sourceQuads), this->apply(sweep.sourceSurface),
      this->apply(sweep.targetSurface), this->apply(sweep.linkingSides) };
  }
};

Eigen::Matrix3d someTurn()
{
  return (Eigen::AngleAxisd(0.9, Eigen::Vector3d(0.3, 1.0, -0.4).normalized()) *
    Eigen::AngleAxisd(2.1, Eigen::Vector3d::UnitZ()))
    .toRotationMatrix();
}

struct Result
{
  Grid quads;
  Grid sourceDisk;
  Grid targetDisk;
};

enum class Setting
{
  Default,
  AsProjected,
  Pinned
};

Result project(const SweepGrids& sweep, Setting setting)
{
  vtkNew<vtkSweepQuadProjector> filter;
  filter->SetInputData(0, sweep.sourceQuads);
  filter->SetInputData(1, sweep.targetSurface);
  filter->SetInputData(2, sweep.linkingSides);
  filter->SetInputData(3, sweep.sourceSurface);
  if (setting != Setting::Default)
  {
    filter->EnsureValidOff();
    filter->ImproveQualityOff();
  }
  if (setting == Setting::Pinned)
  {
    filter->SetMethodToPaperHarmonic();
  }
  test::Events events(filter);
  filter->Update();
  EXPECT_TRUE(events.errors.empty()) << events.errors[0];
  Result result;
  result.quads = filter->GetOutput();
  result.sourceDisk = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(1));
  result.targetDisk = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(2));
  return result;
}

double diskDistance(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  vtkDataArray* one = a->GetPointData()->GetArray(hexsweep::arrays::DiskCoordinates);
  vtkDataArray* other = b->GetPointData()->GetArray(hexsweep::arrays::DiskCoordinates);
  double greatest = one->GetNumberOfTuples() == other->GetNumberOfTuples() ? 0.0 : VTK_DOUBLE_MAX;
  for (vtkIdType i = 0; greatest < 1e9 && i < one->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 2; ++c)
    {
      greatest = std::max(greatest, std::abs(one->GetComponent(i, c) - other->GetComponent(i, c)));
    }
  }
  return greatest;
}

/// A sweep, and how far from the origin it is tried, in sizes.
struct InvarianceCase
{
  std::string name;
  double farAway;
  double roundings; ///< of coordinates that far away, which descents amplify
};

std::ostream& operator<<(std::ostream& out, const InvarianceCase& sweep)
{
  return out << sweep.name;
}

SweepGrids sweepNamed(const std::string& name)
{
  return name.rfind("plate", 0) == 0 ? test::plateSweep(std::stoi(name.substr(5)))
                                     : test::readCase(name);
}

class Invariance : public testing::TestWithParam<InvarianceCase>
{
};

TEST_P(Invariance, OfDiskMapsAndQuads)
{
  const SweepGrids sweep = sweepNamed(GetParam().name);
  const double size = std::max(test::sizeOf(sweep.targetSurface), test::sizeOf(sweep.sourceQuads));
  const Eigen::Matrix3d upright = Eigen::Matrix3d::Identity();
  const Eigen::Vector3d away =
    GetParam().farAway * size * Eigen::Vector3d(1.0, -2.0, 0.5).normalized();
  const std::vector<Motion> motions{ { "small", 1e-6, upright, { 0, 0, 0 } },
    { "large", 1e6, upright, { 0, 0, 0 } }, { "turned", 1.0, someTurn(), { 0, 0, 0 } },
    { "large, turned", 1e6, someTurn(), { 0, 0, 0 } }, { "far away", 1.0, upright, away },
    { "small, turned, far away", 1e-6, someTurn(), 1e-6 * away } };
  for (const Setting setting : { Setting::Default, Setting::AsProjected, Setting::Pinned })
  {
    const Result reference = project(sweep, setting);
    for (const Motion& motion : motions)
    {
      SCOPED_TRACE(motion.name + ", setting " + std::to_string(static_cast<int>(setting)));
      const bool isFar = motion.offset.norm() > 0.0;
      const Result moved = project(motion.apply(sweep), setting);
      const double tolerance = isFar
        ? GetParam().roundings * std::numeric_limits<double>::epsilon() * GetParam().farAway
        : 1e-11;
      EXPECT_LT(
        test::greatestDistance(motion.undo(moved.quads), reference.quads), tolerance * size);
      const double diskTolerance = isFar ? 4e-9 : 1e-11;
      EXPECT_LT(diskDistance(moved.sourceDisk, reference.sourceDisk), diskTolerance);
      EXPECT_LT(diskDistance(moved.targetDisk, reference.targetDisk), diskTolerance);
      if (setting == Setting::Pinned)
      {
        // Where that map folds, nodes gather on the rim of the hole: quads there have no area, and
        // rounding gives it a sign.
        continue;
      }
      for (const char* count : { hexsweep::reports::InvertedQuads,
             hexsweep::reports::InvertedBefore, hexsweep::reports::Rounds })
      {
        EXPECT_EQ(report(moved.quads, count), report(reference.quads, count)) << count;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sweeps, Invariance,
  testing::Values(InvarianceCase{ "plate0", 1e6, 16.0 }, InvarianceCase{ "plate1", 1e6, 16.0 },
    InvarianceCase{ "plate3", 1e6, 16.0 }, InvarianceCase{ "gear_round", 1e6, 64.0 },
    InvarianceCase{ "fig8_concave_twisted_hole", 3e3, 128.0 }),
  [](const auto& sweep) { return sweep.param.name; });
}
