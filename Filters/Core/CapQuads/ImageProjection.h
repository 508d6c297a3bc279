// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Carries a quad mesh to a target cap that is an affine image of the source cap.
 */
#ifndef hexsweep_ImageProjection_h
#define hexsweep_ImageProjection_h

#include "Core/CapQuads/SweepProjection.h"
#include "Core/Geometry/AffineMap.h"

namespace hexsweep
{
/**
 * The image of the quads, its inner nodes put onto the target surface where they are off it by more
 * than rounding.
 *
 * @param source   quads of the source cap.
 * @param map      of the source cap to the target cap, see findAffineSweep().
 * @param boundary all boundary nodes of the quads; they come out exactly where it says.
 * @param borders  inner nodes that belong on borders of the target's faces; they come out there
 * too.
 * @param target   consistently oriented.
 * @param singlePrecision round the points to float before they are judged.
 * @return with quads, quality and fixedCorners filled.
 */
SweepProjection projectToImage(const QuadMesh& source, const AffineMap& map,
  const std::vector<FixedNode>& boundary, const std::vector<FixedNode>& borders,
  const TriangleMesh& target, bool singlePrecision, const ParallelFor& parallelFor = {});
}

#endif
