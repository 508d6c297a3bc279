// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Moebius maps of the unit disk to itself.
 */
#ifndef hexsweep_DiskAutomorphism_h
#define hexsweep_DiskAutomorphism_h

#include "Core/Geometry/Circle.h"

#include <complex>
#include <vector>

namespace hexsweep
{
/// z -> turn (z - a) / (1 - conj(a) z): maps the unit circle to itself, and circles to circles.
class DiskAutomorphism
{
public:
  DiskAutomorphism() = default; ///< the identity

  /// @param toOrigin the point a that goes to the origin, |a| < 1. @param turn of modulus 1.
  DiskAutomorphism(const std::complex<double>& toOrigin, const std::complex<double>& turn);

  std::complex<double> operator()(const std::complex<double>& z) const;
  Circle operator()(const Circle& circle) const;

  /// The angle by which a point of the unit circle is turned: continuous along it.
  double turnAt(const std::complex<double>& z) const;

  /// The same map followed by a multiplication with a number of modulus 1.
  DiskAutomorphism turned(const std::complex<double>& by) const
  {
    return { this->ToOrigin, this->Turn * by };
  }

private:
  std::complex<double> ToOrigin = 0.0;
  std::complex<double> Turn = 1.0;
};

/**
 * The map that brings the weighted mean of points on the unit circle to the origin, without turning
 * the origin's neighbourhood (there is exactly one when no point has half of the weight
 * \cite DouadyEarle1986).
 *
 * @param angles  of the points, in radians.
 * @param weights positive, one a point.
 */
DiskAutomorphism balancingMap(
  const std::vector<double>& angles, const std::vector<double>& weights);

/// The same of the points themselves, on the unit circle.
DiskAutomorphism balancingMap(
  const std::vector<std::complex<double>>& points, const std::vector<double>& weights);

/// The points of the unit circle at these angles, in radians.
std::vector<std::complex<double>> pointsAt(const std::vector<double>& angles);
}

#endif
