// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepStackGrid.h"

#include "HexSweepArrays.h"
#include "HexSweepMemory.h"
#include "HexSweepWriter.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <vector>

namespace hexsweep
{
namespace
{
vtkSmartPointer<vtkIdTypeArray> stackIds(const char* name, const std::vector<Index>& ids)
{
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  array->SetName(name);
  setTuples(array.Get(), static_cast<vtkIdType>(ids.size()));
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), ids[i]);
  }
  return array;
}

/// Number of a side in Exodus II. A hexahedron that was turned over has its bottom above.
unsigned char stackSide(int side, bool turnsOver)
{
  if (side < 4)
  {
    return static_cast<unsigned char>(side + 1);
  }
  return (side == 4) != turnsOver ? 5 : 6;
}

unsigned char partOf(StackFaceKind kind)
{
  return kind == StackFaceKind::Bottom ? 0 : kind == StackFaceKind::Top ? 1 : 2;
}
}

void writeStackGrid(
  const StackMesh& mesh, const Reflection& reflection, int precision, vtkUnstructuredGrid* output)
{
  output->SetPoints(
    vtkSmartPointer<vtkPoints>::Take(newPoints(reflected(mesh.points, reflection), precision)));
  Hexes hexes = mesh.hexes;
  if (reflection.turnsOver())
  {
    hexes.leftCols<4>() = mesh.hexes.rightCols<4>();
    hexes.rightCols<4>() = mesh.hexes.leftCols<4>();
  }
  setCells(output, hexes, VTK_HEXAHEDRON);
  output->GetPointData()->AddArray(stackIds(arrays::SourcePointIds, mesh.planeNodes));
  output->GetCellData()->AddArray(stackIds(arrays::SourceCellIds, mesh.quadOf));
  output->GetCellData()->AddArray(stackIds(arrays::SweepLayer, mesh.layerOf));
}

void writeStackBoundary(const StackMesh& mesh, const Reflection& reflection,
  vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* output)
{
  const bool turnsOver = reflection.turnsOver();
  const auto count = static_cast<Index>(mesh.boundary.size());
  std::vector<Index> newId(static_cast<std::size_t>(mesh.points.rows()), -1);
  vtkNew<vtkPoints> points;
  points->SetDataType(hexes->GetPoints()->GetDataType());
  std::vector<Index> hexPoints;
  std::vector<Index> faceIds;
  std::vector<Index> hexIds;
  Quads quads(count, 4);
  vtkNew<vtkUnsignedCharArray> parts;
  parts->SetName(arrays::BoundaryPart);
  parts->SetNumberOfValues(count);
  vtkNew<vtkUnsignedCharArray> sides;
  sides->SetName(arrays::HexSide);
  sides->SetNumberOfValues(count);
  for (Index q = 0; q < count; ++q)
  {
    const StackBoundaryQuad& quad = mesh.boundary[static_cast<std::size_t>(q)];
    for (std::size_t c = 0; c < 4; ++c)
    {
      Index& id = newId[static_cast<std::size_t>(quad.points[c])];
      if (id < 0)
      {
        id = points->InsertNextPoint(hexes->GetPoint(quad.points[c]));
        hexPoints.push_back(quad.points[c]);
      }
      quads(q, static_cast<Index>(turnsOver ? (4 - c) % 4 : c)) = id;
    }
    faceIds.push_back(quad.faceId);
    hexIds.push_back(quad.hex);
    parts->SetValue(q, partOf(quad.kind));
    sides->SetValue(q, stackSide(quad.side, turnsOver));
  }
  output->SetPoints(points);
  setCells(output, quads, VTK_QUAD);
  output->GetPointData()->AddArray(stackIds(arrays::HexPointIds, hexPoints));
  vtkCellData* cellData = output->GetCellData();
  cellData->AddArray(stackIds(arrays::BoundaryId, faceIds));
  cellData->AddArray(parts);
  cellData->AddArray(stackIds(arrays::HexId, hexIds));
  cellData->AddArray(sides);
  cellData->SetActiveScalars(arrays::BoundaryId);
}
}
