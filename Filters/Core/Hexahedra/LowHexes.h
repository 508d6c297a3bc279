// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Raises the scaled Jacobian of the worst hexahedra by moving all nodes round them at once.
 */
#ifndef hexsweep_LowHexes_h
#define hexsweep_LowHexes_h

#include "Core/Common/Mesh.h"
#include "Core/Common/ParallelFor.h"

namespace hexsweep
{
struct RaisedLowHexes
{
  Points points;
  /// Of the mesh, before and after.
  double before = 1.0;
  double after = 1.0;
  Index patches = 0;
  /// Spent, in the unit of untanglingBudget().
  double work = 0.0;
};

/**
 * Where single nodes are stuck (raiseMinimum()), as each of two neighbours holds the other: of a
 * patch round the worst hexahedra all free nodes descend together, by the foldover-free energy at
 * the 27 places of the lattice \cite Garanzha2021, which sees the inside of hexahedra, too.
 *
 * The worst are those in the lower half between the least scaled Jacobian and what is wanted, with
 * three rings of neighbours. A patch is kept if no more of its hexahedra are uncertified and its
 * least scaled Jacobian is higher. This is repeated as long as that of the mesh rises by a
 * hundredth of what is wanted, and as long as the next round is within the budget, 0.15 of
 * untanglingBudget(): counted, not timed.
 *
 * Bits do not depend on the number of threads.
 *
 * @param points n x 3.
 * @param hexes  m x 8 ids in [0, n).
 * @param fixed  n entries: nodes that stay.
 * @param wanted scaled Jacobian that is enough; nothing is done for <= 0.
 * @throw Aborted when progress returns false.
 */
RaisedLowHexes raiseLowHexes(const PointsRef& points, const HexesRef& hexes,
  const std::vector<bool>& fixed, double wanted, const ParallelFor& parallelFor = {},
  const Progress& progress = {});
}

#endif
