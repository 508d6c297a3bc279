// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/FaceGraph.h"

#include "Core/Common/DisjointSets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace hexsweep
{
namespace
{
/// Unit normals; fills the areas and sums up the faces.
Points shapes(FaceGraph& graph)
{
  const SolidSurface& solid = graph.solid;
  const Index m = solid.triangles.rows();
  const Eigen::RowVector3d least = solid.points.colwise().minCoeff();
  const Eigen::RowVector3d most = solid.points.colwise().maxCoeff();
  graph.center = 0.5 * least + 0.5 * most;
  graph.radius = 0.5 * (most - least).norm();
  Points normals(m, 3);
  graph.faces.resize(graph.patches.ids.size());
  graph.triangleAreas.resize(static_cast<std::size_t>(m));
  for (Index t = 0; t < m; ++t)
  {
    const Eigen::RowVector3d a = solid.points.row(solid.triangles(t, 0));
    const Eigen::RowVector3d b = solid.points.row(solid.triangles(t, 1));
    const Eigen::RowVector3d c = solid.points.row(solid.triangles(t, 2));
    const Eigen::RowVector3d cross = (b - a).cross(c - a);
    const double area = 0.5 * cross.norm();
    const Eigen::RowVector3d normal = cross.normalized();
    normals.row(t) = normal;
    graph.triangleAreas[static_cast<std::size_t>(t)] = area;
    FaceShape& face = graph.faces[graph.patches.faceOfTriangle[static_cast<std::size_t>(t)]];
    face.area += area;
    face.center += area / 3.0 * (a + b + c);
    face.normal += area * normal;
    Eigen::Matrix<double, 1, 6> line;
    line << normal, ((a + b + c) / 3.0 - graph.center).cross(normal) / graph.radius;
    face.moment += area * line.tail<3>();
    face.lines += area * line.transpose() * line;
  }
  for (FaceShape& face : graph.faces)
  {
    face.center /= face.area;
    face.normal /= face.area;
    face.moment /= face.area;
    face.lines /= face.area;
  }
  return normals;
}

void listPatches(FaceGraph& graph)
{
  const FacePatches& patches = graph.patches;
  graph.faceOfPatch.resize(static_cast<std::size_t>(patches.numberOfPatches));
  for (std::size_t t = 0; t < patches.patchOfTriangle.size(); ++t)
  {
    graph.faceOfPatch[static_cast<std::size_t>(patches.patchOfTriangle[t])] =
      patches.faceOfTriangle[t];
  }
  for (std::size_t p = 0; p < graph.faceOfPatch.size(); ++p)
  {
    graph.faces[graph.faceOfPatch[p]].patches.push_back(static_cast<Index>(p));
  }
}

/// Sorts the points of each face into those that other faces share and the rest.
void countPoints(FaceGraph& graph)
{
  constexpr Index None = -1;
  constexpr Index Shared = -2;
  const SolidSurface& solid = graph.solid;
  std::vector<Index> faceOf(static_cast<std::size_t>(solid.points.rows()), None);
  for (Index i = 0; i < solid.triangles.size(); ++i)
  {
    const auto face =
      static_cast<Index>(graph.patches.faceOfTriangle[static_cast<std::size_t>(i / 3)]);
    Index& owner = faceOf[static_cast<std::size_t>(solid.triangles.data()[i])];
    owner = owner == None || owner == face ? face : Shared;
  }
  for (const Index owner : faceOf)
  {
    if (owner >= 0)
    {
      ++graph.faces[static_cast<std::size_t>(owner)].innerPoints;
    }
  }
  for (Index i = 0; i < solid.triangles.size(); ++i)
  {
    const Index point = solid.triangles.data()[i];
    if (faceOf[static_cast<std::size_t>(point)] == Shared)
    {
      graph.faces[graph.patches.faceOfTriangle[static_cast<std::size_t>(i / 3)]]
        .borderPoints.push_back(point);
    }
  }
  for (FaceShape& face : graph.faces)
  {
    std::vector<Index>& points = face.borderPoints;
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
  }
}

void measureTurns(FaceGraph& graph, const Points& normals)
{
  const Index edges = graph.halfEdges.numberOfHalfEdges();
  graph.turns.resize(static_cast<std::size_t>(edges));
  for (Index half = 0; half < edges; ++half)
  {
    const Index other = graph.halfEdges.twin(half);
    const Eigen::RowVector3d own = normals.row(half / 3);
    const Eigen::RowVector3d beyond = normals.row(other / 3);
    const Eigen::RowVector3d along = graph.solid.points.row(graph.halfEdges.to(half)) -
      graph.solid.points.row(graph.halfEdges.from(half));
    const Eigen::RowVector3d cross = own.cross(beyond);
    const double angle = std::atan2(cross.norm(), own.dot(beyond));
    graph.turns[static_cast<std::size_t>(half)] = cross.dot(along) < 0.0 ? -angle : angle;
  }
}

void findContacts(FaceGraph& graph)
{
  std::map<std::pair<std::size_t, std::size_t>, FaceContact> contacts;
  for (Index half = 0; half < graph.halfEdges.numberOfHalfEdges(); ++half)
  {
    const std::size_t own = graph.patches.faceOfTriangle[static_cast<std::size_t>(half / 3)];
    const std::size_t beyond = graph.faceBeyond(half);
    if (own < beyond)
    {
      FaceContact& contact = contacts[{ own, beyond }];
      contact.halfEdges.push_back(half);
      contact.length += graph.edgeLength(half);
      contact.sharpest =
        std::max(contact.sharpest, std::abs(graph.turns[static_cast<std::size_t>(half)]));
    }
  }
  graph.contactsOfFace.resize(graph.faces.size());
  for (auto& [pair, contact] : contacts)
  {
    contact.first = pair.first;
    contact.second = pair.second;
    for (const std::size_t face : { pair.first, pair.second })
    {
      graph.contactsOfFace[face].push_back(graph.contacts.size());
    }
    graph.contacts.push_back(std::move(contact));
  }
}
}

double FaceGraph::edgeLength(Index half) const
{
  return (this->solid.points.row(this->halfEdges.to(half)) -
    this->solid.points.row(this->halfEdges.from(half)))
    .norm();
}

std::size_t FaceGraph::faceBeyond(Index half) const
{
  return this->patches.faceOfTriangle[static_cast<std::size_t>(this->halfEdges.twin(half) / 3)];
}

FaceGraph makeFaceGraph(const SolidSurface& solid)
{
  FaceGraph graph{ solid, HalfEdgeTriangles(solid.triangles), {}, {}, {}, {}, {}, {}, {}, {} };
  graph.patches = findFacePatches(solid, graph.halfEdges);
  graph.patchNeighbors = patchNeighbors(graph.patches, graph.halfEdges);
  measureTurns(graph, shapes(graph));
  listPatches(graph);
  countPoints(graph);
  findContacts(graph);
  const Index m = solid.triangles.rows();
  graph.genus = (2 - (solid.points.rows() - 3 * m / 2 + m)) / 2;
  return graph;
}

std::vector<std::size_t> facesWithIds(const FaceGraph& graph, const std::vector<Index>& ids)
{
  std::vector<std::size_t> faces;
  for (std::size_t face = 0; face < graph.patches.ids.size(); ++face)
  {
    if (std::find(ids.begin(), ids.end(), graph.patches.ids[face]) != ids.end())
    {
      faces.push_back(face);
    }
  }
  return faces;
}

std::vector<Index> stepsFrom(const FaceGraph& graph, const std::vector<std::size_t>& start)
{
  std::vector<Index> steps(graph.faces.size(), -1);
  for (const std::size_t face : start)
  {
    steps[face] = 0;
  }
  std::vector<std::size_t> queue = start;
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    for (const std::size_t c : graph.contactsOfFace[queue[i]])
    {
      const FaceContact& contact = graph.contacts[c];
      const std::size_t next = contact.first == queue[i] ? contact.second : contact.first;
      if (steps[next] < 0)
      {
        steps[next] = steps[queue[i]] + 1;
        queue.push_back(next);
      }
    }
  }
  return steps;
}

std::vector<std::vector<std::size_t>> connectedFaces(const FaceGraph& graph,
  const std::vector<char>& isMember, const std::function<bool(const FaceContact&)>& joins)
{
  DisjointSets sets(static_cast<Index>(graph.faces.size()));
  for (const FaceContact& contact : graph.contacts)
  {
    if (isMember[contact.first] && isMember[contact.second] && joins(contact))
    {
      sets.join(static_cast<Index>(contact.first), static_cast<Index>(contact.second));
    }
  }
  std::map<Index, std::vector<std::size_t>> groups;
  for (std::size_t face = 0; face < graph.faces.size(); ++face)
  {
    if (isMember[face])
    {
      groups[sets.find(static_cast<Index>(face))].push_back(face);
    }
  }
  std::vector<std::vector<std::size_t>> result;
  for (auto& group : groups)
  {
    result.push_back(std::move(group.second));
  }
  return result;
}
}
