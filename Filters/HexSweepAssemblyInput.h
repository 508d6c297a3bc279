// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The volumes of an assembly, in whatever form they come. Private to the module.
 */
#ifndef HexSweepAssemblyInput_h
#define HexSweepAssemblyInput_h

#include "Core/Assemblies/AssemblyPlanning.h"
#include "HexSweepAssemblyOutput.h"
#include "HexSweepSolidPort.h"

#include <string>
#include <vector>

namespace hexsweep
{
struct AssemblyInput
{
  std::vector<AssemblyVolume> volumes; ///< without NamedSweep
  VolumeLabels labels;
};

/**
 * Reads a solid's data as volumes:
 *  - surface cells with `VolumeId`, as readSolidPort() puts collections together, or pieces that do
 *    not touch (readBodies());
 *  - surfaces of which more than two meet at edges: the regions that they enclose, numbered from 1
 *    on (surfaceRegions());
 *  - volume cells: those of one `VolumeId`, else `CellEntityIds`, are a volume.
 *
 * @throw InvalidInput as readBodies(), and where surfaces enclose nothing.
 */
AssemblyInput readAssembly(
  const SolidPort& port, const std::string& faceIdArray, const SolidOptions& options);
}

#endif
