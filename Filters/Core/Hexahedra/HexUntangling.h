// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Moves the nodes around inverted hexahedra until they are valid.
 */
#ifndef hexsweep_HexUntangling_h
#define hexsweep_HexUntangling_h

#include "Core/Common/ParallelFor.h"
#include "Core/Hexahedra/HexDescent.h"
#include "Core/Hexahedra/HexQuality.h"

namespace hexsweep
{
/// How coordinates are stored in the end.
enum class Precision
{
  Double,
  Single
};

/// Rounded to what is stored.
Points stored(const PointsRef& points, Precision precision);

struct UntangledHexes
{
  Points points;
  /// Hexahedra that were not Certified before and after.
  Index before = 0;
  Index after = 0;
  Index patches = 0;
  Index rounds = 0;
  /// Spent, in the unit of untanglingBudget().
  double work = 0.0;
};

/// Of a Newton step of a patch of so many hexahedra, in the unit of untanglingBudget().
double untanglingWork(Index hexes, HexSamples samples);

/**
 * How much work untangleHexes() spends at the most on a mesh of so many hexahedra.
 *
 * Counted, not timed, so that results do not depend on the machine: a Newton step of a patch of c
 * hexahedra is worth c^(4/3) for the corners and 27/8 of it for the lattice, as the solver takes
 * about as many iterations as the patch has hexahedra in a row. A million is a few seconds. What
 * leaves at most half of the bad hexahedra of a patch earns the patch its share once more.
 */
double untanglingBudget(Index hexes);

/**
 * Variational untangling \cite Garanzha2021 (see FoldoverFreeEnergy.h), locally: the bad
 * hexahedra and three rings of neighbours make a patch, all else stays. A patch that is not mended
 * is tried again with twice the rings, until untanglingBudget() is spent, of which each patch gets
 * a share by its size and what those before it have left. A result is kept only if fewer hexahedra
 * of the patch are bad, or as many and the least scaled Jacobian is higher.
 *
 * Bad is a hexahedron whose verdict is not Certified. Where all of a patch's corners are positive
 * the energy looks at the 27 places of the lattice instead of the corners. Hexahedra that their
 * fixed nodes make bad (fixedCorners()) count for nothing: nothing here can cure them.
 *
 * @param points n x 3.
 * @param hexes  m x 8 ids in [0, n).
 * @param boxes  m x 3: what each is to look like.
 * @param fixed  n entries: nodes that stay.
 * @param precision nodes that move are rounded to it, and hexahedra are judged by the rounded
 * nodes.
 * @throw Aborted when progress returns false.
 */
UntangledHexes untangleHexes(const PointsRef& points, const HexesRef& hexes, const HexBoxes& boxes,
  const std::vector<bool>& fixed, const ParallelFor& parallelFor = {},
  const Progress& progress = {}, Precision precision = Precision::Double);
}

#endif
