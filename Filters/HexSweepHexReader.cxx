// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepHexReader.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDataSet.h>
#include <vtkIdList.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

namespace hexsweep
{
namespace
{
// Corners of a voxel in the order of a hexahedron.
constexpr int VoxelCorners[8] = { 0, 1, 3, 2, 4, 5, 7, 6 };
}

HexReader::HexReader(vtkDataSet* data)
  : Data(data)
{
  // The first call from one thread builds what the data set needs for calls from several.
  data->GetCellPoints(0, this->Ids.Local());
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (grid && grid->GetCells() && grid->GetCells()->IsStorageShareable())
  {
    this->Cells = grid->GetCells();
  }
  vtkPointSet* pointSet = vtkPointSet::SafeDownCast(data);
  if (pointSet && pointSet->GetPoints())
  {
    vtkDataArray* points = pointSet->GetPoints()->GetData();
    if (auto* doubles = vtkAOSDataArrayTemplate<double>::FastDownCast(points))
    {
      this->Doubles = doubles->GetPointer(0);
    }
    else if (auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(points))
    {
      this->Floats = floats->GetPointer(0);
    }
  }
}

bool HexReader::isHex(vtkIdType cell) const
{
  const int type = this->Data->GetCellType(cell);
  return type == VTK_HEXAHEDRON || type == VTK_VOXEL;
}

Eigen::RowVector3d HexReader::point(vtkIdType id) const
{
  if (this->Doubles)
  {
    return Eigen::Map<const Eigen::RowVector3d>(this->Doubles + 3 * id);
  }
  if (this->Floats)
  {
    return Eigen::Map<const Eigen::RowVector3f>(this->Floats + 3 * id).cast<double>();
  }
  Eigen::RowVector3d point;
  this->Data->GetPoint(id, point.data());
  return point;
}

HexCorners HexReader::corners(vtkIdType cell)
{
  const vtkIdType* ids = nullptr;
  if (this->Cells)
  {
    vtkIdType size = 0;
    this->Cells->GetCellAtId(cell, size, ids);
  }
  else
  {
    vtkIdList* list = this->Ids.Local();
    this->Data->GetCellPoints(cell, list);
    ids = list->GetPointer(0);
  }
  const bool isVoxel = this->Data->GetCellType(cell) == VTK_VOXEL;
  HexCorners corners;
  for (int i = 0; i < 8; ++i)
  {
    corners.row(i) = this->point(ids[isVoxel ? VoxelCorners[i] : i]);
  }
  return corners;
}
}
