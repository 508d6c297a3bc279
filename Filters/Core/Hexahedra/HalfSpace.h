// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The directions that have as many given vectors as possible on their side.
 */
#ifndef hexsweep_HalfSpace_h
#define hexsweep_HalfSpace_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/**
 * The most vectors that lie in one open half space.
 *
 * Searched exactly: the widest margin that a half space leaves to some vectors is that of the
 * smallest cap of the sphere round them, which one, two or three of them determine; all of these
 * are tried, k^4 / 6 products for k vectors.
 *
 * @param vectors k x 3, any lengths. One without length is in no half space, and neither is one
 *        that has less than 1e-14 of its length on the inner side (rounding).
 * @param preferred where several choices are as large, the one whose inner normal has the greatest
 *        product with this.
 * @return k flags: whether the vector is one of them. All of them if the vectors have a common open
 *         half space.
 */
std::vector<bool> largestHalfSpace(
  const PointsRef& vectors, const Eigen::Ref<const Eigen::RowVector3d>& preferred);
}

#endif
