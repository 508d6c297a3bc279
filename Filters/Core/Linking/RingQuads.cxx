// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/RingQuads.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace hexsweep
{
void CornerSines::add(const CornerSines& others)
{
  this->least = std::min(this->least, others.least);
  this->sum += others.sum;
  this->count += others.count;
}

CornerSines cornerSines(const PointsRef& below, const PointsRef& above)
{
  const Index n = below.rows();
  CornerSines sines;
  for (Index j = 0; j < n; ++j)
  {
    const Index next = (j + 1) % n;
    const Eigen::RowVector3d corners[4] = { below.row(j), below.row(next), above.row(next),
      above.row(j) };
    const Eigen::RowVector3d normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]);
    for (int c = 0; c < 4; ++c)
    {
      const Eigen::RowVector3d ahead = corners[(c + 1) % 4] - corners[c];
      const Eigen::RowVector3d back = corners[(c + 3) % 4] - corners[c];
      const double size = ahead.norm() * back.norm() * normal.norm();
      const double sine = size > 0.0 ? ahead.cross(back).dot(normal) / size : -1.0;
      sines.add({ sine, sine, 1 });
    }
  }
  return sines;
}
}
