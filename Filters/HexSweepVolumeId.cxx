// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepVolumeId.h"

#include "HexSweepArrays.h"
#include "HexSweepIds.h"
#include "HexSweepMemory.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkGenericCell.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include <optional>

namespace hexsweep
{
namespace
{
/// The value that an array has on all cells of one dimension.
std::optional<Index> commonValue(vtkDataSet* data, const char* name, int dimension)
{
  vtkDataArray* array = data->GetCellData()->GetArray(name);
  if (!array || array->GetNumberOfComponents() != 1)
  {
    return std::nullopt;
  }
  const WholeNumbers values(array);
  std::optional<Index> value;
  vtkNew<vtkGenericCell> type;
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
  {
    type->SetCellType(data->GetCellType(c));
    if (type->GetCellDimension() != dimension)
    {
      continue;
    }
    const std::optional<Index> here = values.at(c);
    if (!here || (value && value != here))
    {
      return std::nullopt;
    }
    value = here;
  }
  return value;
}
}

void carryVolumeId(vtkDataSet* solid, vtkUnstructuredGrid* hexes)
{
  std::optional<Index> id = commonValue(solid, arrays::VolumeId, 3);
  id = id ? id : commonValue(solid, arrays::CellEntityIds, 3);
  id = id ? id : commonValue(solid, arrays::VolumeId, 2);
  if (id)
  {
    setVolumeId(*id, hexes);
  }
}

void setVolumeId(Index id, vtkUnstructuredGrid* cells)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(arrays::VolumeId);
  setTuples(ids.Get(), cells->GetNumberOfCells());
  ids->FillValue(id);
  cells->GetCellData()->AddArray(ids);
}
}
