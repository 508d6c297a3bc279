// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SweepChoice.h"

#include "Core/Common/Errors.h"
#include "Core/Geometry/TriangleSearch.h"
#include "Core/Solids/SolidMessages.h"
#include "Core/Solids/SweepCap.h"
#include "Core/Solids/TargetFaces.h"

#include <algorithm>
#include <cstdio>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr std::size_t MostTried = 3;
constexpr std::size_t MostDoubtful = 5;
/// A sweep is not worth a trial where its score is less than this share of the best one's.
constexpr double LeastShare = 0.2;
/// Grave things speak against a sweep of a score below this: then more are tried.
constexpr double DoubtfulScore = 0.5;

[[noreturn]] void failOnRanking(const SolidSurface& solid, const SweepCandidates& ranking)
{
  if (ranking.list.empty())
  {
    const std::size_t faces = std::set<Index>(solid.faceIds.begin(), solid.faceIds.end()).size();
    throw InvalidInput("no way to sweep the solid fits: it has " + countOf(faces, "face") +
      ", of which no two are caps with a side between them. Split its surface into more faces (a "
      "ball needs a cap above, one below, and a belt), or cut the solid.");
  }
  std::string reasons;
  for (std::size_t i = 0; i < std::min(MostTried, ranking.list.size()); ++i)
  {
    const SweepCandidate& candidate = ranking.list[i];
    reasons += (i == 0 ? " The likeliest, " : " Next, ") +
      describeWay(candidate.sourceFaceIds, candidate.targetFaceIds) + ": " + candidate.reasons +
      (candidate.reasons.back() == '.' ? "" : ".");
  }
  throw InvalidInput("no source face is named, and no way to sweep the solid fits." + reasons +
    " Name the source faces (and the target faces) to sweep it all the same, or cut the solid into "
    "parts that can be swept.");
}

SweepChoice bestSweeps(const SolidSurface& solid)
{
  SweepChoice choice;
  choice.ranking = findSweepCandidates(solid);
  const double best = choice.ranking.list.empty() ? 0.0 : choice.ranking.list.front().score;
  const std::size_t most = best < DoubtfulScore ? MostDoubtful : MostTried;
  for (const SweepCandidate& candidate : choice.ranking.list)
  {
    if (candidate.fits && candidate.score >= LeastShare * best && choice.sweeps.size() < most)
    {
      choice.sweeps.push_back(
        sweepBetween(solid, candidate.sourceFaceIds, candidate.targetFaceIds));
    }
  }
  if (choice.sweeps.empty())
  {
    failOnRanking(solid, choice.ranking);
  }
  return choice;
}

/// What fits from one end to the other fits back just as well.
SweepChoice sweepTo(const SolidSurface& solid, const std::vector<Index>& targetFaceIds)
{
  const std::vector<Index> target = checkedFaceIds(solid, targetFaceIds, "target");
  SweepChoice choice;
  choice.ranking = findTargetCandidates(solid, target);
  for (SweepCandidate& candidate : choice.ranking.list)
  {
    std::swap(candidate.sourceFaceIds, candidate.targetFaceIds);
  }
  if (choice.ranking.list.empty())
  {
    throw InvalidInput("no source face is named, and none fits the target cap (" +
      listFaces(target) + "). Name the source faces as well, or other target faces.");
  }
  choice.sweeps.push_back(sweepBetween(solid, choice.ranking.list.front().sourceFaceIds, target));
  return choice;
}
}

SweepChoice chooseSweeps(const SolidSurface& solid, const std::vector<Index>& sourceFaceIds,
  const std::vector<Index>& targetFaceIds)
{
  if (sourceFaceIds.empty() && targetFaceIds.empty())
  {
    return bestSweeps(solid);
  }
  if (sourceFaceIds.empty())
  {
    return sweepTo(solid, targetFaceIds);
  }
  SweepChoice choice;
  std::vector<Index> target = targetFaceIds;
  if (target.empty())
  {
    choice.ranking = findTargetCandidates(solid, sourceFaceIds);
    target = choice.ranking.list.empty() ? findTargetFaces(solid, sourceFaceIds) // says why not
                                         : choice.ranking.list.front().targetFaceIds;
  }
  choice.sweeps.push_back(sweepBetween(solid, sourceFaceIds, target));
  return choice;
}

std::vector<Index> facesUnder(const SolidSurface& solid, const QuadMesh& quads)
{
  const TriangleSearch search(solid.points, solid.triangles);
  std::vector<Index> triangles;
  Index near = -1;
  for (Index q = 0; q < quads.quads.rows(); ++q)
  {
    Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
    for (int c = 0; c < 4; ++c)
    {
      middle += 0.25 * quads.points.row(quads.quads(q, c));
    }
    near = search.closest(middle, near).triangle;
    triangles.push_back(near);
  }
  return facesOfTriangles(solid, triangles);
}

std::string describeWay(
  const std::vector<Index>& sourceFaceIds, const std::vector<Index>& targetFaceIds)
{
  return "from " + listFaces(sourceFaceIds) + " to " + listFaces(targetFaceIds);
}

std::vector<std::string> describeRanking(const SweepCandidates& ranking)
{
  std::vector<std::string> lines;
  for (const SweepCandidate& candidate : ranking.list)
  {
    char score[32];
    std::snprintf(score, sizeof(score), "%.3f", candidate.score);
    lines.push_back(std::to_string(lines.size() + 1) + ": " +
      describeWay(candidate.sourceFaceIds, candidate.targetFaceIds) + ", score " + score + ", " +
      verdictOn(candidate) + ": " + candidate.reasons);
  }
  if (ranking.cut)
  {
    lines.push_back("There were more pairs of caps than these; only the likeliest were tried.");
  }
  return lines;
}
}
