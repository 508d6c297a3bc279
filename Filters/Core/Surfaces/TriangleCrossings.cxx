// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/TriangleCrossings.h"

namespace hexsweep
{
TriangleCrossings triangleCrossings(Index side0, Index side1, Index side2)
{
  const Index sides[3] = { side0, side1, side2 };
  TriangleCrossings result{ { 0, 0, 0 }, { 0, 0, 0 } };
  for (Index c = 0; c < 3; ++c)
  {
    const Index before = sides[(c + 2) % 3];
    const Index after = sides[c];
    const Index opposite = sides[(c + 1) % 3];
    if (opposite > before + after)
    {
      result.from[c] = opposite - before - after;
      result.around[(c + 1) % 3] = after;
      result.around[(c + 2) % 3] = before;
      return result;
    }
    result.around[c] = (before + after - opposite) / 2;
  }
  // Nothing starts in a corner.
  return result;
}
}
