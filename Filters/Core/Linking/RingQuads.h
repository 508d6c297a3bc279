// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How square the quads between two rings of a linking side are.
 */
#ifndef hexsweep_RingQuads_h
#define hexsweep_RingQuads_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/**
 * @param below, above the nodes of two rings, one row a column.
 * @return the least sine of all corners of the quads between them, negative where a corner is
 * turned over against its quad, -1 for an edge without length.
 */
double leastCornerSine(const PointsRef& below, const PointsRef& above);
}

#endif
