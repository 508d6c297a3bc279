// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which triangles of a solid are the source cap, the target cap and the linking sides of a
 * one-to-one sweep, and which loops belong together.
 */
#ifndef hexsweep_SweepTopology_h
#define hexsweep_SweepTopology_h

#include "Core/Solids/SolidSurface.h"

namespace hexsweep
{
/// A linking side: an annulus between one loop of the source cap and one of the target cap.
struct SweepSide
{
  std::vector<Index> triangles; ///< rows of the solid's triangles, rising
  /// Points of the solid along the boundary of the source cap and of the target cap, each in the
  /// direction of that cap's own triangles (the cap on its left, seen from outside the solid), from
  /// the smallest id on.
  Loop sourceLoop;
  Loop targetLoop;
  std::vector<Index> faceIds; ///< rising
};

/// The parts of a one-to-one sweep; every triangle of the solid is in exactly one of them.
struct SweepTopology
{
  std::vector<Index> sourceFaceIds; ///< rising, each once
  std::vector<Index> targetFaceIds;
  std::vector<Index> sourceTriangles; ///< rows of the solid's triangles, rising
  std::vector<Index> targetTriangles;
  /// One a loop of the source cap: the one with the longest loops (both together) first, the
  /// others in the order of their source loop's smallest point id.
  std::vector<SweepSide> sides;
};

/**
 * Takes a solid apart.
 *
 * Both caps must be disks with holes (genus 0, one piece), apart from each other, and everything
 * else must fall into annuli that each join a whole loop of the source cap with a whole loop of the
 * target cap.
 *
 * @param sourceFaceIds, targetFaceIds at least one, any order.
 * @throw InvalidInput saying which of this fails, at which face and where.
 */
SweepTopology sweepBetween(const SolidSurface& solid, const std::vector<Index>& sourceFaceIds,
  const std::vector<Index>& targetFaceIds);
}

#endif
