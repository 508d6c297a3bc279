// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepAssemblyInput.h"

#include "Core/Assemblies/SurfaceRegions.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Geometry/Reflection.h"
#include "Core/Surfaces/FaceSides.h"
#include "HexSweepArrays.h"
#include "HexSweepBodies.h"
#include "HexSweepSolidReader.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointSet.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
void addVolume(SolidSurface surface, Index id, const SolidPort& port, AssemblyInput& input)
{
  AssemblyVolume volume;
  volume.surface = std::move(surface);
  const auto geometry = port.geometries.find(id);
  volume.geometry = geometry == port.geometries.end() ? nullptr : geometry->second;
  auto* names =
    vtkStringArray::SafeDownCast(port.data->GetFieldData()->GetAbstractArray(arrays::VolumeNames));
  const std::string name = names && id >= 0 && id < names->GetNumberOfValues()
    ? std::string(names->GetValue(id))
    : std::string();
  input.labels.ids.push_back(id);
  input.labels.names.push_back(name);
  input.volumes.push_back(std::move(volume));
}

/// The surface of a body where it was given.
SolidSurface givenSurface(ReadBody& body)
{
  SolidSurface surface = std::move(body.surface);
  surface.points = reflected(std::move(surface.points), body.solid.reflection);
  if (body.solid.reflection.turnsOver())
  {
    surface.triangles.col(1).swap(surface.triangles.col(2));
  }
  return surface;
}

/// Points with the same coordinates are one: the lowest of them.
Triangles withMergedPoints(const SolidInput& input)
{
  std::map<std::array<double, 3>, Index> known;
  std::vector<Index> first;
  for (Index i = 0; i < input.points.rows(); ++i)
  {
    first.push_back(
      known.try_emplace({ input.points(i, 0), input.points(i, 1), input.points(i, 2) }, i)
        .first->second);
  }
  return input.triangles.unaryExpr([&](Index i) { return first[at(i)]; });
}

/// Rows of triangles without those that lie on an earlier one, as surfaces of two readers do.
std::vector<Index> withoutTwins(const Triangles& triangles)
{
  std::set<std::array<Index, 3>> known;
  std::vector<Index> rows;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    std::array<Index, 3> corners{ triangles(t, 0), triangles(t, 1), triangles(t, 2) };
    std::sort(corners.begin(), corners.end());
    if (known.insert(corners).second)
    {
      rows.push_back(t);
    }
  }
  return rows;
}

bool isComplex(const Triangles& triangles, Index points)
{
  bool found = false;
  const std::vector<FaceSide> sides = sortedSides(triangles, points);
  forEachEdge(
    sides, [&](std::size_t first, std::size_t last) { found = found || last - first > 2; });
  return found;
}

void addRegions(const SolidData& solid, const Triangles& merged, const SolidOptions& options,
  const SolidPort& port, AssemblyInput& input)
{
  const std::vector<Index> rows = withoutTwins(merged);
  Triangles once(static_cast<Index>(rows.size()), 3);
  for (std::size_t r = 0; r < rows.size(); ++r)
  {
    once.row(static_cast<Index>(r)) = merged.row(rows[r]);
  }
  const std::vector<SurfaceRegion> regions = surfaceRegions(solid.surface.points, once);
  if (regions.empty())
  {
    throw InvalidInput("the surfaces enclose no volume. Close them: each edge needs two faces at "
                       "least.");
  }
  Index id = 0;
  for (const SurfaceRegion& region : regions)
  {
    std::vector<Index> given;
    for (const Index row : region.rows)
    {
      given.push_back(rows[at(row)]);
    }
    SolidInput own = selectTriangles(solid.surface, given);
    own.triangles = region.triangles;
    try
    {
      addVolume(makeSolidSurface(own, options), ++id, port, input);
    }
    catch (const InvalidInput& error)
    {
      throw InvalidInput("volume " + std::to_string(id) + ": " + error.what());
    }
  }
}

/// The volume cells of one id each, by id; none where there are none, or ids of them.
std::map<Index, vtkSmartPointer<vtkUnstructuredGrid>> volumeCells(vtkDataSet* data)
{
  std::map<Index, vtkSmartPointer<vtkUnstructuredGrid>> volumes;
  vtkDataArray* ids = data->GetCellData()->GetArray(arrays::VolumeId);
  ids = ids ? ids : data->GetCellData()->GetArray(arrays::CellEntityIds);
  auto* points = vtkPointSet::SafeDownCast(data);
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; ids && points && c < data->GetNumberOfCells(); ++c)
  {
    if (data->GetCell(c)->GetCellDimension() < 3)
    {
      continue;
    }
    vtkSmartPointer<vtkUnstructuredGrid>& grid = volumes[static_cast<Index>(ids->GetTuple1(c))];
    if (!grid)
    {
      grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
      grid->SetPoints(points->GetPoints());
    }
    data->GetCellPoints(c, corners);
    grid->InsertNextCell(data->GetCellType(c), corners);
  }
  return volumes;
}
}

namespace
{
/// Ids below 1 would be taken for no volume: then all are numbered from 1 on.
void numberFromOne(AssemblyInput& input)
{
  std::vector<Index>& ids = input.labels.ids;
  if (std::all_of(ids.begin(), ids.end(), [](Index id) { return id > 0; }))
  {
    return;
  }
  for (std::size_t v = 0; v < ids.size(); ++v)
  {
    ids[v] = static_cast<Index>(v) + 1;
  }
}

void nameVolumes(AssemblyInput& input)
{
  for (std::size_t v = 0; v < input.volumes.size(); ++v)
  {
    const std::string number = std::to_string(input.labels.ids[v]);
    std::string& name = input.labels.names[v];
    input.volumes[v].name =
      "volume " + number + (name.empty() ? std::string() : " (\"" + name + "\")");
    name = name.empty() ? "Volume " + number : name;
  }
}

AssemblyInput readVolumes(
  const SolidPort& port, const std::string& faceIdArray, const SolidOptions& options)
{
  AssemblyInput input;
  SolidOptions own = options;
  const auto volumes =
    port.data ? volumeCells(port.data) : std::map<Index, vtkSmartPointer<vtkUnstructuredGrid>>();
  for (const auto& [id, grid] : volumes)
  {
    SolidSurface surface = makeSolidSurface(readSolid(grid, "").surface, own);
    own.firstFaceId = *std::max_element(surface.faceIds.begin(), surface.faceIds.end()) + 1;
    addVolume(std::move(surface), id, port, input);
  }
  if (!volumes.empty())
  {
    return input;
  }
  const SolidData solid = readSolid(port.data, faceIdArray);
  if (solid.volumeIds.empty())
  {
    const Triangles merged = withMergedPoints(solid.surface);
    if (isComplex(merged, solid.surface.points.rows()))
    {
      addRegions(solid, merged, options, port, input);
      return input;
    }
  }
  std::vector<ReadBody> bodies = readBodies(port.data, faceIdArray, options);
  for (ReadBody& body : bodies)
  {
    const std::string problem = body.problem;
    addVolume(problem.empty() ? givenSurface(body) : SolidSurface(), body.volumeId, port, input);
    input.volumes.back().problem = problem;
  }
  return input;
}
}

AssemblyInput readAssembly(
  const SolidPort& port, const std::string& faceIdArray, const SolidOptions& options)
{
  AssemblyInput input = readVolumes(port, faceIdArray, options);
  numberFromOne(input);
  nameVolumes(input);
  return input;
}
}
