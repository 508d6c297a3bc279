// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The outer quads of a swept mesh, each with the hexahedron and the solid's triangle behind
 * it.
 */
#ifndef hexsweep_BoundaryQuads_h
#define hexsweep_BoundaryQuads_h

#include "Core/Solids/SolidCage.h"

#include <array>

namespace hexsweep
{
/// A quad of the boundary of the swept mesh.
struct BoundaryQuad
{
  std::array<Index, 4> points; ///< of the swept mesh, seen from outside the same way round as...
  Index triangle;              ///< ...this triangle of the solid, which is below its middle
  Index hex;                   ///< of sweptHexes()
  /// Which face of the hexahedron: 0 to 3 the sides over the edges of its quad, 4 the quad on the
  /// layer that is nearer to the source, 5 the other one.
  int face;
};

/**
 * The boundary of the swept mesh: source quads, target quads, then the linking sides in the order
 * of SolidCage::linking.
 */
std::vector<BoundaryQuad> boundaryQuads(
  const SolidCage& cage, const SolidSurface& solid, const SweepTopology& topology);
}

#endif
