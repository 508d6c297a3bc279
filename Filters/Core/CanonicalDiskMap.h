// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Harmonic map of one cap to the unit disk (paper section 3.1).
 */
#ifndef hexsweep_CanonicalDiskMap_h
#define hexsweep_CanonicalDiskMap_h

#include "CapDisk.h"

namespace hexsweep
{
/// Where the holes of a cap go.
enum class HoleTreatment
{
  ArcLength, ///< circles about the centres that Filled gives; loops on them by arc length
  Filled     ///< wherever the harmonic map of the cap with filled holes puts them
};

/**
 * Maps a cap to the unit disk: the longest loop to the unit circle by arc length, beginning at
 * angle 0 with its smallest point id; the interior harmonic, equation (3).
 *
 * Chords are split first (see refineSurface()). With one loop the two treatments are the same.
 *
 * @param mesh consistently oriented.
 * @throw InvalidInput when the mesh is no cap (see checkCap()), SolverFailure.
 */
CapDisk canonicalDiskMap(const TriangleMesh& mesh, HoleTreatment treatment, Weights weights);
}

#endif
