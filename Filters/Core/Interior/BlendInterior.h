// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Interior nodes as a blend of affine images of both caps plus a harmonic correction.
 */
#ifndef hexsweep_BlendInterior_h
#define hexsweep_BlendInterior_h

#include "Core/Interior/SweepCage.h"

namespace hexsweep
{
/**
 * Places the nodes of a swept volume.
 *
 * With A_k^S and A_k^T the least-squares affine maps that take the source and target loop nodes to
 * ring k (fitAffineMap()), and t_k the fraction of the columns' length at layer k, the blend is
 *
 *   B_k(i) = (1 - t_k) A_k^S(source_i) + t_k A_k^T(target_i).
 *
 * It carries both caps through the volume and knows nothing of how a ring differs from an affine
 * image of the loops. That difference is known on the boundary, and is spread into the volume as
 * the discrete harmonic function on the topological model, the prism of section 4.2 of Cai and
 * Tautges (2013): the target quads translated, with layers of the mean column length over L. The
 * harmonic function with boundary values v is sum_i h_i v_i with the harmonic coordinates h_i of
 * section 4.3, equations (9) to (11), so this is the cage deformation of the paper applied to the
 * difference from the blend instead of to the positions.
 *
 * Affine sweeps (shear, scale, rotation, stretch) of a planar cap are reproduced to rounding, and
 * so are caps in any shape that both are the same up to a rotation and a scale.
 *
 * Result and errors as InteriorMethod says.
 */
Points blendInterior(
  const SweepCage& cage, const Progress& progress = {}, const ParallelFor& parallelFor = {});

/**
 * The same for caps that bulge in different ways: what they do not share does not go through the
 * whole volume.
 *
 * Each cap is split into the harmonic surface in its loops (on the cap's own quads, see
 * quadLaplacian()) and the bulge on top of it. Where the bulges of both caps, each carried to the
 * other by the affine map of the loops, point the same way, the shorter is common to both and is
 * blended with the harmonic surfaces as blendInterior() blends the caps. The rest is a
 * harmonic function on the prism, zero on the linking sides and at the other cap, with layers a
 * quarter as high, in the frame of the layer's affine map.
 *
 * What blendInterior() reproduces this reproduces too.
 */
Points fadingBlendInterior(
  const SweepCage& cage, const Progress& progress = {}, const ParallelFor& parallelFor = {});

/// Whether the caps bulge in different ways by more than a thousandth of a layer's mean height.
/// If not, fadingBlendInterior() has nothing to add to blendInterior().
bool capsBulgeApart(const SweepCage& cage);
}

#endif
