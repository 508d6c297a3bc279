// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Raises the scaled Jacobians of valid hexahedra and loses none of them.
 */
#ifndef hexsweep_HexPolishing_h
#define hexsweep_HexPolishing_h

#include "Core/Common/ParallelFor.h"
#include "Core/Hexahedra/HexQuality.h"

namespace hexsweep
{
struct PolishedHexes
{
  Points points;
  Index movedNodes = 0;
};

/**
 * Moves one node after the other so that the sum of (1 - scaled Jacobian)^2 over the corners of its
 * hexahedra falls (a Gauss-Newton step with backtracking), some times round the mesh; a round in
 * which no node gains is the last.
 *
 * A move is made only if every hexahedron at the node that was Certified still is, and if the least
 * scaled Jacobian among them does not fall (or stays above 0.3 and above the mesh's minimum): the
 * mesh's minimum never falls, and no certificate is lost. Nodes stay whose hexahedra are all better
 * than 0.95, at the beginning or when their turn comes, and so do those whose sum fell by less than
 * 2 % when they were last looked at.
 *
 * Nodes that share no hexahedron are moved side by side, in groups that do not depend on the
 * number of threads: the result is the same bit for bit.
 *
 * @param points n x 3.
 * @param hexes  m x 8 ids in [0, n).
 * @param fixed  n entries: nodes that stay.
 * @param rounds times round the mesh at the most, >= 0.
 * @throw Aborted when progress returns false.
 */
PolishedHexes polishHexes(const PointsRef& points, const HexesRef& hexes,
  const std::vector<bool>& fixed, int rounds, const ParallelFor& parallelFor = {},
  const Progress& progress = {});
}

#endif
