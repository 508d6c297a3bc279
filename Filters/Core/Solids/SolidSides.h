// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The linking sides of a solid, each cut out as a tube.
 */
#ifndef hexsweep_SolidSides_h
#define hexsweep_SolidSides_h

#include "Core/Linking/SideStrip.h"
#include "Core/Solids/SolidSurface.h"
#include "Core/Solids/SweepTopology.h"

namespace hexsweep
{
/**
 * @param patches by side of the topology: parts that are meshed with structured quads already. May
 *                be empty.
 * @param isFree  by side of the topology: whether its columns need not keep to CAD edges, so that
 *                it comes without face ids. May be empty.
 * @return one tube a side of the topology, in its order.
 */
std::vector<SideTube> solidSides(const SolidSurface& solid, const SweepTopology& topology,
  const std::vector<std::vector<QuadMesh>>& patches = {}, const std::vector<bool>& isFree = {});
}

#endif
