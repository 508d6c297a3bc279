// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Area, centre, normal and second moments of a triangulated surface.
 */
#ifndef hexsweep_SurfaceMoments_h
#define hexsweep_SurfaceMoments_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// Integrals over a surface; they depend on its shape alone, not on how it is cut into triangles.
struct SurfaceMoments
{
  double area = 0.0;
  Eigen::RowVector3d center = Eigen::RowVector3d::Zero();     ///< centre of the area
  Eigen::RowVector3d areaVector = Eigen::RowVector3d::Zero(); ///< integral of the unit normal
  /// Mean of (x - center)^T (x - center), 3 x 3.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// @param surface consistently oriented, at least one triangle with an area.
SurfaceMoments surfaceMoments(const TriangleMesh& surface);

/**
 * How far the facets of a surface may be from the smooth surface through its points: the greatest
 * sagitta, height of a triangle over an edge times the turn across it over eight. Edges that turn
 * by more than 30 degrees are taken for edges of the shape.
 *
 * @param surface an oriented 2-manifold. @return in the points' unit, 0 for flat facets.
 */
double facetSagitta(const TriangleMesh& surface);
}

#endif
