// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Least-squares affine maps between matched node sets of loops and rings.
 */
#ifndef hexsweep_AffineMap_h
#define hexsweep_AffineMap_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// x -> targetCenter + linear (x - sourceCenter). Keeping the centres apart from the linear part
/// loses no digits far from the origin.
struct AffineMap
{
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Eigen::RowVector3d sourceCenter = Eigen::RowVector3d::Zero();
  Eigen::RowVector3d targetCenter = Eigen::RowVector3d::Zero();

  /// @param points n x 3; returns n x 3.
  Points apply(const PointsRef& points) const;
};

/// Whether the linear part can be inverted to some digits.
bool isInvertible(const AffineMap& map);

/// @param map invertible.
AffineMap inverse(const AffineMap& map);

/**
 * Vector area of a closed polygon, 1/2 sum (p_j - c) x (p_j+1 - c), n x 3 nodes in loop order.
 *
 * For a planar loop its length is the area and its direction the normal about which the loop runs
 * counter-clockwise; it is independent of the surface that the loop bounds.
 */
Eigen::RowVector3d areaVector(const PointsRef& loop);

/**
 * Least-squares affine map of matched nodes, completed by the normal.
 *
 * Minimises sum_i |A (x_i - c_x) - (y_i - c_y)|^2 + n w^2 |A a - b|^2 about the centroids, where a
 * is the unit normal of the source loop and b that of the target loop times
 * sqrt(target area / source area). The second term matters where the nodes say nothing (a planar
 * loop: A a = b exactly, so that similarity transforms are reproduced) or little (a nearly planar
 * one, whose out-of-plane noise must neither be blown up nor flatten the cap). In units of the node
 * set's radius, w is ten times the root-mean-square residual of the plain least-squares map, plus
 * what the nodes' root-mean-square height over the plane lacks to 0.05. Hence an affine map of a
 * loop that is clearly not planar is reproduced as well, to rounding, and the result is continuous
 * in the data.
 *
 * P. M. Knupp \cite Knupp1998 and X. Roca, J. Sarrate, A. Huerta \cite RocaSarrateHuerta2004 treat
 * the same rank deficiency by shifted centres.
 *
 * @param source     n x 3, n >= 3.
 * @param target     n x 3, row i belongs to source row i.
 * @param sourceArea vector area of the outer loop of the source (see areaVector()).
 * @param targetArea vector area of the same loop of the target. Where one of the two is nearly
 *        zero (a loop like the seam of a tennis ball), the normals come from the least-squares
 *        plane of the source and its image instead.
 * @throw InvalidInput when the sets differ in size, are too small, or the source nodes coincide.
 */
AffineMap fitAffineMap(const PointsRef& source, const PointsRef& target,
  const Eigen::RowVector3d& sourceArea, const Eigen::RowVector3d& targetArea);
}

#endif
