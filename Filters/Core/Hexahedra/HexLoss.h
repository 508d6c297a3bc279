// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What a corner of a hexahedron costs, and what the corners at a node cost together.
 */
#ifndef hexsweep_HexLoss_h
#define hexsweep_HexLoss_h

namespace hexsweep
{
/// A falling convex function of a corner's scaled Jacobian.
struct HexLoss
{
  /// 0: (1 - x)^2. Else exp(sharpness (middle - x)), continued as a parabola below the middle.
  double sharpness = 0.0;
  double middle = 0.0;

  struct Place
  {
    double value;
    double slope;     ///< <= 0 for x <= 1
    double curvature; ///< >= 0
  };
  Place at(double scaledJacobian) const;
};

/// Sum, gradient and Gauss-Newton matrix of a loss with respect to one node.
struct HexNodeSum
{
  double value = 0.0;
  double gradient[3] = { 0.0, 0.0, 0.0 };
  /// Symmetric: xx, xy, xz, yy, yz, zz.
  double curvature[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
};
}

#endif
