// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepSolidBoundary.h"

#include "HexSweepMemory.h"
#include "HexSweepReader.h"
#include "HexSweepWriter.h"

#include "Core/Surfaces/FaceSides.h"

#include <vtkAlgorithm.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace hexsweep
{
namespace
{
/// Dimension of each type of cell in a data set.
class CellDimensions
{
public:
  explicit CellDimensions(vtkDataSet* data)
    : Data(data)
  {
  }
  int of(vtkIdType cell)
  {
    const int type = this->Data->GetCellType(cell);
    const auto known = this->OfType.find(type);
    if (known != this->OfType.end())
    {
      return known->second;
    }
    this->Generic->SetCellType(type);
    return this->OfType[type] = type == VTK_EMPTY_CELL ? 0 : this->Generic->GetCellDimension();
  }

private:
  vtkDataSet* Data;
  vtkNew<vtkGenericCell> Generic;
  std::map<int, int> OfType;
};

vtkSmartPointer<vtkPoints> pointsOf(vtkDataSet* data)
{
  if (vtkPointSet* pointSet = vtkPointSet::SafeDownCast(data))
  {
    return pointSet->GetPoints();
  }
  return vtkSmartPointer<vtkPoints>::Take(
    newPoints(readPoints(data), vtkAlgorithm::DOUBLE_PRECISION));
}

/// Adds cells of another data set on the same points, one by one.
class SurfaceBuilder
{
public:
  explicit SurfaceBuilder(vtkDataSet* data)
    : Grid(vtkSmartPointer<vtkUnstructuredGrid>::New())
  {
    this->Grid->SetPoints(pointsOf(data));
    this->Grid->Allocate();
  }
  void add(int type, vtkIdList* points, vtkIdType cellId)
  {
    this->Grid->InsertNextCell(type, points);
    this->CellIds.push_back(cellId);
  }
  BoundaryCells take()
  {
    BoundaryCells boundary;
    boundary.cells = this->Grid;
    boundary.cellIds = std::move(this->CellIds);
    return boundary;
  }

private:
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  std::vector<Index> CellIds;
};

bool isGhost(vtkDataSet* data, vtkIdType cell)
{
  vtkUnsignedCharArray* ghosts = data->GetCellGhostArray();
  return ghosts && ghosts->GetValue(cell) != 0;
}

BoundaryCells surfaceCells(vtkDataSet* data, CellDimensions& dimensions)
{
  SurfaceBuilder builder(data);
  vtkNew<vtkIdList> points;
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
  {
    if (dimensions.of(c) == 2 && !isGhost(data, c))
    {
      data->GetCellPoints(c, points);
      builder.add(data->GetCellType(c), points, c);
    }
  }
  return builder.take();
}

/// Sides of volume cells that no other one shares; of curved cells the corners only.
BoundaryCells volumeSides(vtkDataSet* data, CellDimensions& dimensions)
{
  // Cells alone: arrays would be carried along, and could have the names of those that are added.
  const auto bare = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
  bare->CopyStructure(data);
  if (vtkUnsignedCharArray* ghosts = data->GetCellGhostArray())
  {
    bare->GetCellData()->AddArray(ghosts);
  }
  requireCopies(data, 4.0);
  vtkNew<vtkDataSetSurfaceFilter> filter;
  filter->SetInputData(bare);
  filter->DelegationOff();
  filter->PassThroughCellIdsOn();
  filter->PassThroughPointIdsOn();
  filter->SetNonlinearSubdivisionLevel(0);
  filter->Update();
  vtkPolyData* boundary = filter->GetOutput();
  auto* cellIds = vtkIdTypeArray::SafeDownCast(
    boundary->GetCellData()->GetArray(filter->GetOriginalCellIdsName()));
  auto* pointIds = vtkIdTypeArray::SafeDownCast(
    boundary->GetPointData()->GetArray(filter->GetOriginalPointIdsName()));
  SurfaceBuilder builder(data);
  vtkNew<vtkIdList> points;
  for (vtkIdType c = 0; cellIds && pointIds && c < boundary->GetNumberOfCells(); ++c)
  {
    const vtkIdType cell = cellIds->GetValue(c);
    if (dimensions.of(cell) == 3)
    {
      boundary->GetCellPoints(c, points);
      for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
      {
        points->SetId(i, pointIds->GetValue(points->GetId(i)));
      }
      builder.add(boundary->GetCellType(c), points, cell);
    }
  }
  return builder.take();
}

/// Corners of a triangle or quad, rising; no corners for other cells.
using CornerSet = std::array<vtkIdType, 4>;

CornerSet cornersOf(vtkDataSet* data, vtkIdType cell, vtkIdList* points)
{
  CornerSet corners = { -1, -1, -1, -1 };
  data->GetCellPoints(cell, points);
  if (points->GetNumberOfIds() <= 4)
  {
    std::copy(points->begin(), points->end(), corners.begin());
    std::sort(corners.begin(), corners.end());
  }
  return corners;
}

/// The surface cells that are sides of the volume's boundary, in place of these; no cells where a
/// side has none. Cells between two volumes are left out.
BoundaryCells cellsOnBoundary(const BoundaryCells& own, const BoundaryCells& boundary)
{
  vtkNew<vtkIdList> points;
  std::vector<CornerSet> sides;
  for (vtkIdType c = 0; c < boundary.cells->GetNumberOfCells(); ++c)
  {
    sides.push_back(cornersOf(boundary.cells, c, points));
  }
  std::sort(sides.begin(), sides.end());
  SurfaceBuilder builder(own.cells);
  std::vector<char> covered(sides.size(), 0);
  for (vtkIdType c = 0; c < own.cells->GetNumberOfCells(); ++c)
  {
    const CornerSet corners = cornersOf(own.cells, c, points);
    const auto side = std::lower_bound(sides.begin(), sides.end(), corners);
    if (side != sides.end() && *side == corners && corners.back() >= 0)
    {
      covered[static_cast<std::size_t>(side - sides.begin())] = 1;
      builder.add(own.cells->GetCellType(c), points, own.cellIds[static_cast<std::size_t>(c)]);
    }
  }
  const bool all = std::find(covered.begin(), covered.end(), 0) == covered.end();
  return all ? builder.take() : SurfaceBuilder(own.cells).take();
}

/// Whether each edge has two cells (polygons and strips count by their triangles).
bool isClosed(vtkDataSet* surface)
{
  const TriangleMesh mesh = readTriangles(surface, "solid").mesh;
  bool closed = true;
  forEachEdge(sortedSides(mesh.triangles, mesh.points.rows()),
    [&](std::size_t first, std::size_t last) { closed = closed && last - first == 2; });
  return closed;
}
}

bool hasVolumes(vtkDataSet* data)
{
  CellDimensions dimensions(data);
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
  {
    if (dimensions.of(c) == 3 && !isGhost(data, c))
    {
      return true;
    }
  }
  return false;
}

BoundaryCells volumeBoundary(vtkDataSet* data)
{
  CellDimensions dimensions(data);
  BoundaryCells sides = volumeSides(data, dimensions);
  BoundaryCells own = surfaceCells(data, dimensions);
  BoundaryCells onBoundary = cellsOnBoundary(own, sides);
  const vtkIdType surfaces = own.cells->GetNumberOfCells();
  BoundaryCells result;
  if (onBoundary.cells->GetNumberOfCells() > 0)
  {
    result = std::move(onBoundary);
    result.ignoredSurfaces = surfaces - result.cells->GetNumberOfCells();
  }
  else if (surfaces > 0 && isClosed(own.cells))
  {
    result = std::move(own);
  }
  else
  {
    result = std::move(sides);
    result.fromVolume = true;
    result.ignoredSurfaces = surfaces;
  }
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
  {
    result.ignoredCells += dimensions.of(c) < 2 && !isGhost(data, c) ? 1 : 0;
  }
  return result;
}
}
