// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSweepSets.h"

#include "HexSweepBoundarySets.h"
#include "HexSweepLists.h"
#include "HexSweepMemory.h"
#include "HexSweepRun.h"

#include <vtkCompositeDataSet.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkUnstructuredGrid.h>

vtkStandardNewMacro(vtkSweepSets);

namespace
{
void setBlock(
  vtkMultiBlockDataSet* blocks, unsigned int i, const std::string& name, vtkDataObject* block)
{
  blocks->SetBlock(i, block);
  blocks->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), name.c_str());
}
}

//------------------------------------------------------------------------------
vtkSweepSets::vtkSweepSets()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkSweepSets::AddSetId(const char* name, vtkIdType id)
{
  this->SetIds.emplace_back(name ? name : "", id);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSweepSets::RemoveAllSetIds()
{
  hexsweep::clearList(this, this->SetIds);
}

//------------------------------------------------------------------------------
int vtkSweepSets::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  // What is missing is said by the filter itself.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSweepSets::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return hexsweep::runFilter(this, outputs, [&] {
    if (hexsweep::isIdleRank(outputs, inputs, { "hexahedra", "boundary" }))
    {
      return;
    }
    auto* hexes = vtkUnstructuredGrid::SafeDownCast(hexsweep::inputDataSet(inputs, 0));
    auto* boundary = vtkUnstructuredGrid::SafeDownCast(hexsweep::inputDataSet(inputs, 1));
    const std::vector<hexsweep::BoundarySet> sets =
      hexsweep::boundarySets(hexes, boundary, this->RoleSets, this->SetIds);

    // Each quad is in two sets, each with sides and nodes, whose arrays grow by doubling.
    hexsweep::requireCopies(hexes, 1.5);
    hexsweep::requireCopies(boundary, 8.0);
    vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputs);
    vtkNew<vtkMultiBlockDataSet> elementBlocks;
    vtkNew<vtkMultiBlockDataSet> sideSets;
    vtkNew<vtkMultiBlockDataSet> nodeSets;
    setBlock(output, 0, "Element Blocks", elementBlocks);
    setBlock(output, 1, "Side Sets", sideSets);
    setBlock(output, 2, "Node Sets", nodeSets);
    setBlock(
      elementBlocks, 0, hexsweep::volumeName(hexes), hexsweep::newElementBlock(hexes, boundary));
    hexsweep::passTextsAndReports(hexes, output);
    unsigned int i = 0;
    for (const hexsweep::BoundarySet& set : sets)
    {
      setBlock(sideSets, i, set.name.sidesBlock, hexsweep::newSideSet(boundary, set));
      setBlock(nodeSets, i, set.name.nodesBlock, hexsweep::newNodeSet(boundary, set));
      ++i;
      hexsweep::reportProgress(hexsweep::pipelineProgress(this),
        static_cast<double>(i) / static_cast<double>(sets.size()));
    }
  });
}

//------------------------------------------------------------------------------
void vtkSweepSets::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RoleSets: " << (this->RoleSets ? "On" : "Off") << "\n";
  os << indent << "SetIds:";
  for (const auto& [name, id] : this->SetIds)
  {
    os << " " << name << "=" << id;
  }
  os << "\n";
}
