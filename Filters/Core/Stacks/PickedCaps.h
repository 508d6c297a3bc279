// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The directions of a solid that have faces which somebody picked at their ends.
 */
#ifndef hexsweep_PickedCaps_h
#define hexsweep_PickedCaps_h

#include "Core/Stacks/CapLikeFaces.h"

#include <string>
#include <vector>

namespace hexsweep
{
/// Faces that are to be caps; those that a solid does not have do not count.
struct PickedCaps
{
  std::vector<Index> sources; ///< at the lower end
  std::vector<Index> targets; ///< at the upper end
};

/// Whether along a direction the picked faces are caps, each at its end.
bool areAtTheirEnds(const PickedCaps& picked, const CapLikeFaces& faces);

/// Those of stackDirections() along which the picked faces are at their ends, reversed where that
/// brings them there.
std::vector<CapLikeFaces> pickedDirections(
  const SolidSurface& solid, const PickedCaps& picked, double draft = 0.0);

/// "face 3 as source cap and faces 5 and 6 as target caps"; empty where none is picked.
std::string describePicked(const PickedCaps& picked);
}

#endif
