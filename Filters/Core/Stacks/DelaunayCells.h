// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cells of a constrained Delaunay triangulation, with the frame round all points.
 */
#ifndef hexsweep_DelaunayCells_h
#define hexsweep_DelaunayCells_h

#include "Core/Stacks/PlaneImprint.h"

#include <array>
#include <vector>

namespace hexsweep
{
/// A triangle, counter-clockwise.
struct DelaunayCell
{
  std::array<Index, 3> corner; ///< points of the graph, then the four of the frame
  std::array<Index, 3> across; ///< across[c]: neighbour over the edge from corner c to the next, -1
  std::array<bool, 3> isEdge{ false, false, false }; ///< whether that edge is one of the graph
};

/**
 * Points one after the other along Hilbert's curve, then the graph's edges, by flips
 * \cite Sloan1993. Signs that decide the topology are exact.
 *
 * @param graph one edge at least.
 * @throw InvalidInput where points coincide, or an edge crosses another one.
 */
std::vector<DelaunayCell> delaunayCells(const PlaneGraph& graph);
}

#endif
