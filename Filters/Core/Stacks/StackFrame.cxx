// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/StackFrame.h"

#include <Eigen/Geometry>

#include <cmath>

namespace hexsweep
{
namespace
{
constexpr double OnAxis = 1e-9;
}

StackFrame::StackFrame(const Eigen::RowVector3d& direction)
{
  Eigen::RowVector3d w = direction.normalized();
  Index longest = 0;
  w.cwiseAbs().maxCoeff(&longest);
  Eigen::RowVector3d axis = Eigen::RowVector3d::Zero();
  axis[longest] = w[longest] > 0.0 ? 1.0 : -1.0;
  if ((w - axis).norm() < OnAxis)
  {
    w = axis;
  }
  Eigen::RowVector3d u = Eigen::RowVector3d::Zero();
  u[(longest + 1) % 3] = 1.0;
  // An axis across an axis stays as it is, bit for bit.
  u = (u - u.dot(w) * w).normalized();
  this->Axes.row(0) = u;
  this->Axes.row(1) = w.cross(u);
  this->Axes.row(2) = w;
}
}
