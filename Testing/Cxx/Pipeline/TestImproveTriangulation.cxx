// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHarmonicDiskMap.h"

#include "CapGrids.h"

#include "HexSweepArrays.h"

#include <vtkCellArray.h>
#include <vtkDelaunay2D.h>
#include <vtkPolyData.h>

#include <set>

namespace TestImproveTriangulation
{
using Edges = std::set<std::pair<vtkIdType, vtkIdType>>;

/// Random points over [0, stretch] x [0, 1], triangulated as if the longer side were 1 as well.
test::Grid stretchedGrid(double stretch)
{
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(0.02, 0.98);
  std::vector<std::array<double, 3>> places;
  for (int i = 0; i < 20; ++i)
  {
    const double s = i / 20.0;
    places.push_back({ s, 0.0, 0.0 });
    places.push_back({ 1.0, s, 0.0 });
    places.push_back({ 1.0 - s, 1.0, 0.0 });
    places.push_back({ 0.0, 1.0 - s, 0.0 });
  }
  for (int i = 0; i < 300; ++i)
  {
    const double x = uniform(generator);
    places.push_back({ x, uniform(generator), 0.0 });
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(test::gridOf(places, {}, VTK_TRIANGLE)->GetPoints());
  vtkNew<vtkDelaunay2D> delaunay;
  delaunay->SetInputData(cloud);
  delaunay->Update();
  std::vector<test::Corners> triangles;
  for (vtkIdType c = 0; c < delaunay->GetOutput()->GetNumberOfCells(); ++c)
  {
    triangles.push_back(test::cornersOf(delaunay->GetOutput(), c));
  }
  for (auto& place : places)
  {
    place[0] *= stretch;
  }
  return test::gridOf(places, triangles, VTK_TRIANGLE);
}

Edges edgesOf(vtkDataSet* data)
{
  Edges edges;
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
  {
    const test::Corners corners = test::cornersOf(data, c);
    for (std::size_t i = 0; i < 3; ++i)
    {
      edges.insert(std::minmax(corners[i], corners[(i + 1) % 3]));
    }
  }
  return edges;
}

vtkSmartPointer<vtkHarmonicDiskMap> run(vtkDataSet* input, int improvement)
{
  auto filter = vtkSmartPointer<vtkHarmonicDiskMap>::New();
  filter->SetInputDataObject(input);
  filter->SetImproveTriangulation(improvement);
  filter->Update();
  return filter;
}

TEST(ImproveTriangulation, AutomaticIsTheDefault)
{
  vtkNew<vtkHarmonicDiskMap> filter;
  EXPECT_EQ(filter->GetImproveTriangulation(), vtkHarmonicDiskMap::AUTOMATIC);
}

TEST(ImproveTriangulation, OffFlipsAndAutomaticDoesNot)
{
  const test::Grid grid = stretchedGrid(1000.0);
  const auto off = run(grid, vtkHarmonicDiskMap::OFF);
  EXPECT_GT(test::report(off->GetOutput(), hexsweep::reports::FlipsBefore), 0.0);
  EXPECT_EQ(test::report(off->GetOutput(), hexsweep::reports::EdgeFlips), 0.0);
  for (const int improvement : { vtkHarmonicDiskMap::AUTOMATIC, vtkHarmonicDiskMap::ON })
  {
    const auto filter = run(grid, improvement);
    vtkUnstructuredGrid* output = filter->GetOutput();
    EXPECT_EQ(test::report(output, hexsweep::reports::FlipsAfter), 0.0);
    EXPECT_GT(test::report(output, hexsweep::reports::EdgeFlips), 100.0);
    EXPECT_EQ(test::report(output, hexsweep::reports::AddedPoints), 0.0);
  }
}

TEST(ImproveTriangulation, FlatFlipsEndInTheTriangulationOfVtkDelaunay2D)
{
  // Mildly stretched: vtkDelaunay2D itself goes wrong where all triangles are needles.
  const test::Grid grid = stretchedGrid(20.0);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(grid->GetPoints());
  vtkNew<vtkDelaunay2D> delaunay;
  delaunay->SetInputData(cloud);
  delaunay->SetTolerance(0.0);
  delaunay->Update();
  const Edges theirs = edgesOf(delaunay->GetOutput());
  const Edges ours = edgesOf(run(grid, vtkHarmonicDiskMap::ON)->GetOutput());
  std::size_t common = 0;
  for (const auto& edge : ours)
  {
    common += theirs.count(edge);
  }
  // All but the chords in the corners, which are halved.
  EXPECT_GE(common + 16, ours.size());
}

TEST(ImproveTriangulation, GoodCapsComeOutTheSame)
{
  const test::SweepGrids sweep = test::plateSweep(3);
  const auto off = run(sweep.targetSurface, vtkHarmonicDiskMap::OFF);
  const auto automatic = run(sweep.targetSurface, vtkHarmonicDiskMap::AUTOMATIC);
  test::expectSameBits(off->GetOutput(), automatic->GetOutput());
}

TEST(ImproveTriangulation, UnknownNumbers)
{
  const test::SweepGrids sweep = test::plateSweep(0);
  for (const int unknown : { -1, 3 })
  {
    vtkNew<vtkHarmonicDiskMap> filter;
    filter->SetInputDataObject(sweep.targetSurface);
    filter->SetImproveTriangulation(unknown);
    test::expectOneError(filter, "ImproveTriangulation " + std::to_string(unknown));
  }
}
}
