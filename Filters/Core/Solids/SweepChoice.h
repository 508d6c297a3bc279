// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which sweeps of a solid are to be tried, from the faces that were named.
 */
#ifndef hexsweep_SweepChoice_h
#define hexsweep_SweepChoice_h

#include "Core/Solids/SweepCandidates.h"
#include "Core/Solids/SweepTopology.h"

namespace hexsweep
{
struct SweepChoice
{
  /// The likeliest first: one, where a face is named, else up to three, or five where something
  /// grave speaks against all. Not empty.
  std::vector<SweepTopology> sweeps;
  SweepCandidates ranking; ///< empty where both caps are named
};

/**
 * @param sourceFaceIds, targetFaceIds in any order; empty: the cap is found.
 * @throw InvalidInput when no sweep fits, with the reasons of the likeliest ones, and what
 *        findSweepTopology() says.
 */
SweepChoice chooseSweeps(const SolidSurface& solid, const std::vector<Index>& sourceFaceIds,
  const std::vector<Index>& targetFaceIds);

/// Ids of the faces that the middles of some quads are nearest to, rising: their cap, where they
/// cover one.
std::vector<Index> facesUnder(const SolidSurface& solid, const QuadMesh& quads);

/// "from face 3 to faces 4 and 5".
std::string describeWay(
  const std::vector<Index>& sourceFaceIds, const std::vector<Index>& targetFaceIds);

/// The ranking as lines for a report, best first: rank, faces, score, verdict, reasons.
std::vector<std::string> describeRanking(const SweepCandidates& ranking);
}

#endif
