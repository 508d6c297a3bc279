// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Moves the nodes around inverted hexahedra until they are valid.
 */
#ifndef hexsweep_HexUntangling_h
#define hexsweep_HexUntangling_h

#include "HexDescent.h"
#include "HexQuality.h"
#include "ParallelFor.h"

namespace hexsweep
{
struct UntangledHexes
{
  Points points;
  /// Hexahedra that were not Certified before and after.
  Index before = 0;
  Index after = 0;
  Index patches = 0;
  Index rounds = 0;
};

/**
 * Variational untangling (Garanzha et al. 2021, see FoldoverFreeEnergy.h), locally: the bad
 * hexahedra and three rings of neighbours make a patch, all else stays. A patch that is not mended
 * is tried again with twice the rings. A result is kept only if fewer hexahedra of the patch are
 * bad, or as many and the least scaled Jacobian is higher.
 *
 * Bad is a hexahedron whose verdict is not Certified. Where all of a patch's corners are positive
 * the energy looks at the 27 places of the lattice instead of the corners. Hexahedra that their
 * fixed nodes make bad (fixedCorners()) count for nothing: nothing here can cure them.
 *
 * @param points n x 3.
 * @param hexes  m x 8 ids in [0, n).
 * @param boxes  m x 3: what each is to look like.
 * @param fixed  n entries: nodes that stay.
 * @throw Aborted when progress returns false.
 */
UntangledHexes untangleHexes(const PointsRef& points, const HexesRef& hexes, const HexBoxes& boxes,
  const std::vector<bool>& fixed, const ParallelFor& parallelFor = {},
  const Progress& progress = {});
}

#endif
