// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangles of about one size on a given surface.
 */
#ifndef hexsweep_SurfaceRemeshing_h
#define hexsweep_SurfaceRemeshing_h

#include "Core/CapQuads/RemeshingMesh.h"

namespace hexsweep
{
/**
 * Isotropic remeshing (\cite BotschKobbelt2004): edges that are too long are halved, short ones
 * collapsed, edges flipped, vertices moved to the centroids of their surroundings, in turn. Flips
 * aim at Delaunay triangles instead of equal valences, and no operation turns a triangle over.
 *
 * @param surface on which all new vertices come to lie.
 * @param size    wanted edge length away from the curves, > 0.
 * @param growth  of the wanted length with the distance from shorter edges on curves, > 0.
 * @param longest of the wanted length at a place; empty: `size`.
 * @param parallelFor lends threads for what is done to many vertices at once; the bits do not
 * depend on them.
 * @throw Aborted.
 */
RemeshedSurface remeshSurface(const RemeshingInput& input, const SurfaceSearch& surface,
  double size, double growth, const Progress& progress = {}, const ParallelFor& parallelFor = {},
  const LengthLimit& longest = {});
}

#endif
