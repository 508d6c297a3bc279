// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Parts the surface of a solid where the solid touches itself.
 */
#ifndef hexsweep_TouchingSheets_h
#define hexsweep_TouchingSheets_h

#include "Core/Solids/SolidSurface.h"

namespace hexsweep
{
/**
 * Where four or more triangles meet at an edge, as along the line of two tangent cylinders, those
 * become neighbours that have material between them; then fans of triangles that meet in a point
 * only, ends of such lines too, get a point each.
 *
 * Edges whose triangles do not alternate in direction round them stay as they are.
 *
 * @param solid oriented; points are added at the end, with their SolidSurface::pointRows.
 * @return number of points added.
 */
Index partTouchingSheets(SolidSurface& solid);
}

#endif
