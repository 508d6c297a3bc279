// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Faces of a tessellated solid that carries no face ids: patches between sharp edges.
 */
#ifndef hexsweep_FeatureFaces_h
#define hexsweep_FeatureFaces_h

#include "Core/Common/Mesh.h"

#include <vector>

namespace hexsweep
{
struct FeatureFaces
{
  /// The face of each triangle, numbered from 0 in the order of their first ones.
  std::vector<Index> faceOfTriangle;
  Index count = 0;
  double sharpest = 0.0; ///< greatest angle at an edge, radians
};

/**
 * Joins triangles over every edge that is less sharp than an angle.
 *
 * @param points       n x 3.
 * @param triangles    m x 3, consistently oriented, at most two at an edge, each with an area.
 * @param featureAngle radians, in (0, pi): largest angle between the normals of two triangles that
 *                     are joined over their common edge.
 * @throw InvalidInput when the angle is out of range.
 */
FeatureFaces facesByFeatureAngle(
  const PointsRef& points, const TrianglesRef& triangles, double featureAngle);

/// Angle (radians, in [0, pi]) between the normals of two triangles of consistent orientation.
double angleBetweenTriangles(
  const PointsRef& points, const TrianglesRef& triangles, Index first, Index second);
}

#endif
