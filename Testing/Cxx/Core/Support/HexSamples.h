// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Hexahedra by chance, and their Jacobian from the shape functions.
 */
#ifndef HexSamples_h
#define HexSamples_h

#include "Core/Hexahedra/HexCertificate.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <random>

namespace test
{
using hexsweep::HexCorners;

HexCorners unitCube();

/// The unit cube with each coordinate changed by up to `amplitude`.
HexCorners shakenCube(double amplitude, std::mt19937& generator);

/// A shaken cube, stretched by up to 100 in each direction, turned and put somewhere else.
HexCorners randomHex(std::mt19937& generator);

/// The derivative of the trilinear map of the unit cube, its determinant taken in `Real`.
template <typename Real>
Real jacobianAt(const HexCorners& corners, double u, double v, double w)
{
  const HexCorners cube = unitCube();
  Eigen::Matrix<Real, 3, 3> derivative = Eigen::Matrix<Real, 3, 3>::Zero();
  const double at[3] = { u, v, w };
  // From the first corner, so that the place of the hexahedron costs no digits.
  for (int i = 1; i < 8; ++i)
  {
    const Eigen::Matrix<Real, 1, 3> x = corners.row(i).cast<Real>() - corners.row(0).cast<Real>();
    for (int d = 0; d < 3; ++d)
    {
      Real slope = cube(i, d) > 0.0 ? Real(1) : Real(-1);
      for (const int other : { (d + 1) % 3, (d + 2) % 3 })
      {
        slope *= cube(i, other) > 0.0 ? Real(at[other]) : Real(1) - Real(at[other]);
      }
      derivative.row(d) += slope * x;
    }
  }
  return derivative.row(0).dot(derivative.row(1).cross(derivative.row(2)));
}

/// The least value of jacobianAt() that a grid of points and a descent from the least of them find.
double leastJacobian(const HexCorners& corners, int points);
}

#endif
