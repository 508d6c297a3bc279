// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOneToOneSweep.h"

#include "HexSweepBodySweep.h"
#include "HexSweepChoices.h"
#include "HexSweepInteriorReport.h"
#include "HexSweepLayers.h"
#include "HexSweepLists.h"
#include "HexSweepRun.h"
#include "HexSweepSelection.h"
#include "HexSweepSolidPort.h"

#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkSelection.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkOneToOneSweep);

using namespace hexsweep;

namespace
{
/// Adds faces that are not there yet.
void addNew(const std::vector<Index>& faces, std::vector<Index>& named)
{
  for (const Index face : faces)
  {
    if (std::find(named.begin(), named.end(), face) == named.end())
    {
      named.push_back(face);
    }
  }
}

/// Adds those of the selections on ports 2 and 3.
void addSelectedFaces(
  vtkInformationVector** inputs, const std::vector<ReadBody>& bodies, NamedCaps& named)
{
  vtkDataObject* solid = vtkDataObject::GetData(inputs[0], 0);
  addNew(selectedFaces(solid, vtkSelection::GetData(inputs[2], 0), "source", bodies),
    named.sourceFaceIds);
  addNew(selectedFaces(solid, vtkSelection::GetData(inputs[3], 0), "target", bodies),
    named.targetFaceIds);
}
}

//------------------------------------------------------------------------------
vtkOneToOneSweep::vtkOneToOneSweep()
{
  this->SetNumberOfLayers(0);
  this->SetNumberOfInputPorts(4);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkOneToOneSweep::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port >= 2)
  {
    acceptSelection(info);
    return 1;
  }
  // Source quads in a collection come here too, to be refused in words instead of block by block.
  acceptSolids(info);
  return 1;
}

//------------------------------------------------------------------------------
void vtkOneToOneSweep::AddSourceFaceId(vtkIdType id)
{
  addToList(this, this->SourceFaceIds, id);
}

//------------------------------------------------------------------------------
void vtkOneToOneSweep::RemoveAllSourceFaceIds()
{
  clearList(this, this->SourceFaceIds);
}

//------------------------------------------------------------------------------
vtkIdType vtkOneToOneSweep::GetSourceFaceId(int i) const
{
  return this->SourceFaceIds.at(static_cast<std::size_t>(i));
}

//------------------------------------------------------------------------------
void vtkOneToOneSweep::AddTargetFaceId(vtkIdType id)
{
  addToList(this, this->TargetFaceIds, id);
}

//------------------------------------------------------------------------------
void vtkOneToOneSweep::RemoveAllTargetFaceIds()
{
  clearList(this, this->TargetFaceIds);
}

//------------------------------------------------------------------------------
vtkIdType vtkOneToOneSweep::GetTargetFaceId(int i) const
{
  return this->TargetFaceIds.at(static_cast<std::size_t>(i));
}

//------------------------------------------------------------------------------
void vtkOneToOneSweep::AddVolumeId(vtkIdType id)
{
  addToList(this, this->VolumeIds, id);
}

//------------------------------------------------------------------------------
void vtkOneToOneSweep::RemoveAllVolumeIds()
{
  clearList(this, this->VolumeIds);
}

//------------------------------------------------------------------------------
vtkIdType vtkOneToOneSweep::GetVolumeId(int i) const
{
  return this->VolumeIds.at(static_cast<std::size_t>(i));
}

//------------------------------------------------------------------------------
int vtkOneToOneSweep::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(this, outputs, [&] { this->Execute(inputs, outputs); });
}

//------------------------------------------------------------------------------
void vtkOneToOneSweep::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (vtkCompositeDataSet::GetData(inputs[1], 0))
  {
    throw InvalidInput("the source quads come as a composite data set. Give one mesh (in ParaView: "
                       "Extract Block, then Merge Blocks).");
  }
  const SolidPort port = readSolidPort(inputs, 0, this->SnapToGeometry);
  vtkDataSet* solid = port.data;
  if (isIdleRank(outputs, { { solid, "solid" }, { inputDataSet(inputs, 1), "source quads" } }))
  {
    return;
  }
  checkInteriorMethod(this->Method);
  checkPrecision(this->OutputPointsPrecision);
  SolidSweepSettings settings;
  settings.size = this->Size;
  settings.quadSize = this->QuadSize;
  settings.chordTolerance = this->ChordTolerance;
  settings.layers = requestedLayers(this, true);
  settings.matchTolerance = this->MatchTolerance;
  settings.projection = projectionMethod("ProjectionMethod", this->ProjectionMethod);
  settings.weights = chosenWeights(this->Weights);
  settings.improvement = chosenImprovement(this->ImproveTriangulation);
  settings.moveBoundaryNodes = this->MoveBoundaryNodes && this->EnsureValid;
  settings.hexes.method = this->Method;
  settings.hexes.ensureValid = this->EnsureValid;
  settings.hexes.improveQuality = this->ImproveQuality;
  settings.hexes.certify = this->Certify;
  settings.hexes.failIfInvalid = this->FailIfInvalid;
  settings.hexes.precision = this->OutputPointsPrecision;
  settings.tell = [this](const std::string& text) { vtkWarningMacro(<< text); };
  StageClock clock;
  std::vector<ReadBody> bodies =
    readBodies(solid, chosenArray(this), solidOptions(this->MatchTolerance, this->FeatureAngle),
      { this->VolumeIds.begin(), this->VolumeIds.end() });
  attachGeometry(port, settings.tell, bodies);
  clock.finish("Read");
  reportProgress(pipelineProgress(this), 0.02);

  auto* hexes = vtkUnstructuredGrid::GetData(outputs, 0);
  NamedCaps named{ { this->SourceFaceIds.begin(), this->SourceFaceIds.end() },
    { this->TargetFaceIds.begin(), this->TargetFaceIds.end() } };
  addSelectedFaces(inputs, bodies, named);
  const std::vector<std::string> warnings =
    sweepBodies({ solid, inputDataSet(inputs, 1), bodies }, named, settings, clock,
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
void vtkOneToOneSweep::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  printList(os, indent, "SourceFaceIds", this->SourceFaceIds);
  printList(os, indent, "TargetFaceIds", this->TargetFaceIds);
  printList(os, indent, "VolumeIds", this->VolumeIds);
  os << indent << "Size: " << this->Size << "\n";
  os << indent << "QuadSize: " << this->QuadSize << "\n";
  os << indent << "ChordTolerance: " << this->ChordTolerance << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MatchTolerance: " << this->MatchTolerance << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "ProjectionMethod: " << this->ProjectionMethod << "\n";
  os << indent << "Weights: " << this->Weights << "\n";
  os << indent << "ImproveTriangulation: " << this->ImproveTriangulation << "\n";
  os << indent << "EnsureValid: " << (this->EnsureValid ? "On" : "Off") << "\n";
  os << indent << "ImproveQuality: " << (this->ImproveQuality ? "On" : "Off") << "\n";
  os << indent << "Certify: " << (this->Certify ? "On" : "Off") << "\n";
  os << indent << "MoveBoundaryNodes: " << (this->MoveBoundaryNodes ? "On" : "Off") << "\n";
  os << indent << "SnapToGeometry: " << (this->SnapToGeometry ? "On" : "Off") << "\n";
  os << indent << "FailIfInvalid: " << (this->FailIfInvalid ? "On" : "Off") << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
