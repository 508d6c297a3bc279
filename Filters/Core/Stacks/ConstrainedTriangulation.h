// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangles between the edges of a graph in the plane.
 */
#ifndef hexsweep_ConstrainedTriangulation_h
#define hexsweep_ConstrainedTriangulation_h

#include "Core/Stacks/PlaneImprint.h"

#include <array>

namespace hexsweep
{
struct ConstrainedTriangles
{
  /// Counter-clockwise, of the graph's points.
  Triangles triangles{ 0, 3 };
  /// Neighbour across the edge from corner c to the next, -1: none.
  Triangles neighbors{ 0, 3 };
  /// One a triangle and corner: whether that edge is one of the graph.
  std::vector<std::array<bool, 3>> isEdge;
  /// Connected triangles that no edge of the graph parts, numbered from 0 on; the outside is -1.
  std::vector<Index> regionOf;
  Index regions = 0;
};

/**
 * The constrained Delaunay triangulation of a graph, see delaunayCells().
 *
 * Triangles outside of all edges are left out. Costs about O(n log n).
 *
 * @throw InvalidInput where points coincide, or an edge crosses another one.
 */
ConstrainedTriangles triangulateGraph(const PlaneGraph& graph);
}

#endif
