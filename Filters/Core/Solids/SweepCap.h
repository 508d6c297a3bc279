// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A cap of a sweep on the surface of a solid: some faces that form a disk with holes.
 */
#ifndef hexsweep_SweepCap_h
#define hexsweep_SweepCap_h

#include "Core/Solids/SolidSurface.h"
#include "Core/Surfaces/HalfEdgeTriangles.h"

#include <string>
#include <vector>

namespace hexsweep
{
struct SweepCap
{
  std::string name;             ///< for messages, e.g. "source cap (face 3)"
  std::vector<Index> faceIds;   ///< rising, each once
  std::vector<Index> triangles; ///< rows of the solid's triangles, rising
  /// Half-edges of the cap's triangles (see HalfEdgeTriangles) along its boundary, in their
  /// direction, each loop from its smallest point id on, in the order of these.
  std::vector<std::vector<Index>> loops;
};

/**
 * Ids in rising order, each once.
 *
 * @param role "source" or "target", for messages.
 * @throw InvalidInput when there are none, or the solid has no face of such an id.
 */
std::vector<Index> checkedFaceIds(
  const SolidSurface& solid, const std::vector<Index>& ids, const std::string& role);

/**
 * The cap that consists of some faces.
 *
 * @param faceIds   rising, each once.
 * @param triangles of these faces, rising, at least one.
 * @param role      "source cap" or "target cap", for messages.
 * @throw InvalidInput when the faces are the whole solid, fall into pieces, touch each other in a
 *        point only, or have a handle.
 */
SweepCap makeSweepCap(const SolidSurface& solid, const HalfEdgeTriangles& halfEdges,
  const std::vector<Index>& faceIds, const std::vector<Index>& triangles, const std::string& role);

/// Points of a loop of half-edges.
Loop pointsOfHalfEdges(const HalfEdgeTriangles& halfEdges, const std::vector<Index>& loop);

/// Number of vertices of some triangles. @param triangles rows.
Index countPoints(const SolidSurface& solid, const std::vector<Index>& triangles);
}

#endif
