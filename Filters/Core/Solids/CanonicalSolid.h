// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A solid in a place and an order that its shape alone decides, so that a mesh does not
 * depend on how a file numbers it, which way its triangles run, or whether it is a mirror image.
 */
#ifndef hexsweep_CanonicalSolid_h
#define hexsweep_CanonicalSolid_h

#include "Core/Geometry/Reflection.h"
#include "Core/Solids/SolidInput.h"

#include <optional>

namespace hexsweep
{
struct CanonicalSolid
{
  SolidInput input;      ///< reflected; ids of points and cells are those of the given solid
  Reflection reflection; ///< takes the given solid here, and all that is made of it back
};

/**
 * Reflects a solid and sorts its points and triangles by their coordinates.
 *
 * Each coordinate is given the sign that puts the mean of the points above the middle of their
 * extent; where the two are the same (within 1e-4 of it), the triangles' coordinates decide. So
 * two solids that are reflections of each other in coordinate planes become one and the same, bit
 * for bit, unless the solid is symmetric itself, and so do two numberings of one solid, also where
 * each triangle has points of its own. Points that no triangle uses are left out.
 *
 * Costs O(n log n).
 *
 * @param reflection the one to take in place of that; nothing: the shape decides.
 * @throw InvalidInput as checkSolidInput().
 */
CanonicalSolid canonicalSolid(
  const SolidInput& solid, const std::optional<Reflection>& reflection = std::nullopt);
}

#endif
