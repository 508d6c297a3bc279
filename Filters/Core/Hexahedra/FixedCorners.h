// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Hexahedra that no placement of the inner nodes can make valid.
 */
#ifndef hexsweep_FixedCorners_h
#define hexsweep_FixedCorners_h

#include "Core/Common/ParallelFor.h"

namespace hexsweep
{
/// Why fixed nodes alone make a hexahedron bad.
enum class ConflictCause
{
  Corner, ///< a corner whose four nodes are fixed is not positive
  Fold,   ///< the faces round a fixed node do not face one side
  Edge,   ///< an edge between fixed nodes has no length
  Inside  ///< all eight nodes are fixed; positive at the corners, but not certified
};

struct Conflict
{
  Index hex;
  Index node; ///< where; a corner of the hexahedron
  ConflictCause cause;
};

struct FixedCorners
{
  /// Least scaled Jacobian of the corners whose four nodes are fixed, 0 at the most where there
  /// are conflicts: the mesh's cannot be higher. 1 where there is neither.
  double floor = 1.0;
  /// One for each such hexahedron, rising.
  std::vector<Conflict> conflicts;

  /// Whether the hexahedron is among the conflicts.
  bool forbids(Index hex) const;
};

/**
 * Looks at what fixed nodes alone decide: corners with four fixed nodes; edges between two;
 * hexahedra with eight (certifyHex()); and, at each edge from a fixed node to a free one, the
 * corners whose other two edges are fixed as well. Their Jacobians are the products of that edge
 * with the normals of the fixed edges: some place of the free node makes all of them positive if
 * and only if the normals have an open half space in common. Where they have not, the fewest that
 * must be left out (largestHalfSpace()) are conflicts.
 *
 * @param points n x 3.
 * @param hexes  m x 8 ids in [0, n), VTK_HEXAHEDRON order.
 * @param fixed  n entries: nodes that stay.
 */
FixedCorners fixedCorners(const PointsRef& points, const HexesRef& hexes,
  const std::vector<bool>& fixed, const ParallelFor& parallelFor = {});
}

#endif
