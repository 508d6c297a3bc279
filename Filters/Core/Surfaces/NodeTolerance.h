// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How near two points of different meshes must be to count as one node.
 */
#ifndef hexsweep_NodeTolerance_h
#define hexsweep_NodeTolerance_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// Largest rounding error (a distance) of the coordinates when they all are single precision
/// numbers (then the mesh was stored so, and its partner perhaps was not), otherwise 0.
double singlePrecisionError(const PointsRef& points);

/**
 * Distance up to which two points coincide.
 *
 * @param matchTolerance relative to `edge`, in [0, 0.5).
 * @param edge           length of the shortest edge at the node.
 * @param roundingError  see singlePrecisionError(); never more than a quarter of the edge counts,
 *                       so that rounding cannot reach the next node.
 */
double coincidenceDistance(double matchTolerance, double edge, double roundingError);

/// Length of the shorter of the two loop edges at each node of a loop.
std::vector<double> loopEdgeLengths(const PointsRef& points, const Loop& loop);
}

#endif
