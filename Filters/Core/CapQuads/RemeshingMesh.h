// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A triangulation that is being remeshed: its half-edges, the curves that it keeps, the
 * lengths that are wanted, and how good its triangles are.
 */
#ifndef hexsweep_RemeshingMesh_h
#define hexsweep_RemeshingMesh_h

#include "Core/Geometry/SurfaceSearch.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <cstdint>
#include <functional>
#include <unordered_set>

namespace hexsweep
{
/// The longest edges that are wanted at a place.
using LengthLimit = std::function<double(const Eigen::RowVector3d&)>;

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

struct RemeshedSurface
{
  TriangleMesh mesh;
  /// Point that each vertex of the input has become; -1: it is gone.
  std::vector<Index> pointOf;
};

/// Of triangles: signed area over squared longest edge, 0.43 if equilateral; negative where they
/// face away from the normal (of any length), 0 where that or all edges have no length.
double triangleShape(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b,
  const Eigen::RowVector3d& c, const Eigen::RowVector3d& normal);

/// Knows and measures; what is done to it is up to TriangleRemesher.
class RemeshingMesh
{
  struct Traits : OpenMesh::DefaultTraits
  {
    using Point = OpenMesh::Vec3d;
    VertexAttributes(OpenMesh::Attributes::Status);
    HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
    EdgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status);
  };

public:
  using HalfEdges = OpenMesh::TriMesh_ArrayKernelT<Traits>;
  using Vertex = OpenMesh::VertexHandle;
  using HalfEdge = OpenMesh::HalfedgeHandle;
  using Edge = OpenMesh::EdgeHandle;

  struct VertexData
  {
    Index label = -1;     ///< point of the input
    double wanted = 0.0;  ///< edge length
    double spacing = 0.0; ///< of the nodes of the curve that it is on
    Eigen::RowVector3d normal = Eigen::RowVector3d::Zero(); ///< of the surface
    Index triangle = -1; ///< of the surface, at the vertex or near it
    bool onCurve = false;
    bool stays = false;
  };

  /**
   * @param surface where normals come from.
   * @param size    wanted edge length away from the curves.
   * @throw InvalidInput when there are more points than a half-edge mesh can number.
   */
  RemeshingMesh(const RemeshingInput& input, const SurfaceSearch& surface, double size);

  std::size_t inputPoints() const { return this->Before.size(); }
  HalfEdges& halfEdges() { return this->Triangulation; }
  const HalfEdges& halfEdges() const { return this->Triangulation; }
  VertexData& data(Vertex v) { return this->Triangulation.property(this->Data, v); }
  const VertexData& data(Vertex v) const { return this->Triangulation.property(this->Data, v); }
  Eigen::RowVector3d position(Vertex v) const;

  /// Length over the mean of what is wanted at its ends.
  double relativeLength(Edge e) const;
  /// triangleShape() about the mean normal of the vertices.
  double shape(Vertex a, Vertex b, Vertex c) const;

  /// Whether it is an edge of a curve.
  bool isKept(Vertex a, Vertex b) const;
  /// Whether it is an edge of a curve or of the boundary.
  bool isKept(Edge e) const;

  /// The neighbors of a vertex on its curve, as points of the input.
  struct CurveNeighbors
  {
    Index before;
    Index after;
  };
  /// @param label of a vertex inside a curve.
  CurveNeighbors curveNeighbors(Index label) const;
  /// Whether there is a curve left once it takes the short cut past this vertex.
  bool canTakeShortCut(Index label) const;
  /// The curve leads from the neighbor before to the one after; the mesh must have that edge.
  void takeShortCut(Index label);

  /// What has become of the input; points that are near in the mesh are near in memory.
  RemeshedSurface result() const;

private:
  void addCurve(const std::vector<Index>& curve);
  void measureCurves(const RemeshingInput& input, double size);
  /// Vertices in the order of the result, breadth first.
  std::vector<OpenMesh::SmartVertexHandle> order() const;

  static std::uint64_t keyOf(Index a, Index b);

  HalfEdges Triangulation;
  OpenMesh::VPropHandleT<VertexData> Data;
  std::vector<Index> Before; // on the curve, by label; of vertices that do not stay
  std::vector<Index> After;
  std::unordered_set<std::uint64_t> KeptEdges; // pairs of labels
};
}

#endif
