// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the nodes of a mesh go on the curves of a cap.
 */
#ifndef hexsweep_CurveDivision_h
#define hexsweep_CurveDivision_h

#include "Core/CapQuads/CapCurves.h"

namespace hexsweep
{
/**
 * Divides curves into edges of about one length.
 *
 * Edges are evenly long; they are shorter where another curve faces this one at less than the
 * length wanted (a thin wall: edges are as long as it is wide), beside curves that are shorter, and
 * where the curve bends by more than a right angle within an edge (down to half the length).
 * From there they grow, by 0.4 of the way. The curves of a loop are divided into four edges at
 * least, and no two curves join the same nodes by one edge each.
 *
 * @param curves of the cap, see traceCapCurves().
 * @param size   wanted length, > 0.
 * @param chordTolerance see CapQuadOptions; of edges half as long as these.
 * @throw InvalidInput where walls are so thin that more than 10 million edges would result.
 * @return one list a curve: arc lengths of its nodes from 0 to its whole length, rising.
 */
std::vector<std::vector<double>> divideCapCurves(const TriangleMesh& cap,
  const std::vector<CapCurve>& curves, double size, double chordTolerance = 0.0);
}

#endif
