// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCageHexInterior.h"

#include "Core/Interior/CageMesh.h"
#include "Core/Interior/TopologicalModel.h"
#include "HexSweepCage.h"
#include "HexSweepChoices.h"
#include "HexSweepHexOutput.h"
#include "HexSweepRun.h"
#include "HexSweepWriter.h"

#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkUnstructuredGrid.h>

#include <numeric>
#include <string>

vtkStandardNewMacro(vtkCageHexInterior);

namespace
{
hexsweep::Points modelOf(const hexsweep::SweepCage& cage)
{
  return hexsweep::topologicalModel(cage.target,
    hexsweep::cageQuads(cage.quads,
      hexsweep::physicalModel(cage.source, cage.target, cage.quads, cage.boundary),
      cage.boundary.numberOfLayers()),
    cage.boundary);
}
}

vtkCageHexInterior::vtkCageHexInterior()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

int vtkCageHexInterior::FillInputPortInformation(int, vtkInformation* info)
{
  hexsweep::acceptSurfaces(info);
  return 1;
}

void vtkCageHexInterior::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "MatchTolerance: " << this->MatchTolerance << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "EnsureValid: " << (this->EnsureValid ? "On" : "Off") << "\n";
  os << indent << "ImproveQuality: " << (this->ImproveQuality ? "On" : "Off") << "\n";
  os << indent << "Certify: " << (this->Certify ? "On" : "Off") << "\n";
  os << indent << "GenerateTopologicalModel: " << (this->GenerateTopologicalModel ? "On" : "Off")
     << "\n";
  os << indent << "FailIfInvalid: " << (this->FailIfInvalid ? "On" : "Off") << "\n";
}

int vtkCageHexInterior::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const auto body = [&]() {
    vtkDataSet* sourceData = hexsweep::inputDataSet(inputs, 0);
    vtkDataSet* targetData = hexsweep::inputDataSet(inputs, 1);
    vtkDataSet* linkingData = hexsweep::inputDataSet(inputs, 2);
    if (hexsweep::isIdleRank(outputs, inputs, { "source quads", "target quads", "linking sides" }))
    {
      return;
    }
    hexsweep::checkInteriorMethod(this->Method);
    hexsweep::checkPrecision(this->OutputPointsPrecision);
    hexsweep::StageClock clock;
    const hexsweep::CageInput cage = hexsweep::readCage(sourceData, targetData, linkingData,
      this->MatchTolerance, hexsweep::pipelineProgress(this, 0.0, 0.05));
    clock.finish("Read");
    hexsweep::reportProgress(hexsweep::pipelineProgress(this), 0.05);

    hexsweep::HexOutputSettings settings;
    settings.method = this->Method;
    settings.ensureValid = this->EnsureValid;
    settings.improveQuality = this->ImproveQuality;
    settings.certify = this->Certify;
    settings.failIfInvalid = this->FailIfInvalid;
    settings.precision = this->OutputPointsPrecision;
    hexsweep::SourceAttributes source;
    source.data = sourceData;
    source.pointIds.resize(static_cast<std::size_t>(sourceData->GetNumberOfPoints()));
    std::iota(source.pointIds.begin(), source.pointIds.end(), hexsweep::Index{ 0 });
    source.cellIds = cage.sourceCellIds;
    vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs);
    vtkFieldData* fieldData = output->GetFieldData();
    hexsweep::passFieldData(targetData, fieldData, hexsweep::interiorReports());
    hexsweep::passFieldData(sourceData, fieldData, hexsweep::interiorReports());
    const hexsweep::HexOutput hexes = hexsweep::writeHexes(
      cage, source, settings, clock, hexsweep::pipelineProgress(this, 0.05, 0.99), output);
    if (this->GenerateTopologicalModel)
    {
      hexsweep::writeSweptGrid(modelOf(cage), cage, source, this->OutputPointsPrecision,
        hexsweep::pipelineProgress(this, 0.99, 1.0), vtkUnstructuredGrid::GetData(outputs, 1));
    }
    clock.finish("Output");
    hexsweep::addStageReport(fieldData, clock);
    for (const std::string& warning : hexes.warnings)
    {
      vtkWarningMacro(<< warning);
    }
  };
  return hexsweep::runFilter(this, outputs, body);
}
