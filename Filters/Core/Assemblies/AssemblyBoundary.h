// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The quads of an assembly's faces with the hexahedra beside them.
 */
#ifndef hexsweep_AssemblyBoundary_h
#define hexsweep_AssemblyBoundary_h

#include "Core/Assemblies/AssemblySweep.h"

#include <array>

namespace hexsweep
{
/// A hexahedron at a quad.
struct HexAtQuad
{
  Index volume = -1; ///< row; -1: there is none
  Index hex = -1;    ///< of the volume
  int side = 0;      ///< 1 to 6 as Exodus II counts them
};

struct AssemblyQuad
{
  std::array<Index, 4> nodes; ///< outward from the first volume
  Index face;                 ///< row
  std::array<HexAtQuad, 2> hexes;
};

/**
 * @return the quads of all faces, face by face. A face of two volumes has a hexahedron on both
 *         sides of each quad, unless a volume could not be filled: that is what makes the mesh
 *         conforming.
 */
std::vector<AssemblyQuad> assemblyBoundary(const AssemblySweep& sweep);
}

#endif
