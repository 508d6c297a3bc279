// SPDX-License-Identifier: BSD-3-Clause
#ifndef hexsweep_Circle_h
#define hexsweep_Circle_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// A circle of the plane.
struct Circle
{
  Eigen::RowVector2d center = Eigen::RowVector2d::Zero();
  double radius = 0.0; ///< >= 0
};

/// Points at these angles (radians) on a circle, one row an angle.
PlanePoints circlePoints(const Circle& circle, const std::vector<double>& angles);
}

#endif
