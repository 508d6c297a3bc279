// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepWriter.h"

#include "Core/Geometry/CoordinateRange.h"
#include "HexSweepMemory.h"

#include <vtkAbstractArray.h>
#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace hexsweep
{
namespace
{
template <typename Array, typename Value>
void addValues(vtkFieldData* fieldData, const char* name, const std::vector<Value>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  setTuples(array.Get(), static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), values[i]);
  }
  fieldData->AddArray(array);
}

}

vtkPoints* newPoints(const PointsRef& points, int precision)
{
  const bool isSingle = precision == vtkAlgorithm::SINGLE_PRECISION;
  if (isSingle)
  {
    checkFitsSinglePrecision(points);
  }
  vtkPoints* result = vtkPoints::New(isSingle ? VTK_FLOAT : VTK_DOUBLE);
  setTuples(result->GetData(), points.rows());
  for (Index i = 0; i < points.rows(); ++i)
  {
    result->SetPoint(i, points.row(i).data());
  }
  return result;
}

void setCells(vtkUnstructuredGrid* grid, const FacesRef& cells, int cellType)
{
  vtkNew<vtkIdTypeArray> connectivity;
  setTuples(connectivity.Get(), cells.size());
  vtkNew<vtkIdTypeArray> offsets;
  setTuples(offsets.Get(), cells.rows() + 1);
  for (Index c = 0; c < cells.rows(); ++c)
  {
    offsets->SetValue(c, c * cells.cols());
    for (Index i = 0; i < cells.cols(); ++i)
    {
      connectivity->SetValue(c * cells.cols() + i, cells(c, i));
    }
  }
  offsets->SetValue(cells.rows(), cells.size());
  vtkNew<vtkCellArray> array;
  array->SetData(offsets, connectivity);
  grid->SetCells(cellType, array);
}

void addReport(vtkFieldData* fieldData, const char* name, double value)
{
  addReport(fieldData, name, std::vector<double>{ value });
}

void passFieldData(vtkDataSet* input, vtkFieldData* output, const std::vector<std::string>& own)
{
  vtkFieldData* fieldData = input->GetFieldData();
  for (int i = 0; i < fieldData->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = fieldData->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    if (std::find(own.begin(), own.end(), name) == own.end())
    {
      output->AddArray(array);
    }
  }
}

void addIds(vtkFieldData* data, const char* name, const std::vector<Index>& ids)
{
  addValues<vtkIdTypeArray>(data, name, ids);
}

void addReport(vtkFieldData* fieldData, const char* name, Index value)
{
  addIds(fieldData, name, { value });
}

void addReport(vtkFieldData* fieldData, const char* name, const std::string& value)
{
  addReport(fieldData, name, std::vector<std::string>{ value });
}

void addReport(vtkFieldData* fieldData, const char* name, const std::vector<std::string>& values)
{
  addValues<vtkStringArray>(fieldData, name, values);
}

void addReport(vtkFieldData* fieldData, const char* name, const std::vector<double>& values)
{
  addValues<vtkDoubleArray>(fieldData, name, values);
}

}
