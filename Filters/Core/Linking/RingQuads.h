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
/// Sines at the corners of quads, negative where a corner is turned over against its quad, -1 for
/// an edge without length.
struct CornerSines
{
  double least = 1.0;
  double sum = 0.0;
  Index count = 0;

  double mean() const
  {
    return this->count > 0 ? this->sum / static_cast<double>(this->count) : 1.0;
  }
  void add(const CornerSines& others);
};

/// @param below, above the nodes of two rings, one row a column.
/// @return of all corners of the quads between them.
CornerSines cornerSines(const PointsRef& below, const PointsRef& above);
}

#endif
