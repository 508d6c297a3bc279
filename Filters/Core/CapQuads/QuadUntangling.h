// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Moves the inner nodes of a quad mesh over a surface until no quad is inverted.
 */
#ifndef hexsweep_QuadUntangling_h
#define hexsweep_QuadUntangling_h

#include "Core/CapQuads/CapCorners.h"

namespace hexsweep
{
/**
 * Variational foldover-free optimisation (see FoldoverFreeEnergy.h) with four corner triangles a
 * quad, in the tangent plane of the surface at each node; nodes return to the surface after each
 * round. Corners at boundary nodes count a second time, projected along the column, or the hex
 * corner there is inverted before the interior begins. The boundary stays.
 *
 * Rounds of Newton descent with falling regularisation, with rectangles as wanted shapes; where
 * these fail, squares, then the source quads. Stops at the first mesh whose movable corners are all
 * upright: one between two fixed edges is out of reach and does not count. A wanted shape has
 * failed after 6 rounds in a row that neither cured a corner or raised the minimum by 0.01, nor
 * lowered the energy by 5 %, after 100 rounds in any case, and after 400 000 Newton steps over the
 * number of quads (but 30), as many again once half of the inverted corners are cured.
 * The result is never worse than the start (CornerQuality::betterThan()).
 *
 * @param points n x 3: the start, on the surface.
 * @param source n x 3: where the nodes came from; shapes only are read.
 * @throw Aborted.
 */
ImprovedQuads untangleTogether(const CapCorners& cap, const Points& points, const PointsRef& source,
  const Progress& progress = {});

/**
 * The same where it is needed: the quads with inverted corners and two rings of neighbours, in
 * pieces that touch no other, each for itself and towards rectangles. All else stays. Then corners
 * with a scaled Jacobian below 0.1 are opened in the same way, by three descents, so that nothing
 * is left on the verge. Of fewer than 1000 quads, where a piece is not cured, or the pieces are
 * more than half of the quads, all quads are untangled together, from the start.
 *
 * Ten times as fast as all together where 7 % of 10,000 quads are inverted.
 */
ImprovedQuads untangleQuads(const CapCorners& cap, const Points& points, const PointsRef& source,
  const Progress& progress = {});
}

#endif
