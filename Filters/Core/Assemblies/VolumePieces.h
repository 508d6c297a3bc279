// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Volumes with caps at several heights, cut into pieces with one source and one target cap
 * each.
 */
#ifndef hexsweep_VolumePieces_h
#define hexsweep_VolumePieces_h

#include "Core/Assemblies/AssemblyPlanning.h"

#include <vector>

namespace hexsweep
{
/**
 * Cuts volumes whose faces are sides and caps along a direction (stackDirections()), but more than
 * two caps, along the planes of their flat caps: a headed bolt where the shank meets the head, a
 * counterbored plate at the depth of its counterbores. Volumes with named caps stay whole.
 *
 * Triangles of neighbours are split where a cut ends on them, so that what volumes share stays
 * shared. New points on a side lie on its true surface where it is known. The cut faces have ids
 * that no volume has.
 *
 * @param volumes        as planVolumes() takes them.
 * @param matchTolerance see makeAssemblyComplex().
 * @return all volumes in their order, pieces from the lowest on in the place of theirs, with
 * `whole` set. Layers that were asked for are shared out by height.
 * @throw InvalidInput as shareTriangles().
 */
std::vector<AssemblyVolume> cutIntoPieces(
  std::vector<AssemblyVolume> volumes, double matchTolerance = 1e-6, const Progress& progress = {});
}

#endif
