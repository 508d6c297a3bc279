// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/FeatureFaces.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Describe.h"
#include "Core/Common/DisjointSets.h"
#include "Core/Common/Errors.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
/// A twelve-sided prism has edges of 30 degrees up to rounding; all of them must be judged alike.
constexpr double AngleSlack = 1e-4;

Eigen::RowVector3d normalOf(const PointsRef& points, const TrianglesRef& triangles, Index t)
{
  const Eigen::RowVector3d a = points.row(triangles(t, 0));
  const Eigen::RowVector3d u = points.row(triangles(t, 1)) - a;
  const Eigen::RowVector3d v = points.row(triangles(t, 2)) - a;
  return u.normalized().cross(v.normalized()).normalized();
}

double angleBetween(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}
}

double angleBetweenTriangles(
  const PointsRef& points, const TrianglesRef& triangles, Index first, Index second)
{
  return angleBetween(normalOf(points, triangles, first), normalOf(points, triangles, second));
}

FeatureFaces facesByFeatureAngle(
  const PointsRef& points, const TrianglesRef& triangles, double featureAngle)
{
  if (!(featureAngle > 0.0 && featureAngle < Pi))
  {
    throw InvalidInput("the feature angle is " + describe(featureAngle * 180.0 / Pi) +
      " degrees; it must lie between 0 and 180 degrees.");
  }
  const Triangles neighbors = triangleNeighbors(triangles);
  DisjointSets regions(triangles.rows());
  FeatureFaces result;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      const Index other = neighbors(t, c);
      if (other > t)
      {
        const double angle = angleBetweenTriangles(points, triangles, t, other);
        result.sharpest = std::max(result.sharpest, angle);
        if (angle <= featureAngle * (1.0 + AngleSlack))
        {
          regions.join(t, other);
        }
      }
    }
  }

  result.faceOfTriangle.resize(static_cast<std::size_t>(triangles.rows()));
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    const Index first = regions.find(t);
    result.faceOfTriangle[static_cast<std::size_t>(t)] =
      first == t ? result.count++ : result.faceOfTriangle[static_cast<std::size_t>(first)];
  }
  return result;
}
}
