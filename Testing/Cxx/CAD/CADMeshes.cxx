// SPDX-License-Identifier: BSD-3-Clause
#include "CADMeshes.h"

#include "vtkCADReader.h"

#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace cadmeshes
{
namespace
{
Eigen::Vector3d pointOf(vtkPointSet* grid, vtkIdType id)
{
  Eigen::Vector3d point;
  grid->GetPoint(id, point.data());
  return point;
}
}

std::string temporaryFile(const std::string& name)
{
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string full = std::string(test->test_suite_name()) + "_" + test->name() + "_" + name;
  std::replace(full.begin(), full.end(), '/', '_');
  return std::string(HEXSWEEP_TEST_OUTPUT_DIR) + "/" + full;
}

vtkPolyData* solidOf(vtkCADReader* reader, unsigned int number)
{
  return vtkPolyData::SafeDownCast(reader->GetOutput()->GetPartition(number, 0));
}

double volumeOf(vtkPolyData* triangles)
{
  double volume = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < triangles->GetNumberOfCells(); ++t)
  {
    triangles->GetCellPoints(t, corners);
    const Eigen::Vector3d a = pointOf(triangles, corners->GetId(0));
    const Eigen::Vector3d b = pointOf(triangles, corners->GetId(1));
    const Eigen::Vector3d c = pointOf(triangles, corners->GetId(2));
    volume += a.dot(b.cross(c)) / 6.0;
  }
  return volume;
}

double volumeOf(vtkUnstructuredGrid* hexes)
{
  // The flux of x / 3 through bilinear faces; two Gauss points a direction are exact for it.
  constexpr int Faces[6][4] = { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 },
    { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };
  const double places[2] = { 0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0) };
  double volume = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType h = 0; h < hexes->GetNumberOfCells(); ++h)
  {
    hexes->GetCellPoints(h, corners);
    const Eigen::Vector3d origin = pointOf(hexes, corners->GetId(0));
    for (const auto& face : Faces)
    {
      Eigen::Vector3d p[4];
      for (int c = 0; c < 4; ++c)
      {
        p[c] = pointOf(hexes, corners->GetId(face[c])) - origin;
      }
      for (const double u : places)
      {
        for (const double v : places)
        {
          const Eigen::Vector3d at =
            (1 - u) * (1 - v) * p[0] + u * (1 - v) * p[1] + u * v * p[2] + (1 - u) * v * p[3];
          const Eigen::Vector3d du = (1 - v) * (p[1] - p[0]) + v * (p[2] - p[3]);
          const Eigen::Vector3d dv = (1 - u) * (p[3] - p[0]) + u * (p[2] - p[1]);
          volume += 0.25 * at.dot(du.cross(dv)) / 3.0;
        }
      }
    }
  }
  return volume;
}

double distanceFromNearestFace(const TopoDS_Shape& shape, vtkUnstructuredGrid* boundary)
{
  constexpr vtkIdType Asked = 500;
  const vtkIdType step = std::max<vtkIdType>(1, boundary->GetNumberOfPoints() / Asked);
  double greatest = 0.0;
  for (vtkIdType point = 0; point < boundary->GetNumberOfPoints(); point += step)
  {
    const Eigen::Vector3d at = pointOf(boundary, point);
    double nearest = HUGE_VAL;
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    {
      GeomAPI_ProjectPointOnSurf search(
        gp_Pnt(at.x(), at.y(), at.z()), BRep_Tool::Surface(TopoDS::Face(face.Current())));
      nearest = search.NbPoints() > 0 ? std::min(nearest, search.LowerDistance()) : nearest;
    }
    greatest = std::max(greatest, nearest);
  }
  return greatest;
}

Distances distancesFrom(const TopoDS_Shape& shape, vtkUnstructuredGrid* boundary)
{
  TopTools_IndexedMapOfShape faces;
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  std::map<vtkIdType, std::set<int>> facesOf;
  std::map<vtkIdType, std::set<int>> partsOf; // cap or side
  vtkDataArray* ids = boundary->GetCellData()->GetArray("BoundaryId");
  vtkDataArray* parts = boundary->GetCellData()->GetArray("BoundaryPart");
  vtkNew<vtkIdList> corners;
  for (vtkIdType q = 0; q < boundary->GetNumberOfCells(); ++q)
  {
    boundary->GetCellPoints(q, corners);
    for (vtkIdType c = 0; c < 4; ++c)
    {
      facesOf[corners->GetId(c)].insert(static_cast<int>(ids->GetTuple1(q)));
      partsOf[corners->GetId(c)].insert(parts->GetTuple1(q) < 2 ? 0 : 1);
    }
  }
  const auto at = [&](vtkIdType point) {
    const Eigen::Vector3d place = pointOf(boundary, point);
    return gp_Pnt(place.x(), place.y(), place.z());
  };
  const auto fromFace = [&](vtkIdType point, const TopoDS_Shape& face) {
    GeomAPI_ProjectPointOnSurf search(at(point), BRep_Tool::Surface(TopoDS::Face(face)));
    return search.NbPoints() > 0 ? search.LowerDistance() : HUGE_VAL;
  };
  // Between the ends: nodes at corners are compared with vertices.
  const auto fromEdge = [&](vtkIdType point, const TopoDS_Shape& edge) {
    double nearest = HUGE_VAL;
    for (TopExp_Explorer end(edge, TopAbs_VERTEX); end.More(); end.Next())
    {
      nearest =
        std::min(nearest, at(point).Distance(BRep_Tool::Pnt(TopoDS::Vertex(end.Current()))));
    }
    double from = 0.0;
    double to = 0.0;
    const opencascade::handle<Geom_Curve> curve = BRep_Tool::Curve(TopoDS::Edge(edge), from, to);
    if (curve.IsNull())
    {
      return HUGE_VAL; // an edge without length
    }
    GeomAPI_ProjectPointOnCurve search(at(point), curve, from, to);
    return search.NbPoints() > 0 ? std::min(nearest, search.LowerDistance()) : nearest;
  };
  Distances result;
  for (const auto& [point, own] : facesOf)
  {
    if (own.size() == 1)
    {
      result.inFaces = std::max(result.inFaces, fromFace(point, faces.FindKey(*own.begin())));
      ++result.nodesInFaces;
    }
    else if (partsOf[point].size() == 2)
    {
      double nearest = HUGE_VAL;
      for (int e = 1; e <= edges.Extent() && nearest > 0.0; ++e)
      {
        nearest = std::min(nearest, fromEdge(point, edges.FindKey(e)));
      }
      result.onEdges = std::max(result.onEdges, nearest);
      ++result.nodesOnEdges;
    }
  }
  return result;
}
}
