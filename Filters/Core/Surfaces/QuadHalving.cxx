// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/QuadHalving.h"

namespace hexsweep
{
Index shorterDiagonal(const Eigen::Matrix<double, 4, 3>& corners)
{
  return (corners.row(0) - corners.row(2)).squaredNorm() <=
      (corners.row(1) - corners.row(3)).squaredNorm()
    ? 0
    : 1;
}

Triangles halveQuads(const PointsRef& points, const QuadsRef& quads)
{
  Triangles triangles(quads.rows() * 2, 3);
  for (Index q = 0; q < quads.rows(); ++q)
  {
    Eigen::Matrix<double, 4, 3> corners;
    for (Index c = 0; c < 4; ++c)
    {
      corners.row(c) = points.row(quads(q, c));
    }
    const Index s = shorterDiagonal(corners);
    triangles.row(2 * q) << quads(q, s), quads(q, s + 1), quads(q, s + 2);
    triangles.row(2 * q + 1) << quads(q, s), quads(q, s + 2), quads(q, (s + 3) % 4);
  }
  return triangles;
}
}
