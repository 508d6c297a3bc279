// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which corner of a loop belongs on which corner of another one.
 */
#ifndef hexsweep_CornerMatching_h
#define hexsweep_CornerMatching_h

#include "Core/Linking/LoopFit.h"

#include <limits>

namespace hexsweep
{
/// Corners on corners in cyclic order, and what that costs (see LoopFit).
struct CornerMatch
{
  LoopAnchors anchors; ///< at the matched corners; empty if there are none
  double cost = std::numeric_limits<double>::infinity();
};

/// All corners on all corners, one match a cyclic offset; none where the numbers differ.
std::vector<CornerMatch> matchAllCorners(const LoopFit& fit);

/**
 * The cyclic sequence of pairs of corners with the least cost; any corners may be left over.
 *
 * Dynamic programming over the source corners, from each of several first pairs. Each source corner
 * is offered to the eight target corners that suit it best, and in loops of more than twelve
 * corners at most five in a row are left over.
 */
CornerMatch matchSomeCorners(const LoopFit& fit);
}

#endif
