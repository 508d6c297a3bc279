// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief From the quads of the source cap to the quads of the target cap, in one call
 * (paper section 3.2).
 */
#ifndef hexsweep_SweepProjection_h
#define hexsweep_SweepProjection_h

#include "Core/CapQuads/CarriedSource.h"
#include "Core/CapQuads/LinkedCaps.h"
#include "Core/CapQuads/QuadPolishing.h"
#include "Core/CapQuads/QuadProjection.h"
#include "Core/CapQuads/QuadQuality.h"
#include "Core/DiskMaps/PaperDiskMap.h"

#include <optional>
#include <string>

namespace hexsweep
{
enum class ProjectionMethod
{
  Harmonic,          ///< through the harmonic maps of both caps to a common domain
  PaperHarmonic,     ///< the source pinned to the canonical domain of the target, for comparison
  AffineLeastSquares ///< the traditional method, for comparison
};

struct SweepProjectionInput
{
  QuadMesh source;     ///< consistently oriented
  TriangleMesh target; ///< any orientation
  /// The rings from the source's loops to the target's. Without them loops are matched by shape.
  std::optional<RingStack> linking;
  /// Triangulation of the source cap; without it the quads' own, halved along shorter diagonals.
  std::optional<TriangleMesh> sourceSurface;
  /// Disk maps of both caps that were made before, to be used as they are.
  std::optional<CapDisk> sourceDisk;
  std::optional<CapDisk> targetDisk;
  /// Inner nodes of the quads that belong at certain places of the target, and stay there.
  std::vector<FixedNode> borders;
  ProjectionMethod method = ProjectionMethod::Harmonic;
  Weights weights = Weights::Cotangent;
  TriangulationImprovement improvement = TriangulationImprovement::Automatic; ///< of both caps
  double matchTolerance = 1e-6;
  bool singlePrecision = false; ///< round the points to float before they are judged
  bool ensureValid = false;     ///< untangle what is inverted, see untangleQuads()
  bool improveQuality = false;  ///< see polishQuads()
  ParallelFor parallelFor = {}; ///< lends threads; the bits do not depend on them
};

struct SweepProjection
{
  ProjectedQuads quads;
  QuadQuality quality;           ///< of the quads on the target surface
  FixedQuadCorners fixedCorners; ///< of those quads: what their boundary nodes alone decide
  Index invertedBefore = 0;      ///< quads that the projection itself inverted
  int rounds = 0;                ///< descents of untangling and polishing
  /// How far the loops wind on their way, see LoopWinding::greatest(); 0 where it was not measured.
  double winding = 0.0;
  /// Holes to which the quads do not wind as the sides do, see missedTurns(): hexahedra fold there
  /// whatever the interior does.
  std::vector<MissedHole> missedHoles;
  /// Whether the quads were carried along the sides (carrySource()): the caps have no common map
  /// then.
  bool carried = false;
  /// The maps that were used; empty for AffineLeastSquares, and where the quads were carried.
  std::optional<CapDisk> source;
  std::optional<CapDisk> target;
  /// For PaperHarmonic with one hole.
  std::optional<NitscheCondition> nitsche;
  /// See MatchedLoops; empty with linking sides.
  std::vector<double> startFractions;
  std::vector<std::string> doubts;
  /// Source quads' loops off the source surface, and last ring off the target surface; none where
  /// the disk maps were given.
  BoundaryMismatch sourceMismatch;
  BoundaryMismatch targetMismatch;
};

/// @throw InvalidInput, SolverFailure, Aborted.
SweepProjection projectSweep(const SweepProjectionInput& input, const Progress& progress = {});
}

#endif
