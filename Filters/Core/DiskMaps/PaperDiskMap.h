// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The source cap pinned to the disk of the target cap (paper section 3.2, steps 1 and 2, to
 * the letter).
 *
 * The target cap has its canonical map (section 3.1.2) to its own domain H2. The boundary nodes of
 * the source cap go to their corresponding places in H2, its inside follows by one harmonic map.
 * H2 need not suit the source: the map of an annulus folds as soon as the hole grows or turns too
 * much against the outer loop, see NitscheCondition. commonDiskMap() is free of that.
 */
#ifndef hexsweep_PaperDiskMap_h
#define hexsweep_PaperDiskMap_h

#include "Core/DiskMaps/CommonDiskMap.h"
#include "Core/DiskMaps/CylinderCap.h"

#include <optional>

namespace hexsweep
{
/**
 * When the annulus sourceRadius <= |z| <= 1 has a one-to-one harmonic map to the annulus
 * targetRadius <= |w| <= 1 whose inner circle turns by `turn` against the outer one.
 *
 * With both circles mapped to their images at constant speed the map is a z + b / conj(z); its
 * Jacobian |a|^2 - |b|^2 / |z|^4 is least on the inner circle, and positive there if and only if
 * targetRadius < 2 r cos(turn) / (1 + r^2), r = sourceRadius. So the map folds all round the hole
 * first, whatever the turn, and beyond a quarter turn always. Without the cosine the bound holds
 * for circles mapped in any way \cite Nitsche1962, \cite IwaniecKovalevOnninen2011. To fulfil it is
 * no promise where nodes run unevenly along the circles: flips are to be counted in any case.
 */
struct NitscheCondition
{
  double sourceRadius = 0.0; ///< inner over outer radius of the source's conformal annulus
  double targetRadius = 0.0; ///< the same of the target
  double turn = 0.0;         ///< in (-pi, pi]: mean over the hole less mean over the outer loop

  /// 2 r cos(turn) / (1 + r^2); zero or less beyond a quarter turn.
  double greatestTargetRadius() const;
  /// greatestTargetRadius() / targetRadius: at 1 and below the map folds.
  double ratio() const { return this->greatestTargetRadius() / this->targetRadius; }
};

/// Where the boundary nodes of a cap lie in its canonical domain.
struct CanonicalBoundary
{
  DiskDomain domain = DiskDomain::Disk;
  std::vector<Circle> holes;
  std::vector<PlanePoints> places;     ///< places[p]: the nodes of loop p, a row each
  std::optional<CylinderCap> cylinder; ///< of the cap itself, with two loops
};

/**
 * The boundary of the domain H2: unit circle by arc length with one loop; the round annulus that
 * the cap is conformal to, nodes at their conformal angles, with two; with more, the circle domain
 * that it is conformal to, see koebeMap().
 *
 * @param angles angles[p]: arc lengths along loop p, scaled to [0, 2 pi).
 */
CanonicalBoundary canonicalBoundary(const TriangleMesh& mesh, const std::vector<Loop>& loops,
  const std::vector<std::vector<double>>& angles);

struct PaperDisks
{
  CommonDisks disks;                       ///< first: source, second: target
  std::optional<NitscheCondition> nitsche; ///< with two loops
};

/**
 * Maps the target to its canonical domain and the source to the same domain.
 *
 * Both maps are linear in the plane over each triangle. Cotangent and mean value weights are tried
 * as in commonDiskMap().
 *
 * @param pairs rings on both, LoopPair::first on the source; the outer one first.
 * @throw InvalidInput (see matchCapBoundaries()), SolverFailure, Aborted.
 */
PaperDisks paperDiskMap(const Cap& source, const Cap& target, const std::vector<LoopPair>& pairs,
  Weights weights, double matchTolerance, const Progress& progress = {},
  const CapNames& names = {});
}

#endif
