// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/TargetFaces.h"

#include "Core/Common/Errors.h"
#include "Core/Solids/CapCandidates.h"
#include "Core/Solids/SolidMessages.h"
#include "Core/Solids/SweepCandidates.h"
#include "Core/Solids/SweepCap.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace hexsweep
{
namespace
{
/// How far a face is from having as many loops as the source cap.
std::size_t missingLoops(const FaceGraph& graph, std::size_t face, std::size_t wanted)
{
  const std::optional<CapCandidate> cap = makeCapCandidate(graph, { face });
  if (!cap)
  {
    return std::numeric_limits<std::size_t>::max();
  }
  const std::size_t loops = cap->loops.size();
  return std::max(loops, wanted) - std::min(loops, wanted);
}

/// The face without a point on the source cap that has the fewest loops amiss, then the largest
/// area; nothing where all of them touch it.
std::optional<Index> likeliestTarget(const FaceGraph& graph, const SweepCap& source)
{
  std::vector<Index> rim;
  for (const std::vector<Index>& loop : source.loops)
  {
    const Loop points = pointsOfHalfEdges(graph.halfEdges, loop);
    rim.insert(rim.end(), points.begin(), points.end());
  }
  std::sort(rim.begin(), rim.end());
  const auto touches = [&](Index t) {
    for (int c = 0; c < 3; ++c)
    {
      if (std::binary_search(rim.begin(), rim.end(), graph.solid.triangles(t, c)))
      {
        return true;
      }
    }
    return false;
  };
  std::optional<Index> likeliest;
  std::pair<std::size_t, double> best;
  for (std::size_t f = 0; f < graph.faces.size(); ++f)
  {
    const std::vector<Index>& own = graph.patches.triangles[f];
    if (std::binary_search(source.faceIds.begin(), source.faceIds.end(), graph.patches.ids[f]) ||
      std::any_of(own.begin(), own.end(), touches))
    {
      continue;
    }
    const std::pair<std::size_t, double> rank(
      missingLoops(graph, f, source.loops.size()), -graph.faces[f].area);
    if (!likeliest || rank < best)
    {
      best = rank;
      likeliest = graph.patches.ids[f];
    }
  }
  return likeliest;
}

[[noreturn]] void failOnLikeliest(const SolidSurface& solid, const std::vector<Index>& sourceIds)
{
  const FaceGraph graph = makeFaceGraph(solid);
  const SweepCap source = makeSweepCap(
    solid, graph.halfEdges, sourceIds, trianglesOfFaces(solid, sourceIds), "source cap");
  const std::string start = "no target face is named, and none fits the " + source.name;
  const std::optional<Index> likeliest = likeliestTarget(graph, source);
  if (!likeliest)
  {
    throw InvalidInput(start +
      ": every other face touches it. A target cap is a face at the other end, with a side in "
      "between. Check the face ids, or name the target faces.");
  }
  std::string problem;
  try
  {
    sweepBetween(solid, sourceIds, { *likeliest });
  }
  catch (const InvalidInput& error)
  {
    problem = error.what();
  }
  throw InvalidInput(start + ". The likeliest is face " + std::to_string(*likeliest) +
    ", but: " + problem + " If the target cap consists of several faces, name them all.");
}
}

std::vector<Index> findTargetFaces(
  const SolidSurface& solid, const std::vector<Index>& sourceFaceIds)
{
  const SweepCandidates candidates = findTargetCandidates(solid, sourceFaceIds);
  if (candidates.list.empty())
  {
    failOnLikeliest(solid, checkedFaceIds(solid, sourceFaceIds, "source"));
  }
  return candidates.list.front().targetFaceIds;
}

SweepTopology findSweepTopology(const SolidSurface& solid, const std::vector<Index>& sourceFaceIds,
  const std::vector<Index>& targetFaceIds)
{
  const std::vector<Index> source = checkedFaceIds(solid, sourceFaceIds, "source");
  return sweepBetween(
    solid, source, targetFaceIds.empty() ? findTargetFaces(solid, source) : targetFaceIds);
}
}
