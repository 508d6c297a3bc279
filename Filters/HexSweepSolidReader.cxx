// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepSolidReader.h"

#include "HexSweepArrays.h"
#include "HexSweepIds.h"
#include "HexSweepReader.h"
#include "HexSweepSolidBoundary.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"

#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <optional>
#include <utility>

namespace hexsweep
{
namespace
{
const char* const What = "solid";

bool isQuad(int type, vtkIdType numberOfPoints)
{
  return type == VTK_QUAD || type == VTK_PIXEL || (type == VTK_POLYGON && numberOfPoints == 4);
}

/// Takes over triangles and quads of a surface.
void fill(SolidInput& solid, const BoundaryCells& surface, TriangleInput input)
{
  solid.points = std::move(input.mesh.points);
  solid.triangles = std::move(input.mesh.triangles);
  std::vector<Index> corners;
  vtkNew<vtkIdList> points;
  for (std::size_t t = 0; t < input.cellIds.size(); ++t)
  {
    const Index own = input.cellIds[t];
    const Index cell =
      surface.cellIds.empty() ? own : surface.cellIds[static_cast<std::size_t>(own)];
    solid.cellIds.push_back(cell);
    if (t > 0 && input.cellIds[t - 1] == own)
    {
      solid.quadOfTriangle.push_back(solid.quadOfTriangle.back());
      continue;
    }
    const int type = surface.cells->GetCellType(own);
    if (type == VTK_TRIANGLE)
    {
      solid.quadOfTriangle.push_back(-1);
      continue;
    }
    surface.cells->GetCellPoints(own, points);
    const bool quad = isQuad(type, points->GetNumberOfIds());
    solid.quadOfTriangle.push_back(quad ? static_cast<Index>(solid.quadCellIds.size()) : -1);
    if (quad)
    {
      const bool pixel = type == VTK_PIXEL;
      for (const int i : { 0, 1, pixel ? 3 : 2, pixel ? 2 : 3 })
      {
        corners.push_back(points->GetId(i));
      }
      solid.quadCellIds.push_back(cell);
    }
  }
  solid.quads = Eigen::Map<const Quads>(corners.data(), static_cast<Index>(corners.size()) / 4, 4);
}

std::string namesOfArrays(vtkCellData* cellData)
{
  std::string names;
  for (int i = 0; i < cellData->GetNumberOfArrays(); ++i)
  {
    const char* name = cellData->GetAbstractArray(i)->GetName();
    names += (names.empty() ? "" : ", ") + std::string(name ? name : "(no name)");
  }
  return names.empty() ? "it has no cell arrays" : "its cell arrays are: " + names;
}

/// The array with the face ids, or nullptr where there is none and none was asked for.
vtkAbstractArray* findFaceIds(vtkDataSet* data, const std::string& asked)
{
  const std::vector<std::string> names = asked.empty()
    ? std::vector<std::string>{ arrays::FaceId, arrays::CellEntityIds }
    : std::vector{ asked };
  for (const std::string& name : names)
  {
    if (vtkAbstractArray* array = data->GetCellData()->GetAbstractArray(name.c_str()))
    {
      return array;
    }
  }
  for (const std::string& name : names)
  {
    if (data->GetPointData()->GetAbstractArray(name.c_str()))
    {
      throw InvalidInput("the solid: the face ids \"" + name +
        "\" are a point array. A face is made of cells: give each cell its id (in ParaView: Point "
        "Data to Cell Data with Categorical Data).");
    }
  }
  if (!asked.empty())
  {
    throw InvalidInput("the solid has no cell array \"" + asked +
      "\" with face ids: " + namesOfArrays(data->GetCellData()) + ".");
  }
  return nullptr;
}

/// @param what "face" or "volume".
std::vector<Index> readCellIds(vtkDataSet* data, vtkAbstractArray* array, const std::string& what,
  const std::vector<Index>& cells)
{
  const std::string start =
    "the solid: the " + what + " ids \"" + std::string(array->GetName()) + "\" ";
  if (array->GetNumberOfTuples() != data->GetNumberOfCells())
  {
    throw InvalidInput(start + "have " + std::to_string(array->GetNumberOfTuples()) +
      " entries for " + std::to_string(data->GetNumberOfCells()) +
      " cells. There must be one a cell.");
  }
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers || array->GetNumberOfComponents() != 1)
  {
    throw InvalidInput(start +
      (numbers ? "have " + std::to_string(array->GetNumberOfComponents()) + " components"
               : std::string("are no numbers")) +
      ". A " + what + " id is one whole number a cell.");
  }
  const WholeNumbers values(numbers);
  std::vector<Index> ids;
  ids.reserve(cells.size());
  for (const Index cell : cells)
  {
    const std::optional<Index> value = values.at(cell);
    if (!value)
    {
      throw InvalidInput(start +
        "are too large or not whole: " + describe(numbers->GetComponent(cell, 0)) + " in cell " +
        std::to_string(cell) + ". Choose the array that numbers the " + what + "s.");
    }
    ids.push_back(*value);
  }
  return ids;
}
}

SolidData readSolid(vtkDataSet* data, const std::string& faceIdArray)
{
  const bool isVolume = data && hasVolumes(data);
  const BoundaryCells boundary = isVolume ? volumeBoundary(data) : BoundaryCells{ data, {} };
  TriangleInput input = readTriangles(boundary.cells, What);
  SolidData solid;
  solid.fromVolume = boundary.fromVolume;
  solid.ignoredCells = boundary.ignoredCells + input.ignoredCells;
  solid.ignoredSurfaces = boundary.ignoredSurfaces;
  fill(solid.surface, boundary, std::move(input));
  vtkAbstractArray* ids = findFaceIds(data, faceIdArray);
  if (ids && !solid.fromVolume)
  {
    solid.surface.faceIds = readCellIds(data, ids, "face", solid.surface.cellIds);
    solid.faceIdArray = ids->GetName();
  }
  vtkAbstractArray* volumes = data->GetCellData()->GetAbstractArray(arrays::VolumeId);
  if (volumes && !solid.fromVolume)
  {
    solid.volumeIds = readCellIds(data, volumes, "volume", solid.surface.cellIds);
  }
  return solid;
}
}
