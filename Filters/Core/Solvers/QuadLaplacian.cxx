// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/QuadLaplacian.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hexsweep
{
namespace
{
using ElementMatrix = Eigen::Matrix4d;

struct Element
{
  ElementMatrix stiffness = ElementMatrix::Zero();
  ElementMatrix mass = ElementMatrix::Zero();
};

Element integrate(const Eigen::Matrix<double, 4, 3>& corners)
{
  Element element;
  const double gauss = 1.0 / std::sqrt(3.0);
  for (const double v : { -gauss, gauss })
  {
    for (const double u : { -gauss, gauss })
    {
      // Shape functions on [-1, 1]^2 and their derivatives; the weights are 1.
      const Eigen::Vector4d shape = 0.25 *
        Eigen::Vector4d((1 - u) * (1 - v), (1 + u) * (1 - v), (1 + u) * (1 + v), (1 - u) * (1 + v));
      Eigen::Matrix<double, 4, 2> slope;
      slope << -(1 - v), -(1 - u), (1 - v), -(1 + u), (1 + v), (1 + u), -(1 + v), (1 - u);
      slope *= 0.25;

      const Eigen::Matrix<double, 3, 2> jacobian = corners.transpose() * slope;
      const Eigen::Matrix2d metric = jacobian.transpose() * jacobian;
      // Quarter of the squared trace: the largest determinant that this trace allows.
      const double bound = 0.25 * metric.trace() * metric.trace();
      const double determinant = std::max(metric.determinant(), 1e-20 * bound);
      if (!(determinant > 0.0))
      {
        continue;
      }
      const double area = std::sqrt(determinant);
      Eigen::Matrix2d adjugate;
      adjugate << metric(1, 1), -metric(0, 1), -metric(1, 0), metric(0, 0);
      element.stiffness += slope * (adjugate / area) * slope.transpose();
      element.mass += area * shape * shape.transpose();
    }
  }
  return element;
}
}

QuadLaplacian quadLaplacian(const PointsRef& points, const QuadsRef& quads)
{
  std::vector<Eigen::Triplet<double>> stiffness;
  std::vector<Eigen::Triplet<double>> mass;
  stiffness.reserve(16 * static_cast<std::size_t>(quads.rows()));
  mass.reserve(stiffness.capacity());
  for (Index q = 0; q < quads.rows(); ++q)
  {
    Eigen::Matrix<double, 4, 3> corners;
    for (int c = 0; c < 4; ++c)
    {
      // About the first corner: no digits are lost far from the origin.
      corners.row(c) = points.row(quads(q, c)) - points.row(quads(q, 0));
    }
    const Element element = integrate(corners);
    for (int a = 0; a < 4; ++a)
    {
      for (int b = 0; b < 4; ++b)
      {
        const int row = static_cast<int>(quads(q, a));
        const int column = static_cast<int>(quads(q, b));
        stiffness.emplace_back(row, column, element.stiffness(a, b));
        mass.emplace_back(row, column, element.mass(a, b));
      }
    }
  }
  QuadLaplacian laplacian;
  laplacian.stiffness.resize(points.rows(), points.rows());
  laplacian.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
  laplacian.mass.resize(points.rows(), points.rows());
  laplacian.mass.setFromTriplets(mass.begin(), mass.end());
  return laplacian;
}
}
