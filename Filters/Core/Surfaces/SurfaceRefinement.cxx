// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SurfaceRefinement.h"

#include "Core/Common/Errors.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <limits>

namespace hexsweep
{
namespace
{
struct Traits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using Vertex = OpenMesh::VertexHandle;

Vertex vertex(Index i)
{
  return Vertex(static_cast<int>(i));
}

/// A half-edge mesh that remembers the triangle each face is part of.
class Refinement
{
public:
  explicit Refinement(const TriangleMesh& mesh)
  {
    if (mesh.points.rows() > std::numeric_limits<int>::max() / 8)
    {
      throw InvalidInput("the surface has more points than a half-edge mesh can number.");
    }
    this->Mesh.add_property(this->Origin);
    for (Index i = 0; i < mesh.points.rows(); ++i)
    {
      this->Mesh.add_vertex({ mesh.points(i, 0), mesh.points(i, 1), mesh.points(i, 2) });
    }
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
    {
      const auto face = this->Mesh.add_face(
        vertex(mesh.triangles(t, 0)), vertex(mesh.triangles(t, 1)), vertex(mesh.triangles(t, 2)));
      if (!face.is_valid())
      {
        throw InvalidInput("triangle " + std::to_string(t) +
          " cannot be joined to its neighbours: the surface is no oriented manifold there.");
      }
      this->Mesh.property(this->Origin, face) = t;
    }
  }

  std::vector<Index> subdivide(const EdgeSubdivision& subdivision)
  {
    const HalfEdgeMesh::Point a = this->Mesh.point(vertex(subdivision.from));
    const HalfEdgeMesh::Point b = this->Mesh.point(vertex(subdivision.to));
    std::vector<Index> inserted;
    Vertex last = vertex(subdivision.from);
    for (const double fraction : subdivision.fractions)
    {
      const auto half = this->Mesh.find_halfedge(last, vertex(subdivision.to));
      if (!half.is_valid())
      {
        throw InvalidInput("there is no edge between points " + std::to_string(subdivision.from) +
          " and " + std::to_string(subdivision.to) + ".");
      }
      last = this->Mesh.add_vertex(a * (1.0 - fraction) + b * fraction);
      this->Mesh.split_copy(this->Mesh.edge_handle(half), last);
      inserted.push_back(last.idx());
    }
    return inserted;
  }

  void splitChords()
  {
    const std::vector<int> loop = this->loopOfVertices();
    const std::size_t edges = this->Mesh.n_edges(); // those that splits add are no chords
    for (std::size_t e = 0; e < edges; ++e)
    {
      const OpenMesh::EdgeHandle edge(static_cast<int>(e));
      const auto half = this->Mesh.halfedge_handle(edge, 0);
      const auto from = this->Mesh.from_vertex_handle(half);
      const auto to = this->Mesh.to_vertex_handle(half);
      const auto known = [&](Vertex v) { return static_cast<std::size_t>(v.idx()) < loop.size(); };
      if (this->Mesh.is_boundary(edge) || !known(from) || !known(to))
      {
        continue;
      }
      const int fromLoop = loop[static_cast<std::size_t>(from.idx())];
      if (fromLoop >= 0 && fromLoop == loop[static_cast<std::size_t>(to.idx())])
      {
        const auto middle = (this->Mesh.point(from) + this->Mesh.point(to)) * 0.5;
        this->Mesh.split_copy(edge, this->Mesh.add_vertex(middle));
      }
    }
  }

  RefinedSurface result() const
  {
    RefinedSurface refined;
    refined.mesh.points.resize(static_cast<Index>(this->Mesh.n_vertices()), 3);
    for (const auto v : this->Mesh.vertices())
    {
      const auto& p = this->Mesh.point(v);
      refined.mesh.points.row(v.idx()) << p[0], p[1], p[2];
    }
    refined.mesh.triangles.resize(static_cast<Index>(this->Mesh.n_faces()), 3);
    for (const auto f : this->Mesh.faces())
    {
      Index corner = 0;
      for (const auto v : f.vertices())
      {
        refined.mesh.triangles(f.idx(), corner++) = v.idx();
      }
      refined.triangleOrigin.push_back(this->Mesh.property(this->Origin, f));
    }
    return refined;
  }

private:
  /// Number of the boundary loop that each vertex lies on, -1 inside.
  std::vector<int> loopOfVertices() const
  {
    std::vector<int> loop(this->Mesh.n_vertices(), -1);
    int count = 0;
    for (const auto half : this->Mesh.halfedges())
    {
      if (!this->Mesh.is_boundary(half) || loop[static_cast<std::size_t>(half.to().idx())] >= 0)
      {
        continue;
      }
      for (auto h = half; loop[static_cast<std::size_t>(h.to().idx())] < 0; h = h.next())
      {
        loop[static_cast<std::size_t>(h.to().idx())] = count;
      }
      ++count;
    }
    return loop;
  }

  HalfEdgeMesh Mesh;
  OpenMesh::FPropHandleT<Index> Origin;
};
}

bool hasChords(const TrianglesRef& triangles, Index numberOfPoints, const std::vector<Loop>& loops)
{
  std::vector<Index> loopOf(static_cast<std::size_t>(numberOfPoints), -1);
  std::vector<Index> next(static_cast<std::size_t>(numberOfPoints), -1);
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    for (std::size_t i = 0; i < loops[l].size(); ++i)
    {
      loopOf[static_cast<std::size_t>(loops[l][i])] = static_cast<Index>(l);
      next[static_cast<std::size_t>(loops[l][i])] = loops[l][(i + 1) % loops[l].size()];
    }
  }
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const auto a = static_cast<std::size_t>(triangles(t, c));
      const Index b = triangles(t, (c + 1) % 3);
      if (loopOf[a] >= 0 && loopOf[a] == loopOf[static_cast<std::size_t>(b)] && next[a] != b)
      {
        return true;
      }
    }
  }
  return false;
}

RefinedSurface refineSurface(
  const TriangleMesh& mesh, const std::vector<EdgeSubdivision>& subdivisions, bool splitChords)
{
  Refinement refinement(mesh);
  std::vector<std::vector<Index>> inserted;
  inserted.reserve(subdivisions.size());
  for (const EdgeSubdivision& subdivision : subdivisions)
  {
    inserted.push_back(refinement.subdivide(subdivision));
  }
  if (splitChords)
  {
    refinement.splitChords();
  }
  RefinedSurface refined = refinement.result();
  refined.inserted = std::move(inserted);
  return refined;
}
}
