// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Harmonic map of one cap to the unit disk (paper section 3.1).
 */
#ifndef hexsweep_CanonicalDiskMap_h
#define hexsweep_CanonicalDiskMap_h

#include "Core/DiskMaps/CapDisk.h"

namespace hexsweep
{
/// Where the holes of a cap go.
enum class HoleTreatment
{
  Koebe,     ///< the circle domain that the cap is conformal to, see koebeMap()
  ArcLength, ///< circles about the centres that Filled gives; loops on them by arc length
  Filled     ///< wherever the harmonic map of the cap with filled holes puts them
};

/**
 * Maps a cap to the unit disk, its longest loop to the unit circle; the interior is harmonic,
 * equation (3), with the nodes of the loops on the circles of the domain.
 *
 * Koebe: outer nodes at their conformal angles, the smallest point id at angle 0. An annulus in
 * which straight triangles would be flipped is linear in (log r, angle), see DiskDomain. A cap that
 * is too coarse or too distorted for it gets circles by arc length, and CapDisk::koebeFailure says
 * why. Otherwise, and with one loop: by arc length, beginning
 * at angle 0 with the smallest point id.
 *
 * Chords are split first (see refineSurface()). With one loop the three treatments are the same.
 *
 * @param mesh        consistently oriented.
 * @param improvement see improveCap().
 * @param limits      of Koebe's iteration.
 * @throw InvalidInput when the mesh is no cap (see checkCap()), SolverFailure, Aborted.
 */
CapDisk canonicalDiskMap(const TriangleMesh& mesh, HoleTreatment treatment, Weights weights,
  TriangulationImprovement improvement = TriangulationImprovement::Off,
  const KoebeLimits& limits = {}, const Progress& progress = {});
}

#endif
