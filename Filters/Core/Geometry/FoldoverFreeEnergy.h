// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Distortion of a linear map that is finite for inverted maps too and drives them upright.
 *
 * Equations (1) to (6) of V. Garanzha et al. \cite Garanzha2021; the implementation is from the
 * formulae.
 */
#ifndef hexsweep_FoldoverFreeEnergy_h
#define hexsweep_FoldoverFreeEnergy_h

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
/// chi(d, e) = (d + sqrt(e^2 + d^2)) / 2: positive for every d, d itself for e -> 0 and d > 0.
inline double regularized(double determinant, double epsilon)
{
  const double root = std::sqrt(epsilon * epsilon + determinant * determinant);
  // For negative determinants the sum cancels.
  return determinant >= 0.0 ? 0.5 * (determinant + root)
                            : 0.5 * epsilon * epsilon / (root - determinant);
}

/// Derivative of the determinant with respect to the matrix.
inline Eigen::Matrix2d cofactors(const Eigen::Matrix2d& m)
{
  Eigen::Matrix2d c;
  c << m(1, 1), -m(1, 0), -m(0, 1), m(0, 0);
  return c;
}
inline Eigen::Matrix3d cofactors(const Eigen::Matrix3d& m)
{
  Eigen::Matrix3d c;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    c(i, 0) = m(j, 1) * m(k, 2) - m(j, 2) * m(k, 1);
    c(i, 1) = m(j, 2) * m(k, 0) - m(j, 0) * m(k, 2);
    c(i, 2) = m(j, 0) * m(k, 1) - m(j, 1) * m(k, 0);
  }
  return c;
}

template <int Dim>
struct Distortion
{
  double value;
  double determinant;
  Eigen::Matrix<double, Dim, Dim> gradient; ///< with respect to the Jacobian matrix
  /// Positive semidefinite part of the second derivative, columns of the Jacobian stacked.
  Eigen::Matrix<double, Dim * Dim, Dim * Dim> curvature;
};

/**
 * (1 - theta) |J|^2 / (d chi^(2/d)) + theta (1 + det^2) / (2 chi), 1 for a rotation.
 *
 * @param epsilon regularisation, > 0.
 * @param theta   weight of the volume term against the shape term, in [0, 1].
 */
template <int Dim>
Distortion<Dim> distortion(
  const Eigen::Matrix<double, Dim, Dim>& jacobian, double epsilon, double theta)
{
  const Eigen::Matrix<double, Dim, Dim> cofactor = cofactors(jacobian);
  Distortion<Dim> result;
  const double det = jacobian.row(0).dot(cofactor.row(0));
  result.determinant = det;
  const double chi = regularized(det, epsilon);
  const double root = std::sqrt(epsilon * epsilon + det * det);
  const double logSlope = root > 0.0 ? 1.0 / root : 0.0; // chi' / chi = 1 / root
  const double power = Dim == 2 ? chi : std::cbrt(chi * chi);
  const double shape = jacobian.squaredNorm() / (Dim * power);
  const double volume = (1.0 + det * det) / (2.0 * chi);
  result.value = (1.0 - theta) * shape + theta * volume;
  result.gradient = (1.0 - theta) * 2.0 / (Dim * power) * jacobian +
    ((1.0 - theta) * shape * (-2.0 / Dim) * logSlope + theta * (det / chi - volume * logSlope)) *
      cofactor;

  // |J|^2 / y is convex in (J, y): what is left out is the curvature of y = chi^(2/d) in J.
  using Stacked = Eigen::Matrix<double, Dim * Dim, 1>;
  const Eigen::Map<const Stacked> j(jacobian.data());
  const Eigen::Map<const Stacked> c(cofactor.data());
  const Stacked slope = (2.0 / Dim) * logSlope * c; // gradient of log y
  const double shapeWeight = (1.0 - theta) * 2.0 / (Dim * power);
  result.curvature.setIdentity();
  result.curvature -= j * slope.transpose() + slope * j.transpose();
  result.curvature += jacobian.squaredNorm() * slope * slope.transpose();
  result.curvature *= shapeWeight;
  result.curvature += theta * 2.0 * volume * logSlope * logSlope * c * c.transpose();
  return result;
}

/// The value alone.
template <int Dim>
double distortionValue(
  const Eigen::Matrix<double, Dim, Dim>& jacobian, double epsilon, double theta)
{
  const double det = jacobian.determinant();
  const double chi = regularized(det, epsilon);
  const double power = Dim == 2 ? chi : std::cbrt(chi * chi);
  return (1.0 - theta) * jacobian.squaredNorm() / (Dim * power) +
    theta * (1.0 + det * det) / (2.0 * chi);
}

/**
 * The next regularisation after a descent that lowered the energy from `before` to `after` and
 * left `leastDeterminant` (equation (6)): it follows the worst element down to zero.
 *
 * @param leastRate part by which it falls at the least.
 */
inline double nextEpsilon(
  double epsilon, double leastDeterminant, double before, double after, double leastRate)
{
  const double rate = std::max(1.0 - after / before, leastRate);
  const double wanted = (1.0 - rate) * regularized(leastDeterminant, epsilon);
  return leastDeterminant < wanted ? 2.0 * std::sqrt(wanted * (wanted - leastDeterminant)) : 1e-10;
}
}

#endif
