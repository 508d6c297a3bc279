// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Jacobians of several hexahedra at once, as the lanes of vector registers.
 */
#ifndef hexsweep_HexLanes_h
#define hexsweep_HexLanes_h

namespace hexsweep
{
/// Hexahedra in a batch: the lanes that every x86-64 and ARMv8 processor has.
constexpr int HexLanesSize = 2;

/// One number for each hexahedron of a batch.
#if defined(__GNUC__)
using HexLanes = double __attribute__((vector_size(HexLanesSize * sizeof(double))));
#else
struct HexLanes
{
  double lanes[HexLanesSize];

  double& operator[](int i) { return this->lanes[i]; }
  double operator[](int i) const { return this->lanes[i]; }
};
#endif

/// Figures of the hexahedra of a batch.
template <typename Number>
struct HexFigures
{
  /// The least of the Bezier coefficients of the Jacobian (bezierCoefficients(); length^3).
  Number leastCoefficient;
  /// The least and the greatest Jacobian of a corner (length^3).
  Number leastCorner;
  Number greatestCorner;
  /// Squares, with the sign, of the scaled Jacobian: the least of the corners, and the centre.
  Number scaledCorner;
  Number scaledCenter;
  /// Squares of the products of three lengths that the nine scaled Jacobians were divided by
  /// (length^6): the least of them, and their sum, which is not finite if a coordinate is not.
  Number leastProduct;
  Number sumOfProducts;
  /// The same of the greatest lengths of the edges in the three directions.
  Number edgeProduct;
};

/// @param corners points of three coordinates: the eight of one hexahedron (VTK_HEXAHEDRON order),
///        then those of the next.
HexFigures<HexLanes> measureHexes(const double* const (&corners)[8 * HexLanesSize]);
}

#endif
