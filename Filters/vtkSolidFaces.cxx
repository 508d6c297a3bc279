// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSolidFaces.h"

#include "Core/Solids/FaceMeasures.h"
#include "HexSweepArrays.h"
#include "HexSweepBodies.h"
#include "HexSweepRun.h"
#include "HexSweepSolidPort.h"
#include "HexSweepWriter.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkDataSet.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

vtkStandardNewMacro(vtkSolidFaces);

namespace
{
/// @param names by face id; nullptr: there are none.
void addRows(
  const std::vector<hexsweep::ReadBody>& bodies, vtkStringArray* names, vtkTable* table)
{
  vtkNew<vtkIdTypeArray> volumes;
  volumes->SetName(hexsweep::arrays::VolumeId);
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkIdTypeArray> triangles;
  vtkNew<vtkDoubleArray> areas;
  vtkNew<vtkDoubleArray> centers;
  vtkNew<vtkDoubleArray> flatness;
  vtkNew<vtkStringArray> own;
  vtkNew<vtkStringArray> types;
  own->SetName("Name");
  types->SetName("Surface");
  ids->SetName("FaceId");
  triangles->SetName("Triangles");
  areas->SetName("Area");
  centers->SetName("Center");
  flatness->SetName("Flatness");
  centers->SetNumberOfComponents(3);
  for (const hexsweep::ReadBody& body : bodies)
  {
    for (const hexsweep::FaceMeasure& face : hexsweep::measureFaces(body.surface))
    {
      const hexsweep::Points center =
        hexsweep::reflected(hexsweep::Points(face.center), body.solid.reflection);
      ids->InsertNextValue(face.id);
      triangles->InsertNextValue(face.triangles);
      areas->InsertNextValue(face.area);
      centers->InsertNextTuple(center.data());
      flatness->InsertNextValue(face.flatness);
      volumes->InsertNextValue(body.volumeId);
      const bool isNamed = names && face.id >= 0 && face.id < names->GetNumberOfValues();
      own->InsertNextValue(isNamed ? names->GetValue(face.id) : vtkStdString());
      types->InsertNextValue(body.geometry ? body.geometry->surfaceType(face.id) : std::string());
    }
  }
  table->AddColumn(ids);
  table->AddColumn(triangles);
  table->AddColumn(areas);
  table->AddColumn(centers);
  table->AddColumn(flatness);
  table->AddColumn(volumes);
  table->AddColumn(own);
  table->AddColumn(types);
}
}

//------------------------------------------------------------------------------
int vtkSolidFaces::FillInputPortInformation(int, vtkInformation* info)
{
  hexsweep::acceptSolids(info);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSolidFaces::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return hexsweep::runFilter(this, outputs, [&] {
    const hexsweep::SolidPort port = hexsweep::readSolidPort(inputs, 0, true);
    if (hexsweep::isIdleRank(outputs, { { port.data, "solid" } }))
    {
      return;
    }
    std::vector<hexsweep::ReadBody> bodies =
      hexsweep::readBodies(port.data, hexsweep::chosenArray(this),
        hexsweep::solidOptions(this->MatchTolerance, this->FeatureAngle));
    hexsweep::checkAreSolids(bodies);
    hexsweep::attachGeometry(
      port, [this](const std::string& text) { vtkWarningMacro(<< text); }, bodies);
    vtkTable* table = vtkTable::GetData(outputs);
    addRows(bodies,
      vtkStringArray::SafeDownCast(
        port.data->GetFieldData()->GetAbstractArray(hexsweep::arrays::FaceNames)),
      table);
    hexsweep::addReport(table->GetFieldData(), hexsweep::reports::FacesByAngle,
      static_cast<hexsweep::Index>(bodies.front().surface.facesByAngle));
  });
}

//------------------------------------------------------------------------------
void vtkSolidFaces::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MatchTolerance: " << this->MatchTolerance << "\n";
}
