// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/RemeshingMesh.h"

#include "Core/Common/Errors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace hexsweep
{
double triangleShape(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b,
  const Eigen::RowVector3d& c, const Eigen::RowVector3d& normal)
{
  const double longest =
    std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() });
  const double length = normal.norm();
  return longest > 0.0 && length > 0.0 ? 0.5 * (b - a).cross(c - a).dot(normal) / (longest * length)
                                       : 0.0;
}

RemeshingMesh::RemeshingMesh(const RemeshingInput& input, const SurfaceSearch& surface, double size)
  : Before(input.stays.size(), -1)
  , After(input.stays.size(), -1)
{
  const Points& points = input.mesh.points;
  if (points.rows() > std::numeric_limits<int>::max() / 8)
  {
    throw InvalidInput("the cap has more points than a half-edge mesh can number.");
  }
  this->Triangulation.add_property(this->Data);
  const SurfacePlaces places = surface.project(points);
  for (Index i = 0; i < points.rows(); ++i)
  {
    const Vertex v = this->Triangulation.add_vertex({ points(i, 0), points(i, 1), points(i, 2) });
    const auto k = static_cast<std::size_t>(i);
    this->data(
      v) = { i, size, size, places.normals.row(i), places.triangles[k], false, input.stays[k] };
  }
  const auto vertex = [](Index i) { return Vertex(static_cast<int>(i)); };
  for (Index t = 0; t < input.mesh.triangles.rows(); ++t)
  {
    this->Triangulation.add_face(vertex(input.mesh.triangles(t, 0)),
      vertex(input.mesh.triangles(t, 1)), vertex(input.mesh.triangles(t, 2)));
  }
  for (const std::vector<Index>& curve : input.curves)
  {
    this->addCurve(curve);
  }
  this->measureCurves(input, size);
}

void RemeshingMesh::addCurve(const std::vector<Index>& curve)
{
  for (std::size_t k = 0; k + 1 < curve.size(); ++k)
  {
    this->KeptEdges.insert(keyOf(curve[k], curve[k + 1]));
    if (k > 0)
    {
      this->Before[static_cast<std::size_t>(curve[k])] = curve[k - 1];
      this->After[static_cast<std::size_t>(curve[k])] = curve[k + 1];
    }
  }
  for (const Index point : curve)
  {
    this->data(Vertex(static_cast<int>(point))).onCurve = true;
  }
}

void RemeshingMesh::measureCurves(const RemeshingInput& input, double size)
{
  const auto stays = [&](Index point) { return input.stays[static_cast<std::size_t>(point)]; };
  std::vector<double> sum(input.stays.size(), 0.0);
  std::vector<double> count(input.stays.size(), 0.0);
  for (const std::vector<Index>& curve : input.curves)
  {
    for (std::size_t first = 0; first + 1 < curve.size();)
    {
      std::size_t last = first + 1;
      while (!stays(curve[last]))
      {
        ++last;
      }
      const double length =
        (input.mesh.points.row(curve[last]) - input.mesh.points.row(curve[first])).norm();
      for (std::size_t k = first; k <= last; ++k)
      {
        sum[static_cast<std::size_t>(curve[k])] += length;
        count[static_cast<std::size_t>(curve[k])] += 1.0;
      }
      first = last;
    }
  }
  for (const auto v : this->Triangulation.vertices())
  {
    const auto i = static_cast<std::size_t>(v.idx());
    if (count[i] > 0.0)
    {
      this->data(v).spacing = std::min(size, sum[i] / count[i]);
    }
  }
}

std::uint64_t RemeshingMesh::keyOf(Index a, Index b)
{
  return (static_cast<std::uint64_t>(std::min(a, b)) << 32) |
    static_cast<std::uint64_t>(std::max(a, b));
}

Eigen::RowVector3d RemeshingMesh::position(Vertex v) const
{
  return Eigen::Map<const Eigen::RowVector3d>(this->Triangulation.point(v).data());
}

double RemeshingMesh::relativeLength(Edge e) const
{
  const HalfEdge h = this->Triangulation.halfedge_handle(e, 0);
  const Vertex a = this->Triangulation.from_vertex_handle(h);
  const Vertex b = this->Triangulation.to_vertex_handle(h);
  return (this->position(a) - this->position(b)).norm() /
    (0.5 * (this->data(a).wanted + this->data(b).wanted));
}

double RemeshingMesh::shape(Vertex a, Vertex b, Vertex c) const
{
  return triangleShape(this->position(a), this->position(b), this->position(c),
    this->data(a).normal + this->data(b).normal + this->data(c).normal);
}

bool RemeshingMesh::isKept(Vertex a, Vertex b) const
{
  return this->data(a).onCurve && this->data(b).onCurve &&
    this->KeptEdges.count(keyOf(this->data(a).label, this->data(b).label)) > 0;
}

bool RemeshingMesh::isKept(Edge e) const
{
  const HalfEdge h = this->Triangulation.halfedge_handle(e, 0);
  return this->Triangulation.is_boundary(e) ||
    this->isKept(
      this->Triangulation.from_vertex_handle(h), this->Triangulation.to_vertex_handle(h));
}

RemeshingMesh::CurveNeighbors RemeshingMesh::curveNeighbors(Index label) const
{
  const auto i = static_cast<std::size_t>(label);
  return { this->Before[i], this->After[i] };
}

bool RemeshingMesh::canTakeShortCut(Index label) const
{
  const auto [before, after] = this->curveNeighbors(label);
  return before != after && this->KeptEdges.count(keyOf(before, after)) == 0;
}

void RemeshingMesh::takeShortCut(Index label)
{
  const auto [before, after] = this->curveNeighbors(label);
  this->KeptEdges.erase(keyOf(before, label));
  this->KeptEdges.erase(keyOf(label, after));
  this->KeptEdges.insert(keyOf(before, after));
  this->After[static_cast<std::size_t>(before)] = after;
  this->Before[static_cast<std::size_t>(after)] = before;
}

std::vector<OpenMesh::SmartVertexHandle> RemeshingMesh::order() const
{
  std::vector<bool> seen(this->Triangulation.n_vertices(), false);
  std::vector<OpenMesh::SmartVertexHandle> order;
  const auto add = [&](OpenMesh::SmartVertexHandle v) {
    if (!seen[static_cast<std::size_t>(v.idx())])
    {
      seen[static_cast<std::size_t>(v.idx())] = true;
      order.push_back(v);
    }
  };
  std::size_t next = 0;
  for (const auto start : this->Triangulation.vertices())
  {
    if (this->Triangulation.is_isolated(start))
    {
      continue;
    }
    add(start);
    for (; next < order.size(); ++next)
    {
      const auto here = order[next];
      for (const auto v : here.vertices())
      {
        add(v);
      }
    }
  }
  return order;
}

RemeshedSurface RemeshingMesh::result() const
{
  const HalfEdges& mesh = this->Triangulation;
  const std::vector<OpenMesh::SmartVertexHandle> order = this->order();
  RemeshedSurface result;
  result.pointOf.assign(this->Before.size(), -1);
  result.mesh.points.resize(static_cast<Index>(order.size()), 3);
  std::vector<Index> number(mesh.n_vertices(), -1);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    number[static_cast<std::size_t>(order[i].idx())] = static_cast<Index>(i);
    result.mesh.points.row(static_cast<Index>(i)) = this->position(order[i]);
    const Index label = this->data(order[i]).label;
    if (label >= 0)
    {
      result.pointOf[static_cast<std::size_t>(label)] = static_cast<Index>(i);
    }
  }
  result.mesh.triangles.resize(static_cast<Index>(mesh.n_faces()), 3);
  std::vector<bool> taken(mesh.n_faces(), false);
  Index t = 0;
  for (const auto here : order)
  {
    for (const auto f : here.faces())
    {
      if (taken[static_cast<std::size_t>(f.idx())])
      {
        continue;
      }
      taken[static_cast<std::size_t>(f.idx())] = true;
      Index c = 0;
      for (const auto v : f.vertices())
      {
        result.mesh.triangles(t, c++) = number[static_cast<std::size_t>(v.idx())];
      }
      ++t;
    }
  }
  result.mesh.triangles.conservativeResize(t, 3);
  return result;
}
}
