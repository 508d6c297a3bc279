// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The triangles that solids have in common.
 */
#ifndef hexsweep_SharedTriangles_h
#define hexsweep_SharedTriangles_h

#include "Core/Solids/SolidSurface.h"

#include <array>

namespace hexsweep
{
using TriangleCorners = std::array<Index, 3>;

/// The triangle of another solid at the same place that faces a triangle.
struct Partner
{
  Index volume = -1; ///< row of the solids; -1: there is none
  Index row = -1;
};

struct SharedTriangles
{
  Points points;                                     ///< of all solids, each once
  std::vector<std::vector<TriangleCorners>> corners; ///< by solid and triangle, of these points
  std::vector<std::vector<Partner>> partners;
};

/**
 * @param matchTolerance points are one that are nearer than this to each other, of the shortest
 * edge.
 * @throw InvalidInput naming a face with a triangle that more than two solids have.
 */
SharedTriangles shareTriangles(
  const std::vector<const SolidSurface*>& solids, double matchTolerance);
}

#endif
