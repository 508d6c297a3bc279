// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Joins the patches of linking quads that repeat the points of their common seams.
 */
#ifndef hexsweep_SeamWelding_h
#define hexsweep_SeamWelding_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/**
 * The linking quads with the points of seams joined: patches that do not share points along their
 * seams come to share the smallest id there. Only points on edges with one quad are joined.
 *
 * @param linkingPoints  m x 3.
 * @param linkingQuads   q x 4 ids in [0, m).
 * @param matchTolerance as for traceLinkingRings().
 * @throw InvalidInput when there are no quads, or a quad names a point that does not exist or is
 *        not finite.
 */
Quads weldLinkingSeams(
  const PointsRef& linkingPoints, const QuadsRef& linkingQuads, double matchTolerance = 1e-6);
}

#endif
