// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepReader.h"

#include "HexSweepInputCheck.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/CoordinateRange.h"
#include "Core/Surfaces/QuadHalving.h"
#include "Core/Surfaces/TriangleAngles.h"

#include <vtkCellType.h>
#include <vtkDataSet.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolygon.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersion.h>

#include <functional>
#include <utility>

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
  return "cell " + std::to_string(cell) + " is a " + describeCellType(type);
}

/// Appends the corners of a cell's faces, 3 or 4 point ids each.
using AppendFaces =
  std::function<void(vtkIdType id, int type, vtkGenericCell*, std::vector<Index>&)>;

/// Faces of a data set as rows of corners.
struct FaceRows
{
  Points points;
  std::vector<Index> corners; ///< point ids, face after face
  std::vector<Index> cellIds; ///< one a face
  Index ignoredCells = 0;
};

FaceRows readSurface(
  vtkDataSet* data, const std::string& what, std::size_t cornersEach, const AppendFaces& append)
{
  checkPresent(data, what);
  FaceRows faces;
  faces.points = readPoints(data);
  vtkUnsignedCharArray* ghosts = data->GetCellGhostArray();
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
      ++faces.ignoredCells;
      continue;
    }
    if (cell->GetCellDimension() > 2)
    {
      throw InvalidInput("the " + what + ": " + describeCell(c, type) +
        ", a volume cell. Pass the surface alone (in ParaView: Extract Surface).");
    }
    append(c, type, cell, faces.corners);
    faces.cellIds.resize(faces.corners.size() / cornersEach, c);
  }
  if (faces.corners.empty())
  {
    throw InvalidInput("the " + what + verb(what, " is", " are") +
      " empty (no surface cells). Connect a surface mesh.");
  }
  checkCoordinates(faces.points, faces.corners, what);
  return faces;
}

template <typename Rows>
Rows rowsOf(const std::vector<Index>& corners)
{
  return Eigen::Map<const Rows>(corners.data(),
    static_cast<Index>(corners.size()) / Rows::ColsAtCompileTime, Rows::ColsAtCompileTime);
}

/// Local corners of the triangles of a strip of n points.
std::vector<int> cutStrip(int n)
{
  std::vector<int> corners;
  for (int i = 0; i + 2 < n; ++i)
  {
    const bool odd = i % 2 != 0;
    corners.insert(corners.end(), { odd ? i + 1 : i, odd ? i : i + 1, i + 2 });
  }
  return corners;
}

/// Local corners of the halves of a quad or pixel.
std::vector<int> cutQuad(vtkGenericCell* cell, bool isPixel)
{
  const int order[4] = { 0, 1, isPixel ? 3 : 2, isPixel ? 2 : 3 };
  Eigen::Matrix<double, 4, 3> corners;
  for (int c = 0; c < 4; ++c)
  {
    double p[3];
    cell->GetPoints()->GetPoint(order[c], p);
    corners.row(c) << p[0], p[1], p[2];
  }
  const auto s = static_cast<int>(shorterDiagonal(corners));
  return { order[s], order[s + 1], order[s + 2], order[s], order[s + 2], order[(s + 3) % 4] };
}

/// Local corners of the triangles of a polygon; none where there is no way to cut it.
std::vector<int> cutPolygon(vtkGenericCell* cell)
{
  vtkNew<vtkPolygon> polygon;
  polygon->Initialize(static_cast<int>(cell->GetNumberOfPoints()), cell->GetPoints());
  vtkNew<vtkIdList> corners;
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  const bool done = polygon->TriangulateLocalIds(0, corners) != 0;
#else
  const bool done = polygon->Triangulate(corners) != 0;
#endif
  return done ? std::vector<int>(corners->begin(), corners->end()) : std::vector<int>();
}

std::vector<int> cutCell(vtkIdType id, int type, vtkGenericCell* cell, const std::string& what)
{
  const int n = static_cast<int>(cell->GetNumberOfPoints());
  if (n == 3)
  {
    return { 0, 1, 2 };
  }
  switch (type)
  {
    case VTK_TRIANGLE_STRIP:
      return cutStrip(n);
    case VTK_QUAD:
    case VTK_PIXEL:
      return cutQuad(cell, type == VTK_PIXEL);
    case VTK_POLYGON:
      return cutPolygon(cell);
    default:
      throw InvalidInput("the " + what + ": " + describeCell(id, type) +
        ". Only triangles, strips, quads and polygons are surfaces here; linearise the mesh "
        "first.");
  }
}

void appendTriangles(
  vtkIdType id, int type, vtkGenericCell* cell, const std::string& what, std::vector<Index>& ids)
{
  const std::vector<int> corners = cutCell(id, type, cell, what);
  if (corners.empty())
  {
    throw InvalidInput("the " + what + ": " + describeCell(id, type) +
      " that cannot be triangulated. Repair or remove it.");
  }
  for (const int corner : corners)
  {
    ids.push_back(cell->GetPointId(corner));
  }
}

void appendQuad(
  vtkIdType id, int type, vtkGenericCell* cell, const std::string& what, std::vector<Index>& ids)
{
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
}
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

TriangleInput readTriangles(vtkDataSet* data, const std::string& what)
{
  FaceRows faces = readSurface(
    data, what, 3, [&](vtkIdType id, int type, vtkGenericCell* cell, std::vector<Index>& ids) {
      appendTriangles(id, type, cell, what, ids);
    });
  return { { std::move(faces.points), rowsOf<Triangles>(faces.corners) }, std::move(faces.cellIds),
    faces.ignoredCells };
}

QuadInput readQuads(vtkDataSet* data, const std::string& what)
{
  FaceRows faces = readSurface(
    data, what, 4, [&](vtkIdType id, int type, vtkGenericCell* cell, std::vector<Index>& ids) {
      appendQuad(id, type, cell, what, ids);
    });
  return { { std::move(faces.points), rowsOf<Quads>(faces.corners) }, std::move(faces.cellIds),
    faces.ignoredCells };
}

std::optional<QuadMesh> readOptionalQuads(vtkDataSet* data, const std::string& what)
{
  return data ? std::optional<QuadMesh>(readQuads(data, what).mesh) : std::nullopt;
}

void checkAreas(const PointsRef& points, const TrianglesRef& triangles,
  const std::vector<Index>& cellIds, const std::string& what)
{
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    const auto corners = triangles.row(t);
    const bool collapsed =
      corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
    // A point that a cell uses twice is named where the topology is checked.
    if (!collapsed && !hasWeights(points, corners))
    {
      const Eigen::RowVector3d center =
        (points.row(triangles(t, 0)) + points.row(triangles(t, 1)) + points.row(triangles(t, 2))) /
        3.0;
      throw InvalidInput("the " + what + ": cell " +
        std::to_string(cellIds[static_cast<std::size_t>(t)]) + " at " + describe(center) +
        " has no area or is cut into a triangle that has none, so that no angle is defined. Remove "
        "degenerate cells (in ParaView: Clean) or triangulate again.");
    }
  }
}

void checkAreas(const TriangleInput& surface, const std::string& what)
{
  checkAreas(surface.mesh.points, surface.mesh.triangles, surface.cellIds, what);
}
}
