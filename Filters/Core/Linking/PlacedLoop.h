// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Places on a loop by values at its points that rise by 1 a round.
 */
#ifndef hexsweep_PlacedLoop_h
#define hexsweep_PlacedLoop_h

#include "Core/Common/Mesh.h"

#include <vector>

namespace hexsweep
{
/// A loop of a side, with places that rise by less than 1 on the way round.
struct PlacedLoop
{
  Points points;         ///< n x 3
  std::vector<double> v; ///< one a point
};

/// A place between point `edge` of a loop and the next one.
struct LoopPlace
{
  std::size_t edge;
  double fraction; ///< in [0, 1]; 0 or 1 where the place is a point of the loop to rounding
  Eigen::RowVector3d between(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b) const;
};

/// @param values v at a loop's points, see PlacedLoop. @param v any number, period 1.
LoopPlace placeOnLoop(const std::vector<double>& values, double v);

/// Value at a place (edge + fraction) of a loop whose values rise by 1 a round.
double valueAt(const std::vector<double>& values, double place);
}

#endif
