// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What every interior method is given: both caps, their quads, and the rings between them.
 */
#ifndef hexsweep_SweepCage_h
#define hexsweep_SweepCage_h

#include "Core/Common/ParallelFor.h"
#include "Core/Interior/SweepBoundary.h"

namespace hexsweep
{
struct SweepCage
{
  Points source; ///< n x 3
  Points target; ///< n x 3, same order
  /// m x 4, the connectivity of both. Points that no quad uses are placed on the straight line
  /// between the caps.
  Quads quads;
  SweepBoundary boundary;
  /// Whether the target is an affine image of the source, and columns are straight lines, see
  /// ruledInterior().
  bool isRuled = false;
};

/**
 * An interior method: places the nodes of a swept volume.
 *
 * @param parallelFor lends threads; the bits do not depend on them. Progress is reported from the
 *        calling thread alone.
 * @return (L + 1) n x 3, row k n + i is source point i on layer k. Cap and ring points come out bit
 *         for bit as given.
 * @throw InvalidInput, SolverFailure, Aborted (progress).
 */
using InteriorMethod = std::function<Points(
  const SweepCage& cage, const Progress& progress, const ParallelFor& parallelFor)>;

/// One a node of the filled cage, (L + 1) n: whether it is on a cap or a linking side.
std::vector<bool> fixedNodes(const SweepCage& cage);

/// @throw InvalidInput where the parts of a cage do not belong together.
void checkCage(const SweepCage& cage);
}

#endif
