// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The borders between the faces of a surface, its boundary included: the nearest place on
 * them, and their corners.
 */
#ifndef hexsweep_BorderSearch_h
#define hexsweep_BorderSearch_h

#include "Core/Geometry/TriangleSearch.h"

#include <utility>

namespace hexsweep
{
using PointPair = std::pair<Index, Index>;

/// Finds the nearest place on edges: triangle i of what is found is edge i, its first coordinate
/// belongs to the edge's first end, the others to the second one.
TriangleSearch edgeSearch(const PointsRef& points, const std::vector<PointPair>& edges);

/// Polylines of facets that may stand for curves.
struct ChainShape
{
  std::vector<bool> corner; ///< one a point: chains end, meet, or turn by more than 30 degrees
  /// One an edge: how far its curve is off it at most, for what the chain turns at its ends.
  std::vector<double> sagitta;
};

ChainShape chainShape(const PointsRef& points, const std::vector<PointPair>& edges);

/// An edge of a surface that is on its boundary or between two faces.
struct BorderEdge
{
  Index triangle; ///< one of those at it
  PointPair ends; ///< lower one first
  bool onBoundary;
};

class BorderSearch
{
public:
  /**
   * @param surface an oriented 2-manifold with boundary.
   * @param faceIds one a triangle.
   * @param keep    points that count as corners.
   */
  BorderSearch(
    const TriangleMesh& surface, const std::vector<Index>& faceIds, const std::vector<Index>& keep);

  struct Place
  {
    const BorderEdge& edge;
    double sagitta;  ///< see ChainShape
    double along;    ///< from the edge's first end, in [0, 1]
    double distance; ///< from what was asked for
  };
  /// @param onBoundary look at the boundary only.
  Place closest(const Eigen::RowVector3d& place, bool onBoundary) const;

  const std::vector<BorderEdge>& edges() const { return this->Edges; }
  /// Points, rising.
  const std::vector<Index>& corners() const { return this->Corners; }

private:
  std::vector<BorderEdge> outer();

  std::vector<std::size_t> OuterEdges;
  std::vector<BorderEdge> Edges;
  ChainShape Shape;
  TriangleSearch All;
  TriangleSearch Outer;
  std::vector<Index> Corners;
};
}

#endif
