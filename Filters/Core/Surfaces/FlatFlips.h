// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A surface's triangles, changed without changing the surface: flips between coplanar
 * triangles, points on edges and in triangles.
 */
#ifndef hexsweep_FlatFlips_h
#define hexsweep_FlatFlips_h

#include "Core/Surfaces/HalfEdgeTriangles.h"

#include <cstdint>
#include <unordered_set>

namespace hexsweep
{
/// A mesh while its edges are flipped and points are added; its surface stays the same.
class FlatFlips
{
public:
  /// @param mesh an oriented 2-manifold, see checkSurface().
  explicit FlatFlips(const TriangleMesh& mesh);

  const HalfEdgeTriangles& connectivity() const { return this->Connectivity; }
  const Eigen::RowVector3d& point(Index i) const
  {
    return this->Positions[static_cast<std::size_t>(i)];
  }
  Index numberOfPoints() const { return static_cast<Index>(this->Positions.size()); }
  Index flips() const { return this->NumberOfFlips; }
  TriangleMesh mesh() const;

  /// The weight of an edge, equation (1) of the paper.
  double weight(Index half) const;

  /// Whether the triangles beside an inner edge lie in one plane, up to rounding.
  bool isCoplanar(Index half) const;

  /// Whether the triangles beside an edge are coplanar, up to rounding, and would stay upright
  /// with the other diagonal.
  bool isFlat(Index half) const;

  /// The same with another place for the apex of the triangle left of the edge.
  bool isFlat(Index half, const Eigen::RowVector3d& apex) const;

  /// Whether flipAll() would flip an edge if the triangle left of it had its apex elsewhere.
  bool wouldFlip(Index half, const Eigen::RowVector3d& apex) const;

  /// An edge that is never flipped, nor are the pieces into which insertOn() cuts it.
  void keep(Index from, Index to);

  /// Adds a point on an edge, then flips where that helps. @return its id.
  Index insertOn(Index from, Index to, const Eigen::RowVector3d& place);

  /// Flips flat edges of negative weight until there are none.
  void flipAll();

  /// Adds a point in the middle of an inner edge, then flips where that helps. @return its id.
  Index halve(Index half);

  /// Adds a triangle's centroid, then flips where that helps. @return its id.
  Index insertCentroid(Index triangle);

private:
  bool isCoplanar(Index half, const Eigen::RowVector3d& apex) const;
  double cotangent(Index half, const Eigen::RowVector3d& apex) const;
  double cotangent(Index half) const;
  /// Whether an edge leads from the start of `half` to a vertex.
  bool existsEdge(Index half, Index to) const;
  bool isKept(Index half) const;
  /// The half-edge from one vertex to another; -1: there is none.
  Index halfEdge(Index from, Index to) const;
  /// Adds a vertex on an edge and flips what lies around it.
  void splitEdge(Index half, Index vertex);
  void flipFrom(std::vector<Index> open);
  /// After a triangle has changed.
  void update(Index triangle);
  Index add(const Eigen::RowVector3d& position);

  HalfEdgeTriangles Connectivity;
  std::vector<Eigen::RowVector3d> Positions;
  std::vector<Index> Outgoing; // a half-edge that begins at each point, -1: none
  std::unordered_set<std::uint64_t> Kept;
  double Tolerance; // distance of the two diagonals of four coplanar points
  Index NumberOfFlips = 0;
};
}

#endif
