// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepInputCheck.h"

#include "Core/Common/Errors.h"

#include "HexSweepIds.h"

#include <vtkAlgorithm.h>
#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDataSetAlgorithm.h>
#include <vtkDataSetAttributes.h>
#include <vtkGenericCell.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVersion.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr const char* Repair = " Write the data set anew, or repair what made it.";

/// How many points a cell of a type must have.
struct CellSize
{
  vtkIdType points = 0;
  bool isExact = false;
  bool isType = true; ///< whether there is such a type
};

CellSize sizeOf(int type)
{
  switch (type)
  {
    case VTK_TRIANGLE_STRIP:
    case VTK_POLYGON:
      return { 3, false };
    case VTK_POLY_LINE:
      return { 1, false };
    case VTK_EMPTY_CELL:
    case VTK_POLY_VERTEX:
    case VTK_POLYHEDRON:
    case VTK_QUADRATIC_POLYGON:
    case VTK_CONVEX_POINT_SET:
      return {};
    default:
      break;
  }
  const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
  if (!cell)
  {
    return { 0, false, false };
  }
  return type < VTK_LAGRANGE_CURVE ? CellSize{ cell->GetNumberOfPoints(), true } : CellSize();
}

/// sizeOf() each type, asked once.
class CellSizes
{
public:
  CellSize of(int type)
  {
    std::optional<CellSize>& known = this->Known[static_cast<std::size_t>(type)];
    known = known ? known : sizeOf(type);
    return *known;
  }

private:
  std::array<std::optional<CellSize>, 256> Known{};
};

/// Types of a grid's cells: VTK has given the call another name.
template <typename Grid>
auto typesOf(Grid* grid, int) -> decltype(static_cast<vtkDataArray*>(grid->GetCellTypesArray()))
{
  return grid->GetCellTypesArray();
}

template <typename Grid>
auto typesOf(Grid* grid, long) -> decltype(static_cast<vtkDataArray*>(grid->GetCellTypes()))
{
  return grid->GetCellTypes();
}

/// Cells of a data set that are kept in one vtkCellArray.
struct CellsToCheck
{
  vtkCellArray* cells;
  vtkIdType first;                    ///< number of the first one in the data set
  std::function<int(vtkIdType)> type; ///< by place in the array
};

void checkCorners(
  const CellsToCheck& part, vtkIdType points, CellSizes& sizes, const std::string& what)
{
  vtkCellArray* cells = part.cells;
  const vtkIdType count = cells->GetNumberOfCells();
  const vtkIdType ids = cells->GetConnectivityArray()->GetNumberOfValues();
  const WholeNumbers offsets(cells->GetOffsetsArray());
  const WholeNumbers corners(cells->GetConnectivityArray());
  for (vtkIdType c = 0; c < count; ++c)
  {
    const vtkIdType begin = offsets[c];
    const vtkIdType end = offsets[c + 1];
    const auto name = [&] { return "the " + what + ": cell " + std::to_string(part.first + c); };
    if (begin < 0 || end < begin || end > ids)
    {
      throw InvalidInput(name() + " has its corners at places " + std::to_string(begin) + " to " +
        std::to_string(end) + " of a list of " + std::to_string(ids) + "." + Repair);
    }
    const int type = part.type(c);
    const CellSize size = sizes.of(type);
    if (!size.isType)
    {
      throw InvalidInput(
        name() + " is of type " + std::to_string(type) + ", which VTK does not have." + Repair);
    }
    if (size.isExact ? end - begin != size.points : end - begin < size.points)
    {
      throw InvalidInput(name() + " is a " + describeCellType(type) + " of " +
        std::to_string(end - begin) + " points instead of " + std::to_string(size.points) + "." +
        Repair);
    }
    for (vtkIdType i = begin; i < end; ++i)
    {
      const vtkIdType corner = corners[i];
      if (corner < 0 || corner >= points)
      {
        throw InvalidInput(name() + " has the corner " + std::to_string(corner) +
          ", but there are " + std::to_string(points) + " points." + Repair);
      }
    }
  }
}

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
/// Faces of polyhedra: how many, and of each its number of points and these.
void checkFaceStream(vtkUnstructuredGrid* grid, const std::string& what)
{
  vtkIdTypeArray* faces = grid->GetFaces();
  vtkIdTypeArray* locations = grid->GetFaceLocations();
  const vtkIdType length = faces ? faces->GetNumberOfValues() : 0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    if (grid->GetCellType(c) != VTK_POLYHEDRON)
    {
      continue;
    }
    bool fits = locations && c < locations->GetNumberOfValues() && locations->GetValue(c) >= 0 &&
      locations->GetValue(c) < length;
    vtkIdType at = fits ? locations->GetValue(c) : 0;
    const vtkIdType count = fits ? faces->GetValue(at++) : 0;
    for (vtkIdType f = 0; f < count && fits; ++f)
    {
      fits = at < length && faces->GetValue(at) >= 0 && faces->GetValue(at) < length - at;
      const vtkIdType end = fits ? at + 1 + faces->GetValue(at) : at;
      for (++at; at < end && fits; ++at)
      {
        fits = faces->GetValue(at) >= 0 && faces->GetValue(at) < grid->GetNumberOfPoints();
      }
    }
    if (!fits)
    {
      throw InvalidInput("the " + what + ": cell " + std::to_string(c) +
        " is a polyhedron whose faces are not complete." + Repair);
    }
  }
}
#endif

void checkGrid(vtkUnstructuredGrid* grid, CellSizes& sizes, const std::string& what)
{
  vtkDataArray* types = typesOf(grid, 0);
  const vtkIdType count = grid->GetCells() ? grid->GetCells()->GetNumberOfCells() : 0;
  const vtkIdType typed = types ? types->GetNumberOfTuples() : 0;
  if (count != grid->GetNumberOfCells() || typed < count)
  {
    throw InvalidInput("the " + what + " has " + std::to_string(count) + " cells, but " +
      std::to_string(typed) + " types of them." + Repair);
  }
  if (count == 0)
  {
    return;
  }
  checkCorners({ grid->GetCells(), 0, [=](vtkIdType c) { return grid->GetCellType(c); } },
    grid->GetNumberOfPoints(), sizes, what);
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
  checkFaceStream(grid, what);
#endif
}

void checkPolyData(vtkPolyData* data, CellSizes& sizes, const std::string& what)
{
  const std::pair<vtkCellArray*, int> parts[] = { { data->GetVerts(), VTK_POLY_VERTEX },
    { data->GetLines(), VTK_POLY_LINE }, { data->GetPolys(), VTK_POLYGON },
    { data->GetStrips(), VTK_TRIANGLE_STRIP } };
  vtkIdType first = 0;
  for (const auto& [cells, type] : parts)
  {
    const int own = type;
    checkCorners(
      { cells, first, [own](vtkIdType) { return own; } }, data->GetNumberOfPoints(), sizes, what);
    first += cells->GetNumberOfCells();
  }
}

/// Which arrays are read or copied: all, or no more than flags of ghosts.
enum class ReadArrays
{
  All,
  GhostFlags
};

bool isRead(vtkAbstractArray* array, ReadArrays read)
{
  const std::string name = array->GetName() ? array->GetName() : "";
  return read == ReadArrays::All || name == vtkDataSetAttributes::GhostArrayName();
}

void checkAttributes(vtkDataSetAttributes* attributes, vtkIdType count, const std::string& kind,
  const std::string& kinds, ReadArrays read, const std::string& what)
{
  for (int a = 0; a < attributes->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(a);
    if (array->GetNumberOfTuples() != count && isRead(array, read))
    {
      throw InvalidInput("the " + what + ": the " + kind + " array \"" +
        (array->GetName() ? array->GetName() : "") + "\" has " +
        std::to_string(array->GetNumberOfTuples()) +
        (array->GetNumberOfTuples() == 1 ? " entry for " : " entries for ") +
        std::to_string(count) + " " + kinds + ". There must be one a " + kind +
        ": make it anew, or remove it.");
    }
  }
}

void checkDataSet(vtkDataSet* data, CellSizes& sizes, ReadArrays read, const std::string& what)
{
  vtkPointSet* pointSet = vtkPointSet::SafeDownCast(data);
  if (pointSet && !pointSet->GetPoints() && data->GetNumberOfCells() > 0)
  {
    throw InvalidInput("the " + what + " has " + std::to_string(data->GetNumberOfCells()) +
      " cells, but no points." + Repair);
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    checkGrid(grid, sizes, what);
  }
  else if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    checkPolyData(polyData, sizes, what);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
  {
    int sides[3];
    structured->GetDimensions(sides);
    const vtkIdType points = vtkIdType{ sides[0] } * sides[1] * sides[2];
    if (points > 0 && points != data->GetNumberOfPoints())
    {
      throw InvalidInput("the " + what + " has " + std::to_string(data->GetNumberOfPoints()) +
        " points for a grid of " + std::to_string(points) + "." + Repair);
    }
  }
  checkAttributes(data->GetPointData(), data->GetNumberOfPoints(), "point", "points", read, what);
  checkAttributes(data->GetCellData(), data->GetNumberOfCells(), "cell", "cells", read, what);
}

void checkDataObject(vtkDataObject* data, ReadArrays read, const std::string& what)
{
  CellSizes sizes;
  if (auto* single = vtkDataSet::SafeDownCast(data))
  {
    checkDataSet(single, sizes, read, what);
    return;
  }
  auto* collection = vtkCompositeDataSet::SafeDownCast(data);
  if (!collection)
  {
    return;
  }
  const auto places = vtkSmartPointer<vtkCompositeDataIterator>::Take(collection->NewIterator());
  for (places->InitTraversal(); !places->IsDoneWithTraversal(); places->GoToNextItem())
  {
    if (auto* leaf = vtkDataSet::SafeDownCast(places->GetCurrentDataObject()))
    {
      checkDataSet(
        leaf, sizes, read, what + ", block " + std::to_string(places->GetCurrentFlatIndex()));
    }
  }
}

}

std::string describeCellType(int type)
{
  const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
  return cell ? cell->GetClassName() : "cell of type " + std::to_string(type);
}

void checkData(vtkDataObject* data, const std::string& what)
{
  checkDataObject(data, ReadArrays::All, what);
}

void checkInputs(vtkAlgorithm* algorithm)
{
  // What gives its input back adds arrays, and passes the others by.
  const ReadArrays read =
    vtkDataSetAlgorithm::SafeDownCast(algorithm) ? ReadArrays::GhostFlags : ReadArrays::All;
  const int ports = algorithm->GetNumberOfInputPorts();
  for (int port = 0; port < ports; ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      checkDataObject(algorithm->GetInputDataObject(port, i), read,
        ports > 1 ? "input of port " + std::to_string(port) : "input");
    }
  }
}
}
