// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Jacobians of several hexahedra at once, as the lanes of vector registers.
 *
 * Compiled more than once, for what every processor has and for newer ones; the choice is made at
 * run time. All give the same bits: lanes are added up in one order, and no product is rounded
 * together with a sum.
 */
#ifndef hexsweep_HexKernels_h
#define hexsweep_HexKernels_h

#include "Core/Hexahedra/HexLoss.h"

namespace hexsweep
{
/// Hexahedra in a batch.
constexpr int HexLanesSize = 4;

/// One number for each hexahedron of a batch.
struct HexLanes
{
  double lanes[HexLanesSize];

  double& operator[](int i) { return this->lanes[i]; }
  double operator[](int i) const { return this->lanes[i]; }
};

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

/// The order of a hexahedron's corners (VTK_HEXAHEDRON) that begins with a given one and is not
/// left-handed where the hexahedron's is not.
constexpr int HexCornersFrom[8][8] = { { 0, 1, 2, 3, 4, 5, 6, 7 }, { 1, 2, 3, 0, 5, 6, 7, 4 },
  { 2, 3, 0, 1, 6, 7, 4, 5 }, { 3, 0, 1, 2, 7, 4, 5, 6 }, { 4, 7, 6, 5, 0, 3, 2, 1 },
  { 5, 4, 7, 6, 1, 0, 3, 2 }, { 6, 5, 4, 7, 2, 1, 0, 3 }, { 7, 6, 5, 4, 3, 2, 1, 0 } };

/**
 * `corners`: points of three coordinates, the eight of one hexahedron, then those of the next;
 * 8 HexLanesSize of them a batch.
 */
struct HexKernels
{
  const char* name;
  HexFigures<HexLanes> (*measure)(const double* const* corners);
  /// The loss of the four corners that the first point of each hexahedron enters into, of all
  /// batches together, as a function of that point. The corners are in the order of
  /// HexCornersFrom; a corner with an edge that has no length does not count.
  HexNodeSum (*sum)(const double* const* corners, int batches, const HexLoss& loss);
  /// HexNodeSum::value alone.
  double (*value)(const double* const* corners, int batches, const HexLoss& loss);
};

/// The kernels for this processor.
const HexKernels& hexKernels();

/// All kernels that this processor runs, the plainest first.
/// @return how many; `kernels` holds up to two.
int availableHexKernels(const HexKernels* kernels[2]);
}

#endif
