// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAssemblySweep.h"

#include "Core/Assemblies/VolumePieces.h"
#include "Core/Common/Describe.h"
#include "HexSweepAssemblyInput.h"
#include "HexSweepAssemblyOutput.h"
#include "HexSweepAssemblyText.h"
#include "HexSweepBodies.h"
#include "HexSweepRanks.h"
#include "HexSweepRun.h"
#include "HexSweepSolidPort.h"

#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <utility>

vtkStandardNewMacro(vtkAssemblySweep);

using namespace hexsweep;

namespace
{
/// @throw InvalidInput where a volume is named that is not there.
template <typename Named>
void checkNamed(const VolumeLabels& labels, const Named& named, const std::string& what)
{
  for (const auto& [volume, value] : named)
  {
    if (std::find(labels.ids.begin(), labels.ids.end(), volume) == labels.ids.end())
    {
      throw InvalidInput(what + " are named for volume " + std::to_string(volume) +
        ", and there is no such volume. There are " + std::to_string(labels.ids.size()) +
        ", from " + std::to_string(labels.ids.front()) + " to " +
        std::to_string(labels.ids.back()) + ".");
    }
  }
}

/// @throw InvalidInput for a number below 1.
Index layersOf(const std::map<vtkIdType, vtkIdType>& named, Index volumeId)
{
  const auto found = named.find(volumeId);
  if (found != named.end() && found->second < 1)
  {
    throw InvalidInput("volume " + std::to_string(volumeId) + " is to have " +
      std::to_string(found->second) + " layers. Give 1 or more.");
  }
  return found == named.end() ? 0 : found->second;
}

std::vector<Index> idsOf(const std::map<vtkIdType, std::vector<vtkIdType>>& named, Index volumeId)
{
  const auto found = named.find(volumeId);
  return found == named.end() ? std::vector<Index>()
                              : std::vector<Index>(found->second.begin(), found->second.end());
}
}

//------------------------------------------------------------------------------
vtkAssemblySweep::vtkAssemblySweep()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkAssemblySweep::FillInputPortInformation(int, vtkInformation* info)
{
  acceptSolids(info);
  return 1;
}

//------------------------------------------------------------------------------
int vtkAssemblySweep::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(),
    port == 0 ? "vtkPartitionedDataSetCollection" : "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
void vtkAssemblySweep::AddVolumeSource(vtkIdType volumeId, vtkIdType faceId)
{
  this->Sources[volumeId].push_back(faceId);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkAssemblySweep::AddVolumeTarget(vtkIdType volumeId, vtkIdType faceId)
{
  this->Targets[volumeId].push_back(faceId);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkAssemblySweep::RemoveAllVolumeSources()
{
  this->Sources.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkAssemblySweep::RemoveAllVolumeTargets()
{
  this->Targets.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkAssemblySweep::AddVolumeLayers(vtkIdType volumeId, vtkIdType layers)
{
  this->Layers[volumeId] = layers;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkAssemblySweep::RemoveAllVolumeLayers()
{
  this->Layers.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkAssemblySweep::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(this, outputs, [&] { this->Execute(inputs, outputs); });
}

//------------------------------------------------------------------------------
void vtkAssemblySweep::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const Ranks ranks;
  vtkDataObject* const given =
    inputs[0]->GetNumberOfInformationObjects() > 0 ? vtkDataObject::GetData(inputs[0], 0) : nullptr;
  const SolidPort port = readSolids(ranks.ofFirst(given), this->SnapToGeometry);
  for (const std::string& problem : port.problems)
  {
    vtkWarningMacro(<< problem);
  }
  AssemblyInput input =
    readAssembly(port, chosenArray(this), solidOptions(this->MatchTolerance, this->FeatureAngle));
  std::vector<AssemblyVolume>& volumes = input.volumes;
  const VolumeLabels& labels = input.labels;
  for (std::size_t v = 0; v < volumes.size(); ++v)
  {
    const Index id = labels.ids[v];
    volumes[v].named = { idsOf(this->Sources, id), idsOf(this->Targets, id),
      layersOf(this->Layers, id) };
  }
  if (!(this->Size >= 0.0) || !std::isfinite(this->Size))
  {
    throw InvalidInput("the size is " + describe(this->Size) +
      ". Set Size to a positive length, or to 0 for one that fits the assembly.");
  }
  checkNamed(labels, this->Sources, "sources");
  checkNamed(labels, this->Targets, "targets");
  checkNamed(labels, this->Layers, "layers");
  std::vector<std::string> names;
  for (const AssemblyVolume& volume : volumes)
  {
    names.push_back(volume.name);
  }
  volumes =
    cutIntoPieces(std::move(volumes), this->MatchTolerance, pipelineProgress(this, 0.0, 0.05));
  PlannedAssembly planned =
    planVolumes(volumes, this->Size, this->MatchTolerance, pipelineProgress(this, 0.05, 0.15));
  for (const std::string& warning : planned.warnings)
  {
    if (ranks.rank() == 0)
    {
      vtkWarningMacro(<< warning);
    }
  }
  std::vector<bool> isMine;
  for (const int rank : shareVolumes(planned, ranks.count()))
  {
    isMine.push_back(rank == ranks.rank());
  }
  const AssemblySweep sweep = this->Sweep(volumes, std::move(planned), isMine, ranks);
  const std::vector<std::string> sentences = describeVolumes(sweep, volumes, names);
  for (const std::string& sentence : sentences)
  {
    vtkWarningMacro(<< sentence);
  }
  const std::vector<Index> counts = ranks.greatest(assemblyCounts(sweep));
  checkAnyHexes(sweep, counts, sentences);
  const AssemblyNumbers numbers = numberAssembly(sweep, counts);
  vtkNew<vtkFieldData> fields;
  passSolidFields(port.data, fields);
  const NumberedAssembly assembly{ sweep, numbers, labels };
  writeAssembly(
    assembly, this->Merged, fields, vtkPartitionedDataSetCollection::GetData(outputs, 0));
  writeAssemblyBoundary(assembly, vtkUnstructuredGrid::GetData(outputs, 1));
}

//------------------------------------------------------------------------------
AssemblySweep vtkAssemblySweep::Sweep(const std::vector<AssemblyVolume>& volumes,
  PlannedAssembly planned, const std::vector<bool>& isMine, const Ranks& ranks)
{
  AssemblySweep sweep;
  bool isAborted = false;
  try
  {
    sweep = sweepAssembly(
      volumes, std::move(planned), isMine, smpFor(), pipelineProgress(this, 0.15, 0.95));
  }
  catch (const Aborted&)
  {
    isAborted = true;
  }
  // Where one rank stops all do: the others would wait for its numbers.
  if (ranks.greatest({ isAborted ? 1 : 0 }).front() > 0)
  {
    throw Aborted();
  }
  return sweep;
}

//------------------------------------------------------------------------------
void vtkAssemblySweep::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const auto& named) {
    os << indent << name << ":";
    for (const auto& [volume, faces] : named)
    {
      os << " " << volume << ":";
      for (const vtkIdType face : faces)
      {
        os << " " << face;
      }
    }
    os << "\n";
  };
  print("VolumeSources", this->Sources);
  print("VolumeTargets", this->Targets);
  os << indent << "VolumeLayers:";
  for (const auto& [volume, layers] : this->Layers)
  {
    os << " " << volume << ": " << layers;
  }
  os << "\n";
  os << indent << "Size: " << this->Size << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MatchTolerance: " << this->MatchTolerance << "\n";
  os << indent << "Merged: " << (this->Merged ? "On" : "Off") << "\n";
  os << indent << "SnapToGeometry: " << (this->SnapToGeometry ? "On" : "Off") << "\n";
}
