// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangles without area that fill the cracks of a tessellation.
 */
#ifndef hexsweep_DegenerateTriangles_h
#define hexsweep_DegenerateTriangles_h

#include "Core/Solids/SolidSurface.h"

namespace hexsweep
{
/**
 * Flips away triangles without area: one whose corners lie on a line hangs a point into the middle
 * of an edge. The triangle on the other side of its longest edge is cut in two at that point
 * instead, and both halves belong to its face and cell. So the surface keeps its shape, and what
 * was closed stays closed.
 *
 * Those stay whose longest edge has not two triangles, or that would give an edge which there is
 * already, or another triangle without area. Costs O(n log n) where there are any.
 *
 * @return how many were flipped away.
 */
Index flipDegenerateTriangles(SolidSurface& solid);
}

#endif
