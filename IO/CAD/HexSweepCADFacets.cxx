// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepCADFacets.h"

#include "HexSweepCADRun.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>

namespace hexsweep
{
namespace
{
using Place = Eigen::RowVector3d;

Place placeOf(const gp_Pnt& point)
{
  return { point.X(), point.Y(), point.Z() };
}

/// Collects the facets of one solid.
class Collector
{
public:
  Collector(const TopTools_IndexedMapOfShape& faces, const TopTools_IndexedMapOfShape& edges)
    : FaceNumbers(faces)
    , EdgeNumbers(edges)
  {
  }

  void addFace(const TopoDS_Face& face)
  {
    const Index faceId = this->FaceNumbers.FindIndex(face);
    TopLoc_Location location;
    const opencascade::handle<Poly_Triangulation>& mesh = BRep_Tool::Triangulation(face, location);
    if (mesh.IsNull() || mesh->NbTriangles() == 0)
    {
      this->EmptyFaces.push_back(faceId);
      return;
    }
    std::vector<Index> idOf(static_cast<std::size_t>(mesh->NbNodes()) + 1, -1);
    for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
    {
      this->addEdge(TopoDS::Edge(edge.Current()), faceId, mesh, location, idOf);
    }
    for (int n = 1; n <= mesh->NbNodes(); ++n)
    {
      Index& id = idOf[static_cast<std::size_t>(n)];
      id = id >= 0 ? id : this->newPoint(mesh->Node(n).Transformed(location.Transformation()));
    }
    const bool reversed = face.Orientation() == TopAbs_REVERSED;
    for (int t = 1; t <= mesh->NbTriangles(); ++t)
    {
      int a = 0;
      int b = 0;
      int c = 0;
      mesh->Triangle(t).Get(a, b, c);
      if (reversed)
      {
        std::swap(b, c);
      }
      const std::array<Index, 3> corners{ idOf[static_cast<std::size_t>(a)],
        idOf[static_cast<std::size_t>(b)], idOf[static_cast<std::size_t>(c)] };
      if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
      {
        this->Corners.push_back(corners);
        this->FaceIds.push_back(faceId);
      }
    }
  }

  CADSolidFacets finish()
  {
    CADSolidFacets result;
    result.facets.points.resize(static_cast<Index>(this->Places.size()), 3);
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      result.facets.points.row(static_cast<Index>(i)) = this->Places[i];
    }
    result.facets.triangles.resize(static_cast<Index>(this->Corners.size()), 3);
    for (std::size_t t = 0; t < this->Corners.size(); ++t)
    {
      for (int c = 0; c < 3; ++c)
      {
        result.facets.triangles(static_cast<Index>(t), c) =
          this->Corners[t][static_cast<std::size_t>(c)];
      }
    }
    result.facets.faceIds = std::move(this->FaceIds);
    for (auto& [id, edge] : this->Edges)
    {
      std::sort(edge.faceIds.begin(), edge.faceIds.end());
      edge.faceIds.erase(std::unique(edge.faceIds.begin(), edge.faceIds.end()), edge.faceIds.end());
      result.edges.push_back(std::move(edge));
    }
    result.emptyFaces = std::move(this->EmptyFaces);
    return result;
  }

private:
  Index newPoint(const gp_Pnt& point)
  {
    this->Places.push_back(placeOf(point));
    return static_cast<Index>(this->Places.size()) - 1;
  }

  Index vertexId(const TopoDS_Vertex& vertex)
  {
    const int number = this->Vertices.Add(vertex);
    if (static_cast<std::size_t>(number) > this->VertexIds.size())
    {
      this->VertexIds.push_back(this->newPoint(BRep_Tool::Pnt(vertex)));
    }
    return this->VertexIds[static_cast<std::size_t>(number - 1)];
  }

  /// The points of an edge, made where it is met first.
  const std::vector<Index>& pointsOf(const TopoDS_Edge& edge, Index edgeId, Index faceId,
    const opencascade::handle<Poly_PolygonOnTriangulation>& polygon,
    const opencascade::handle<Poly_Triangulation>& mesh, const TopLoc_Location& location)
  {
    const auto [found, isNew] = this->Edges.try_emplace(edgeId, CADEdgeFacets{ edgeId, {}, {} });
    std::vector<Index>& points = found->second.points;
    found->second.faceIds.push_back(faceId);
    if (!isNew)
    {
      return points;
    }
    // Of the shape that is numbered: both directions of an edge are one.
    const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    double from = 0.0;
    double to = 0.0;
    const opencascade::handle<Geom_Curve> curve = BRep_Tool::Curve(forward, from, to);
    const int count = polygon->NbNodes();
    points.push_back(this->vertexId(TopExp::FirstVertex(forward)));
    for (int i = 2; i < count; ++i)
    {
      points.push_back(this->newPoint(!curve.IsNull() && polygon->HasParameters()
          ? curve->Value(polygon->Parameter(i))
          : mesh->Node(polygon->Node(i)).Transformed(location.Transformation())));
    }
    points.push_back(this->vertexId(TopExp::LastVertex(forward)));
    return points;
  }

  void addEdge(const TopoDS_Edge& edge, Index faceId,
    const opencascade::handle<Poly_Triangulation>& mesh, const TopLoc_Location& location,
    std::vector<Index>& idOf)
  {
    const opencascade::handle<Poly_PolygonOnTriangulation>& polygon =
      BRep_Tool::PolygonOnTriangulation(edge, mesh, location);
    if (polygon.IsNull())
    {
      return;
    }
    if (BRep_Tool::Degenerated(edge))
    {
      const Index id = this->vertexId(TopExp::FirstVertex(edge));
      for (int i = 1; i <= polygon->NbNodes(); ++i)
      {
        idOf[static_cast<std::size_t>(polygon->Node(i))] = id;
      }
      return;
    }
    const std::vector<Index>& points =
      this->pointsOf(edge, this->EdgeNumbers.FindIndex(edge), faceId, polygon, mesh, location);
    const std::size_t count = std::min(points.size(), static_cast<std::size_t>(polygon->NbNodes()));
    for (std::size_t i = 0; i < count; ++i)
    {
      idOf[static_cast<std::size_t>(polygon->Node(static_cast<int>(i) + 1))] = points[i];
    }
  }

  const TopTools_IndexedMapOfShape& FaceNumbers;
  const TopTools_IndexedMapOfShape& EdgeNumbers;
  TopTools_IndexedMapOfShape Vertices;
  std::vector<Index> VertexIds; // by number in Vertices - 1
  std::vector<Place> Places;
  std::vector<std::array<Index, 3>> Corners;
  std::vector<Index> FaceIds;
  std::map<Index, CADEdgeFacets> Edges;
  std::vector<Index> EmptyFaces;
};
}

void divideShape(
  const TopoDS_Shape& shape, double deflection, double angle, const Progress& progress)
{
  IMeshTools_Parameters parameters;
  parameters.Deflection = deflection;
  parameters.Angle = angle;
  parameters.AngleInterior = angle;
  parameters.DeflectionInterior = deflection;
  parameters.InParallel = false;
  parameters.AllowQualityDecrease = true; // coarser triangles take the place of finer ones
  opencascade::handle<CADProgress> shown = new CADProgress(progress);
  callCAD("the CAD kernel failed to divide the faces into triangles", [&] {
    const BRepMesh_IncrementalMesh mesher(shape, parameters, shown->Start());
    return mesher.GetStatusFlags();
  });
  shown->check();
}

CADSolidFacets facetsOfSolid(const TopoDS_Shape& solid, const TopTools_IndexedMapOfShape& faces,
  const TopTools_IndexedMapOfShape& edges)
{
  Collector collector(faces, edges);
  for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next())
  {
    collector.addFace(TopoDS::Face(face.Current()));
  }
  return collector.finish();
}
}
