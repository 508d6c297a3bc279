// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief All that is decided about an assembly before anything is meshed.
 */
#ifndef hexsweep_AssemblyPlanning_h
#define hexsweep_AssemblyPlanning_h

#include "Core/Assemblies/AssemblyIntervals.h"
#include "Core/Common/Stopwatch.h"
#include "Core/Geometry/ModelGeometry.h"

#include <memory>
#include <string>

namespace hexsweep
{
struct AssemblyVolume
{
  SolidSurface surface; ///< faces that solids share have one id, see makeAssemblyComplex()
  std::shared_ptr<const ModelGeometry> geometry; ///< nullptr: nodes stay on the triangles
  std::string name;                              ///< for messages: "\"Bolt\""
  std::string problem = {};                      ///< why it has no surface; empty: it has
  NamedSweep named;
  /// Of a piece (see cutIntoPieces()): row of the volume as it was given. Pieces of one volume have
  /// hexahedra together or not at all. -1: no piece.
  Index whole = -1;
};

struct PlannedAssembly
{
  AssemblyComplex complex;
  AssemblyPlan plan;
  AssemblyIntervals intervals;
  double size = 0.0;
  std::vector<Index> bodyOf; ///< one a volume: its own row; of a piece that of the first piece
  std::vector<std::string> problems; ///< one a volume: why it is left out; empty: it is not
  std::vector<std::string> warnings; ///< see describeNeighbours()
  std::vector<Stage> stages;
};

/**
 * Finds the complex, the plan (planAssembly(), imprintTargets()) and the numbers of edges
 * (assemblyIntervals()).
 *
 * The same bits wherever it is called, so ranks may each call it. Costs O(n log n) for the
 * triangles where few volumes are joined cap to cap.
 *
 * @param size wanted length of edges; 0: what suits the finest cap (see defaultQuadSize()), but no
 *             more than some 400000 hexahedra.
 * @param matchTolerance see makeAssemblyComplex().
 * @throw InvalidInput where no volume can be swept or there is no plan, and for a size that would
 * give more than 10^9 hexahedra; Aborted.
 */
PlannedAssembly planVolumes(const std::vector<AssemblyVolume>& volumes, double size,
  double matchTolerance = 1e-6, const Progress& progress = {});

/**
 * Spreads volumes over ranks: stack after stack, the most work first, to the rank that has the
 * least
 * (\cite Graham1969); where one stack is more than a rank's share, volume after volume.
 *
 * @param ranks >= 1.
 * @return one a volume: its rank.
 */
std::vector<int> shareVolumes(const PlannedAssembly& planned, int ranks);
}

#endif
