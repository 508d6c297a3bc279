// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The order of points of the plane along Hilbert's curve.
 *
 * Neighbours on the curve are neighbours in the plane: what is stored and visited in this order
 * stays in the cache whatever the numbering of the input.
 */
#ifndef hexsweep_HilbertOrder_h
#define hexsweep_HilbertOrder_h

#include "Core/Common/Mesh.h"

#include <cstdint>
#include <vector>

namespace hexsweep
{
/// A square of 2^16 x 2^16 cells and the place of each cell on Hilbert's curve \cite Hilbert1891
/// through all of them.
class HilbertCurve
{
public:
  /// Over the box of the points; entries that are not finite are ignored.
  explicit HilbertCurve(const PlanePointsRef& points);

  /// Points beyond the square count to its nearest cell.
  std::uint32_t key(double x, double y) const;

private:
  double LowX = 0.0;
  double LowY = 0.0;
  double CellsPerUnit = 0.0;
};

/// A point's key and its number.
struct CurvePlace
{
  std::uint32_t key;
  std::uint32_t id;
};

/**
 * All points, ordered by key, those of one cell by number. O(n) (radix sort).
 *
 * @throw InvalidInput for 2^32 points or more.
 */
std::vector<CurvePlace> hilbertOrder(const HilbertCurve& curve, const PlanePointsRef& points);
}

#endif
