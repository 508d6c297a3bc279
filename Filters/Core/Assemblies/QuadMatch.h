// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Compares two quad meshes node for node, from their boundaries inward.
 */
#ifndef hexsweep_QuadMatch_h
#define hexsweep_QuadMatch_h

#include "Core/Common/Mesh.h"

#include <optional>

namespace hexsweep
{
/**
 * @param source one piece, consistently oriented, points in [0, n).
 * @param target any orientation, any ids.
 * @param known  n entries: point of the target that a point of the source is, -1 where that is not
 *               known; known are those of a boundary edge at least.
 * @return for each point of the source that a quad uses its point of the target, -1 for the others;
 *         nothing where the meshes are not the same with these.
 */
std::optional<std::vector<Index>> matchQuads(
  const Quads& source, const Quads& target, std::vector<Index> known);
}

#endif
