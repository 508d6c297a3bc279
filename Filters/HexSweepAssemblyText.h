// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What vtkAssemblySweep tells the user about its volumes. Private to the module.
 */
#ifndef HexSweepAssemblyText_h
#define HexSweepAssemblyText_h

#include "Core/Assemblies/AssemblySweep.h"

#include <string>
#include <vector>

namespace hexsweep
{
/// A sentence for each volume that was to be filled and has no hexahedra, or bad ones.
/// @param volumes as they were swept. @param names of the volumes as they were given.
std::vector<std::string> describeVolumes(const AssemblySweep& sweep,
  const std::vector<AssemblyVolume>& volumes, const std::vector<std::string>& names);

/// @param counts see assemblyCounts(), of all ranks. @param sentences see describeVolumes().
/// @throw InvalidInput where no volume has a hexahedron.
void checkAnyHexes(const AssemblySweep& sweep, const std::vector<Index>& counts,
  const std::vector<std::string>& sentences);
}

#endif
