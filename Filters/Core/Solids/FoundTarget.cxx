// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/FoundTarget.h"

#include "Core/Common/Errors.h"
#include "Core/Interior/RingAdvance.h"
#include "Core/Solids/SolidMessages.h"

namespace hexsweep
{
namespace
{
/// Share of its way that a sweep to a target that nobody named may go back.
constexpr double MostBackward = 0.25;
}

void checkFoundTarget(const SweepBoundary& boundary, const std::vector<Index>& targetFaceIds)
{
  if (backwardShare(boundary) > MostBackward)
  {
    const bool one = targetFaceIds.size() == 1;
    throw InvalidInput("no target face is named, and " + listFaces(targetFaceIds) +
      (one ? " fits" : " fit") + " the source cap best, but the sides turn back on their way " +
      (one ? "to it" : "there") +
      ", as into a blind hole. Name the target faces, or cut the solid where it turns back.");
  }
}
}
