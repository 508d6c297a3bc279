// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Angles of triangles as the weights of harmonic maps take them.
 */
#ifndef hexsweep_TriangleAngles_h
#define hexsweep_TriangleAngles_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// Ids of the corners of one triangle.
using TriangleRef = Eigen::Ref<const Eigen::Matrix<Index, 1, 3>>;

/// Cotangents of the three angles of a triangle, in the order of its corners. Computed from edge
/// lengths and area, so any units do. A triangle without area gives infinities.
Eigen::RowVector3d cornerCotangents(const PointsRef& points, const TriangleRef& triangle);

/// cornerCotangents() of each triangle; column c belongs to corner c.
Points cotangents(const PointsRef& points, const TrianglesRef& triangles);

/// tan(a/2) = sin a / (1 + cos a) of the angle a between u and v.
double halfAngleTangent(const Eigen::RowVector3d& u, const Eigen::RowVector3d& v);

/// Whether a triangle has angles that give finite weights of both kinds, as one with area has.
bool hasWeights(const PointsRef& points, const TriangleRef& triangle);
}

#endif
