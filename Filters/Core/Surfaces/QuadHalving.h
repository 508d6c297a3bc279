// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Quads as two triangles each.
 */
#ifndef hexsweep_QuadHalving_h
#define hexsweep_QuadHalving_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// The corner, 0 or 1, at which a quad's shorter diagonal begins; 0 where both are as long.
/// @param corners in turn.
Index shorterDiagonal(const Eigen::Matrix<double, 4, 3>& corners);

/**
 * Cuts quads along their shorter diagonals.
 *
 * @return rows 2 q and 2 q + 1: the halves of quad q, oriented as it is.
 */
Triangles halveQuads(const PointsRef& points, const QuadsRef& quads);
}

#endif
