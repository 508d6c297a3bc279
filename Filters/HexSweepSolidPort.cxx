// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepSolidPort.h"

#include "Core/Geometry/ReflectedGeometry.h"
#include "HexSweepArrays.h"
#include "HexSweepFineBody.h"
#include "HexSweepRun.h"

#include <vtkAlgorithm.h>
#include <vtkAppendDataSets.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

namespace hexsweep
{
namespace
{
struct Leaf
{
  vtkPointSet* data;
  Index number; ///< in the collection, from 1 on
  std::string name;
};

std::string nameOf(vtkPointSet* data, vtkInformation* metaData)
{
  auto* names =
    vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(arrays::VolumeName));
  if (names && names->GetNumberOfValues() > 0)
  {
    return names->GetValue(0);
  }
  return metaData && metaData->Has(vtkCompositeDataSet::NAME())
    ? metaData->Get(vtkCompositeDataSet::NAME())
    : "";
}

std::vector<Leaf> leavesOf(vtkCompositeDataSet* collection)
{
  std::vector<Leaf> leaves;
  if (auto* parts = vtkPartitionedDataSetCollection::SafeDownCast(collection))
  {
    for (unsigned int s = 0; s < parts->GetNumberOfPartitionedDataSets(); ++s)
    {
      for (unsigned int p = 0; p < parts->GetNumberOfPartitions(s); ++p)
      {
        auto* data = vtkPointSet::SafeDownCast(parts->GetPartition(s, p));
        if (data && data->GetNumberOfCells() > 0)
        {
          leaves.push_back({ data, Index{ s } + 1,
            nameOf(data, parts->HasMetaData(s) ? parts->GetMetaData(s) : nullptr) });
        }
      }
    }
    return leaves;
  }
  const auto places = vtkSmartPointer<vtkCompositeDataIterator>::Take(collection->NewIterator());
  Index number = 0;
  for (places->InitTraversal(); !places->IsDoneWithTraversal(); places->GoToNextItem())
  {
    auto* data = vtkPointSet::SafeDownCast(places->GetCurrentDataObject());
    if (data && data->GetNumberOfCells() > 0)
    {
      leaves.push_back({ data, ++number,
        nameOf(data, places->HasCurrentMetaData() ? places->GetCurrentMetaData() : nullptr) });
    }
  }
  return leaves;
}

vtkSmartPointer<vtkDataSet> appended(const std::vector<Leaf>& leaves)
{
  vtkNew<vtkAppendDataSets> append;
  append->MergePointsOff();
  append->SetOutputDataSetType(VTK_POLY_DATA);
  vtkNew<vtkStringArray> names;
  names->SetName(arrays::VolumeNames);
  names->SetNumberOfValues(leaves.back().number + 1);
  for (const Leaf& leaf : leaves)
  {
    if (!vtkPolyData::SafeDownCast(leaf.data))
    {
      append->SetOutputDataSetType(VTK_UNSTRUCTURED_GRID);
    }
    const auto numbered = vtkSmartPointer<vtkPointSet>::Take(leaf.data->NewInstance());
    numbered->ShallowCopy(leaf.data);
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName(arrays::VolumeId);
    ids->SetNumberOfValues(leaf.data->GetNumberOfCells());
    ids->FillValue(leaf.number);
    numbered->GetCellData()->AddArray(ids);
    append->AddInputData(numbered);
    names->SetValue(leaf.number, leaf.name);
  }
  append->Update();
  vtkSmartPointer<vtkDataSet> result = vtkDataSet::SafeDownCast(append->GetOutput());
  result->GetFieldData()->PassData(leaves.front().data->GetFieldData());
  result->GetFieldData()->RemoveArray(arrays::VolumeName); // the first one's
  result->GetFieldData()->AddArray(names);
  return result;
}
}

void acceptSolids(vtkInformation* portInformation)
{
  acceptSurfaces(portInformation);
  portInformation->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
}

void passSolidFields(vtkDataSet* solid, vtkFieldData* fields)
{
  fields->PassData(solid->GetFieldData());
  for (const char* name : { arrays::CADGeometry, arrays::CADFaceIds, arrays::CADEdgeIds,
         arrays::CADFile, arrays::CADChecksum, arrays::CADSettings, arrays::CADSolid })
  {
    fields->RemoveArray(name);
  }
}

SolidPort readSolidPort(vtkInformationVector** inputs, int port, bool withGeometry)
{
  return inputs[port]->GetNumberOfInformationObjects() > 0
    ? readSolids(vtkDataObject::GetData(inputs[port], 0), withGeometry)
    : SolidPort();
}

SolidPort readSolids(vtkDataObject* given, bool withGeometry)
{
  SolidPort result;
  const auto addGeometry = [&](vtkDataObject* data, Index volumeId) {
    std::string problem;
    if (const auto geometry =
          withGeometry ? vtkModelGeometry::Of(data, problem) : vtkModelGeometry::Geometry())
    {
      result.geometries[volumeId] = geometry;
    }
    if (!problem.empty())
    {
      result.problems.push_back(problem);
    }
  };
  auto* collection = vtkCompositeDataSet::SafeDownCast(given);
  if (!collection)
  {
    result.data = vtkPointSet::SafeDownCast(given);
    addGeometry(result.data, 0);
    return result;
  }
  const std::vector<Leaf> leaves = leavesOf(collection);
  if (leaves.empty())
  {
    result.data = vtkSmartPointer<vtkPolyData>::New();
    return result;
  }
  if (leaves.size() == 1)
  {
    result.data = leaves.front().data;
    addGeometry(result.data, 0);
    return result;
  }
  result.data = appended(leaves);
  for (const Leaf& leaf : leaves)
  {
    addGeometry(leaf.data, leaf.number);
  }
  return result;
}

void attachGeometry(const SolidPort& port, const std::function<void(const std::string&)>& tell,
  std::vector<ReadBody>& bodies)
{
  for (const std::string& problem : port.problems)
  {
    tell(problem + ". Nodes stay on the facets.");
  }
  for (ReadBody& body : bodies)
  {
    const auto found =
      port.geometries.find(port.geometries.count(0) > 0 && bodies.size() == 1 ? 0 : body.volumeId);
    if (found == port.geometries.end() || !body.problem.empty())
    {
      continue;
    }
    body.geometry = reflectedGeometry(found->second, body.solid.reflection);
    if (!liesOnGeometry(body))
    {
      body.geometry = nullptr;
      tell(messageAbout(body,
        "the triangles of the solid do not lie on the CAD surfaces that come with them: they have "
        "been moved or changed since they were read. Nodes stay on the facets."));
    }
  }
}
}
