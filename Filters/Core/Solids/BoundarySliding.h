// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Better places on the solid for the boundary nodes of a swept mesh.
 */
#ifndef hexsweep_BoundarySliding_h
#define hexsweep_BoundarySliding_h

#include "Core/Geometry/ModelGeometry.h"
#include "Core/Interior/SweepInterior.h"
#include "Core/Solids/SolidCage.h"

#include <string>
#include <vector>

namespace hexsweep
{
/// Whose nodes stay where they are, since they were given.
struct GivenQuads
{
  bool source = false;
  bool sides = false;
};

struct SlidBoundary
{
  SolidCage cage;
  Points points;             ///< of the hexahedra in it, see SweepInterior::points
  std::string method;        ///< of the interior that was begun with
  Index moved = 0;           ///< boundary nodes that lie elsewhere now
  double greatestMove = 0.0; ///< of one of them
};

/**
 * Raises the lowest scaled Jacobians of the hexahedra by moves of boundary nodes as well: each
 * stays on its face of the solid. Nodes of the loops, and nodes where faces meet, stay where they
 * are.
 *
 * Rounds of moves of single nodes at the lowest hexahedra, each for a higher soft minimum of the
 * scaled Jacobians beside it, take turns with sweepInterior(), as long as the minimum rises.
 *
 * @param geometry where nodes lie on the true surfaces, else nullptr: the facets of a face count.
 * @param starts   for the interior of the cage as it is given.
 * @param options  the precision does not count: nothing is rounded here.
 * @return the cage as it was, and filled, where no move makes the mesh better.
 * @throw as sweepInterior(); Aborted.
 */
SlidBoundary slideBoundary(const SolidSurface& solid, const SweepTopology& topology,
  const ModelGeometry* geometry, const SolidCage& cage, const GivenQuads& given,
  const std::vector<InteriorStart>& starts, const InteriorOptions& options,
  const Progress& progress = {});
}

#endif
