// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A linking side without the depth of its steps.
 */
#ifndef hexsweep_RuledShape_h
#define hexsweep_RuledShape_h

#include "Core/Linking/PlacedLoop.h"

#include <optional>
#include <vector>

namespace hexsweep
{
/// Values are one a point of the side.
struct RuledShape
{
  Points points;
  std::vector<double> v;    ///< of the line next to the point, in [0, 1]
  std::vector<bool> onStep; ///< whether the point is none of the ruled surface
};

/**
 * Many sides are ruled but for a groove, a rib, a pad: straight lines from the source to the target
 * loop that take a step aside and back. In the side's own metric a step is a hill that columns go
 * round, so that they crowd beside it and part on it. In the metric of this shape, a side with
 * flatter steps, they go on straighter.
 *
 * @param side       a refined side.
 * @param source, target its loops, equal v at both ends of a line.
 * @param negligible what is nearer to the ruled surface lies on it, in the points' unit.
 * @param depthLeft  of the distance of each point from the ruled surface, in (0, 1].
 * @return nothing where there is no step, or half of the area and more is
 *         none of the ruled surface.
 */
std::optional<RuledShape> ruledShape(const TriangleMesh& side, const PlacedLoop& source,
  const PlacedLoop& target, double negligible, double depthLeft);
}

#endif
