// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepBoundaryGrid.h"

#include "Core/Solids/BoundaryQuads.h"
#include "HexSweepArrays.h"
#include "HexSweepWriter.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <vector>

namespace hexsweep
{
namespace
{
/// Sides of a hexahedron as Exodus II counts them: 1 to 4 over the edges of the bottom, 5 the
/// bottom (nodes 1 to 4), 6 the top. Whether the source is below or above, edges keep their number.
unsigned char exodusSide(int face, bool sourceIsBottom)
{
  if (face < 4)
  {
    return static_cast<unsigned char>(face + 1);
  }
  return (face == 4) == sourceIsBottom ? 5 : 6;
}

enum BoundaryPart : unsigned char
{
  Source = 0,
  Target = 1,
  Side = 2
};
}

void writeBoundary(const SolidCage& cage, const SolidSurface& solid, const SweepTopology& topology,
  bool sourceIsBottom, bool turnsOver, vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* output)
{
  const std::vector<BoundaryQuad> boundary = boundaryQuads(cage, solid, topology);
  const Index count = static_cast<Index>(boundary.size());
  std::vector<Index> newId(static_cast<std::size_t>(hexes->GetNumberOfPoints()), -1);
  vtkNew<vtkIdTypeArray> hexPointIds;
  hexPointIds->SetName(arrays::HexPointIds);
  vtkNew<vtkPoints> points;
  points->SetDataType(hexes->GetPoints()->GetDataType());
  Quads quads(count, 4);
  vtkNew<vtkIdTypeArray> faceIds;
  faceIds->SetName(arrays::BoundaryId);
  vtkNew<vtkUnsignedCharArray> parts;
  parts->SetName(arrays::BoundaryPart);
  vtkNew<vtkIdTypeArray> hexIds;
  hexIds->SetName(arrays::HexId);
  vtkNew<vtkUnsignedCharArray> sides;
  sides->SetName(arrays::HexSide);
  faceIds->SetNumberOfValues(count);
  parts->SetNumberOfValues(count);
  hexIds->SetNumberOfValues(count);
  sides->SetNumberOfValues(count);
  for (Index q = 0; q < count; ++q)
  {
    const BoundaryQuad& quad = boundary[static_cast<std::size_t>(q)];
    for (std::size_t c = 0; c < 4; ++c)
    {
      Index& id = newId[static_cast<std::size_t>(quad.points[c])];
      if (id < 0)
      {
        id = points->InsertNextPoint(hexes->GetPoint(quad.points[c]));
        hexPointIds->InsertNextValue(quad.points[c]);
      }
      quads(q, static_cast<Index>(turnsOver ? (4 - c) % 4 : c)) = id;
    }
    faceIds->SetValue(q, solid.faceIds[static_cast<std::size_t>(quad.triangle)]);
    parts->SetValue(q, quad.face == 4 ? Source : quad.face == 5 ? Target : Side);
    hexIds->SetValue(q, quad.hex);
    sides->SetValue(q, exodusSide(quad.face, sourceIsBottom));
  }
  output->SetPoints(points);
  setCells(output, quads, VTK_QUAD);
  output->GetPointData()->AddArray(hexPointIds);
  vtkCellData* cellData = output->GetCellData();
  cellData->AddArray(faceIds);
  cellData->AddArray(parts);
  cellData->AddArray(hexIds);
  cellData->AddArray(sides);
  cellData->SetActiveScalars(arrays::BoundaryId);
}
}
