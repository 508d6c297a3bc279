// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief One conforming hexahedral mesh of several solids that touch, from their triangles on.
 */
#ifndef hexsweep_AssemblySweep_h
#define hexsweep_AssemblySweep_h

#include "Core/Assemblies/AssemblyIntervals.h"
#include "Core/Assemblies/VolumeFill.h"
#include "Core/Common/Stopwatch.h"

#include <functional>

namespace hexsweep
{
struct AssemblyVolume
{
  SolidSurface surface; ///< faces that solids share have one id, see makeAssemblyComplex()
  std::shared_ptr<const ModelGeometry> geometry; ///< nullptr: nodes stay on the triangles
  std::string name;                              ///< for messages: "\"Bolt\""
  NamedSweep named;
};

struct AssemblySettings
{
  double size = 0.0; ///< wanted length of edges; 0: see defaultAssemblySize()
  ParallelFor parallelFor;
};

struct SweptVolume
{
  VolumeHexes hexes;
  /// One a point of `hexes`: the node of AssemblySweep::nodes that it is.
  std::vector<Index> nodes;
  std::string problem; ///< why the volume has no hexahedra; empty: it has
};

struct AssemblySweep
{
  AssemblyComplex complex;
  AssemblyPlan plan;
  AssemblyIntervals intervals;
  AssemblyMesh boundary; ///< the quads of all faces
  Points nodes;          ///< of all volumes, those of `boundary` first
  std::vector<SweptVolume> volumes;
  double size = 0.0;
  std::vector<std::string> warnings; ///< see describeNeighbours()
  std::vector<Stage> stages;
};

/**
 * A size for an assembly about which nothing is known: what suits the finest cap (see
 * defaultQuadSize()), but no more than some 400000 hexahedra.
 */
double defaultAssemblySize(const AssemblyComplex& complex, const AssemblyPlan& plan,
  const std::vector<AssemblyVolume>& volumes);

/**
 * Plans (planAssembly()), divides curves (assemblyIntervals()), meshes each face once, then fills
 * each volume by itself. A volume that cannot be filled is named in its `problem`; the others are
 * there.
 *
 * @throw InvalidInput where there is no plan; Aborted.
 */
AssemblySweep sweepAssembly(const std::vector<AssemblyVolume>& volumes,
  const AssemblySettings& settings, const Progress& progress = {});
}

#endif
