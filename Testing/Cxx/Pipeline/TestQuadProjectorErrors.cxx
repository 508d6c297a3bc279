// SPDX-License-Identifier: BSD-3-Clause
// What vtkSweepQuadProjector refuses.
#include "QuadProjection.h"

#include <vtkSphereSource.h>

namespace TestQuadProjectorErrors
{
using test::Corners;
using test::expectOneError;
using test::Grid;
using test::SweepGrids;
using Projection = test::QuadProjection;

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
}
