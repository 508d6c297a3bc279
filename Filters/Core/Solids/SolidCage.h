// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief From the parts of a solid to a cage that is ready to be filled with hexahedra: linking
 * sides meshed, quads carried to the target cap.
 */
#ifndef hexsweep_SolidCage_h
#define hexsweep_SolidCage_h

#include "Core/CapQuads/SweepProjection.h"
#include "Core/Common/Stopwatch.h"
#include "Core/Interior/SweepInterior.h"
#include "Core/Linking/LinkingSides.h"
#include "Core/Solids/AffineSweep.h"
#include "Core/Solids/SolidSurface.h"
#include "Core/Solids/SweepTopology.h"

namespace hexsweep
{
struct SolidCageInput
{
  const SolidSurface& solid;
  const SweepTopology& topology;
  QuadMesh source; ///< quads of the source cap, consistently oriented, either way
  /// By side of the topology: parts that are meshed with structured quads already. May be empty.
  std::vector<std::vector<QuadMesh>> patches;
  LayerRequest layers;
  double matchTolerance = 1e-6;
  bool singlePrecision = false; ///< see SweepProjectionInput
  bool ensureValid = true;      ///< see SweepProjectionInput
  bool improveQuality = true;   ///< see SweepProjectionInput
  ProjectionMethod method = ProjectionMethod::Harmonic;
  Weights weights = Weights::Cotangent;
  TriangulationImprovement improvement = TriangulationImprovement::Automatic;
  std::vector<FixedNode> imprinted = {}; ///< see SourceQuads::imprinted
  std::vector<bool> freeSides = {};      ///< see solidSides()
  double stepDepth = 1.0;                ///< see SideTube
  ParallelFor parallelFor = {};
  /// What findAffineSweep() gave, where it was asked already.
  const std::optional<AffineSweep>* affine = nullptr;
  double leastTriangles = 500.0; ///< see SideTube
};

struct SolidCage : SweepCage
{
  std::vector<Loop> loops;       ///< of the quads
  LinkingMesh linking;           ///< see meshLinkingSides()
  SweepProjection projection;    ///< see projectSweep()
  double greatestDistance = 0.0; ///< of a source point from the source cap
  /// Whether nodes had to leave the target's borders (see SolidCageInput::imprinted), or quads
  /// would be inverted.
  bool leftBorders = false;
  /// Ids of faces whose CAD edges were given up, see makeUnhinderedCage().
  std::vector<Index> freedSides;
  std::vector<Stage> stages;
};

/**
 * @throw InvalidInput when the quads are no cap, do not lie on the source cap, or a linking side
 *        cannot be meshed or collapses; SolverFailure; Aborted.
 */
SolidCage makeSolidCage(const SolidCageInput& input, const Progress& progress = {});

/// The side of each loop, by number in the topology.
std::vector<Index> sidesOfLoops(const SolidCage& cage);
}

#endif
