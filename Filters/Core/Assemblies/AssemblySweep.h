// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief One conforming hexahedral mesh of several solids that touch.
 */
#ifndef hexsweep_AssemblySweep_h
#define hexsweep_AssemblySweep_h

#include "Core/Assemblies/AssemblyPlanning.h"
#include "Core/Assemblies/VolumeFill.h"

#include <functional>

namespace hexsweep
{
struct SweptVolume
{
  VolumeHexes hexes;
  /// One a point of `hexes`: its node, those up to AssemblySweep::boundary's number are there.
  std::vector<Index> nodes;
  std::string problem; ///< why the volume has no hexahedra; empty: it has, or it is not this rank's
  bool isMine = true;  ///< whether it was to be filled
};

struct AssemblySweep
{
  PlannedAssembly planned;
  AssemblyMesh boundary; ///< the quads of the faces of all volumes that were filled
  Points nodes;          ///< of all volumes, those of `boundary` first
  std::vector<SweptVolume> volumes;
  std::vector<Stage> stages;
};

/**
 * Divides curves, meshes each face once, then fills each volume by itself. A volume that cannot be
 * filled is named in its `problem`; the others are there.
 *
 * A face's mesh depends on the plan and the faces upstream of it alone, so ranks that share volumes
 * make those that they need, bit for bit the same.
 *
 * @param volumes as planVolumes() had them.
 * @param isMine  one a volume: whether it is to be filled; empty: all are.
 * @throw Aborted.
 */
AssemblySweep sweepAssembly(const std::vector<AssemblyVolume>& volumes, PlannedAssembly planned,
  const std::vector<bool>& isMine = {}, const ParallelFor& parallelFor = {},
  const Progress& progress = {});
}

#endif
