// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The nearest place on the boundary loops of a cap, and whether a ring lies on them.
 */
#ifndef hexsweep_BoundarySearch_h
#define hexsweep_BoundarySearch_h

#include "Core/Geometry/TriangleSearch.h"

#include <string>

namespace hexsweep
{
/// All edges of a cap's boundary, as triangles without area for the search.
class BoundarySearch
{
public:
  /// @param points n x 3. @param loops at least one; ids in [0, n).
  BoundarySearch(const PointsRef& points, const std::vector<Loop>& loops);

  /// A point of the boundary; lengths in the points' unit.
  struct Place
  {
    std::size_t loop;
    double position;   ///< edge of the loop + fraction along it, in [0, number of nodes]
    double distance;   ///< from the point that was asked for
    double edgeLength; ///< of the edge that the place lies on
  };
  /// The boundary's point next to p.
  Place closest(const Eigen::RowVector3d& p) const;

private:
  TriangleSearch Search;
  std::vector<std::size_t> LoopOfEdge;
  std::vector<Index> EdgeInLoop;
  std::vector<double> EdgeLength;
};

/// Nodes of rings that are further from a cap's boundary than the facets of a curve explain.
struct BoundaryMismatch
{
  Index nodes = 0;                                       ///< how many
  Index ringNodes = 0;                                   ///< of how many
  double distance = 0.0;                                 ///< the greatest of theirs from the cap
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero(); ///< the node with that distance
};

/**
 * Compares rings with the boundary polygon of the cap that they should lie on.
 *
 * Two polygons with different vertices on one curve differ by the sagitta of their edges, an eighth
 * of edge times turning angle, in the plane in which the curve turns. A node is counted when it is
 * further away than a thousandth of an edge (or matchTolerance, if that is more) and four times the
 * sagitta, or when it is that far across that plane; where the plane itself turns by an angle beta
 * along the edge, sin(beta) times that is allowed there.
 *
 * @param loops          of the cap, ids of its points.
 * @param rings          closed polygons, each n x 3.
 * @param matchTolerance >= 0, relative to the longest edge at a node, of the ring and the cap.
 */
BoundaryMismatch boundaryMismatch(const PointsRef& points, const std::vector<Loop>& loops,
  const std::vector<Points>& rings, double matchTolerance);

/**
 * The mismatch as a warning, or an empty text.
 *
 * @param cap, ring names of the two, e.g. "target surface", "last ring of the linking sides".
 */
std::string describeMismatch(
  const BoundaryMismatch& mismatch, const std::string& cap, const std::string& ring);
}

#endif
