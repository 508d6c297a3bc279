// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scaled Jacobians of quads on a curved surface.
 */
#ifndef hexsweep_QuadQuality_h
#define hexsweep_QuadQuality_h

#include "Core/Common/Mesh.h"

#include <vector>

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

/// Corner of a quad between two edges that cannot move.
struct FixedCorner
{
  Index quad;
  Index corner; ///< 0 to 3
  double scaledJacobian;
};

/// What the fixed nodes decide about the quads, wherever the other nodes are.
struct FixedQuadCorners
{
  /// Least scaled Jacobian of these corners (-1 where an edge has no length), 1 if there are none:
  /// an upper bound of QuadQuality::minimum for any place of the other nodes.
  double floor = 1.0;
  /// The worst corner of each quad that has one <= 0 or without a value; ascending quads.
  std::vector<FixedCorner> inverted;
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

/**
 * The corners whose own node and both neighbours in the quad are fixed, measured as quadQuality()
 * does.
 *
 * @param fixed n entries: nodes that stay.
 */
FixedQuadCorners fixedQuadCorners(const PointsRef& points, const QuadsRef& quads,
  const PointsRef& normals, const std::vector<bool>& fixed);
}

#endif
