// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Pieces of work that report progress and can be stopped.
 */
#ifndef hexsweep_StoppablePieces_h
#define hexsweep_StoppablePieces_h

#include "Core/Common/Errors.h"
#include "Core/Common/ParallelFor.h"

#include <algorithm>

namespace hexsweep
{
/**
 * forPieces() that asks before every piece whether to go on, or every eight where other threads may
 * run them.
 *
 * @param progress called from the calling thread only, with the share of [0, count) that is done.
 * @throw Aborted when progress returns false.
 */
inline void forStoppablePieces(const ParallelFor& parallelFor, const Progress& progress,
  Index count, Index grain, const std::function<void(Index, Index)>& body)
{
  constexpr Index PiecesAtOnce = 8;
  const Index group = grain * (parallelFor ? PiecesAtOnce : 1);
  for (Index first = 0; first < count; first += group)
  {
    reportProgress(progress, static_cast<double>(first) / static_cast<double>(count));
    forPieces(parallelFor, std::min(group, count - first), grain,
      [&](Index begin, Index end) { body(first + begin, first + end); });
  }
}
}

#endif
