// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the hexahedra of a sweep are to look like.
 */
#ifndef hexsweep_SweptBoxes_h
#define hexsweep_SweptBoxes_h

#include "Core/Hexahedra/HexDescent.h"
#include "Core/Interior/SweepBoundary.h"

namespace hexsweep
{
/**
 * A box for each hexahedron of a sweep: along the quads the mean length of opposite sides, blended
 * from the source to the target quad; across them the layer's height where its four columns are,
 * but never much less than the layer's mean.
 *
 * @param points (L + 1) n x 3, row k n + i is point i on layer k.
 * @param quads  m x 4 ids in [0, n).
 * @return L m x 3, row k m + j for quad j in layer k.
 */
HexBoxes sweptBoxes(const PointsRef& points, const QuadsRef& quads, const SweepBoundary& boundary);
}

#endif
