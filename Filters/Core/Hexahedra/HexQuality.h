// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Corner Jacobians and scaled Jacobian of hexahedra, and what can be concluded from them.
 *
 * The scaled Jacobian is Verdict's (\cite Stimpson2007, section on hexahedra): the least, over the
 * eight corners and the centre, of the determinant of three edge vectors over the product of
 * their lengths. Positive corners do not prove that a hexahedron is valid everywhere: a corner
 * test alone can condemn, never acquit. What acquits is the certificate (certifyHex()).
 */
#ifndef hexsweep_HexQuality_h
#define hexsweep_HexQuality_h

#include "Core/Common/Mesh.h"
#include "Core/Common/ParallelFor.h"
#include "Core/Hexahedra/HexCertificate.h"

#include <limits>
#include <vector>

namespace hexsweep
{
struct HexQuality
{
  /// In [-1, 1]. 0 or less for an edge without length, not a number where a coordinate is not.
  double scaledJacobian = 0.0;
  /// HexCertificate::jacobianLowerBound; not a number where no certificate was asked for.
  double jacobianLowerBound = std::numeric_limits<double>::quiet_NaN();
  Validity validity = Validity::Undecided;
  /// All eight corner Jacobians are negative: the points are in left-handed order.
  bool insideOut = false;
};

/// Determinants of the three edge vectors that leave each corner (length^3), in corner order.
Eigen::Matrix<double, 8, 1> cornerJacobians(const HexCornersRef& corners);

/**
 * Scaled Jacobian of one hexahedron, and what corners and centre tell of its validity: never
 * Certified.
 *
 * Verdict returns 1e30 for an edge whose squared length is below 1e-30, so that a collapsed
 * hexahedron looks perfect. Here such a corner has the scaled Jacobian 0, the hexahedron is
 * Degenerate, and no absolute length enters.
 */
HexQuality hexQuality(const HexCornersRef& corners);

/**
 * Quality of each hexahedron of a mesh, in order.
 *
 * @param points n x 3; @param hexes m x 8 ids in [0, n), VTK_HEXAHEDRON order.
 * @param certify with the verdict and the bound of certifyHex(); otherwise as hexQuality().
 * @throw InvalidInput for an id that is no point's; Aborted when progress returns false.
 */
std::vector<HexQuality> hexQualities(const PointsRef& points, const HexesRef& hexes,
  bool certify = true, const ParallelFor& parallelFor = {}, const Progress& progress = {});

/// The same for hexahedra that share no points. @param corners 8 m x 3, hexahedron by hexahedron.
/// @throw InvalidInput when their number is no multiple of 8.
std::vector<HexQuality> hexQualities(const PointsRef& corners, bool certify = true);

/**
 * The same without a tight bound (there is any, or not a number), which costs several times the
 * verdict where a hexahedron is not nearly a parallelepiped.
 */
std::vector<HexQuality> hexVerdicts(const PointsRef& points, const HexesRef& hexes,
  const ParallelFor& parallelFor = {}, const Progress& progress = {});

/// The same of few. @param corners points of three coordinates, the eight of one hexahedron, then
/// those of the next. @param verdicts one for each hexahedron.
void hexVerdicts(const double* const* corners, Index hexes, HexQuality* verdicts);

/// Counts and extremes over many hexahedra; those that are NotJudged do not count.
struct HexQualitySummary
{
  Index hexes = 0;
  /// InvertedCorner and InvertedInside.
  Index inverted = 0;
  /// InvertedInside alone.
  Index invertedInside = 0;
  Index insideOut = 0;
  Index degenerate = 0;
  Index undecided = 0;
  /// Everything that is not Certified, the inverted and degenerate ones included.
  Index notCertified = 0;
  /// Over all hexahedra with finite coordinates; 0 when there are none.
  double minScaledJacobian = 0.0;
  double meanScaledJacobian = 0.0;
  /// Over all hexahedra that have a bound; not a number when none has.
  double minJacobianLowerBound = std::numeric_limits<double>::quiet_NaN();

  /// Adds one more. The order of the calls fixes the last bits of the mean.
  void add(const HexQuality& quality);

private:
  double SumScaledJacobian = 0.0;
  Index FiniteHexes = 0;
};

HexQualitySummary summarize(const std::vector<HexQuality>& qualities);
}

#endif
