// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepSelection.h"

#include "Core/Solids/SolidMessages.h"
#include "HexSweepSolidPort.h"

#include <vtkAlgorithm.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>

#include <map>
#include <set>

namespace hexsweep
{
namespace
{
constexpr const char* Number = "HexSweepSelectionNumber";
constexpr const char* HowTo = "In ParaView select cells on a face (key s), then press Copy Active "
                              "Selection.";

/// With its own number on each cell, counted on from `next`.
vtkSmartPointer<vtkDataObject> numberedLeaf(vtkDataObject* leaf, vtkIdType& next)
{
  auto copy = vtkSmartPointer<vtkDataObject>::Take(leaf->NewInstance());
  copy->ShallowCopy(leaf);
  if (auto* data = vtkDataSet::SafeDownCast(copy))
  {
    vtkNew<vtkIdTypeArray> numbers;
    numbers->SetName(Number);
    numbers->SetNumberOfValues(data->GetNumberOfCells());
    for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
    {
      numbers->SetValue(c, next++);
    }
    data->GetCellData()->AddArray(numbers);
  }
  return copy;
}

using Visit = std::function<void(vtkCompositeDataIterator*, vtkDataObject*)>;

void forEachLeaf(vtkCompositeDataSet* collection, const Visit& visit)
{
  const auto places = vtkSmartPointer<vtkCompositeDataIterator>::Take(collection->NewIterator());
  for (places->InitTraversal(); !places->IsDoneWithTraversal(); places->GoToNextItem())
  {
    visit(places, places->GetCurrentDataObject());
  }
}

vtkSmartPointer<vtkDataObject> numberedCopy(vtkDataObject* solid)
{
  vtkIdType next = 0;
  auto* collection = vtkCompositeDataSet::SafeDownCast(solid);
  if (!collection)
  {
    return numberedLeaf(solid, next);
  }
  auto copy = vtkSmartPointer<vtkCompositeDataSet>::Take(collection->NewInstance());
  copy->CopyStructure(collection);
  forEachLeaf(collection, [&](vtkCompositeDataIterator* place, vtkDataObject* leaf) {
    copy->SetDataSet(place, numberedLeaf(leaf, next));
  });
  return copy;
}

/// What a node of a selection lists. @throw InvalidInput where it is no list of cells.
vtkDataArray* listedCells(vtkSelectionNode* node, const std::string& cap)
{
  const int type = node->GetFieldType();
  if (type != vtkSelectionNode::CELL && type != -1)
  {
    throw InvalidInput("the " + cap + " selection is of points or rows, not of cells. " + HowTo);
  }
  auto* list = vtkDataArray::SafeDownCast(node->GetSelectionList());
  const bool inverse = node->GetProperties()->Has(vtkSelectionNode::INVERSE()) &&
    node->GetProperties()->Get(vtkSelectionNode::INVERSE()) != 0;
  if (node->GetContentType() != vtkSelectionNode::INDICES || inverse)
  {
    throw InvalidInput("the " + cap + " selection is no list of cells, but a query or a region. " +
      "Freeze it (in ParaView: Edit, Find Data), or select cells on the face (key s).");
  }
  return list; // nullptr: nothing
}

/// Numbers of the cells that are selected.
std::set<vtkIdType> selectedNumbers(
  vtkDataObject* solid, vtkSelection* selection, const std::string& cap)
{
  std::set<vtkIdType> numbers;
  for (unsigned int n = 0; n < selection->GetNumberOfNodes(); ++n)
  {
    vtkSelectionNode* node = selection->GetNode(n);
    vtkDataArray* list = listedCells(node, cap);
    vtkInformation* about = node->GetProperties();
    const int block = about->Has(vtkSelectionNode::COMPOSITE_INDEX())
      ? about->Get(vtkSelectionNode::COMPOSITE_INDEX())
      : -1; // all
    vtkIdType first = 0;
    const auto add = [&](vtkDataObject* leaf, bool isMeant) {
      auto* data = vtkDataSet::SafeDownCast(leaf);
      const vtkIdType count = data ? data->GetNumberOfCells() : 0;
      for (vtkIdType i = 0; isMeant && list && i < list->GetNumberOfTuples(); ++i)
      {
        const auto cell = static_cast<vtkIdType>(list->GetTuple1(i));
        if (cell >= 0 && cell < count)
        {
          numbers.insert(first + cell);
        }
      }
      first += count;
    };
    if (auto* collection = vtkCompositeDataSet::SafeDownCast(solid))
    {
      forEachLeaf(collection, [&](vtkCompositeDataIterator* place, vtkDataObject* leaf) {
        add(leaf, block < 0 || place->GetCurrentFlatIndex() == static_cast<unsigned int>(block));
      });
    }
    else
    {
      add(solid, true);
    }
  }
  return numbers;
}

/// Cells of the solid as readSolids() joins them, by their ids there.
std::set<Index> selectedCells(vtkDataObject* solid, vtkSelection* selection, const std::string& cap)
{
  const vtkSmartPointer<vtkDataObject> numbered = numberedCopy(solid);
  const std::set<vtkIdType> numbers = selectedNumbers(solid, selection, cap);
  const SolidPort port = readSolids(numbered, false);
  auto* own = vtkIdTypeArray::SafeDownCast(port.data->GetCellData()->GetArray(Number));
  std::set<Index> cells;
  for (vtkIdType c = 0; own && c < own->GetNumberOfValues(); ++c)
  {
    if (numbers.count(own->GetValue(c)) > 0)
    {
      cells.insert(c);
    }
  }
  return cells;
}

/// Faces that each of some cells is part of, of one body.
std::map<Index, std::set<Index>> facesOfCells(const ReadBody& body, const std::set<Index>& cells)
{
  std::map<Index, std::set<Index>> faces;
  for (std::size_t t = 0; t < body.surface.cellIds.size(); ++t)
  {
    if (cells.count(body.surface.cellIds[t]) > 0)
    {
      faces[body.surface.cellIds[t]].insert(body.surface.faceIds[t]);
    }
  }
  return faces;
}

/// Those of cells that are part of one face only. @throw InvalidInput where there are cells, but no
/// such.
std::set<Index> certainFaces(
  const std::map<Index, std::set<Index>>& facesOfCell, const std::string& cap)
{
  std::set<Index> certain;
  for (const auto& [cell, faces] : facesOfCell)
  {
    if (faces.size() == 1)
    {
      certain.insert(*faces.begin());
    }
  }
  if (certain.empty() && !facesOfCell.empty())
  {
    const auto& [cell, faces] = *facesOfCell.begin();
    throw InvalidInput("each cell of the " + cap + " selection is part of several faces, cell " +
      std::to_string(cell) + " of " + listFaces({ faces.begin(), faces.end() }) +
      ". Select a cell in the middle of the face.");
  }
  return certain;
}
}

void acceptSelection(vtkInformation* portInformation)
{
  portInformation->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkSelection");
  portInformation->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
}

std::vector<Index> selectedFaces(vtkDataObject* solid, vtkSelection* selection,
  const std::string& cap, const std::vector<ReadBody>& bodies)
{
  if (!selection)
  {
    return {};
  }
  const std::set<Index> cells = selectedCells(solid, selection, cap);
  std::set<Index> chosen;
  const ReadBody* owner = nullptr;
  for (const ReadBody& body : bodies)
  {
    const std::set<Index> faces = certainFaces(facesOfCells(body, cells), cap);
    if (!faces.empty() && owner)
    {
      throw InvalidInput("the " + cap +
        " selection is on several bodies: " + listFaces({ chosen.begin(), chosen.end() }) + " of " +
        owner->name + ", and " + listFaces({ faces.begin(), faces.end() }) + " of " + body.name +
        ". Select faces of one of them.");
    }
    if (!faces.empty())
    {
      owner = &body;
      chosen = faces;
    }
  }
  if (chosen.empty())
  {
    throw InvalidInput("the " + cap + " selection has no cells of the solid's surface. " + HowTo);
  }
  return { chosen.begin(), chosen.end() };
}
}
