// SPDX-License-Identifier: BSD-3-Clause
// What vtkHarmonicDiskMap refuses.
#include "DiskMapping.h"

#include <vtkSphereSource.h>

namespace TestDiskMapErrors
{
using test::Corners;
using test::expectOneError;
using test::Grid;
using Map = test::DiskMapping;

Grid moebiusStrip()
{
  std::vector<std::array<double, 3>> points;
  std::vector<Corners> quads;
  const vtkIdType n = 9;
  for (vtkIdType i = 0; i < n; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * static_cast<double>(i) / static_cast<double>(n);
    for (const double side : { -0.3, 0.3 })
    {
      const double r = 1.0 + side * std::cos(angle / 2.0);
      points.push_back({ r * std::cos(angle), r * std::sin(angle), side * std::sin(angle / 2.0) });
    }
    const bool last = i + 1 == n;
    quads.push_back({ 2 * i, last ? 1 : 2 * i + 2, last ? 0 : 2 * i + 3, 2 * i + 1 });
  }
  return test::gridOf(points, quads, VTK_QUAD);
}

TEST(HarmonicDiskMap, MissingInput)
{
  vtkNew<vtkHarmonicDiskMap> filter;
  test::expectOneError(filter, "the input surface is missing");
}

TEST(HarmonicDiskMap, EmptyInput)
{
  Map map(test::emptyGrid());
  expectOneError(map.filter, "the input surface is empty");
  const Grid points = test::readGrid("ubend/target_surface");
  Grid noCells = Grid::New();
  noCells->SetPoints(points->GetPoints());
  Map noCellsMap(noCells);
  expectOneError(noCellsMap.filter, "no cells");
  Map vertices(test::gridOf({ { 0, 0, 0 } }, { { 0 } }, VTK_VERTEX));
  expectOneError(vertices.filter, "no surface cells");
}

TEST(HarmonicDiskMap, EmptyPartnerAndLinkingSides)
{
  const test::SweepGrids sweep = test::readCase("ubend");
  Map partner(sweep.sourceSurface, test::emptyGrid());
  expectOneError(partner.filter, "the partner surface is empty");
  Map linking(sweep.sourceSurface, sweep.targetSurface, test::emptyGrid());
  expectOneError(linking.filter, "the linking sides are empty");
}

TEST(HarmonicDiskMap, ClosedSurface)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  Map map(sphere->GetOutput());
  expectOneError(map.filter, "closed surface");
  const test::SweepGrids sweep = test::readCase("ubend");
  Map partner(sweep.sourceSurface, sphere->GetOutput(), sweep.linkingSides);
  expectOneError(partner.filter, "closed surface");
}

TEST(HarmonicDiskMap, NotANumber)
{
  const test::SweepGrids sweep = test::readCase("ubend");
  Map map(test::withNaN(sweep.sourceSurface));
  expectOneError(map.filter, "not a finite number");
  Map partner(sweep.sourceSurface, test::withNaN(sweep.targetSurface), sweep.linkingSides);
  expectOneError(partner.filter, "not a finite number");
  Map linking(sweep.sourceSurface, sweep.targetSurface, test::withNaN(sweep.linkingSides));
  expectOneError(linking.filter, "not a finite number");
}

TEST(HarmonicDiskMap, MoebiusStrip)
{
  Map map(moebiusStrip());
  expectOneError(map.filter, "Moebius");
}

TEST(HarmonicDiskMap, SurfacesThatAreNoManifold)
{
  const std::vector<std::array<double, 3>> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
    { 0, 0, 1 }, { 0, -1, 0 }, { -1, 0, 0 } };
  Map edge(test::gridOf(points, { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } }, VTK_TRIANGLE));
  expectOneError(edge.filter, "more than two faces");
  Map point(test::gridOf(points, { { 0, 1, 2 }, { 0, 4, 5 } }, VTK_TRIANGLE));
  expectOneError(point.filter, "point 0");
  Map pieces(test::gridOf(points, { { 0, 1, 2 }, { 3, 4, 5 } }, VTK_TRIANGLE));
  expectOneError(pieces.filter, "the input surface falls into 2 pieces");
  Map collapsed(test::gridOf(points, { { 0, 1, 1 } }, VTK_TRIANGLE));
  expectOneError(collapsed.filter, "twice");
  Map flat(test::gridOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, { { 0, 1, 2 } }, VTK_TRIANGLE));
  expectOneError(flat.filter, "no area");
}

TEST(HarmonicDiskMap, ACellWithoutAreaIsNamedAsTheUserSeesIt)
{
  // The vertex cell counts: cell 2 is the third of the data set, the second triangle.
  const Grid good = test::readCase("taper10").sourceSurface;
  Grid flat =
    test::gridOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 2, 0 } }, {}, VTK_TRIANGLE);
  for (const Corners& corners : { Corners{ 0 }, Corners{ 0, 1, 2 }, Corners{ 0, 2, 3 } })
  {
    flat->InsertNextCell(corners.size() == 1 ? VTK_VERTEX : VTK_TRIANGLE,
      static_cast<vtkIdType>(corners.size()), corners.data());
  }
  Map input(flat);
  expectOneError(input.filter, "the input surface: cell 2 at (0, 1, 0) has no area");
  Map partner(good, flat);
  expectOneError(partner.filter, "the partner surface: cell 2 at (0, 1, 0) has no area");
}

TEST(HarmonicDiskMap, CellsThatAreNoSurface)
{
  const std::vector<std::array<double, 3>> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
    { 0, 0, 1 }, { 0.5, 0.5, 0 }, { 0, 0.5, 0.1 } };
  Map volume(test::gridOf(points, { { 0, 1, 2, 3 } }, VTK_TETRA));
  expectOneError(volume.filter, "volume cell");
  Map quadratic(test::gridOf(points, { { 0, 1, 2, 3, 4, 5 } }, VTK_QUADRATIC_TRIANGLE));
  expectOneError(quadratic.filter, "linearise");
}

TEST(HarmonicDiskMap, DifferentNumbersOfHoles)
{
  const test::SweepGrids one = test::readCase("ubend");
  const test::SweepGrids two = test::readCase("taper10");
  Map map(one.sourceSurface, two.targetSurface, one.linkingSides);
  test::Events events(map.filter);
  map.filter->Update();
  EXPECT_EQ(events.errors.size(), 1u);
  EXPECT_TRUE(test::isEmpty(map.filter));
  Map byShape(one.sourceSurface, two.targetSurface);
  expectOneError(byShape.filter, "the input surface has 1 boundary loop(s), the partner surface 2");
}

TEST(HarmonicDiskMap, LoopsThatDoNotMatch)
{
  const test::SweepGrids sweep = test::readCase("ubend");
  // Linking sides that are a bit too wide, and those of another volume.
  const Grid wide = test::changedPoints(
    sweep.linkingSides, [](vtkIdType, std::array<double, 3>& p) { p[0] *= 1.2; });
  Map map(sweep.sourceSurface, sweep.targetSurface, wide);
  expectOneError(map.filter, "a loop of the linking sides does not lie on the boundary of the ");
  Map other(sweep.sourceSurface, sweep.targetSurface, test::readGrid("c_open/linking_quads"));
  test::Events events(other.filter);
  other.filter->Update();
  EXPECT_EQ(events.errors.size(), 1u);
  EXPECT_TRUE(test::isEmpty(other.filter));
}

TEST(HarmonicDiskMap, UnknownHoleTreatmentIsAnError)
{
  Map map(test::plateSweep(3).sourceSurface);
  map.filter->SetHoleTreatment(7);
  expectOneError(map.filter, "HoleTreatment 7 does not exist");
}

TEST(HarmonicDiskMap, ErrorsDoNotLast)
{
  Map map(test::withNaN(test::readGrid("ubend/target_surface")));
  expectOneError(map.filter, "not a finite number");
  map.filter->SetInputData(test::readGrid("ubend/target_surface"));
  map.filter->Update();
  EXPECT_GT(map.filter->GetOutput()->GetNumberOfCells(), 0);
}
}
