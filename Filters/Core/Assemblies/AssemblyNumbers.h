// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Numbers of nodes and hexahedra that do not depend on who made which.
 */
#ifndef hexsweep_AssemblyNumbers_h
#define hexsweep_AssemblyNumbers_h

#include "Core/Assemblies/AssemblySweep.h"

namespace hexsweep
{
/**
 * How many nodes and hexahedra there are of each kind: nodes inside each face, inside the target
 * cap that each volume made, inside each volume; hexahedra of each volume.
 *
 * What was not made here counts nothing, so that the greatest counts of all ranks are those of the
 * whole.
 */
std::vector<Index> assemblyCounts(const AssemblySweep& sweep);

struct AssemblyNumbers
{
  std::vector<Index> nodes;      ///< one a node of AssemblySweep::nodes
  std::vector<Index> firstHexes; ///< one a volume
};

/// Nodes of curves first, then kind by kind. @param counts of all ranks together.
AssemblyNumbers numberAssembly(const AssemblySweep& sweep, const std::vector<Index>& counts);
}

#endif
