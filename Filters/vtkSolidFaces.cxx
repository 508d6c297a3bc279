// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSolidFaces.h"

#include "Core/Common/Constants.h"
#include "Core/Solids/FaceMeasures.h"
#include "Core/Solids/SolidInput.h"
#include "HexSweepArrays.h"
#include "HexSweepRun.h"
#include "HexSweepSolidReader.h"
#include "HexSweepWriter.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkTable.h>

vtkStandardNewMacro(vtkSolidFaces);

namespace
{
void addColumns(const std::vector<hexsweep::FaceMeasure>& faces, vtkTable* table)
{
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkIdTypeArray> triangles;
  vtkNew<vtkDoubleArray> areas;
  vtkNew<vtkDoubleArray> centers;
  vtkNew<vtkDoubleArray> flatness;
  ids->SetName("FaceId");
  triangles->SetName("Triangles");
  areas->SetName("Area");
  centers->SetName("Center");
  flatness->SetName("Flatness");
  centers->SetNumberOfComponents(3);
  for (const hexsweep::FaceMeasure& face : faces)
  {
    ids->InsertNextValue(face.id);
    triangles->InsertNextValue(face.triangles);
    areas->InsertNextValue(face.area);
    centers->InsertNextTuple(face.center.data());
    flatness->InsertNextValue(face.flatness);
  }
  table->AddColumn(ids);
  table->AddColumn(triangles);
  table->AddColumn(areas);
  table->AddColumn(centers);
  table->AddColumn(flatness);
}
}

//------------------------------------------------------------------------------
int vtkSolidFaces::FillInputPortInformation(int, vtkInformation* info)
{
  hexsweep::acceptSurfaces(info);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSolidFaces::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return hexsweep::runFilter(this, outputs, [&] {
    if (hexsweep::isIdleRank(outputs, inputs, { "solid" }))
    {
      return;
    }
    hexsweep::SolidOptions options;
    options.matchTolerance = this->MatchTolerance;
    options.featureAngle = this->FeatureAngle * hexsweep::Pi / 180.0;
    const hexsweep::SolidSurface solid = hexsweep::makeSolidSurface(
      hexsweep::readSolid(hexsweep::inputDataSet(inputs, 0), hexsweep::chosenArray(this)).surface,
      options);
    vtkTable* table = vtkTable::GetData(outputs);
    addColumns(hexsweep::measureFaces(solid), table);
    hexsweep::addReport(table->GetFieldData(), hexsweep::reports::FacesByAngle,
      static_cast<hexsweep::Index>(solid.facesByAngle));
  });
}

//------------------------------------------------------------------------------
void vtkSolidFaces::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MatchTolerance: " << this->MatchTolerance << "\n";
}
