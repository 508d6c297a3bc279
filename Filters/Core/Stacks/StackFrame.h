// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Coordinates along and across the direction of a sweep.
 */
#ifndef hexsweep_StackFrame_h
#define hexsweep_StackFrame_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/**
 * Right-handed axes: u and v span the plane across the direction, w runs along it.
 *
 * Along a coordinate axis the frame only exchanges coordinates: they keep every bit.
 */
class StackFrame
{
public:
  /// @param direction of any length but 0; within 1e-9 of a coordinate axis it is that one.
  explicit StackFrame(const Eigen::RowVector3d& direction);

  /// Unit vector.
  Eigen::RowVector3d direction() const { return this->Axes.row(2); }
  /// @param points n x 3. @return n x 3, (u, v, w) a row.
  Points toFrame(const PointsRef& points) const { return points * this->Axes.transpose(); }
  /// The inverse.
  Points fromFrame(const PointsRef& points) const { return points * this->Axes; }

private:
  Eigen::Matrix3d Axes; // a row each
};
}

#endif
