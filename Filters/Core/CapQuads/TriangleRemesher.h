// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A triangulation while it is remeshed: the local operations, each of which looks before it
 * leaps.
 */
#ifndef hexsweep_TriangleRemesher_h
#define hexsweep_TriangleRemesher_h

#include "Core/Geometry/SurfaceSearch.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <cstdint>
#include <unordered_set>

namespace hexsweep
{
/// A triangulation and the curves that its remeshing is to keep.
struct RemeshingInput
{
  TriangleMesh mesh; ///< an oriented 2-manifold, see checkSurface()
  /// Points of the curves, edge by edge; the ends of each one stay. A closed one repeats its first.
  std::vector<std::vector<Index>> curves;
  /// One entry a point: it stays where it is. Other points of curves go wherever possible, and the
  /// curve takes the short cut.
  std::vector<bool> stays;
};

/// Passes over all edges and vertices, in the order of their numbers.
class TriangleRemesher
{
public:
  /**
   * @param surface new and moved vertices are put on it.
   * @param size    wanted edge length away from the curves.
   * @param growth  of the wanted length with the distance from shorter edges on curves.
   */
  TriangleRemesher(
    const RemeshingInput& input, const SurfaceSearch& surface, double size, double growth);

  /// Sets the wanted length at each vertex from the edges on the curves.
  void updateSizes();
  /// Takes away the vertices of curves that need not stay. @return how many.
  Index shortenCurves();
  /// Collapses edges that are too short. @return how many.
  Index collapseShort();
  /// Halves edges that are too long and the longest of their triangles. @return how many.
  Index splitLong();
  /// Flips edges until they are Delaunay, where no triangle turns over. @return how many.
  Index flip();
  /// Moves vertices to the centroids of their surroundings, on the surface.
  void relax();
  /// Forgets what was deleted.
  void collectGarbage();

  struct Result
  {
    TriangleMesh mesh;
    /// Point that each vertex of the input has become; -1: it is gone.
    std::vector<Index> pointOf;
  };
  Result result() const;

private:
  struct Traits : OpenMesh::DefaultTraits
  {
    using Point = OpenMesh::Vec3d;
    VertexAttributes(OpenMesh::Attributes::Status);
    HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
    EdgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status);
  };
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
  using Vertex = OpenMesh::VertexHandle;
  using HalfEdge = OpenMesh::HalfedgeHandle;
  using Edge = OpenMesh::EdgeHandle;

  struct VertexData
  {
    Index label = -1; ///< point of the input
    double wanted = 0.0;
    double spacing = 0.0; ///< of the nodes of the curve that it is on
    Eigen::RowVector3d normal = Eigen::RowVector3d::Zero();
    bool onCurve = false;
    bool stays = false;
  };

  VertexData& data(Vertex v) { return this->Triangulation.property(this->Data, v); }
  const VertexData& data(Vertex v) const { return this->Triangulation.property(this->Data, v); }
  Eigen::RowVector3d position(Vertex v) const;
  double relativeLength(Edge e) const;
  bool isKept(Vertex a, Vertex b) const;
  bool isKept(Edge e) const;
  /// Signed area over squared longest edge; negative where the triangle faces away from the
  /// surface.
  double shape(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b,
    const Eigen::RowVector3d& c, const Eigen::RowVector3d& normal) const;
  double shape(Vertex a, Vertex b, Vertex c) const;
  bool wantsFlip(Edge e) const;
  bool canCollapse(HalfEdge h, bool longEdgesToo);
  void measureCurves(const RemeshingInput& input);
  bool shortenCurve(Vertex v);
  void putOnSurface(const std::vector<Vertex>& vertices);

  static std::uint64_t keyOf(Index a, Index b);

  const SurfaceSearch& Surface;
  double Size;
  double Growth;
  Mesh Triangulation;
  OpenMesh::VPropHandleT<VertexData> Data;
  std::vector<Index> Before; // on the curve, by label; of vertices that do not stay
  std::vector<Index> After;
  std::unordered_set<std::uint64_t> KeptEdges; // pairs of labels
};
}

#endif
