// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepBridge.h"

#include "HexSweepFailure.h"

#include "Core/Common/Describe.h"
#include "Core/Surfaces/TriangleAngles.h"

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCellTypes.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolygon.h>
#include <vtkSMPTools.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVersion.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>

namespace hexsweep
{
namespace
{
constexpr int MaximumDimensionOfCurves = 1;

void checkPresent(vtkDataSet* data, const std::string& what)
{
  if (!data)
  {
    throw InvalidInput("the " + what + verb(what, " is", " are") +
      " missing. Connect an unstructured grid or polygonal data to that input.");
  }
  if (data->GetNumberOfCells() == 0)
  {
    throw InvalidInput(
      "the " + what + verb(what, " is", " are") + " empty (no cells). Connect a surface mesh.");
  }
}

std::string describeCell(vtkIdType cell, int type)
{
  return "cell " + std::to_string(cell) + " is a " + vtkCellTypes::GetClassNameFromTypeId(type);
}

/// Reads one cell's faces into rows of `corners` point ids each.
using AppendFaces =
  std::function<void(vtkIdType id, int type, vtkGenericCell*, std::vector<Index>&)>;

SurfaceInput readSurface(
  vtkDataSet* data, const std::string& what, Index corners, const AppendFaces& append)
{
  checkPresent(data, what);
  SurfaceInput input;
  input.points = readPoints(data);
  vtkUnsignedCharArray* ghosts = data->GetCellGhostArray();
  std::vector<Index> ids;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
  {
    if (ghosts && ghosts->GetValue(c) != 0)
    {
      continue;
    }
    data->GetCell(c, cell);
    const int type = data->GetCellType(c);
    if (type == VTK_EMPTY_CELL || cell->GetCellDimension() <= MaximumDimensionOfCurves)
    {
      ++input.ignoredCells;
      continue;
    }
    if (cell->GetCellDimension() > 2)
    {
      throw InvalidInput("the " + what + ": " + describeCell(c, type) +
        ", a volume cell. Pass the surface alone (in ParaView: Extract Surface).");
    }
    append(c, type, cell, ids);
    input.cellIds.resize(ids.size() / static_cast<std::size_t>(corners), c);
  }
  if (ids.empty())
  {
    throw InvalidInput("the " + what + verb(what, " is", " are") +
      " empty (no surface cells). Connect a surface mesh.");
  }
  input.faces =
    Eigen::Map<const Faces>(ids.data(), static_cast<Index>(ids.size()) / corners, corners);
  for (const Index p : ids)
  {
    if (!input.points.row(p).allFinite())
    {
      throw InvalidInput("the " + what + ": point " + std::to_string(p) +
        " has a coordinate that is not a finite number. Repair or remove it.");
    }
  }
  return input;
}

void appendTriangles(
  vtkIdType id, int type, vtkGenericCell* cell, const std::string& what, std::vector<Index>& ids)
{
  if (cell->GetNumberOfPoints() == 3)
  {
    for (int i = 0; i < 3; ++i)
    {
      ids.push_back(cell->GetPointId(i));
    }
    return;
  }
  vtkNew<vtkIdList> triangles;
  bool done = true;
  if (type == VTK_TRIANGLE_STRIP)
  {
    for (vtkIdType i = 0; i + 2 < cell->GetNumberOfPoints(); ++i)
    {
      const bool odd = i % 2 != 0;
      triangles->InsertNextId(cell->GetPointId(static_cast<int>(odd ? i + 1 : i)));
      triangles->InsertNextId(cell->GetPointId(static_cast<int>(odd ? i : i + 1)));
      triangles->InsertNextId(cell->GetPointId(static_cast<int>(i + 2)));
    }
  }
  else if (type == VTK_QUAD || type == VTK_PIXEL)
  {
    const int order[4] = { 0, 1, type == VTK_QUAD ? 2 : 3, type == VTK_QUAD ? 3 : 2 };
    vtkIdType corner[4];
    for (int i = 0; i < 4; ++i)
    {
      corner[i] = cell->GetPointId(order[i]);
    }
    // The shorter diagonal; a tie goes to the first so that the choice is the same everywhere.
    const auto length2 = [&](int a, int b) {
      double p[3];
      double q[3];
      cell->GetPoints()->GetPoint(order[a], p);
      cell->GetPoints()->GetPoint(order[b], q);
      return vtkMath::Distance2BetweenPoints(p, q);
    };
    const int s = length2(0, 2) <= length2(1, 3) ? 0 : 1;
    for (const int i : { s, s + 1, s + 2, s, s + 2, s + 3 })
    {
      triangles->InsertNextId(corner[i % 4]);
    }
  }
  else if (type == VTK_POLYGON)
  {
    vtkNew<vtkPolygon> polygon;
    polygon->Initialize(static_cast<int>(cell->GetNumberOfPoints()), cell->GetPoints());
    vtkNew<vtkIdList> corners;
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
    done = polygon->TriangulateLocalIds(0, corners) != 0;
#else
    done = polygon->Triangulate(corners) != 0;
#endif
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      triangles->InsertNextId(cell->GetPointId(static_cast<int>(corners->GetId(i))));
    }
  }
  else
  {
    throw InvalidInput("the " + what + ": " + describeCell(id, type) +
      ". Only triangles, strips, quads and polygons are surfaces here; linearise the mesh first.");
  }
  if (!done || triangles->GetNumberOfIds() == 0)
  {
    throw InvalidInput("the " + what + ": " + describeCell(id, type) +
      " that cannot be triangulated. Repair or remove it.");
  }
  for (vtkIdType i = 0; i < triangles->GetNumberOfIds(); ++i)
  {
    ids.push_back(triangles->GetId(i));
  }
}

/// Progress of an algorithm and its abort flag, as this VTK version has them.
bool continues(vtkAlgorithm* self)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220816)
  return !self->CheckAbort();
#else
  return !self->GetAbortExecute();
#endif
}

template <typename Array, typename Value>
void addValues(vtkFieldData* fieldData, const char* name, const std::vector<Value>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), values[i]);
  }
  fieldData->AddArray(array);
}

void clearOutputs(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (vtkDataObject* output = vtkDataObject::GetData(outputs, port))
    {
      output->Initialize();
    }
  }
}
}

void acceptSurfaces(vtkInformation* portInformation)
{
  portInformation->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  portInformation->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  portInformation->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
}

vtkDataSet* inputDataSet(vtkInformationVector** inputs, int port)
{
  return inputs[port]->GetNumberOfInformationObjects() > 0 ? vtkPointSet::GetData(inputs[port], 0)
                                                           : nullptr;
}

namespace
{
/// Whether one input is empty on a rank > 0; see isIdleRank().
bool isEmptyPiece(vtkInformationVector* outputs, vtkDataSet* data, const std::string& what)
{
  const int piece =
    outputs->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
  if (piece <= 0 || !data)
  {
    return false;
  }
  if (data->GetNumberOfCells() > 0)
  {
    throw InvalidInput("the " + what +
      ": distributed over several ranks, but a cap is swept as a whole. Gather it on the first "
      "rank (a serial reader leaves it there) before sweeping.");
  }
  return true;
}
}

bool isIdleRank(vtkInformationVector* outputs, vtkInformationVector** inputs,
  const std::vector<std::string>& portNames)
{
  bool empty = false;
  for (std::size_t port = 0; port < portNames.size(); ++port)
  {
    vtkDataSet* data = inputDataSet(inputs, static_cast<int>(port));
    empty = isEmptyPiece(outputs, data, portNames[port]) || empty;
  }
  return empty;
}

std::string chosenArray(vtkAlgorithm* algorithm)
{
  vtkInformation* chosen = algorithm->GetInputArrayInformation(0);
  const char* name = chosen->Get(vtkDataObject::FIELD_NAME());
  return !name || std::string(name) == "None" ? std::string() : name;
}

std::optional<QuadMesh> readOptionalQuads(vtkDataSet* data, const std::string& what)
{
  if (!data)
  {
    return std::nullopt;
  }
  const SurfaceInput input = readQuads(data, what);
  return QuadMesh{ input.points, input.faces };
}

Points readPoints(vtkDataSet* data)
{
  Points points(data->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, points.row(i).data());
  }
  return points;
}

SurfaceInput readTriangles(vtkDataSet* data, const std::string& what)
{
  return readSurface(
    data, what, 3, [&](vtkIdType id, int type, vtkGenericCell* cell, std::vector<Index>& ids) {
      appendTriangles(id, type, cell, what, ids);
    });
}

SurfaceInput readQuads(vtkDataSet* data, const std::string& what)
{
  return readSurface(
    data, what, 4, [&](vtkIdType id, int type, vtkGenericCell* cell, std::vector<Index>& ids) {
      if (type != VTK_QUAD && type != VTK_PIXEL &&
        !(type == VTK_POLYGON && cell->GetNumberOfPoints() == 4))
      {
        throw InvalidInput("the " + what + ": " + describeCell(id, type) +
          ", not a quad. Only all-quad meshes are swept to hexes; remesh with quads.");
      }
      const bool pixel = type == VTK_PIXEL;
      for (const int i : { 0, 1, pixel ? 3 : 2, pixel ? 2 : 3 })
      {
        ids.push_back(cell->GetPointId(i));
      }
    });
}

void checkAreas(const SurfaceInput& surface, const std::string& what)
{
  const Triangles triangles = surface.faces;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    const auto corners = triangles.row(t);
    const bool collapsed =
      corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
    // A point that a cell uses twice is named where the topology is checked.
    if (!collapsed && !hasWeights(surface.points, corners))
    {
      const Eigen::RowVector3d center =
        (surface.points.row(triangles(t, 0)) + surface.points.row(triangles(t, 1)) +
          surface.points.row(triangles(t, 2))) /
        3.0;
      throw InvalidInput("the " + what + ": cell " +
        std::to_string(surface.cellIds[static_cast<std::size_t>(t)]) + " at " + describe(center) +
        " has no area or is cut into a triangle that has none, so that no angle is defined. Remove "
        "degenerate cells (in ParaView: Clean) or triangulate again.");
    }
  }
}

vtkPoints* newPoints(const PointsRef& points, int precision)
{
  vtkPoints* result =
    vtkPoints::New(precision == vtkAlgorithm::SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE);
  result->SetNumberOfPoints(points.rows());
  for (Index i = 0; i < points.rows(); ++i)
  {
    result->SetPoint(i, points.row(i).data());
  }
  return result;
}

void setCells(vtkUnstructuredGrid* grid, const FacesRef& cells, int cellType)
{
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(cells.size());
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(cells.rows() + 1);
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

Progress pipelineProgress(vtkAlgorithm* self, double from, double to)
{
  return [self, from, to](double fraction) {
    self->UpdateProgress(from + (to - from) * std::min(std::max(fraction, 0.0), 1.0));
    return continues(self);
  };
}

ParallelFor smpFor()
{
  if (vtkSMPTools::GetEstimatedNumberOfThreads() == 1)
  {
    return {}; // progress can be reported, and an abort noticed, after every piece then
  }
  return [](Index count, const std::function<void(Index)>& call) {
    // An exception that leaves a thread would end the process.
    std::vector<std::exception_ptr> failures(static_cast<std::size_t>(count));
    vtkSMPTools::For(0, count, 1, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        try
        {
          call(i);
        }
        catch (...)
        {
          failures[static_cast<std::size_t>(i)] = std::current_exception();
        }
      }
    });
    for (const std::exception_ptr& failure : failures)
    {
      if (failure)
      {
        std::rethrow_exception(failure);
      }
    }
  };
}

int runFilter(vtkAlgorithm* self, vtkInformationVector* outputs, const std::function<void()>& body)
{
  clearFailure(self);
  std::string problem;
  try
  {
    body();
    return 1;
  }
  catch (const Aborted&)
  {
    clearOutputs(outputs);
    return 1;
  }
  catch (const std::bad_alloc&)
  {
    problem = "not enough memory for this mesh. Use a coarser one or fewer layers.";
  }
  catch (const std::exception& error)
  {
    problem = error.what();
  }
  clearOutputs(outputs);
  reportFailure(self, problem);
  return 0;
}
}
