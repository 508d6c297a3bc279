// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Proof that a hexahedron is valid, or that it is not.
 */
#ifndef hexsweep_HexCertificate_h
#define hexsweep_HexCertificate_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// The corners of one hexahedron in VTK_HEXAHEDRON order, one a row.
using HexCorners = Eigen::Matrix<double, 8, 3, Eigen::RowMajor>;
using HexCornersRef = Eigen::Ref<const HexCorners>;

/// What is known of a hexahedron; the numbers are those of the cell array `Validity`.
enum class Validity : unsigned char
{
  Certified = 0,      ///< the Jacobian is positive at every point (proved)
  InvertedCorner = 1, ///< the Jacobian of a corner is not positive
  InvertedInside = 2, ///< positive corners, but not positive somewhere inside (proved)
  Undecided = 3,      ///< positive corners, nothing proved
  Degenerate = 4,     ///< an edge without length, a coordinate not finite, flat but for rounding
  NotJudged = 5       ///< not a hexahedron with straight edges
};

struct HexCertificate
{
  Validity validity;
  /**
   * A bound of the least value of det J over the hexahedron from below (length^3), J the derivative
   * of the trilinear map of the unit cube: the volume, for a box. Never above the minimum; below it
   * by at most 1 % of its magnitude and 2e-12 of the product of the greatest lengths of its edges
   * in the three directions, but where 400 bisections are not enough (the minimum is nearly zero
   * then). Not a number for Degenerate.
   */
  double jacobianLowerBound;
};

/**
 * Judges one hexahedron with the Bezier coefficients of its Jacobian (bezierCoefficients()),
 * bisected where they do not tell.
 *
 * The verdicts are about the coordinates as they are stored, in exact arithmetic: a rounding error
 * bound decides nearly always, and what it leaves open is done again with exact numbers. Undecided
 * is left where the Jacobian touches zero between the points of the bisections or comes so near to
 * it that they are too many, or where the magnitudes of the coordinates are too far apart for exact
 * numbers (by 2^250).
 */
HexCertificate certifyHex(const HexCornersRef& corners);
}

#endif
