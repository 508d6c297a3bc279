// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Another certificate, to hold the one of Core against, and hexahedra that are hard to
 * judge.
 *
 * It shares nothing with Core's: the determinant is evaluated at 27 points by the shape functions,
 * in intervals and, where these do not tell, in integers of any length (Boost.Multiprecision) over
 * one power of two, which stand for the coordinates exactly.
 */
#ifndef ExactHexes_h
#define ExactHexes_h

#include "Core/Hexahedra/HexCertificate.h"

#include <cstdint>

namespace test
{
using hexsweep::HexCorners;

enum class Truth
{
  Positive,    ///< the Jacobian is positive at every point
  NotPositive, ///< there is a point where it is not
  Unknown      ///< neither was found by so many bisections
};

/// What is true of a hexahedron with finite corners.
struct HexTruth
{
  Truth everywhere = Truth::Unknown;
  bool positiveCorners = false; ///< at all eight
  bool byIntervals = false;     ///< without exact numbers
};

/// @param boxes that exact numbers may look at.
HexTruth truthOf(const HexCorners& corners, int boxes = 3000);

/// HexTruth::everywhere alone: exact numbers only where intervals do not tell.
Truth truthEverywhere(const HexCorners& corners, int boxes = 3000);

constexpr int AdversarialKinds = 14;

/**
 * Hexahedra of AdversarialKinds kinds in turn: by chance, on small integers, with a corner in the
 * plane of its neighbours but for some last bits, on the edge of what Core certifies, far from the
 * origin, huge, tiny, slender, collapsed, left-handed, of magnitudes far apart, and rounded to
 * single precision.
 */
HexCorners adversarialHex(std::uint64_t number);
}

#endif
