// SPDX-License-Identifier: BSD-3-Clause
#include "vtkModelGeometry.h"

#include "Core/Geometry/ModelGeometry.h"
#include "HexSweepArrays.h"

#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationObjectBaseKey.h>
#include <vtkObjectFactory.h>

#include <utility>

vtkStandardNewMacro(vtkModelGeometry);
vtkInformationKeyMacro(vtkModelGeometry, MODEL_GEOMETRY, ObjectBase);

namespace
{
vtkModelGeometry::Restorer& restorer()
{
  static vtkModelGeometry::Restorer known = nullptr;
  return known;
}
}

//------------------------------------------------------------------------------
vtkModelGeometry::vtkModelGeometry() = default;
vtkModelGeometry::~vtkModelGeometry() = default;

//------------------------------------------------------------------------------
void vtkModelGeometry::SetMaker(Maker maker)
{
  this->Make = std::move(maker);
  this->Model = nullptr;
  this->Problem.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
vtkModelGeometry::Geometry vtkModelGeometry::GetGeometry(std::string& problem)
{
  const std::lock_guard<std::mutex> lock(this->Making);
  if (this->Make)
  {
    const Maker make = std::exchange(this->Make, nullptr);
    this->Model = make(this->Problem);
  }
  problem = this->Problem;
  return this->Model;
}

//------------------------------------------------------------------------------
void vtkModelGeometry::SetRestorer(Restorer known)
{
  restorer() = known;
}

//------------------------------------------------------------------------------
vtkModelGeometry::Geometry vtkModelGeometry::Of(vtkDataObject* data, std::string& problem)
{
  if (!data)
  {
    return nullptr;
  }
  if (auto* own = vtkModelGeometry::SafeDownCast(
        data->GetInformation()->Get(vtkModelGeometry::MODEL_GEOMETRY())))
  {
    return own->GetGeometry(problem);
  }
  vtkFieldData* fields = data->GetFieldData();
  if (!fields || !fields->HasArray(hexsweep::arrays::CADFaceIds))
  {
    return nullptr;
  }
  if (!restorer())
  {
    problem = "the solid brings its CAD geometry, but the library that reads it is not loaded (in "
              "Python: name hexsweep.vtkCADReader once) or was not built (it needs OpenCASCADE)";
    return nullptr;
  }
  return restorer()(data, problem);
}

//------------------------------------------------------------------------------
void vtkModelGeometry::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* state = this->Make ? "not made yet" : "none";
  os << indent << "Geometry: " << (this->Model ? "made" : state) << "\n";
}
