// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCADReader.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Errors.h"
#include "HexSweepCADFile.h"
#include "HexSweepCADLoad.h"
#include "HexSweepCADOutput.h"
#include "HexSweepCADRepair.h"
#include "HexSweepRun.h"

#include <vtkCompositeDataPipeline.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <string>

vtkStandardNewMacro(vtkCADReader);

using namespace hexsweep;

//------------------------------------------------------------------------------
vtkCADReader::vtkCADReader()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
bool vtkCADReader::CanReadFile(const char* fileName)
{
  return fileName && cadFormatOf(fileName);
}

//------------------------------------------------------------------------------
int vtkCADReader::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPartitionedDataSetCollection");
  return 1;
}

//------------------------------------------------------------------------------
int vtkCADReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  for (int port = 0; port < 2; ++port)
  {
    // Every rank may ask: those behind the first get the structure.
    outputs->GetInformationObject(port)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkCADReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  return runFilter(this, outputs, [&] { this->Execute(outputs); });
}

//------------------------------------------------------------------------------
void vtkCADReader::Execute(vtkInformationVector* outputs)
{
  if (this->FileName.empty())
  {
    throw InvalidInput("no file is named. Set FileName.");
  }
  const auto& units = cadLengthUnits();
  if (this->LengthUnit < FILE_UNIT || this->LengthUnit > static_cast<int>(units.size()))
  {
    throw InvalidInput("LengthUnit is " + std::to_string(this->LengthUnit) +
      ". Set it to a number from 0 (that of the file) to " + std::to_string(units.size()) + ".");
  }
  CADSettings settings;
  settings.lengthUnit = this->LengthUnit == FILE_UNIT
    ? std::string()
    : units[static_cast<std::size_t>(this->LengthUnit - 1)];
  settings.imprint = this->ImprintAndMerge;
  settings.imprintTolerance = this->ImprintTolerance;
  settings.heal = this->HealGeometry;
  vtkInformation* out = outputs->GetInformationObject(0);
  const int piece = out->Has(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER())
    ? out->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER())
    : 0;
  CADModel model = loadCADModel(this->FileName, settings, pipelineProgress(this, 0.0, 0.7));
  CADOutputSettings output;
  output.file = this->FileName;
  output.settings = writtenSettings(settings);
  output.deflection = this->LinearDeflection * model.size;
  output.angle = this->AngularDeflection * Pi / 180.0;
  output.structureOnly = piece > 0;
  writeCADModel(model, output, pipelineProgress(this, 0.7, 1.0),
    vtkPartitionedDataSetCollection::GetData(outputs, 0),
    vtkPartitionedDataSetCollection::GetData(outputs, 1));
  if (!model.leftOut.empty())
  {
    vtkWarningMacro(<< this->FileName << ": left out: " << listWords(model.leftOut) << ".");
  }
  for (const std::string& complaint : model.complaints)
  {
    vtkWarningMacro(<< this->FileName << ": " << complaint);
  }
}

//------------------------------------------------------------------------------
void vtkCADReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "LengthUnit: " << this->LengthUnit << "\n";
  os << indent << "LinearDeflection: " << this->LinearDeflection << "\n";
  os << indent << "AngularDeflection: " << this->AngularDeflection << "\n";
  os << indent << "ImprintAndMerge: " << (this->ImprintAndMerge ? "On" : "Off") << "\n";
  os << indent << "ImprintTolerance: " << this->ImprintTolerance << "\n";
  os << indent << "HealGeometry: " << (this->HealGeometry ? "On" : "Off") << "\n";
}
