// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/TriangleRemesher.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Errors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace hexsweep
{
namespace
{
constexpr double TooLong = 4.0 / 3.0; // times the wanted length
constexpr double TooShort = 4.0 / 5.0;
constexpr double GoodShape = 0.05; // an equilateral triangle has 0.43
constexpr double VeryShort = 0.01;
constexpr double FlatShape = -0.01;
constexpr double FlipMargin = 1e-9;
}

TriangleRemesher::TriangleRemesher(
  const RemeshingInput& input, const SurfaceSearch& surface, double size, double growth)
  : Surface(surface)
  , Size(size)
  , Growth(growth)
  , Before(input.stays.size(), -1)
  , After(input.stays.size(), -1)
{
  const Points& points = input.mesh.points;
  if (points.rows() > std::numeric_limits<int>::max() / 8)
  {
    throw InvalidInput("the cap has more points than a half-edge mesh can number.");
  }
  this->Triangulation.add_property(this->Data);
  const Points normals = surface.project(points).normals;
  for (Index i = 0; i < points.rows(); ++i)
  {
    const Vertex v = this->Triangulation.add_vertex({ points(i, 0), points(i, 1), points(i, 2) });
    this->data(
      v) = { i, size, size, normals.row(i), false, input.stays[static_cast<std::size_t>(i)] };
  }
  const auto vertex = [](Index i) { return Vertex(static_cast<int>(i)); };
  for (Index t = 0; t < input.mesh.triangles.rows(); ++t)
  {
    this->Triangulation.add_face(vertex(input.mesh.triangles(t, 0)),
      vertex(input.mesh.triangles(t, 1)), vertex(input.mesh.triangles(t, 2)));
  }
  for (const std::vector<Index>& curve : input.curves)
  {
    for (std::size_t k = 0; k + 1 < curve.size(); ++k)
    {
      this->KeptEdges.insert(keyOf(curve[k], curve[k + 1]));
      this->data(vertex(curve[k])).onCurve = true;
      if (k > 0)
      {
        this->Before[static_cast<std::size_t>(curve[k])] = curve[k - 1];
        this->After[static_cast<std::size_t>(curve[k])] = curve[k + 1];
      }
    }
    this->data(vertex(curve.back())).onCurve = true;
  }
  this->measureCurves(input);
}

void TriangleRemesher::measureCurves(const RemeshingInput& input)
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
      this->data(v).spacing = std::min(this->Size, sum[i] / count[i]);
    }
  }
}

std::uint64_t TriangleRemesher::keyOf(Index a, Index b)
{
  return (static_cast<std::uint64_t>(std::min(a, b)) << 32) |
    static_cast<std::uint64_t>(std::max(a, b));
}

Eigen::RowVector3d TriangleRemesher::position(Vertex v) const
{
  return Eigen::Map<const Eigen::RowVector3d>(this->Triangulation.point(v).data());
}

double TriangleRemesher::relativeLength(Edge e) const
{
  const HalfEdge h = this->Triangulation.halfedge_handle(e, 0);
  const Vertex a = this->Triangulation.from_vertex_handle(h);
  const Vertex b = this->Triangulation.to_vertex_handle(h);
  return (this->position(a) - this->position(b)).norm() /
    (0.5 * (this->data(a).wanted + this->data(b).wanted));
}

bool TriangleRemesher::isKept(Vertex a, Vertex b) const
{
  return this->data(a).onCurve && this->data(b).onCurve &&
    this->KeptEdges.count(keyOf(this->data(a).label, this->data(b).label)) > 0;
}

bool TriangleRemesher::isKept(Edge e) const
{
  const HalfEdge h = this->Triangulation.halfedge_handle(e, 0);
  return this->Triangulation.is_boundary(e) ||
    this->isKept(
      this->Triangulation.from_vertex_handle(h), this->Triangulation.to_vertex_handle(h));
}

double TriangleRemesher::shape(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b,
  const Eigen::RowVector3d& c, const Eigen::RowVector3d& normal) const
{
  const double longest =
    std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() });
  const double length = normal.norm();
  return longest > 0.0 && length > 0.0 ? 0.5 * (b - a).cross(c - a).dot(normal) / (longest * length)
                                       : 0.0;
}

double TriangleRemesher::shape(Vertex a, Vertex b, Vertex c) const
{
  return this->shape(this->position(a), this->position(b), this->position(c),
    this->data(a).normal + this->data(b).normal + this->data(c).normal);
}

void TriangleRemesher::updateSizes()
{
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (const auto v : this->Triangulation.vertices())
  {
    VertexData& data = this->data(v);
    data.wanted = data.spacing;
    open.emplace(data.wanted, v.idx());
  }
  while (!open.empty())
  {
    const auto [wanted, id] = open.top();
    open.pop();
    const OpenMesh::SmartVertexHandle v(id, &this->Triangulation);
    if (wanted > this->data(v).wanted)
    {
      continue;
    }
    for (const auto other : v.vertices())
    {
      const double grown =
        wanted + this->Growth * (this->position(other) - this->position(v)).norm();
      if (grown < this->data(other).wanted)
      {
        this->data(other).wanted = grown;
        open.emplace(grown, other.idx());
      }
    }
  }
}

bool TriangleRemesher::canCollapse(HalfEdge h, bool longEdgesToo)
{
  Mesh& mesh = this->Triangulation;
  if (!mesh.is_collapse_ok(h))
  {
    return false;
  }
  const Vertex gone = mesh.from_vertex_handle(h);
  const Vertex kept = mesh.to_vertex_handle(h);
  double before = std::numeric_limits<double>::infinity();
  double after = std::numeric_limits<double>::infinity();
  for (auto out = mesh.cvoh_iter(gone); out.is_valid(); ++out)
  {
    const Vertex b = mesh.to_vertex_handle(*out);
    if (!longEdgesToo && b != kept &&
      (this->position(b) - this->position(kept)).norm() >
        TooLong * 0.5 * (this->data(b).wanted + this->data(kept).wanted))
    {
      return false;
    }
    if (mesh.is_boundary(*out))
    {
      continue;
    }
    const Vertex c = mesh.to_vertex_handle(mesh.next_halfedge_handle(*out));
    before = std::min(before, this->shape(gone, b, c));
    if (b != kept && c != kept)
    {
      after = std::min(after, this->shape(kept, b, c));
    }
  }
  // A very short edge may leave flat triangles, since flips mend these.
  const double length = (this->position(gone) - this->position(kept)).norm();
  return after > GoodShape || after > before ||
    (length < VeryShort * this->data(kept).wanted && after > FlatShape);
}

bool TriangleRemesher::shortenCurve(Vertex v)
{
  Mesh& mesh = this->Triangulation;
  const auto label = static_cast<std::size_t>(this->data(v).label);
  const Index before = this->Before[label];
  const Index after = this->After[label];
  if (before == after || this->KeptEdges.count(keyOf(before, after)) > 0)
  {
    return false; // nothing would be left of the curve
  }
  std::vector<std::pair<double, HalfEdge>> ways;
  for (auto h = mesh.voh_iter(v); h.is_valid(); ++h)
  {
    const Vertex to = mesh.to_vertex_handle(*h);
    if (this->isKept(v, to))
    {
      ways.emplace_back((this->position(to) - this->position(v)).norm(), *h);
    }
  }
  std::sort(ways.begin(), ways.end());
  for (const auto& way : ways)
  {
    if (this->canCollapse(way.second, true))
    {
      mesh.collapse(way.second);
      this->KeptEdges.erase(keyOf(before, static_cast<Index>(label)));
      this->KeptEdges.erase(keyOf(static_cast<Index>(label), after));
      this->KeptEdges.insert(keyOf(before, after));
      this->After[static_cast<std::size_t>(before)] = after;
      this->Before[static_cast<std::size_t>(after)] = before;
      return true;
    }
  }
  return false;
}

Index TriangleRemesher::shortenCurves()
{
  // Every second one, over and over: fewer triangles that all meet in one vertex.
  Index count = 0;
  for (Index last = -1; last != 0;)
  {
    last = 0;
    std::vector<bool> shortened(this->Before.size(), false);
    for (std::size_t i = 0; i < this->Triangulation.n_vertices(); ++i)
    {
      const Vertex v(static_cast<int>(i));
      const VertexData& data = this->data(v);
      if (this->Triangulation.status(v).deleted() || !data.onCurve || data.stays ||
        shortened[static_cast<std::size_t>(data.label)])
      {
        continue;
      }
      const auto label = static_cast<std::size_t>(data.label);
      if (this->shortenCurve(v))
      {
        shortened[static_cast<std::size_t>(this->Before[label])] = true;
        shortened[static_cast<std::size_t>(this->After[label])] = true;
        ++last;
      }
    }
    count += last;
  }
  return count;
}

Index TriangleRemesher::collapseShort()
{
  Index count = 0;
  for (std::size_t i = 0; i < this->Triangulation.n_edges(); ++i)
  {
    const Edge e(static_cast<int>(i));
    if (this->Triangulation.status(e).deleted() || this->relativeLength(e) >= TooShort)
    {
      continue;
    }
    for (const unsigned side : { 0u, 1u })
    {
      const HalfEdge h = this->Triangulation.halfedge_handle(e, side);
      const VertexData& gone = this->data(this->Triangulation.from_vertex_handle(h));
      if (!gone.onCurve && !gone.stays && this->canCollapse(h, false))
      {
        this->Triangulation.collapse(h);
        ++count;
        break;
      }
    }
  }
  return count;
}

Index TriangleRemesher::splitLong()
{
  Mesh& mesh = this->Triangulation;
  std::vector<Vertex> added;
  const std::size_t edges = mesh.n_edges();
  for (std::size_t i = 0; i < edges; ++i)
  {
    const Edge e(static_cast<int>(i));
    if (mesh.status(e).deleted() || this->isKept(e))
    {
      continue;
    }
    const double length = this->relativeLength(e);
    if (!(length > TooLong))
    {
      continue;
    }
    bool longest = true;
    for (const unsigned side : { 0u, 1u })
    {
      const HalfEdge next = mesh.next_halfedge_handle(mesh.halfedge_handle(e, side));
      for (const HalfEdge h : { next, mesh.next_halfedge_handle(next) })
      {
        const Edge other = mesh.edge_handle(h);
        longest = longest && this->relativeLength(other) <= length;
      }
    }
    if (!longest)
    {
      continue;
    }
    const HalfEdge h = mesh.halfedge_handle(e, 0);
    const Vertex a = mesh.from_vertex_handle(h);
    const Vertex b = mesh.to_vertex_handle(h);
    const double half = 0.5 * (this->position(a) - this->position(b)).norm();
    const double wanted = std::min(
      this->Size, std::min(this->data(a).wanted, this->data(b).wanted) + this->Growth * half);
    const Vertex v = mesh.add_vertex((mesh.point(a) + mesh.point(b)) * 0.5);
    this->data(v).wanted = wanted;
    this->data(v).spacing = this->Size;
    mesh.split(e, v);
    added.push_back(v);
  }
  this->putOnSurface(added);
  return static_cast<Index>(added.size());
}

void TriangleRemesher::putOnSurface(const std::vector<Vertex>& vertices)
{
  Points points(static_cast<Index>(vertices.size()), 3);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    points.row(static_cast<Index>(i)) = this->position(vertices[i]);
  }
  const SurfacePlaces places = this->Surface.project(points);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const Eigen::RowVector3d p = places.points.row(static_cast<Index>(i));
    this->Triangulation.set_point(vertices[i], { p[0], p[1], p[2] });
    this->data(vertices[i]).normal = places.normals.row(static_cast<Index>(i));
  }
}

bool TriangleRemesher::wantsFlip(Edge e) const
{
  const Mesh& mesh = this->Triangulation;
  if (mesh.status(e).deleted() || this->isKept(e) || !mesh.is_flip_ok(e))
  {
    return false;
  }
  const HalfEdge h = mesh.halfedge_handle(e, 0);
  const HalfEdge g = mesh.halfedge_handle(e, 1);
  const Vertex a = mesh.from_vertex_handle(h);
  const Vertex b = mesh.to_vertex_handle(h);
  const Vertex c = mesh.to_vertex_handle(mesh.next_halfedge_handle(h));
  const Vertex d = mesh.to_vertex_handle(mesh.next_halfedge_handle(g));
  const double before = std::min(this->shape(a, b, c), this->shape(b, a, d));
  const double after = std::min(this->shape(c, a, d), this->shape(d, b, c));
  if (before < GoodShape)
  {
    return after > before + FlipMargin;
  }
  const auto angle = [&](Vertex apex) {
    const Eigen::RowVector3d u = this->position(a) - this->position(apex);
    const Eigen::RowVector3d w = this->position(b) - this->position(apex);
    return std::atan2(u.cross(w).norm(), u.dot(w));
  };
  return angle(c) + angle(d) > Pi + 1e-6 && after > GoodShape;
}

Index TriangleRemesher::flip()
{
  constexpr int MaximumPasses = 20;
  Index count = 0;
  for (int pass = 0; pass < MaximumPasses; ++pass)
  {
    Index flips = 0;
    for (std::size_t i = 0; i < this->Triangulation.n_edges(); ++i)
    {
      const Edge e(static_cast<int>(i));
      if (this->wantsFlip(e))
      {
        this->Triangulation.flip(e);
        ++flips;
      }
    }
    count += flips;
    if (flips == 0)
    {
      break;
    }
  }
  return count;
}

void TriangleRemesher::relax()
{
  const Mesh& mesh = this->Triangulation;
  std::vector<Vertex> free;
  std::vector<Eigen::RowVector3d> wishes;
  for (const auto v : mesh.vertices())
  {
    if (this->data(v).onCurve || this->data(v).stays)
    {
      continue;
    }
    const Eigen::RowVector3d here = this->position(v);
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    double weights = 0.0;
    for (const auto h : v.outgoing_halfedges())
    {
      const Vertex b = h.to();
      const Vertex c = h.next().to();
      const Eigen::RowVector3d p = this->position(b);
      const Eigen::RowVector3d q = this->position(c);
      const double size = this->data(v).wanted + this->data(b).wanted + this->data(c).wanted;
      const double weight = (p - here).cross(q - here).norm() / (size * size);
      sum += weight * (here + p + q) / 3.0;
      weights += weight;
    }
    if (weights > 0.0)
    {
      Eigen::RowVector3d move = sum / weights - here;
      const Eigen::RowVector3d normal = this->data(v).normal;
      move -= move.dot(normal) * normal;
      free.push_back(v);
      wishes.push_back(here + move);
    }
  }
  Points points(static_cast<Index>(free.size()), 3);
  for (std::size_t i = 0; i < free.size(); ++i)
  {
    points.row(static_cast<Index>(i)) = wishes[i];
  }
  const SurfacePlaces places = this->Surface.project(points);
  for (std::size_t i = 0; i < free.size(); ++i)
  {
    const Vertex v = free[i];
    const Eigen::RowVector3d p = places.points.row(static_cast<Index>(i));
    const Eigen::RowVector3d normal = places.normals.row(static_cast<Index>(i));
    double before = std::numeric_limits<double>::infinity();
    double after = before;
    for (auto h = mesh.cvoh_iter(v); h.is_valid(); ++h)
    {
      const Vertex b = mesh.to_vertex_handle(*h);
      const Vertex c = mesh.to_vertex_handle(mesh.next_halfedge_handle(*h));
      before = std::min(before, this->shape(v, b, c));
      after = std::min(after,
        this->shape(p, this->position(b), this->position(c),
          normal + this->data(b).normal + this->data(c).normal));
    }
    if (after > 2.0 * GoodShape || after > before)
    {
      this->Triangulation.set_point(v, { p[0], p[1], p[2] });
      this->data(v).normal = normal;
    }
  }
}

void TriangleRemesher::collectGarbage()
{
  this->Triangulation.garbage_collection();
}

TriangleRemesher::Result TriangleRemesher::result() const
{
  const Mesh& mesh = this->Triangulation;
  Result result;
  result.pointOf.assign(this->Before.size(), -1);
  // Breadth first, so that what is near in the mesh is near in memory.
  std::vector<Index> number(mesh.n_vertices(), -1);
  std::vector<OpenMesh::SmartVertexHandle> order;
  for (const auto start : mesh.vertices())
  {
    if (mesh.is_isolated(start) || number[static_cast<std::size_t>(start.idx())] >= 0)
    {
      continue;
    }
    number[static_cast<std::size_t>(start.idx())] = static_cast<Index>(order.size());
    order.push_back(start);
    for (std::size_t next = order.size() - 1; next < order.size(); ++next)
    {
      const auto here = order[next];
      for (const auto v : here.vertices())
      {
        if (number[static_cast<std::size_t>(v.idx())] < 0)
        {
          number[static_cast<std::size_t>(v.idx())] = static_cast<Index>(order.size());
          order.push_back(v);
        }
      }
    }
  }
  result.mesh.points.resize(static_cast<Index>(order.size()), 3);
  result.mesh.triangles.resize(static_cast<Index>(mesh.n_faces()), 3);
  std::vector<bool> taken(mesh.n_faces(), false);
  Index t = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    result.mesh.points.row(static_cast<Index>(i)) = this->position(order[i]);
    const Index label = this->data(order[i]).label;
    if (label >= 0)
    {
      result.pointOf[static_cast<std::size_t>(label)] = static_cast<Index>(i);
    }
    for (const auto f : order[i].faces())
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
