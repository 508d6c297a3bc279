// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The connectivity of a swept mesh.
 */
#ifndef hexsweep_SweptHexes_h
#define hexsweep_SweptHexes_h

#include "Core/Common/Mesh.h"
#include "Core/Common/ParallelFor.h"

namespace hexsweep
{
/**
 * Whether the quad of layer k is the bottom of right-handed hexes between layers k and k + 1, or
 * that of layer k + 1: the sign of the sum of the corner Jacobians decides, over up to eight layers
 * spread evenly from the first to the last.
 *
 * @param quads  m x 4 ids in [0, n), consistently oriented.
 * @param points (L + 1) n x 3, row k n + i is point i on layer k.
 * @param numberOfLayers L >= 1.
 * @throw InvalidInput for an id out of this range, or points that do not make L + 1 layers.
 */
bool sourceIsBottom(const QuadsRef& quads, const PointsRef& points, Index numberOfLayers,
  const ParallelFor& parallelFor = {});

/**
 * Hexes over a quad mesh: hex k m + j has quad j on layer k and the same quad on layer k + 1.
 *
 * The hexes are right-handed whichever way the quads face: sourceIsBottom() decides,
 * once for the whole mesh, whether the quad of layer k is the bottom (points 0 to 3) or the top
 * (points 4 to 7) of VTK_HEXAHEDRON order.
 *
 * @param quads  m x 4 ids in [0, n), consistently oriented.
 * @param points (L + 1) n x 3, row k n + i is point i on layer k.
 * @param numberOfLayers L >= 1.
 * @return L m x 8.
 * @throw InvalidInput as sourceIsBottom().
 */
Hexes sweptHexes(const QuadsRef& quads, const PointsRef& points, Index numberOfLayers,
  const ParallelFor& parallelFor = {});

/**
 * Checks that two quad meshes have the same cells: quad j of both has the same points in the same
 * cyclic order, in either direction and from any start.
 *
 * @throw InvalidInput with the first quad that differs.
 */
void checkSameQuads(const QuadsRef& source, const QuadsRef& target);
}

#endif
