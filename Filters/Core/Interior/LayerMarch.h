// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Interior nodes layer by layer, from both caps towards each other.
 */
#ifndef hexsweep_LayerMarch_h
#define hexsweep_LayerMarch_h

#include "Core/Interior/SweepCage.h"

namespace hexsweep
{
/**
 * Places the nodes of a swept volume by carrying each cap from ring to ring.
 *
 * A layer X whose boundary is ring r moves to the next ring r' by the least-squares affine map A of
 * r to r' (fitAffineMap()) plus the harmonic function on X itself whose boundary values are what A
 * leaves, r' - A r. Layers are surfaces in space (quadLaplacian()); no plane is fitted to a ring.
 * Since every layer brings its own metric, the steps add up to a flow of the cap: a hole may turn
 * against the outer loop much further than a single harmonic function between the two bears without
 * folding \cite Nitsche1962. How far is a matter of the quads, which the turn shears.
 *
 * Where the harmonic part changes an edge by more than a quarter of its length, the step is divided
 * into up to 8 parts, with rings on the straight lines between r and r', and only the last layer of
 * them is kept.
 *
 * With F_k marched from the source and G_k from the target, and s = t^2 (3 - 2 t) of the fraction t
 * of the columns' length at layer k, the result is (1 - s) F_k + s G_k: each cap gives up its hold
 * slowly, so that columns leave it as its own march does.
 *
 * Affine sweeps are reproduced to rounding: those of a planar cap (shear, scale, rotation,
 * stretch), those of caps in any shape that both are the same up to a rotation and a scale, and,
 * where the loops are not planar, those of any cap.
 *
 * One sparse factorisation a layer and direction, and one more for each part of a divided step, all
 * in one elimination order.
 *
 * Result as InteriorMethod says; serial.
 *
 * @throw InvalidInput, SolverFailure (a layer whose quads have collapsed), Aborted (progress).
 */
Points layerMarchInterior(
  const SweepCage& cage, const Progress& progress = {}, const ParallelFor& parallelFor = {});
}

#endif
