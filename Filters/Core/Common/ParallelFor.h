// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How Core runs independent pieces of work: the caller lends the threads.
 */
#ifndef hexsweep_ParallelFor_h
#define hexsweep_ParallelFor_h

#include "Core/Common/Mesh.h"

#include <algorithm>

namespace hexsweep
{
/// Calls a function once with each number in [0, count), in any order and from any thread, and
/// returns when all calls have returned. What a call throws is thrown again by the caller, that of
/// the smallest number where several do. May be empty: one after the other then.
using ParallelFor = std::function<void(Index count, const std::function<void(Index)>& call)>;

/**
 * Calls body(begin, end) with [0, count) cut into pieces of `grain` (the last may be shorter).
 *
 * The pieces do not depend on the number of threads; a body that writes to its own piece only thus
 * gives the same bits with any of them.
 */
inline void forPieces(const ParallelFor& parallelFor, Index count, Index grain,
  const std::function<void(Index, Index)>& body)
{
  const Index pieces = (count + grain - 1) / grain;
  const auto call = [&](Index p) { body(p * grain, std::min((p + 1) * grain, count)); };
  if (parallelFor)
  {
    parallelFor(pieces, call);
    return;
  }
  for (Index p = 0; p < pieces; ++p)
  {
    call(p);
  }
}
}

#endif
