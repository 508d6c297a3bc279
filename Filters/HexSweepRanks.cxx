// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepRanks.h"

#include <vtkCommunicator.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataObject.h>
#include <vtkDataObjectTypes.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkType.h>

#include <string>

namespace hexsweep
{
namespace
{

/// Blocks of a collection, in their places; nullptr where there is nothing.
struct Block
{
  vtkDataObject* data;
  std::string name;
};

std::string nameIn(vtkInformation* information)
{
  return information && information->Has(vtkCompositeDataSet::NAME())
    ? information->Get(vtkCompositeDataSet::NAME())
    : "";
}

std::vector<Block> blocksOf(vtkDataObject* data)
{
  std::vector<Block> blocks;
  if (auto* parts = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    for (unsigned int p = 0; p < parts->GetNumberOfPartitionedDataSets(); ++p)
    {
      blocks.push_back({ parts->GetNumberOfPartitions(p) > 0 ? parts->GetPartition(p, 0) : nullptr,
        parts->HasMetaData(p) ? nameIn(parts->GetMetaData(p)) : "" });
    }
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto places = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (places->InitTraversal(); !places->IsDoneWithTraversal(); places->GoToNextItem())
    {
      blocks.push_back({ places->GetCurrentDataObject(),
        places->HasCurrentMetaData() ? nameIn(places->GetCurrentMetaData()) : "" });
    }
  }
  return blocks;
}
}

Ranks::Ranks()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
  if (this->Controller)
  {
    this->Rank = this->Controller->GetLocalProcessId();
    this->Count = this->Controller->GetNumberOfProcesses();
  }
}

vtkSmartPointer<vtkDataObject> Ranks::ofFirst(vtkDataObject* data) const
{
  if (this->Count == 1)
  {
    return data;
  }
  // Each block goes by itself: not every VTK sends collections.
  const bool isFirst = this->Rank == 0;
  const std::vector<Block> blocks = isFirst ? blocksOf(data) : std::vector<Block>();
  const bool isBlocks = vtkCompositeDataSet::SafeDownCast(data) != nullptr;
  vtkIdType count = isBlocks ? static_cast<vtkIdType>(blocks.size()) : data ? -1 : 0;
  this->Controller->Broadcast(&count, 1, 0);
  if (count == 0)
  {
    return nullptr;
  }
  if (count < 0)
  {
    return this->broadcast(data);
  }
  vtkNew<vtkPartitionedDataSetCollection> received;
  for (vtkIdType b = 0; b < count; ++b)
  {
    const auto place = static_cast<unsigned int>(b);
    std::string name = isFirst ? blocks[place].name : std::string();
    auto length = static_cast<vtkIdType>(name.size());
    this->Controller->Broadcast(&length, 1, 0);
    name.resize(static_cast<std::size_t>(length));
    if (length > 0)
    {
      this->Controller->Broadcast(&name[0], length, 0);
    }
    vtkNew<vtkPartitionedDataSet> parts;
    if (const auto block = this->broadcast(isFirst ? blocks[place].data : nullptr))
    {
      parts->SetPartition(0, block);
    }
    received->SetPartitionedDataSet(place, parts);
    received->GetMetaData(place)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  }
  return isFirst ? vtkSmartPointer<vtkDataObject>(data)
                 : vtkSmartPointer<vtkDataObject>(received.Get());
}

vtkSmartPointer<vtkDataObject> Ranks::broadcast(vtkDataObject* data) const
{
  int type = data ? data->GetDataObjectType() : -1;
  this->Controller->Broadcast(&type, 1, 0);
  if (type < 0)
  {
    return nullptr;
  }
  vtkSmartPointer<vtkDataObject> result = data;
  if (this->Rank != 0)
  {
    result = vtkSmartPointer<vtkDataObject>::Take(vtkDataObjectTypes::NewDataObject(type));
  }
  this->Controller->Broadcast(result, 0);
  return result;
}

std::vector<Index> Ranks::greatest(std::vector<Index> values) const
{
  if (this->Count == 1 || values.empty())
  {
    return values;
  }
  std::vector<vtkIdType> own(values.begin(), values.end());
  std::vector<vtkIdType> all(own.size());
  this->Controller->AllReduce(
    own.data(), all.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::MAX_OP);
  return { all.begin(), all.end() };
}
}
