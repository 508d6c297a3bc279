// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sweeps as VTK grids: the cases of Data/cases, a plate with holes, and ways to disturb
 * them.
 */
#ifndef CapGrids_h
#define CapGrids_h

#include "TestEvents.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;
using Corners = std::vector<vtkIdType>;

/// The four inputs of a sweep.
struct SweepGrids
{
  Grid sourceQuads;
  Grid sourceSurface;
  Grid targetSurface;
  Grid linkingSides;
};

Grid readGrid(const std::string& file);

SweepGrids readCase(const std::string& name);

Corners cornersOf(vtkDataSet* data, vtkIdType cell);

std::array<double, 3> pointOf(vtkDataSet* data, vtkIdType i);

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b);

/// Diagonal of the box.
double sizeOf(vtkDataSet* data);

/// Greatest distance between points of the same number; infinite if the counts differ.
double greatestDistance(vtkDataSet* a, vtkDataSet* b);

/// A grid of cells of one type.
Grid gridOf(const std::vector<std::array<double, 3>>& coordinates,
  const std::vector<Corners>& cells, int type);

Grid emptyGrid();

/// The same points, data, and cells after `change`, which gets the cell's number and corners.
Grid changedCells(
  vtkUnstructuredGrid* grid, const std::function<void(vtkIdType, Corners&)>& change);

/// Every cell turned over.
Grid turnedOver(vtkUnstructuredGrid* grid);

/// Each cell turned over or not, as chance has it, beginning at any corner.
Grid anyOrientation(vtkUnstructuredGrid* grid, unsigned seed);

/// Cells in an order that chance has picked; cell data are dropped.
Grid shuffledCells(vtkUnstructuredGrid* grid, unsigned seed);

/// The points after `change`.
Grid changedPoints(
  vtkUnstructuredGrid* grid, const std::function<void(vtkIdType, std::array<double, 3>&)>& change);

Grid withNaN(vtkUnstructuredGrid* grid);

/// Coordinates rounded to single precision and stored as such.
Grid singlePrecision(vtkUnstructuredGrid* grid);

vtkSmartPointer<vtkPolyData> polyData(vtkUnstructuredGrid* grid);

/// The grid with a vertex cell before all others, a line after the first one and at the end;
/// cell data `Number` counts the cells.
Grid withVerticesAndLines(vtkUnstructuredGrid* grid);

vtkSmartPointer<vtkDoubleArray> numbers(const char* name, vtkIdType count, double first);

/// Gives a grid the arrays PointNumber (100 + i), CellNumber (1000 + c) and the field Note (7).
Grid withData(vtkUnstructuredGrid* grid);

/// Boundary edges as next[a] = b, in cell direction.
std::map<vtkIdType, vtkIdType> boundaryOf(vtkDataSet* data);

/**
 * Boundary nodes of projected quads must be the ends of their linking columns bit for bit, the
 * others lie on the target surface.
 *
 * @param ends by the place of a column's beginning.
 */
void expectOnTarget(vtkDataSet* projected, const SweepGrids& sweep,
  const std::map<std::array<double, 3>, std::array<double, 3>>& ends);

/// A curved plate of 12 x 12 squares with up to three holes, swept to one whose holes have moved.
SweepGrids plateSweep(int numberOfHoles);

double report(vtkDataSet* data, const std::string& name);

std::string textReport(vtkDataSet* data, const std::string& name);

/// Bits of points, cells, point and cell arrays are the same (text and times are not compared).
void expectSameBits(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b);

bool isEmpty(vtkAlgorithm* filter);

/// Runs a filter that must raise one error with `part` in its text and leave its outputs empty.
void expectOneError(vtkAlgorithm* filter, const std::string& part);

/// Sets the abort flag when the filter has got this far.
class AbortAt : public vtkCommand
{
public:
  static AbortAt* New() { return new AbortAt; }
  double Fraction = 0.0;
  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
    if (algorithm->GetProgress() >= this->Fraction)
    {
      algorithm->SetAbortExecute(1);
    }
  }
};

/// The outputs of an aborted filter are empty, and that is no error.
void expectEmptyWhenAborted(vtkAlgorithm* filter, double fraction);
}

#endif
