// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the vertices of a cap's boundary lie along a ring of the linking sides.
 *
 * A place on a ring with n nodes is one number s in [0, n): edge floor(s), which leads from node
 * floor(s) to the next, and the fraction s - floor(s) along it.
 */
#ifndef hexsweep_RingParameter_h
#define hexsweep_RingParameter_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/**
 * Attaches the vertices of a closed polygon to a ring that runs the same way round.
 *
 * Vertices that coincide with a ring node get its number exactly. Between those, where one ring
 * edge spans the gap, vertices are placed by arc length, otherwise by the monotone assignment to
 * ring edges with the least sum of squared distances (dynamic programming). The result is
 * strictly rising round the loop, so that no edge of the polygon collapses.
 *
 * @param polygon        m x 3, m >= 3.
 * @param ring           n x 3, n >= 3.
 * @param matchTolerance relative to the shorter ring edge at a node: up to there a vertex is the
 *                       node.
 * @return m places; cyclically strictly rising.
 */
std::vector<double> ringParameters(
  const PointsRef& polygon, const PointsRef& ring, double matchTolerance);

/**
 * The union of the places of several polygons on one ring: sorted, with all integers.
 *
 * Places closer than 1e-7 of an edge are one; an integer wins over what is near it.
 */
std::vector<double> uniteParameters(
  Index ringSize, const std::vector<const std::vector<double>*>& places);

/// Number of the united place that s belongs to.
std::size_t unitedPlace(const std::vector<double>& united, Index ringSize, double s);

/// Cumulated length of the ring at each united place, 0 at place 0; last entry: whole length.
std::vector<double> ringLengths(const PointsRef& ring, const std::vector<double>& united);

/// The same without the last entry, scaled so that the whole length is 2 pi.
std::vector<double> ringAngles(const PointsRef& ring, const std::vector<double>& united);

/// Whether a ring that lies on a loop runs the way the loop does.
bool runsAlong(const PointsRef& ring, const PointsRef& points, const Loop& loop);
}

#endif
