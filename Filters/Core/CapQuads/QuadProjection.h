// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Carries a quad mesh from the source cap to the target cap (paper section 3.2, steps 3, 4).
 */
#ifndef hexsweep_QuadProjection_h
#define hexsweep_QuadProjection_h

#include "Core/Common/ParallelFor.h"
#include "Core/DiskMaps/CapDisk.h"

namespace hexsweep
{
/// Points of the target quads, and what happened on the way.
struct ProjectedQuads
{
  Points points; ///< n x 3, in the order of the source points
  /// Greatest distance of an interior quad node from the source surface.
  double maximumSourceDistance = 0.0;
  /// Interior nodes whose disk point lies in no positively oriented triangle of the target; the
  /// nearest triangle was taken.
  Index outside = 0;
};

/// A boundary node of the quads and where it belongs on the target cap.
struct FixedNode
{
  Index point;
  Eigen::RowVector3d position;
};

/**
 * Projects through two disk maps into one domain: equations (4) to (7).
 *
 * Each interior node is located on the source surface (closest point; barycentric coordinates,
 * equations (4) and (5)), placed in the source disk with them, located in the target disk, and
 * taken to the target surface (equations (6) and (7)).
 *
 * @param quadPoints n x 3.
 * @param used       n entries: points that a quad uses; the others keep their place.
 * @param boundary   all boundary nodes of the quads; they come out exactly where it says.
 * @param source, target both in the same domain with the same boundary (see commonDiskMap()).
 * @param parallelFor lends threads; the bits do not depend on them.
 */
ProjectedQuads projectThroughDisks(const PointsRef& quadPoints, const std::vector<bool>& used,
  const std::vector<FixedNode>& boundary, const CapDisk& source, const CapDisk& target,
  const Progress& progress = {}, const ParallelFor& parallelFor = {});

/**
 * The traditional projection: the affine map that fits the loops best (after X. Roca, J. Sarrate,
 * A. Huerta \cite RocaSarrateHuerta2004), then down to the target surface: to the nearest place,
 * or, where that is on its boundary, along the normal of the triangle there.
 *
 * @param outerLoop nodes of the outer loop, in order; they fix the normal direction of flat caps.
 */
ProjectedQuads projectAffinely(const PointsRef& quadPoints, const std::vector<bool>& used,
  const std::vector<FixedNode>& boundary, const Loop& outerLoop, const TriangleMesh& target,
  const Progress& progress = {});
}

#endif
