// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Interior nodes by affine maps and interpolated residuals: the BoundaryError method.
 */
#ifndef hexsweep_BoundaryErrorInterior_h
#define hexsweep_BoundaryErrorInterior_h

#include "Core/Interior/SweepCage.h"

namespace hexsweep
{
/**
 * The classical method that section 2 of Cai and Tautges (2013) compares with (their references
 * 14 and 15), here as the baseline.
 *
 * On each layer the source nodes are moved by the least-squares affine map of the source loop
 * nodes to the ring (fitAffineMap()); what the map leaves at the loop nodes, the residual, is
 * added with weights 1 / distance^2 between cap node and loop nodes on the source cap. The same
 * is done from the target cap, and the two results are blended linearly with the fraction of the
 * columns' length.
 *
 * Affine sweeps are reproduced to rounding. The weights see straight distances, through holes and
 * across notches; nothing keeps the hexes valid.
 *
 * Costs O(n b L) for n points, b loop nodes, L layers, in O(n L) memory.
 *
 * Result and errors as InteriorMethod says.
 */
Points boundaryErrorInterior(
  const SweepCage& cage, const Progress& progress = {}, const ParallelFor& parallelFor = {});
}

#endif
