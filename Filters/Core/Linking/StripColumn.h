// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief CAD edges as columns of a linking side.
 */
#ifndef hexsweep_StripColumn_h
#define hexsweep_StripColumn_h

#include "Core/Common/Mesh.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace hexsweep
{
/// A CAD edge that leads from the source loop to the target loop.
struct StripColumn
{
  std::vector<Index> points; ///< from source to target
  std::vector<double> u;     ///< of each point: its height in the strip, rising from 0 to 1
  double v = 0.0;
};

/// The point of a CAD edge after a height, and the fraction of the way to it from the one before.
inline std::pair<std::size_t, double> placeOn(const StripColumn& edge, double u)
{
  const std::size_t after = static_cast<std::size_t>(
    std::upper_bound(edge.u.begin(), edge.u.end() - 1, u) - edge.u.begin());
  return { after, (u - edge.u[after - 1]) / (edge.u[after] - edge.u[after - 1]) };
}
}

#endif
