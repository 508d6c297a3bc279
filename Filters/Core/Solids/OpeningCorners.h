// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Corners of the source cap that open on the way to the target.
 */
#ifndef hexsweep_OpeningCorners_h
#define hexsweep_OpeningCorners_h

#include "Core/CapQuads/CornerFans.h"
#include "Core/Common/Mesh.h"
#include "Core/Linking/SideStrip.h"

namespace hexsweep
{
/**
 * Where a node of the source quads' loops has so few quads that hexahedra would be flat on some
 * layer: its column reaches a place where the side is straighter than at the source (the corner of
 * a polygon on the way to an ellipse).
 *
 * The angle inside the cap is measured on all layers, across the column. m quads share it best
 * where the least sine of an m-th of these angles is greatest; a node is left alone where that of
 * the quads which it has is 1/2 at least (no angle beyond 150 degrees).
 *
 * @param loops of the quads, see checkSurface().
 * @param sides one a loop, see meshLinkingSides().
 * @return all corners that are to have more than one quad, where there are any with too few; none
 * where the sides cannot be meshed, which the sweep itself will tell.
 * @throw Aborted.
 */
std::vector<CornerFan> openingCorners(const QuadMesh& quads, const std::vector<Loop>& loops,
  const std::vector<SideTube>& sides, Index layers, const Progress& progress = {});
}

#endif
