// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which CAD edges of a linking side go the way that the sweep goes.
 */
#ifndef hexsweep_SteadyColumns_h
#define hexsweep_SteadyColumns_h

#include "Core/Linking/StripColumn.h"

namespace hexsweep
{
/**
 * Leaves out CAD edges that wander: that fall back on their way, or drift round the side otherwise
 * than the rest. As columns of the mesh they would drag their neighbours along.
 *
 * An edge that is left out is still on the side: it is crossed by quads.
 *
 * @param columns of a side, in the order of its source loop.
 * @param free    (v, u) of each point of the side in a harmonic strip that knows no CAD edge; v has
 *                period 1.
 * @return those that are left, in the same order.
 */
std::vector<StripColumn> steadyColumns(
  const std::vector<StripColumn>& columns, const PlanePointsRef& free);

/// The heights u of `free` along an edge, made to rise strictly from 0 to 1: an edge round a ledge
/// has no other heights than its neighbourhood then, although it is longer.
std::vector<double> risingHeights(const StripColumn& column, const PlanePointsRef& free);
/// Whether an edge has no corner, a turn by more than 30 degrees at one of its points.
bool isSmooth(const PointsRef& points, const StripColumn& column);
}

#endif
