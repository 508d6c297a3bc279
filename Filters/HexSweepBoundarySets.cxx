// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepBoundarySets.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"

#include "HexSweepArrays.h"
#include "HexSweepIds.h"
#include "HexSweepMemory.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkHexahedron.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

namespace hexsweep
{
namespace
{
/// Sides of a hexahedron in the order of Exodus II, from 1 on, in that of vtkHexahedron's faces.
constexpr int VtkFaces[7] = { -1, 2, 1, 3, 0, 4, 5 };

/// Checks an array of whole numbers in a range.
void checkIds(vtkFieldData* data, const std::string& name, vtkIdType first, vtkIdType last)
{
  vtkDataArray* array = data->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw InvalidInput("the boundary has no array \"" + name +
      "\". Connect the second output (Boundary) of OneToOneSweep.");
  }
  const WholeNumbers ids(array);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const std::optional<Index> id = ids.at(i);
    if (!id || *id < first || *id > last)
    {
      throw InvalidInput("the boundary is not that of these hexahedra: entry " + std::to_string(i) +
        " of \"" + name + "\" is " + describe(array->GetComponent(i, 0)) +
        ", which is not a whole number in [" + std::to_string(first) + ", " + std::to_string(last) +
        "]. Connect both outputs of the same OneToOneSweep, unchanged.");
    }
  }
}

/// An array of ids that has been checked.
WholeNumbers idsOf(vtkFieldData* data, const char* name)
{
  return WholeNumbers(data->GetArray(name));
}

void checkCells(vtkUnstructuredGrid* grid, const std::string& what, int type, const char* cells)
{
  if (!grid || grid->GetNumberOfCells() == 0)
  {
    throw InvalidInput("the " + what + (grid ? " is empty (no cells)." : " is not connected.") +
      " Connect both outputs of OneToOneSweep: the first as Hexes, the second as Boundary.");
  }
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    if (grid->GetCellType(c) != type)
    {
      throw InvalidInput("the " + what + ": cell " + std::to_string(c) + " is no " + cells +
        ". Connect both outputs of OneToOneSweep: the first as Hexes, the second as Boundary.");
    }
  }
}

/// Every quad must be the side that it names, or sets of another mesh would be written.
void checkSides(vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary)
{
  const WholeNumbers hexIds = idsOf(boundary->GetCellData(), arrays::HexId);
  const WholeNumbers hexSides = idsOf(boundary->GetCellData(), arrays::HexSide);
  const WholeNumbers pointIds = idsOf(boundary->GetPointData(), arrays::HexPointIds);
  vtkNew<vtkIdList> corners;
  vtkNew<vtkIdList> nodes;
  for (vtkIdType q = 0; q < boundary->GetNumberOfCells(); ++q)
  {
    boundary->GetCellPoints(q, corners);
    hexes->GetCellPoints(hexIds[q], nodes);
    const vtkIdType* side = vtkHexahedron::GetFaceArray(VtkFaces[hexSides[q]]);
    std::array<vtkIdType, 4> found;
    std::array<vtkIdType, 4> expected;
    for (std::size_t i = 0; i < 4; ++i)
    {
      found[i] = pointIds[corners->GetId(static_cast<vtkIdType>(i))];
      expected[i] = nodes->GetId(side[i]);
    }
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    if (found != expected)
    {
      throw InvalidInput("the boundary is not that of these hexahedra: its quad " +
        std::to_string(q) + " is not side " + std::to_string(hexSides[q]) + " of hexahedron " +
        std::to_string(hexIds[q]) + ". Connect both outputs of the same OneToOneSweep, unchanged.");
    }
  }
}

void checkBoundary(vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary)
{
  checkCells(hexes, "mesh of hexahedra", VTK_HEXAHEDRON, "hexahedron");
  checkCells(boundary, "boundary", VTK_QUAD, "quad");
  constexpr auto AnyId = std::numeric_limits<vtkIdType>();
  checkIds(boundary->GetCellData(), arrays::BoundaryId, AnyId.min(), AnyId.max());
  checkIds(boundary->GetCellData(), arrays::BoundaryPart, 0, 2);
  checkIds(boundary->GetCellData(), arrays::HexId, 0, hexes->GetNumberOfCells() - 1);
  checkIds(boundary->GetCellData(), arrays::HexSide, 1, 6);
  checkIds(boundary->GetPointData(), arrays::HexPointIds, 0, hexes->GetNumberOfPoints() - 1);
  checkSides(hexes, boundary);
}

bool isTextOrReport(vtkAbstractArray* array)
{
  const std::string name = array->GetName() ? array->GetName() : "";
  return name.empty() || !vtkDataArray::SafeDownCast(array) || name.rfind(reports::Prefix, 0) == 0;
}

/// The ids from 1 on.
vtkSmartPointer<vtkIdTypeArray> newGlobalIds(const char* name, vtkIdType count)
{
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName(name);
  setTuples(ids.Get(), count);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + count, vtkIdType{ 1 });
  return ids;
}

vtkSmartPointer<vtkIntArray> newBlockIds(vtkUnstructuredGrid* hexes)
{
  vtkDataArray* volumes = hexes->GetCellData()->GetArray(arrays::VolumeId);
  auto ids = vtkSmartPointer<vtkIntArray>::New();
  ids->SetName("ObjectId");
  setTuples(ids.Get(), hexes->GetNumberOfCells());
  for (vtkIdType c = 0; c < hexes->GetNumberOfCells(); ++c)
  {
    const Index id = volumes ? WholeNumbers(volumes).at(c).value_or(1) : 1;
    const bool fits = id >= 1 && id <= std::numeric_limits<int>::max();
    ids->SetValue(c, fits ? static_cast<int>(id) : 1);
  }
  return ids;
}

std::vector<vtkIdType> boundaryFirst(vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary)
{
  std::vector<vtkIdType> order;
  std::vector<bool> taken(static_cast<std::size_t>(hexes->GetNumberOfCells()), false);
  const auto take = [&](vtkIdType hex) {
    if (!taken[static_cast<std::size_t>(hex)])
    {
      taken[static_cast<std::size_t>(hex)] = true;
      order.push_back(hex);
    }
  };
  const WholeNumbers hexIds = idsOf(boundary->GetCellData(), arrays::HexId);
  for (vtkIdType q = 0; q < boundary->GetNumberOfCells(); ++q)
  {
    take(hexIds[q]);
  }
  for (vtkIdType hex = 0; hex < hexes->GetNumberOfCells(); ++hex)
  {
    take(hex);
  }
  return order;
}

/// Points of the boundary that the quads use, in the order in which they do.
struct UsedPoints
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkIdTypeArray> globalIds;
  std::map<vtkIdType, vtkIdType> newId;

  UsedPoints(vtkUnstructuredGrid* boundary, const BoundarySet& set)
  {
    this->points->SetDataType(boundary->GetPoints()->GetDataType());
    this->globalIds->SetName("GlobalNodeId");
    const WholeNumbers hexPointIds = idsOf(boundary->GetPointData(), arrays::HexPointIds);
    vtkNew<vtkIdList> corners;
    for (const vtkIdType quad : set.quads)
    {
      boundary->GetCellPoints(quad, corners);
      for (const vtkIdType point : *corners)
      {
        if (this->newId.emplace(point, this->points->GetNumberOfPoints()).second)
        {
          this->points->InsertNextPoint(boundary->GetPoint(point));
          this->globalIds->InsertNextValue(hexPointIds[point] + 1);
        }
      }
    }
  }
};

using QuadsById = std::map<vtkIdType, std::vector<vtkIdType>>;

vtkStringArray* faceNames(vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary)
{
  for (vtkUnstructuredGrid* grid : { boundary, hexes })
  {
    vtkAbstractArray* names = grid->GetFieldData()->GetAbstractArray(arrays::FaceNames);
    if (vtkStringArray* texts = vtkStringArray::SafeDownCast(names))
    {
      return texts;
    }
  }
  return nullptr;
}

/// @param id that of the side set or the node set.
void addNameAndId(vtkUnstructuredGrid* set, const std::string& name, vtkIdType id)
{
  vtkNew<vtkStringArray> names;
  names->SetName(arrays::SetName);
  names->InsertNextValue(name);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(arrays::SetId);
  ids->InsertNextValue(id);
  set->GetFieldData()->AddArray(names);
  set->GetFieldData()->AddArray(ids);
}
}

std::vector<BoundarySet> boundarySets(
  vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary, bool roleSets, const ChosenIds& chosen)
{
  checkBoundary(hexes, boundary);
  const WholeNumbers faces = idsOf(boundary->GetCellData(), arrays::BoundaryId);
  const WholeNumbers parts = idsOf(boundary->GetCellData(), arrays::BoundaryPart);
  QuadsById byFace;
  QuadsById byPart;
  for (vtkIdType q = 0; q < boundary->GetNumberOfCells(); ++q)
  {
    byFace[faces[q]].push_back(q);
    if (roleSets)
    {
      byPart[parts[q]].push_back(q);
    }
  }
  std::vector<BoundarySet> sets;
  std::vector<vtkIdType> faceIds;
  for (auto& [face, quads] : byFace)
  {
    faceIds.push_back(face);
    sets.push_back({ {}, std::move(quads) });
  }
  std::vector<std::string> partNames;
  for (auto& [part, quads] : byPart)
  {
    partNames.push_back(part == 0 ? "Source" : part == 1 ? "Target" : "Sides");
    sets.push_back({ {}, std::move(quads) });
  }
  const std::vector<SetName> names =
    nameSets(faceIds, faceNames(hexes, boundary), partNames, chosen);
  for (std::size_t i = 0; i < sets.size(); ++i)
  {
    sets[i].name = names[i];
  }
  return sets;
}

std::string volumeName(vtkUnstructuredGrid* hexes)
{
  vtkDataArray* volumes = hexes->GetCellData()->GetArray(arrays::VolumeId);
  if (volumes && volumes->GetRange()[0] != volumes->GetRange()[1])
  {
    return "Volumes";
  }
  auto* names =
    vtkStringArray::SafeDownCast(hexes->GetFieldData()->GetAbstractArray(arrays::VolumeName));
  if (names && names->GetNumberOfValues() > 0 && !names->GetValue(0).empty())
  {
    return names->GetValue(0);
  }
  return "Volume " + (volumes ? describe(volumes->GetComponent(0, 0)) : std::string("1"));
}

vtkSmartPointer<vtkUnstructuredGrid> newElementBlock(
  vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary)
{
  vtkNew<vtkCellData> cellData;
  cellData->ShallowCopy(hexes->GetCellData());
  cellData->AddArray(newBlockIds(hexes));
  cellData->SetGlobalIds(newGlobalIds("GlobalElementId", hexes->GetNumberOfCells()));

  auto block = vtkSmartPointer<vtkUnstructuredGrid>::New();
  block->SetPoints(hexes->GetPoints());
  block->GetPointData()->ShallowCopy(hexes->GetPointData());
  block->GetCellData()->CopyAllOn();
  allocateTuples(cellData, hexes->GetNumberOfCells(), block->GetCellData());
  vtkNew<vtkCellArray> cells;
  requireMemory(9.0 * sizeof(vtkIdType) * static_cast<double>(hexes->GetNumberOfCells()));
  cells->AllocateExact(hexes->GetNumberOfCells(), 8 * hexes->GetNumberOfCells());
  vtkNew<vtkIdList> corners;
  for (const vtkIdType hex : boundaryFirst(hexes, boundary))
  {
    hexes->GetCellPoints(hex, corners);
    block->GetCellData()->CopyData(cellData, hex, cells->InsertNextCell(corners));
  }
  block->SetCells(VTK_HEXAHEDRON, cells);
  block->GetPointData()->SetGlobalIds(newGlobalIds("GlobalNodeId", hexes->GetNumberOfPoints()));
  vtkNew<vtkFieldData> numbers;
  for (int a = 0; a < hexes->GetFieldData()->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = hexes->GetFieldData()->GetAbstractArray(a);
    if (!isTextOrReport(array))
    {
      numbers->AddArray(array);
    }
  }
  block->SetFieldData(numbers);
  return block;
}

vtkSmartPointer<vtkUnstructuredGrid> newSideSet(
  vtkUnstructuredGrid* boundary, const BoundarySet& set)
{
  const UsedPoints used(boundary, set);
  const WholeNumbers hexIds = idsOf(boundary->GetCellData(), arrays::HexId);
  const WholeNumbers hexSides = idsOf(boundary->GetCellData(), arrays::HexSide);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdTypeArray> elements;
  elements->SetName("SourceElementId");
  vtkNew<vtkIntArray> sides;
  sides->SetName("SourceElementSide");
  vtkNew<vtkIdList> corners;
  for (const vtkIdType quad : set.quads)
  {
    boundary->GetCellPoints(quad, corners);
    for (vtkIdType& corner : *corners)
    {
      corner = used.newId.at(corner);
    }
    cells->InsertNextCell(corners);
    elements->InsertNextValue(hexIds[quad]);
    sides->InsertNextValue(VtkFaces[hexSides[quad]]);
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(used.points);
  grid->SetCells(VTK_QUAD, cells);
  grid->GetPointData()->SetGlobalIds(used.globalIds);
  grid->GetCellData()->AddArray(elements);
  grid->GetCellData()->AddArray(sides);
  addNameAndId(grid, set.name.name, set.name.id);
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> newNodeSet(
  vtkUnstructuredGrid* boundary, const BoundarySet& set)
{
  const UsedPoints used(boundary, set);
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < used.points->GetNumberOfPoints(); ++i)
  {
    cells->InsertNextCell(1, &i);
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(used.points);
  grid->SetCells(VTK_VERTEX, cells);
  grid->GetPointData()->SetGlobalIds(used.globalIds);
  addNameAndId(grid, set.name.name, set.name.nodesId);
  return grid;
}

void passTextsAndReports(vtkUnstructuredGrid* hexes, vtkDataObject* output)
{
  for (int a = 0; a < hexes->GetFieldData()->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = hexes->GetFieldData()->GetAbstractArray(a);
    if (isTextOrReport(array))
    {
      output->GetFieldData()->AddArray(array);
    }
  }
}
}
