// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/TriangleRemesher.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

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
constexpr Index VerticesAtOnce = 512;
}

TriangleRemesher::TriangleRemesher(const RemeshingInput& input, const SurfaceSearch& surface,
  double size, double growth, const ParallelFor& parallelFor, LengthLimit longest)
  : Surface(surface)
  , Size(size)
  , Growth(growth)
  , Threads(parallelFor)
  , Longest(std::move(longest))
  , Mesh(input, surface, size)
{
}

void TriangleRemesher::updateSizes()
{
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (const auto v : this->Mesh.halfEdges().vertices())
  {
    RemeshingMesh::VertexData& data = this->Mesh.data(v);
    data.wanted =
      this->Longest ? std::min(data.spacing, this->Longest(this->Mesh.position(v))) : data.spacing;
    if (data.wanted < this->Size) // others do not shorten what is next to them
    {
      open.emplace(data.wanted, v.idx());
    }
  }
  while (!open.empty())
  {
    const auto [wanted, id] = open.top();
    open.pop();
    const OpenMesh::SmartVertexHandle v(id, &this->Mesh.halfEdges());
    if (wanted > this->Mesh.data(v).wanted)
    {
      continue;
    }
    for (const auto other : v.vertices())
    {
      const double grown =
        wanted + this->Growth * (this->Mesh.position(other) - this->Mesh.position(v)).norm();
      if (grown < this->Mesh.data(other).wanted)
      {
        this->Mesh.data(other).wanted = grown;
        open.emplace(grown, other.idx());
      }
    }
  }
}

bool TriangleRemesher::canCollapse(HalfEdge h, bool longEdgesToo)
{
  HalfEdges& mesh = this->Mesh.halfEdges();
  const Vertex gone = mesh.from_vertex_handle(h);
  const Vertex kept = mesh.to_vertex_handle(h);
  double before = std::numeric_limits<double>::infinity();
  double after = std::numeric_limits<double>::infinity();
  for (auto out = mesh.cvoh_iter(gone); out.is_valid(); ++out)
  {
    const Vertex b = mesh.to_vertex_handle(*out);
    if (!longEdgesToo && b != kept &&
      (this->Mesh.position(b) - this->Mesh.position(kept)).norm() >
        TooLong * 0.5 * (this->Mesh.data(b).wanted + this->Mesh.data(kept).wanted))
    {
      return false;
    }
    if (mesh.is_boundary(*out))
    {
      continue;
    }
    const Vertex c = mesh.to_vertex_handle(mesh.next_halfedge_handle(*out));
    before = std::min(before, this->Mesh.shape(gone, b, c));
    if (b != kept && c != kept)
    {
      after = std::min(after, this->Mesh.shape(kept, b, c));
    }
  }
  // A very short edge may leave flat triangles, since flips mend these.
  const double length = (this->Mesh.position(gone) - this->Mesh.position(kept)).norm();
  const bool isFair = after > GoodShape || after > before ||
    (length < VeryShort * this->Mesh.data(kept).wanted && after > FlatShape);
  return isFair && mesh.is_collapse_ok(h); // last: it visits the neighbours of both ends
}

bool TriangleRemesher::shortenCurve(Vertex v)
{
  HalfEdges& mesh = this->Mesh.halfEdges();
  const Index label = this->Mesh.data(v).label;
  if (!this->Mesh.canTakeShortCut(label))
  {
    return false;
  }
  std::vector<std::pair<double, HalfEdge>> ways;
  for (auto h = mesh.voh_iter(v); h.is_valid(); ++h)
  {
    const Vertex to = mesh.to_vertex_handle(*h);
    if (this->Mesh.isKept(v, to))
    {
      ways.emplace_back((this->Mesh.position(to) - this->Mesh.position(v)).norm(), *h);
    }
  }
  std::sort(ways.begin(), ways.end());
  for (const auto& way : ways)
  {
    if (this->canCollapse(way.second, true))
    {
      mesh.collapse(way.second);
      this->Mesh.takeShortCut(label);
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
    std::vector<bool> shortened(this->Mesh.inputPoints(), false);
    for (std::size_t i = 0; i < this->Mesh.halfEdges().n_vertices(); ++i)
    {
      const Vertex v(static_cast<int>(i));
      const RemeshingMesh::VertexData& data = this->Mesh.data(v);
      if (this->Mesh.halfEdges().status(v).deleted() || !data.onCurve || data.stays ||
        shortened[static_cast<std::size_t>(data.label)])
      {
        continue;
      }
      const auto [before, after] = this->Mesh.curveNeighbors(data.label);
      if (this->shortenCurve(v))
      {
        shortened[static_cast<std::size_t>(before)] = true;
        shortened[static_cast<std::size_t>(after)] = true;
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
  for (std::size_t i = 0; i < this->Mesh.halfEdges().n_edges(); ++i)
  {
    const Edge e(static_cast<int>(i));
    if (this->Mesh.halfEdges().status(e).deleted() || this->Mesh.relativeLength(e) >= TooShort)
    {
      continue;
    }
    for (const unsigned side : { 0u, 1u })
    {
      const HalfEdge h = this->Mesh.halfEdges().halfedge_handle(e, side);
      const RemeshingMesh::VertexData& gone =
        this->Mesh.data(this->Mesh.halfEdges().from_vertex_handle(h));
      if (!gone.onCurve && !gone.stays && this->canCollapse(h, false))
      {
        this->Mesh.halfEdges().collapse(h);
        ++count;
        break;
      }
    }
  }
  return count;
}

Index TriangleRemesher::splitLong()
{
  HalfEdges& mesh = this->Mesh.halfEdges();
  std::vector<Vertex> added;
  const std::size_t edges = mesh.n_edges();
  for (std::size_t i = 0; i < edges; ++i)
  {
    const Edge e(static_cast<int>(i));
    if (mesh.status(e).deleted() || this->Mesh.isKept(e))
    {
      continue;
    }
    const double length = this->Mesh.relativeLength(e);
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
        longest = longest && this->Mesh.relativeLength(other) <= length;
      }
    }
    if (!longest)
    {
      continue;
    }
    const HalfEdge h = mesh.halfedge_handle(e, 0);
    const Vertex a = mesh.from_vertex_handle(h);
    const Vertex b = mesh.to_vertex_handle(h);
    const double half = 0.5 * (this->Mesh.position(a) - this->Mesh.position(b)).norm();
    const double wanted = std::min(this->Size,
      std::min(this->Mesh.data(a).wanted, this->Mesh.data(b).wanted) + this->Growth * half);
    const Vertex v = mesh.add_vertex((mesh.point(a) + mesh.point(b)) * 0.5);
    this->Mesh.data(v).wanted = wanted;
    this->Mesh.data(v).spacing = this->Size;
    this->Mesh.data(v).triangle = this->Mesh.data(a).triangle;
    mesh.split(e, v);
    added.push_back(v);
  }
  this->putOnSurface(added);
  return static_cast<Index>(added.size());
}

void TriangleRemesher::putOnSurface(const std::vector<Vertex>& vertices)
{
  Points points(static_cast<Index>(vertices.size()), 3);
  std::vector<Index> starts(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    points.row(static_cast<Index>(i)) = this->Mesh.position(vertices[i]);
    starts[i] = this->Mesh.data(vertices[i]).triangle;
  }
  const SurfacePlaces places = this->Surface.project(points, this->Threads, starts);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const Eigen::RowVector3d p = places.points.row(static_cast<Index>(i));
    this->Mesh.halfEdges().set_point(vertices[i], { p[0], p[1], p[2] });
    this->Mesh.data(vertices[i]).normal = places.normals.row(static_cast<Index>(i));
    this->Mesh.data(vertices[i]).triangle = places.triangles[i];
  }
}

/// Whether the angles at c and d, across the edge from a to b, are more than pi together.
bool TriangleRemesher::isBeyondHalfTurn(Vertex a, Vertex b, Vertex c, Vertex d) const
{
  constexpr double Slack = 1e-6;
  // Sine and cosine of the angle at an apex, times the lengths of its sides.
  const auto angle = [&](Vertex apex) {
    const Eigen::RowVector3d u = this->Mesh.position(a) - this->Mesh.position(apex);
    const Eigen::RowVector3d w = this->Mesh.position(b) - this->Mesh.position(apex);
    return Eigen::Vector2d(u.cross(w).norm(), u.dot(w));
  };
  const Eigen::Vector2d first = angle(c);
  const Eigen::Vector2d second = angle(d);
  return first[0] * second[1] + first[1] * second[0] < -Slack * first.norm() * second.norm();
}

bool TriangleRemesher::wantsFlip(Edge e) const
{
  const HalfEdges& mesh = this->Mesh.halfEdges();
  if (mesh.status(e).deleted() || this->Mesh.isKept(e) || mesh.is_boundary(e))
  {
    return false;
  }
  const HalfEdge h = mesh.halfedge_handle(e, 0);
  const HalfEdge g = mesh.halfedge_handle(e, 1);
  const Vertex a = mesh.from_vertex_handle(h);
  const Vertex b = mesh.to_vertex_handle(h);
  const Vertex c = mesh.to_vertex_handle(mesh.next_halfedge_handle(h));
  const Vertex d = mesh.to_vertex_handle(mesh.next_halfedge_handle(g));
  const double before = std::min(this->Mesh.shape(a, b, c), this->Mesh.shape(b, a, d));
  const bool flat = before < GoodShape;
  if (!flat && !this->isBeyondHalfTurn(a, b, c, d))
  {
    return false;
  }
  const double after = std::min(this->Mesh.shape(c, a, d), this->Mesh.shape(d, b, c));
  return after > (flat ? before + FlipMargin : GoodShape);
}

Index TriangleRemesher::flip()
{
  constexpr int MaximumPasses = 20;
  HalfEdges& mesh = this->Mesh.halfEdges();
  // Edges that want no flip will not do so before one of their triangles has changed.
  std::vector<char> settled(mesh.n_edges(), 0);
  Index count = 0;
  for (int pass = 0; pass < MaximumPasses; ++pass)
  {
    Index flips = 0;
    for (std::size_t i = 0; i < settled.size(); ++i)
    {
      const Edge e(static_cast<int>(i));
      if (settled[i] || !this->wantsFlip(e))
      {
        settled[i] = 1;
        continue;
      }
      // Looks at all neighbours of a vertex, which are many where a cap has few triangles.
      if (mesh.is_flip_ok(e))
      {
        mesh.flip(e);
        ++flips;
        for (const unsigned side : { 0u, 1u })
        {
          const HalfEdge next = mesh.next_halfedge_handle(mesh.halfedge_handle(e, side));
          for (const HalfEdge h : { next, mesh.next_halfedge_handle(next) })
          {
            settled[static_cast<std::size_t>(mesh.edge_handle(h).idx())] = 0;
          }
        }
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

/// The centroid of what surrounds a vertex, in its tangent plane; where it is where nothing does.
Eigen::RowVector3d TriangleRemesher::wishOf(OpenMesh::SmartVertexHandle v) const
{
  Eigen::RowVector3d here = this->Mesh.position(v);
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  double weights = 0.0;
  for (const auto h : v.outgoing_halfedges())
  {
    const Vertex b = h.to();
    const Vertex c = h.next().to();
    const Eigen::RowVector3d p = this->Mesh.position(b);
    const Eigen::RowVector3d q = this->Mesh.position(c);
    const double size =
      this->Mesh.data(v).wanted + this->Mesh.data(b).wanted + this->Mesh.data(c).wanted;
    const double weight = (p - here).cross(q - here).norm() / (size * size);
    sum += weight * (here + p + q) / 3.0;
    weights += weight;
  }
  if (!(weights > 0.0))
  {
    return here;
  }
  const Eigen::RowVector3d move = sum / weights - here;
  const Eigen::RowVector3d normal = this->Mesh.data(v).normal;
  return here + move - move.dot(normal) * normal;
}

/// Of the triangles at a vertex, with it at a place of the surface.
double TriangleRemesher::leastShapeAt(
  Vertex v, const Eigen::RowVector3d& place, const Eigen::RowVector3d& normal) const
{
  const HalfEdges& mesh = this->Mesh.halfEdges();
  double least = std::numeric_limits<double>::infinity();
  for (auto h = mesh.cvoh_iter(v); h.is_valid(); ++h)
  {
    const Vertex b = mesh.to_vertex_handle(*h);
    const Vertex c = mesh.to_vertex_handle(mesh.next_halfedge_handle(*h));
    least = std::min(least,
      triangleShape(place, this->Mesh.position(b), this->Mesh.position(c),
        normal + this->Mesh.data(b).normal + this->Mesh.data(c).normal));
  }
  return least;
}

void TriangleRemesher::relax()
{
  const HalfEdges& mesh = this->Mesh.halfEdges();
  std::vector<OpenMesh::SmartVertexHandle> free;
  for (const auto v : mesh.vertices())
  {
    if (!this->Mesh.data(v).onCurve && !this->Mesh.data(v).stays)
    {
      free.push_back(v);
    }
  }
  Points points(static_cast<Index>(free.size()), 3);
  std::vector<Index> starts(free.size());
  forPieces(this->Threads, points.rows(), VerticesAtOnce, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i)
    {
      const auto k = static_cast<std::size_t>(i);
      points.row(i) = this->wishOf(free[k]);
      starts[k] = this->Mesh.data(free[k]).triangle;
    }
  });
  const SurfacePlaces places = this->Surface.project(points, this->Threads, starts);
  for (std::size_t i = 0; i < free.size(); ++i)
  {
    const Vertex v = free[i];
    const Eigen::RowVector3d p = places.points.row(static_cast<Index>(i));
    const Eigen::RowVector3d normal = places.normals.row(static_cast<Index>(i));
    const double after = this->leastShapeAt(v, p, normal);
    if (after > 2.0 * GoodShape ||
      after > this->leastShapeAt(v, this->Mesh.position(v), this->Mesh.data(v).normal))
    {
      this->Mesh.halfEdges().set_point(v, { p[0], p[1], p[2] });
      this->Mesh.data(v).normal = normal;
      this->Mesh.data(v).triangle = places.triangles[i];
    }
  }
}

void TriangleRemesher::collectGarbage()
{
  this->Mesh.halfEdges().garbage_collection();
}
}
