// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A triangulation while it is remeshed: the local operations, each of which looks before it
 * leaps.
 */
#ifndef hexsweep_TriangleRemesher_h
#define hexsweep_TriangleRemesher_h

#include "Core/CapQuads/RemeshingMesh.h"

namespace hexsweep
{
/// Passes over all edges and vertices, in the order of their numbers.
class TriangleRemesher
{
public:
  /**
   * @param surface new and moved vertices are put on it; must outlive the remesher.
   * @param size    wanted edge length away from the curves.
   * @param growth  of the wanted length with the distance from shorter edges on curves.
   * @param parallelFor lends threads for what is done to many vertices at once.
   * @param longest of the wanted length at a place; empty: `size`.
   */
  TriangleRemesher(const RemeshingInput& input, const SurfaceSearch& surface, double size,
    double growth, const ParallelFor& parallelFor = {}, LengthLimit longest = {});

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

  RemeshedSurface result() const { return this->Mesh.result(); }

private:
  using HalfEdges = RemeshingMesh::HalfEdges;
  using Vertex = RemeshingMesh::Vertex;
  using HalfEdge = RemeshingMesh::HalfEdge;
  using Edge = RemeshingMesh::Edge;

  bool wantsFlip(Edge e) const;
  bool isBeyondHalfTurn(Vertex a, Vertex b, Vertex c, Vertex d) const;
  bool canCollapse(HalfEdge h, bool longEdgesToo);
  bool shortenCurve(Vertex v);
  void putOnSurface(const std::vector<Vertex>& vertices);
  Eigen::RowVector3d wishOf(OpenMesh::SmartVertexHandle v) const;
  double leastShapeAt(
    Vertex v, const Eigen::RowVector3d& place, const Eigen::RowVector3d& normal) const;

  const SurfaceSearch& Surface;
  double Size;
  double Growth;
  ParallelFor Threads;
  LengthLimit Longest;
  RemeshingMesh Mesh;
};
}

#endif
