// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Takes a solid that consists of several bodies apart.
 */
#ifndef hexsweep_SolidBodies_h
#define hexsweep_SolidBodies_h

#include "Core/Solids/SolidInput.h"

#include <vector>

namespace hexsweep
{
struct SolidBody
{
  Index volumeId = 0;
  SolidInput input; ///< its triangles and points alone; ids are those of the solid
};

/**
 * The bodies of a solid.
 *
 * @param solid     what SolidInput::cellIds and SolidInput::pointIds name stays named.
 * @param volumeIds body of each triangle; empty: pieces that no edge joins are bodies of their own,
 *                  with ids from 1 on in the order of their first triangles, but a closed piece
 *                  inside another one is a void of the same body.
 * @return by rising id; one at least.
 * @throw InvalidInput as checkSolidInput(), and when `volumeIds` has another length than the
 *        triangles.
 */
std::vector<SolidBody> solidBodies(
  const SolidInput& solid, const std::vector<Index>& volumeIds, const SolidOptions& options = {});
}

#endif
