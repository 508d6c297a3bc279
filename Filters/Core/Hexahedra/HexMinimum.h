// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Raises the least scaled Jacobian of a hexahedral mesh up to what its boundary allows.
 */
#ifndef hexsweep_HexMinimum_h
#define hexsweep_HexMinimum_h

#include "Core/Hexahedra/HexNodeMoves.h"

namespace hexsweep
{
struct RaisedMinimum
{
  Points points;
  /// Hexahedra whose scaled Jacobian is below what is wanted, before and after.
  Index before = 0;
  Index after = 0;
  int rounds = 0;
};

/**
 * Moves the nodes of hexahedra whose scaled Jacobian is too low, one after the other, down the sum
 * of exp(k (m - scaled Jacobian)) over the corners at the node, with m the least at the node: a
 * smooth minimum. Hexahedra that have more than is wanted give some of it away.
 *
 * No hexahedron loses its certificate (unless they may go), none falls below both what is wanted
 * and the least around the node that moves: the least scaled Jacobian of the mesh does not fall.
 * Bits do not depend on the number of threads.
 *
 * Ends where all have what is wanted, where nothing is gained any more, and after 20000 visits
 * of nodes and one for every ten free nodes of the mesh: counted, not timed.
 *
 * @param points n x 3.
 * @param hexes  m x 8 ids in [0, n).
 * @param fixed  n entries: nodes that stay.
 * @param wanted scaled Jacobian that is enough, see FixedCorners::floor; nothing is done for <= 0.
 * @throw Aborted when progress returns false.
 */
RaisedMinimum raiseMinimum(const PointsRef& points, const HexesRef& hexes,
  const std::vector<bool>& fixed, double wanted, Certificates certificates = Certificates::Stay,
  const ParallelFor& parallelFor = {}, const Progress& progress = {});
}

#endif
