// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepCapDiskGrid.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/DiskMaps/MapDistortion.h"
#include "Core/Solvers/SurfaceLaplacian.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "HexSweepArrays.h"
#include "HexSweepMemory.h"
#include "HexSweepReader.h"
#include "HexSweepWriter.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr std::size_t FlipsToName = 10;

const char* nameOf(DiskDomain domain)
{
  switch (domain)
  {
    case DiskDomain::Annulus:
      return "Annulus";
    case DiskDomain::Circles:
      return "Circles";
    default:
      return "Disk";
  }
}

DiskDomain domainNamed(const std::string& name)
{
  for (const DiskDomain domain : { DiskDomain::Annulus, DiskDomain::Circles })
  {
    if (name == nameOf(domain))
    {
      return domain;
    }
  }
  return DiskDomain::Disk;
}

Weights weightsNamed(const std::string& name)
{
  for (const Weights weights : { Weights::MeanValue, Weights::Intrinsic })
  {
    if (name == nameOf(weights))
    {
      return weights;
    }
  }
  return Weights::Cotangent;
}

Points inSpace(const PlanePoints& plane)
{
  Points points = Points::Zero(plane.rows(), 3);
  points.leftCols<2>() = plane;
  return points;
}

vtkSmartPointer<vtkDoubleArray> vectors(const char* name, const PointsRef& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  setTuples(array.Get(), values.rows());
  for (Index i = 0; i < values.rows(); ++i)
  {
    array->SetTypedTuple(i, values.row(i).data());
  }
  return array;
}

/// Attributes of the input under the new numbering; ids[i] < 0 gives null values.
void copyAttributes(vtkDataSetAttributes* from, vtkDataSetAttributes* to,
  const std::vector<Index>& ids, const char* idsName)
{
  const vtkIdType count = static_cast<vtkIdType>(ids.size());
  to->CopyAllOn();
  allocateTuples(from, count, to);
  vtkNew<vtkIdTypeArray> origin;
  origin->SetName(idsName);
  setTuples(origin.Get(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Index id = ids[static_cast<std::size_t>(i)];
    if (id >= 0)
    {
      to->CopyData(from, id, i);
    }
    else
    {
      to->NullData(i);
    }
    origin->SetValue(i, id);
  }
  to->AddArray(origin);
}

void writeMapReport(const CapDisk& cap, vtkFieldData* field)
{
  const MapDistortion distortion = mapDistortion(cap);
  addReport(field, reports::Loops, static_cast<Index>(cap.loops.size()));
  addReport(field, reports::DirichletEnergy, distortion.dirichletEnergy);
  addReport(field, reports::WorstAngleDistortion, distortion.worstAngle);
  addReport(field, reports::MeanAngleDistortion, distortion.meanAngle);
  if (cap.rounds.empty())
  {
    return;
  }
  addReport(field, reports::KoebeRounds, static_cast<Index>(cap.rounds.size()));
  addReport(field, reports::KoebeConverged, static_cast<Index>(cap.converged ? 1 : 0));
  std::vector<double> changes;
  for (std::size_t r = 1; r < cap.rounds.size(); ++r)
  {
    changes.push_back(cap.rounds[r].change);
  }
  addReport(field, reports::KoebeChanges, changes);
  addReport(field, reports::Circularity, cap.circularity);
}

/// The first text of an array, or of another one where there is no such array; else empty.
std::string textOf(vtkFieldData* field, const char* name, const char* otherName = nullptr)
{
  for (const char* each : { name, otherName })
  {
    auto* texts = each ? vtkStringArray::SafeDownCast(field->GetAbstractArray(each)) : nullptr;
    if (texts && texts->GetNumberOfValues() > 0)
    {
      return texts->GetValue(0);
    }
  }
  return {};
}

Points arrayPoints(vtkDataArray* array)
{
  Points points(array->GetNumberOfTuples(), 3);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->GetTuple(i, points.row(i).data());
  }
  return points;
}
}

const char* nameOf(Weights weights)
{
  switch (weights)
  {
    case Weights::MeanValue:
      return "MeanValue";
    case Weights::Intrinsic:
      return "IntrinsicCotangent";
    default:
      return "Cotangent";
  }
}

void writeCapDisk(const CapDisk& cap, const CapOrigin& origin, int precision, bool outputDisk,
  vtkUnstructuredGrid* output)
{
  const Points disk = inSpace(cap.disk);
  output->SetPoints(
    vtkSmartPointer<vtkPoints>::Take(newPoints(outputDisk ? disk : cap.mesh.points, precision)));
  setCells(output, cap.mesh.triangles, VTK_TRIANGLE);

  std::vector<Index> pointIds;
  for (Index i = 0; i < cap.mesh.points.rows(); ++i)
  {
    pointIds.push_back(i < cap.numberOfOriginalPoints ? i : -1);
  }
  std::vector<Index> cellIds;
  for (const Index face : cap.triangleOrigin)
  {
    cellIds.push_back(origin.cellIds[static_cast<std::size_t>(face)]);
  }
  copyAttributes(
    origin.data->GetPointData(), output->GetPointData(), pointIds, arrays::OriginalPointIds);
  copyAttributes(
    origin.data->GetCellData(), output->GetCellData(), cellIds, arrays::OriginalCellIds);
  output->GetPointData()->AddArray(vectors(arrays::DiskCoordinates, disk));
  if (outputDisk)
  {
    output->GetPointData()->AddArray(vectors(arrays::SurfacePoints, cap.mesh.points));
  }

  vtkFieldData* field = output->GetFieldData();
  field->PassData(origin.data->GetFieldData());
  addReport(field, arrays::DiskMapDomain, std::string(nameOf(cap.domain)));
  addReport(field, reports::Weights, std::string(nameOf(cap.weights)));
  addReport(field, reports::Method, std::string(nameOf(cap.weights)));
  addReport(field, reports::FlipsBefore, cap.flipsBefore);
  addReport(field, reports::FlipsAfter, static_cast<Index>(cap.flipped.size()));
  addReport(field, reports::EdgeFlips, cap.edgeFlips);
  addReport(field, reports::AddedPoints, cap.addedPoints);
  addReport(field, reports::IgnoredCells, origin.ignoredCells);
  Points circles(static_cast<Index>(cap.holes.size()), 3);
  for (std::size_t h = 0; h < cap.holes.size(); ++h)
  {
    circles.row(static_cast<Index>(h)) << cap.holes[h].center.x(), cap.holes[h].center.y(),
      cap.holes[h].radius;
  }
  field->AddArray(vectors(arrays::HoleCircles, circles));
  writeMapReport(cap, field);
}

CapDisk readCapDisk(vtkDataSet* data, const std::string& what)
{
  TriangleInput surface = readTriangles(data, what);
  vtkDataArray* disk = data->GetPointData()->GetArray(arrays::DiskCoordinates);
  if (!disk || disk->GetNumberOfComponents() != 3)
  {
    throw InvalidInput("the " + what + " has no point array " + arrays::DiskCoordinates +
      " with 3 components. Apply HarmonicDiskMap to it first, or set DiskMaps to Automatic.");
  }
  CapDisk cap;
  vtkDataArray* ownPoints = data->GetPointData()->GetArray(arrays::SurfacePoints);
  cap.mesh.points = ownPoints ? arrayPoints(ownPoints) : std::move(surface.mesh.points);
  cap.mesh.triangles = std::move(surface.mesh.triangles);
  cap.triangleOrigin = std::move(surface.cellIds);
  cap.numberOfOriginalPoints = cap.mesh.points.rows();
  cap.disk = arrayPoints(disk).leftCols<2>();
  if (!cap.disk.allFinite())
  {
    throw InvalidInput("the " + what + ": array " + arrays::DiskCoordinates +
      " has values that are not finite. Apply HarmonicDiskMap again.");
  }
  cap.domain = domainNamed(textOf(data->GetFieldData(), arrays::DiskMapDomain));
  cap.weights = weightsNamed(textOf(data->GetFieldData(), reports::Weights, reports::Method));
  vtkDataArray* circles = data->GetFieldData()->GetArray(arrays::HoleCircles);
  if (circles && circles->GetNumberOfComponents() == 3)
  {
    const Points holes = arrayPoints(circles);
    for (Index h = 0; h < holes.rows(); ++h)
    {
      cap.holes.push_back({ holes.row(h).head<2>(), holes(h, 2) });
    }
  }
  cap.loops = checkSurface(cap.mesh.triangles, cap.mesh.points.rows(), what).loops;
  cap.flipped = domainTriangles(cap.domain, cap.disk, cap.mesh.triangles).flipped;
  cap.flipsBefore = static_cast<Index>(cap.flipped.size());
  return cap;
}

std::string describeFlips(const CapDisk& cap, const std::string& what)
{
  if (cap.flipped.empty())
  {
    return {};
  }
  std::string text = std::to_string(cap.flipped.size()) + " of " +
    std::to_string(cap.mesh.triangles.rows()) + " triangles of the " + what +
    " are flipped in the disk (the first at";
  for (std::size_t i = 0; i < std::min(FlipsToName, cap.flipped.size()); ++i)
  {
    const auto triangle = cap.mesh.triangles.row(cap.flipped[i]);
    const Eigen::RowVector3d center =
      (cap.mesh.points.row(triangle[0]) + cap.mesh.points.row(triangle[1]) +
        cap.mesh.points.row(triangle[2])) /
      3.0;
    text += (i > 0 ? ", " : " ") + describe(center);
  }
  return text + "): the map is not one-to-one there. A finer or more regular triangulation helps.";
}
}
