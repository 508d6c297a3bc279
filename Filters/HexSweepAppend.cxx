// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepAppend.h"

#include "HexSweepArrays.h"
#include "HexSweepMemory.h"

#include <vtkAbstractArray.h>
#include <vtkAppendFilter.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <string>

namespace hexsweep
{
namespace
{
/// A grid with one array of ids counted on. @param attributes of the grid.
void countOn(vtkDataSetAttributes* attributes, const char* name, vtkIdType offset)
{
  vtkDataArray* ids = attributes->GetArray(name);
  vtkNew<vtkIdTypeArray> shifted;
  shifted->SetName(name);
  shifted->SetNumberOfValues(ids->GetNumberOfTuples());
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    shifted->SetValue(i, static_cast<vtkIdType>(ids->GetComponent(i, 0)) + offset);
  }
  attributes->AddArray(shifted);
}

void appendReports(vtkFieldData* more, vtkFieldData* all)
{
  for (int i = 0; i < more->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = more->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    if (name.rfind(reports::Prefix, 0) != 0)
    {
      continue;
    }
    vtkAbstractArray* known = all->GetAbstractArray(name.c_str());
    if (!known)
    {
      const auto copy = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
      copy->DeepCopy(array);
      copy->SetName(array->GetName());
      all->AddArray(copy);
      continue;
    }
    known->InsertTuples(known->GetNumberOfTuples(), array->GetNumberOfTuples(), 0, array);
  }
}
}

void appendBodies(
  const std::vector<BodyMesh>& bodies, vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary)
{
  vtkNew<vtkAppendFilter> hexAppend;
  vtkNew<vtkAppendFilter> boundaryAppend;
  vtkNew<vtkFieldData> reports;
  vtkIdType points = 0;
  vtkIdType cells = 0;
  unsigned long bytes = 0; // in units of 1024
  for (const BodyMesh& body : bodies)
  {
    countOn(body.boundary->GetPointData(), arrays::HexPointIds, points);
    countOn(body.boundary->GetCellData(), arrays::HexId, cells);
    points += body.hexes->GetNumberOfPoints();
    cells += body.hexes->GetNumberOfCells();
    appendReports(body.hexes->GetFieldData(), reports);
    bytes += body.hexes->GetActualMemorySize() + body.boundary->GetActualMemorySize();
    hexAppend->AddInputData(body.hexes);
    boundaryAppend->AddInputData(body.boundary);
  }
  requireMemory(2.0 * 1024.0 * static_cast<double>(bytes));
  hexAppend->Update();
  boundaryAppend->Update();
  hexes->ShallowCopy(hexAppend->GetOutput());
  boundary->ShallowCopy(boundaryAppend->GetOutput());
  hexes->GetFieldData()->PassData(bodies.front().hexes->GetFieldData());
  boundary->GetFieldData()->PassData(bodies.front().boundary->GetFieldData());
  hexes->GetFieldData()->PassData(reports);
  hexes->GetCellData()->SetActiveScalars(arrays::ScaledJacobian);
  boundary->GetCellData()->SetActiveScalars(arrays::BoundaryId);
}
}
