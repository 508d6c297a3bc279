// SPDX-License-Identifier: BSD-3-Clause
// One million points in a plane mesh of two million triangles. Everything is counted on both
// sides, from arrays or vtkPolyData to triangle ids and barycentric coordinates.
#include "BenchmarkMeshes.h"
#include "Interleaved.h"

#include "Core/Geometry/TriangleWalk.h"

#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <array>

namespace
{
using hexsweep::Index;
using hexsweep::PlanePoints;
using hexsweep::Points;
using hexsweep::TriangleMesh;
using test::Numbering;

constexpr Index NumberOfTriangles = 2000000;
constexpr Index CellsOfPoints = 999; // a million nodes of another mesh

vtkNew<vtkPolyData> polyData(const TriangleMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.points.rows());
  for (Index i = 0; i < mesh.points.rows(); ++i)
  {
    points->SetPoint(i, mesh.points(i, 0), mesh.points(i, 1), mesh.points(i, 2));
  }
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(mesh.triangles.rows(), mesh.triangles.size());
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    cells->InsertNextCell({ mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2) });
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  data->BuildCells();
  return data;
}

Points queries(Numbering numbering)
{
  std::mt19937 generator(5);
  const Points points = test::shakenNodes(CellsOfPoints, generator);
  return numbering == Numbering::FileOrder
    ? points
    : test::rowsOf(points, test::shuffledIds(points.rows(), generator));
}

struct Found
{
  std::vector<Index> cells;
  std::vector<std::array<double, 3>> weights;
};

Found findCells(vtkPolyData* data, const Points& points)
{
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(data);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  Found found;
  found.cells.resize(static_cast<std::size_t>(points.rows()));
  found.weights.resize(found.cells.size());
  for (Index i = 0; i < points.rows(); ++i)
  {
    const std::size_t entry = static_cast<std::size_t>(i);
    std::array<double, 3> x{ points(i, 0), points(i, 1), points(i, 2) };
    std::array<double, 3> pcoords{};
    int subId = 0;
    found.cells[entry] =
      locator->FindCell(x.data(), 0.0, cell, subId, pcoords.data(), found.weights[entry].data());
  }
  return found;
}

void locate(benchmark::State& state, Numbering numbering)
{
  const TriangleMesh mesh = test::cap(NumberOfTriangles, numbering);
  const PlanePoints plane = mesh.points.leftCols<2>();
  const Points points = queries(numbering);
  const PlanePoints planeQueries = points.leftCols<2>();
  const vtkNew<vtkPolyData> data = polyData(mesh);

  hexsweep::LocatedPoints ours;
  Found theirs;
  test::Interleaved runs;
  runs.add(
    "walk", [&] { ours = hexsweep::TriangleWalk(plane, mesh.triangles).locate(planeQueries); });
  runs.add("vtkStaticCellLocator", [&] { theirs = findCells(data, points); });
  runs.report(state);

  // Where both have an answer it is the same one, but for points on edges.
  Index missed = 0;
  Index differing = 0;
  for (std::size_t i = 0; i < theirs.cells.size(); ++i)
  {
    missed += theirs.cells[i] < 0 ? 1 : 0;
    differing += theirs.cells[i] >= 0 && theirs.cells[i] != ours.triangles[i] ? 1 : 0;
  }
  state.counters["walk_missed"] = static_cast<double>(ours.outside.size());
  state.counters["vtkStaticCellLocator_missed"] = static_cast<double>(missed);
  state.counters["differing"] = static_cast<double>(differing);
}
}

BENCHMARK_CAPTURE(locate, FileOrder, Numbering::FileOrder)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(locate, RandomNumbering, Numbering::Random)
  ->Iterations(1)
  ->Unit(benchmark::kSecond);
