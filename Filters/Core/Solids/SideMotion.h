// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The rigid motion along which the sides of a sweep lie.
 */
#ifndef hexsweep_SideMotion_h
#define hexsweep_SideMotion_h

#include "Core/Solids/CapCandidates.h"

#include <Eigen/Geometry>

namespace hexsweep
{
/// Velocities of a body that is shifted, turned, or both: shifts along the axis are a screw.
struct RigidMotion
{
  Eigen::RowVector3d origin = Eigen::RowVector3d::Zero();
  Eigen::RowVector3d linear = Eigen::RowVector3d::Zero();  ///< velocity of the origin
  Eigen::RowVector3d angular = Eigen::RowVector3d::Zero(); ///< radians

  Eigen::RowVector3d at(const Eigen::RowVector3d& point) const
  {
    return this->linear + this->angular.cross(point - this->origin);
  }
};

struct SideMotion
{
  RigidMotion motion;
  /// Mean square of the velocities across the sides over that across the caps: 0 for straight
  /// prisms, revolutions and helical sides. Infinite where the motion does not lead from cap to
  /// cap.
  double slip = 0.0;
};

/**
 * The motion that least crosses some faces against how much it crosses the caps: that of a
 * kinematic surface \cite PottmannRandrup1998, by the eigenvectors of the lines of the normals, as
 * local slippage is found \cite GelfandGuibas2004.
 *
 * Costs O(faces).
 *
 * @param isSide one a face.
 */
SideMotion findSideMotion(const FaceGraph& graph, const std::vector<char>& isSide,
  const CapCandidate& source, const CapCandidate& target);
}

#endif
