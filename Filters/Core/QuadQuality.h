// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scaled Jacobians of quads on a curved surface.
 */
#ifndef hexsweep_QuadQuality_h
#define hexsweep_QuadQuality_h

#include "Mesh.h"

namespace hexsweep
{
/// Quality of quads on a curved surface.
struct QuadQuality
{
  Eigen::VectorXd scaledJacobian; ///< m: least of the four corners, in [-1, 1]; NaN where an edge
                                  ///< has no length
  Index inverted = 0;             ///< quads with a corner <= 0 or an edge without length
  double minimum = 0.0;           ///< over all quads
  double mean = 0.0;
};

/**
 * Scaled Jacobians of quads, their corners measured against the normal of the surface that they
 * lie on: (a x b) . n / (|a| |b|) with the two edges a, b at the corner.
 *
 * Quads and normals may face opposite sides, all of them: the mesh's total area counts as positive
 * (it depends on the boundary alone, whatever is inverted inside).
 *
 * @param normals n x 3 unit normals at the quads' points.
 */
QuadQuality quadQuality(const PointsRef& points, const QuadsRef& quads, const PointsRef& normals);
}

#endif
