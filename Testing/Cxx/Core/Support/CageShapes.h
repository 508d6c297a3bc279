// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Closed triangle meshes, points inside them, and integrals over their triangles by
 * quadrature.
 */
#ifndef CageShapes_h
#define CageShapes_h

#include "Core/Common/Mesh.h"

#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <random>

namespace test
{
using hexsweep::Index;
using hexsweep::Points;

hexsweep::TriangleMesh tetrahedron();

/// [0, 2] x [0, 2] x [0, 1] without its quarter x > 1, y > 1: with a re-entrant edge. The point
/// (x, y, z) is inside if 0 < z < 1 and min(x, y) < 1, and so on.
hexsweep::TriangleMesh angleBlock();

/// The mesh turned, scaled and moved.
hexsweep::TriangleMesh moved(hexsweep::TriangleMesh mesh, const Eigen::Affine3d& motion);

/// A similarity of the given scale that is aligned with nothing.
Eigen::Affine3d similarity(double scale);

/// Points well inside the angle block, near its faces, and in the planes of its re-entrant walls.
Points insideAngleBlock();

/**
 * Integral of f(y, barycentric coordinates of y) over a triangle: seven Gauss points (Radon, degree
 * 5) on parts that are small beside their distance from `x`, where f is singular.
 */
using TriangleFunction =
  std::function<double(const Eigen::RowVector3d& y, const Eigen::RowVector3d& barycentric)>;

double integrate(const Eigen::Matrix3d& corners, const Eigen::RowVector3d& x,
  const TriangleFunction& f, const Eigen::Matrix3d& part = Eigen::Matrix3d::Identity());
}

#endif
