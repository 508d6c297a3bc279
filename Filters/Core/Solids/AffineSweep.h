// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Recognises sweeps whose target cap is an affine image of the source cap, with sides that
 * are ruled along it: prisms, right or oblique, frusta, ruled twists.
 */
#ifndef hexsweep_AffineSweep_h
#define hexsweep_AffineSweep_h

#include "Core/Geometry/AffineMap.h"
#include "Core/Solids/SolidSurface.h"
#include "Core/Solids/SweepTopology.h"

#include <optional>

namespace hexsweep
{
/// Carries each point of the source cap to the target cap; the straight line between the two runs
/// on the sides where it begins on a loop.
struct AffineSweep
{
  AffineMap map;
  /// Whether the map is a translation: `map.linear` is the identity, bit for bit.
  bool isTranslation = false;
};

/**
 * Looks for an affine map between the caps and compares curves and surfaces, not triangulations.
 *
 * The first guess is the map without a rotation of its own that takes the caps' centres, normals
 * and second moments to each other (the optimal transport between two Gaussians
 * \cite OlkinPukelsheim1982); others follow the outer side round. Each is fitted to the loops'
 * points where these match one to one, otherwise a translation is tried before other maps, and to
 * their nearest places (iterative closest points). What is returned was checked: loops on loops,
 * caps on caps, straight lines from loop to loop on the sides and the sides on them, each both
 * ways, up to what the facets of curves explain and a millionth of the solid's size.
 *
 * Costs O(n log n).
 *
 * @return nothing where there is no such map.
 */
std::optional<AffineSweep> findAffineSweep(
  const SolidSurface& solid, const SweepTopology& topology);
}

#endif
