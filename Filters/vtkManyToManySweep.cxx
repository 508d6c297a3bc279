// SPDX-License-Identifier: BSD-3-Clause
#include "vtkManyToManySweep.h"

#include "HexSweepBodySweep.h"
#include "HexSweepChoices.h"
#include "HexSweepInteriorReport.h"
#include "HexSweepLayers.h"
#include "HexSweepLists.h"
#include "HexSweepRun.h"
#include "HexSweepSelection.h"
#include "HexSweepSolidPort.h"

#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkSelection.h>
#include <vtkUnstructuredGrid.h>

#include <string>
#include <vector>

vtkStandardNewMacro(vtkManyToManySweep);

using namespace hexsweep;

//------------------------------------------------------------------------------
vtkManyToManySweep::vtkManyToManySweep()
{
  this->SetNumberOfLayers(0);
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkManyToManySweep::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port > 0)
  {
    acceptSelection(info);
    return 1;
  }
  acceptSolids(info);
  return 1;
}

//------------------------------------------------------------------------------
void vtkManyToManySweep::AddVolumeId(vtkIdType id)
{
  addToList(this, this->VolumeIds, id);
}

//------------------------------------------------------------------------------
void vtkManyToManySweep::RemoveAllVolumeIds()
{
  clearList(this, this->VolumeIds);
}

//------------------------------------------------------------------------------
vtkIdType vtkManyToManySweep::GetVolumeId(int i) const
{
  return this->VolumeIds.at(static_cast<std::size_t>(i));
}

//------------------------------------------------------------------------------
int vtkManyToManySweep::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(this, outputs, [&] { this->Execute(inputs, outputs); });
}

//------------------------------------------------------------------------------
void vtkManyToManySweep::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const SolidPort port = readSolidPort(inputs, 0, this->SnapToGeometry);
  vtkDataSet* solid = port.data;
  if (isIdleRank(outputs, { { solid, "solid" } }))
  {
    return;
  }
  checkPrecision(this->OutputPointsPrecision);
  SolidSweepSettings settings;
  settings.size = this->Size;
  settings.chordTolerance = this->ChordTolerance;
  settings.layers = requestedLayers(this, true);
  settings.matchTolerance = this->MatchTolerance;
  settings.hexes.ensureValid = this->EnsureValid;
  settings.hexes.improveQuality = this->ImproveQuality;
  settings.hexes.failIfInvalid = this->FailIfInvalid;
  settings.hexes.precision = this->OutputPointsPrecision;
  StackSweepSettings stacks;
  stacks.direction << this->SweepDirection[0], this->SweepDirection[1], this->SweepDirection[2];
  stacks.axisPoint << this->Axis[0], this->Axis[1], this->Axis[2];
  stacks.axisDirection << this->Axis[3], this->Axis[4], this->Axis[5];
  stacks.draftAngle = this->DraftAngle;
  stacks.imprintTolerance = this->ImprintTolerance;
  settings.stacks = stacks;
  settings.tell = [this](const std::string& text) { vtkWarningMacro(<< text); };
  StageClock clock;
  SolidOptions options = solidOptions(this->MatchTolerance, this->FeatureAngle);
  // Features that are tangent touch in a line.
  options.partTouching = true;
  std::vector<ReadBody> bodies = readBodies(
    solid, chosenArray(this), options, { this->VolumeIds.begin(), this->VolumeIds.end() });
  vtkDataObject* input = vtkDataObject::GetData(inputs[0], 0);
  PickedCaps& picked = settings.stacks->picked;
  picked.sources = selectedFaces(input, vtkSelection::GetData(inputs[1], 0), "source", bodies);
  picked.targets = selectedFaces(input, vtkSelection::GetData(inputs[2], 0), "target", bodies);
  attachGeometry(port, settings.tell, bodies);
  clock.finish("Read");
  reportProgress(pipelineProgress(this), 0.02);

  auto* hexes = vtkUnstructuredGrid::GetData(outputs, 0);
  const std::vector<std::string> warnings =
    sweepBodies({ solid, nullptr, bodies }, { picked.sources, picked.targets }, settings, clock,
      pipelineProgress(this, 0.02, 1.0), hexes, vtkUnstructuredGrid::GetData(outputs, 1));
  addStageReport(hexes->GetFieldData(), clock);
  for (const std::string& warning : warnings)
  {
    if (!warning.empty())
    {
      vtkWarningMacro(<< warning);
    }
  }
}

//------------------------------------------------------------------------------
void vtkManyToManySweep::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SweepDirection: " << this->SweepDirection[0] << " " << this->SweepDirection[1]
     << " " << this->SweepDirection[2] << "\n";
  os << indent << "Axis:";
  for (const double value : this->Axis)
  {
    os << " " << value;
  }
  os << "\n";
  os << indent << "DraftAngle: " << this->DraftAngle << "\n";
  os << indent << "ImprintTolerance: " << this->ImprintTolerance << "\n";
  printList(os, indent, "VolumeIds", this->VolumeIds);
  os << indent << "Size: " << this->Size << "\n";
  os << indent << "ChordTolerance: " << this->ChordTolerance << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MatchTolerance: " << this->MatchTolerance << "\n";
  os << indent << "EnsureValid: " << (this->EnsureValid ? "On" : "Off") << "\n";
  os << indent << "ImproveQuality: " << (this->ImproveQuality ? "On" : "Off") << "\n";
  os << indent << "SnapToGeometry: " << (this->SnapToGeometry ? "On" : "Off") << "\n";
  os << indent << "FailIfInvalid: " << (this->FailIfInvalid ? "On" : "Off") << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
