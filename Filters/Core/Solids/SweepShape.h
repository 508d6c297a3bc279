// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The parts of a sweep as shapes, and whether a map between the caps is what the sweep does.
 */
#ifndef hexsweep_SweepShape_h
#define hexsweep_SweepShape_h

#include "Core/Geometry/AffineMap.h"
#include "Core/Solids/SolidSurface.h"
#include "Core/Solids/SweepTopology.h"
#include "Core/Surfaces/SurfaceMoments.h"

namespace hexsweep
{
struct SideShape
{
  TriangleMesh surface;
  Points source; ///< nodes of the loop on the source cap, n x 3
  Points target; ///< nodes of the loop on the target cap, the same way round the sweep
};

struct SweepShape
{
  TriangleMesh source;
  TriangleMesh target;
  SurfaceMoments sourceMoments;
  SurfaceMoments targetMoments;
  std::vector<SideShape> sides; ///< in the order of SweepTopology::sides: the outer one first
  double size = 0.0;            ///< diagonal of the solid's box
};

SweepShape sweepShape(const SolidSurface& solid, const SweepTopology& topology);

/**
 * Whether a map takes the source cap to the target cap and straight lines between the two form the
 * sides, up to twice what facets of curves explain and a millionth of the size.
 *
 * Loops are compared as curves and surfaces as surfaces, each both ways: their points may differ.
 *
 * @param map invertible.
 */
bool isRuledImage(const SweepShape& shape, const AffineMap& map);

/// The nearest place of a closed polygon to each point. @param polygon n x 3. @param points m x 3.
Points nearestOnPolygon(const Points& polygon, const Points& points);
}

#endif
