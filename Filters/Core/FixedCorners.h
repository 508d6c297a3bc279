// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Corners of hexahedra that no placement of the inner nodes can change.
 */
#ifndef hexsweep_FixedCorners_h
#define hexsweep_FixedCorners_h

#include "Mesh.h"

namespace hexsweep
{
struct FixedCorners
{
  /// Least scaled Jacobian of the corners whose four nodes are fixed: the mesh's cannot be higher.
  /// 1 where there are none.
  double floor = 1.0;
  /// Hexahedra with such a corner that is not positive: cap and linking side contradict each
  /// other there. Rising.
  std::vector<Index> conflicts;
};

/**
 * @param points n x 3.
 * @param hexes  m x 8 ids in [0, n), VTK_HEXAHEDRON order.
 * @param fixed  n entries: nodes that stay.
 */
FixedCorners fixedCorners(
  const PointsRef& points, const HexesRef& hexes, const std::vector<bool>& fixed);
}

#endif
