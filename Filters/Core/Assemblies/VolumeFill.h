// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Hexahedra in a volume of an assembly whose sides and source cap have quads.
 */
#ifndef hexsweep_VolumeFill_h
#define hexsweep_VolumeFill_h

#include "Core/Assemblies/AssemblyMesh.h"
#include "Core/Geometry/AffineMap.h"
#include "Core/Hexahedra/HexQuality.h"
#include "Core/Interior/SweepCage.h"

#include <optional>
#include <string>

namespace hexsweep
{
/// A volume between its caps: both have quads.
struct VolumeCage
{
  SweepCage cage;
  /// Row k, column i: node of the assembly at point i on layer k; -1: inside.
  Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> nodes;
};

/**
 * Carries the quads of the source cap to the target cap.
 *
 * @param map  of the source cap to the target cap, where there is one (capMapOf()): quads of the
 *             target are images of the source's then.
 * @param mesh has the quads of the source cap and of all sides; gets those of the target cap. Where
 *        faces of the target have quads already, these must be the source's, node for node along
 *        the columns.
 * @throw InvalidInput where they are not, and as projectSweep(); SolverFailure; Aborted.
 */
VolumeCage carryToTarget(const AssemblyComplex& complex, const AssemblyGeometry& geometry,
  Index volume, const SweepLayout& layout, const std::optional<AffineMap>& map, AssemblyMesh& mesh,
  const Progress& progress = {}, const ParallelFor& parallelFor = {});

struct VolumeHexes
{
  Points points; ///< row k n + i: point i on layer k
  Hexes hexes;   ///< of these
  std::vector<HexQuality> qualities;
  std::string method; ///< see SweepInterior::method
};

/// Places the nodes inside, see sweepInterior(). @throw Aborted, SolverFailure.
VolumeHexes fillVolume(
  const VolumeCage& cage, const Progress& progress = {}, const ParallelFor& parallelFor = {});
}

#endif
