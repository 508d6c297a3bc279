// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Lengths along loops of a mesh, and angles made of them.
 *
 * A polygon is n x 3, one node a row, and closed: its last edge leads back to the first node.
 */
#ifndef hexsweep_LoopGeometry_h
#define hexsweep_LoopGeometry_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// Rows of points at the nodes of a loop.
Points loopPoints(const PointsRef& points, const Loop& loop);

/// Of each point: the one that follows it on its loop; -1: on no loop. @param loops apart.
std::vector<Index> nextOnLoops(const std::vector<Loop>& loops, Index numberOfPoints);

/// Flags the nodes of all loops; n entries.
std::vector<bool> boundaryFlags(Index n, const std::vector<Loop>& loops);

/// Length from the first node up to each node, 0 first; last entry (of n + 1): the whole length.
std::vector<double> reachedLengths(const PointsRef& polygon);

/// Length of a polygon, the edge from its last node to the first one included.
double closedLength(const PointsRef& polygon);

/// The point of an open chain that is nearest to a place. @param chain n x 3, n >= 1.
Eigen::RowVector3d nearestOnChain(const PointsRef& chain, const Eigen::RowVector3d& place);

/// Number of the longest loop, of several the first one. @param loops at least one.
std::size_t longestLoop(const PointsRef& points, const std::vector<Loop>& loops);

/**
 * Reached lengths as angles (radians): 0 for the first node, rising to less than 2 pi.
 *
 * @param reached as from reachedLengths(); the whole length, which has no angle, is positive.
 */
std::vector<double> anglesOfLengths(std::vector<double> reached);

/// Angles of a polygon's nodes by arc length. @param polygon of positive length.
std::vector<double> arcLengthAngles(const PointsRef& polygon);

/**
 * Whether the angles turn exactly once, without standing still.
 *
 * @param angles    in radians, unwrapped, one a node of a loop.
 * @param direction 1: counter-clockwise, -1: clockwise.
 */
bool turnsOnce(const std::vector<double>& angles, double direction);
}

#endif
