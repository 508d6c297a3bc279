// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepMeshSets.h"

#include "Core/Common/Errors.h"

#include "HexSweepArrays.h"
#include "HexSweepIds.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkFieldData.h>
#include <vtkHexahedron.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace hexsweep
{
namespace
{
[[noreturn]] void refuse()
{
  throw InvalidInput(
    "the input is not a swept mesh with its sets. Connect the output of SweepSets.");
}

vtkMultiBlockDataSet* part(vtkDataObject* input, unsigned int i)
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(input);
  auto* block = blocks && i < blocks->GetNumberOfBlocks()
    ? vtkMultiBlockDataSet::SafeDownCast(blocks->GetBlock(i))
    : nullptr;
  if (!block)
  {
    refuse();
  }
  return block;
}

vtkUnstructuredGrid* gridOf(vtkMultiBlockDataSet* blocks, unsigned int i)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(i));
  if (!grid)
  {
    refuse();
  }
  return grid;
}

/// An array of whole numbers in [first, last], one for each of so many.
std::vector<vtkIdType> numbers(
  vtkFieldData* data, const char* name, vtkIdType count, vtkIdType first, vtkIdType last)
{
  vtkDataArray* array = data->GetArray(name);
  if (!array || array->GetNumberOfTuples() != count || array->GetNumberOfComponents() != 1)
  {
    refuse();
  }
  const WholeNumbers all(array);
  std::vector<vtkIdType> result(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    const std::optional<Index> number = all.at(i);
    if (!number || *number < first || *number > last)
    {
      refuse();
    }
    result[static_cast<std::size_t>(i)] = *number;
  }
  return result;
}

/// The cell of each hexahedron, whose ids in the file are those from 1 on.
std::vector<vtkIdType> cellsById(vtkUnstructuredGrid* grid)
{
  const vtkIdType count = grid->GetNumberOfCells();
  const std::vector<vtkIdType> ids =
    numbers(grid->GetCellData(), "GlobalElementId", count, 1, count);
  std::vector<vtkIdType> cells(static_cast<std::size_t>(count), -1);
  for (vtkIdType c = 0; c < count; ++c)
  {
    cells[static_cast<std::size_t>(ids[static_cast<std::size_t>(c)] - 1)] = c;
  }
  const bool isComplete = std::find(cells.begin(), cells.end(), -1) == cells.end();
  if (!isComplete || !grid->GetPoints() || !grid->IsHomogeneous() ||
    grid->GetCellType(0) != VTK_HEXAHEDRON)
  {
    refuse();
  }
  return cells;
}

std::string blockName(vtkMultiBlockDataSet* blocks, unsigned int i)
{
  const char* name =
    blocks->HasMetaData(i) ? blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? name : "";
}

/// @param name of the only volume. @param names by id; nullptr: they have none.
std::vector<MeshVolume> volumesOf(
  const MeshSets& mesh, const std::string& name, vtkStringArray* names)
{
  const auto nameOfSeveral = [&](vtkIdType id) {
    const bool isNamed = names && id < names->GetNumberOfValues() && !names->GetValue(id).empty();
    return isNamed ? std::string(names->GetValue(id)) : "Volume " + std::to_string(id);
  };
  const std::vector<vtkIdType> ids =
    numbers(mesh.grid->GetCellData(), "ObjectId", mesh.hexCount(), 1, VTK_INT_MAX);
  std::map<vtkIdType, std::vector<vtkIdType>> byId;
  for (vtkIdType hex = 0; hex < mesh.hexCount(); ++hex)
  {
    const vtkIdType cell = mesh.cells[static_cast<std::size_t>(hex)];
    byId[ids[static_cast<std::size_t>(cell)]].push_back(hex);
  }
  std::vector<MeshVolume> volumes;
  for (auto& [id, hexes] : byId)
  {
    volumes.push_back({ byId.size() == 1 ? name : nameOfSeveral(id), id, std::move(hexes) });
  }
  return volumes;
}

std::string nameOf(vtkUnstructuredGrid* set)
{
  auto* names =
    vtkStringArray::SafeDownCast(set->GetFieldData()->GetAbstractArray(arrays::SetName));
  if (!names || names->GetNumberOfValues() != 1)
  {
    refuse();
  }
  return names->GetValue(0);
}

MeshSet setOf(const MeshSets& mesh, vtkUnstructuredGrid* sides, vtkUnstructuredGrid* nodes)
{
  MeshSet set;
  set.name = nameOf(sides);
  set.id = numbers(sides->GetFieldData(), arrays::SetId, 1, 1, VTK_INT_MAX).front();
  const vtkIdType count = sides->GetNumberOfCells();
  const std::vector<vtkIdType> hexes =
    numbers(sides->GetCellData(), "SourceElementId", count, 0, mesh.hexCount() - 1);
  const std::vector<vtkIdType> faces =
    numbers(sides->GetCellData(), "SourceElementSide", count, 0, 5);
  for (std::size_t i = 0; i < hexes.size(); ++i)
  {
    set.sides.push_back({ hexes[i], static_cast<int>(faces[i]) });
  }
  set.nodes =
    numbers(nodes->GetPointData(), "GlobalNodeId", nodes->GetNumberOfPoints(), 1, mesh.nodeCount());
  std::sort(set.nodes.begin(), set.nodes.end());
  for (vtkIdType& node : set.nodes)
  {
    --node;
  }
  return set;
}
}

vtkIdType MeshSets::nodeCount() const
{
  return this->grid->GetNumberOfPoints();
}

std::array<double, 3> MeshSets::node(vtkIdType node) const
{
  std::array<double, 3> place;
  this->grid->GetPoint(node, place.data());
  return place;
}

std::array<vtkIdType, 8> MeshSets::hex(vtkIdType hex) const
{
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  this->grid->GetCells()->GetCellAtId(this->cells[static_cast<std::size_t>(hex)], count, corners);
  std::array<vtkIdType, 8> result;
  std::copy_n(corners, result.size(), result.begin());
  return result;
}

std::array<vtkIdType, 4> MeshSets::quad(const MeshSide& side) const
{
  const std::array<vtkIdType, 8> corners = this->hex(side.hex);
  const vtkIdType* face = vtkHexahedron::GetFaceArray(side.side);
  std::array<vtkIdType, 4> result;
  std::transform(face, face + result.size(), result.begin(),
    [&](vtkIdType corner) { return corners[static_cast<std::size_t>(corner)]; });
  return result;
}

std::vector<const MeshSet*> MeshSets::sets() const
{
  std::vector<const MeshSet*> all;
  for (const std::vector<MeshSet>* some : { &this->faces, &this->parts })
  {
    for (const MeshSet& set : *some)
    {
      all.push_back(&set);
    }
  }
  return all;
}

MeshSets meshSets(vtkDataObject* input)
{
  MeshSets mesh;
  vtkMultiBlockDataSet* blocks = part(input, 0);
  vtkMultiBlockDataSet* sideSets = part(input, 1);
  vtkMultiBlockDataSet* nodeSets = part(input, 2);
  mesh.grid = gridOf(blocks, 0);
  if (mesh.grid->GetNumberOfCells() == 0 ||
    sideSets->GetNumberOfBlocks() != nodeSets->GetNumberOfBlocks())
  {
    refuse();
  }
  mesh.cells = cellsById(mesh.grid);
  mesh.volumes = volumesOf(mesh, blockName(blocks, 0),
    vtkStringArray::SafeDownCast(input->GetFieldData()->GetAbstractArray(arrays::VolumeNames)));
  std::set<std::pair<vtkIdType, int>> seen;
  for (unsigned int i = 0; i < sideSets->GetNumberOfBlocks(); ++i)
  {
    MeshSet set = setOf(mesh, gridOf(sideSets, i), gridOf(nodeSets, i));
    // The faces come first and are disjoint; a part is made of faces.
    const bool isNew = std::all_of(set.sides.begin(), set.sides.end(),
      [&](const MeshSide& side) { return seen.emplace(side.hex, side.side).second; });
    (isNew ? mesh.faces : mesh.parts).push_back(std::move(set));
  }
  return mesh;
}
}
