// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceLaplacian.h"

#include "Errors.h"

#include <Eigen/Geometry>

#include <cmath>
#include <string>

namespace hexsweep
{
namespace
{
using Triplets = std::vector<Eigen::Triplet<double, int>>;

/// Adds the directed weight w_ij to row i.
void addWeight(Triplets& entries, Index i, Index j, double w)
{
  entries.emplace_back(static_cast<int>(i), static_cast<int>(j), -w);
  entries.emplace_back(static_cast<int>(i), static_cast<int>(i), w);
}

SparseMatrix assemble(Index n, const Triplets& entries)
{
  SparseMatrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

[[noreturn]] void failFlat(Index triangle)
{
  throw InvalidInput("triangle " + std::to_string(triangle) +
    " has no area, so that no angle is defined. Remove degenerate triangles (in ParaView: Clean) "
    "or triangulate again.");
}
}

Points cotangents(const PointsRef& points, const TrianglesRef& triangles)
{
  Points result(triangles.rows(), 3);
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Eigen::RowVector3d apex = points.row(triangles(t, c));
      const Eigen::RowVector3d u = points.row(triangles(t, (c + 1) % 3)) - apex;
      const Eigen::RowVector3d v = points.row(triangles(t, (c + 2) % 3)) - apex;
      result(t, c) = u.dot(v) / u.cross(v).norm();
    }
  }
  return result;
}

SparseMatrix cotangentLaplacian(const PointsRef& points, const TrianglesRef& triangles)
{
  const Points cot = cotangents(points, triangles);
  Triplets entries;
  entries.reserve(static_cast<std::size_t>(triangles.rows()) * 12);
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    if (!cot.row(t).allFinite())
    {
      failFlat(t);
    }
    for (Index c = 0; c < 3; ++c)
    {
      const Index i = triangles(t, (c + 1) % 3);
      const Index j = triangles(t, (c + 2) % 3);
      addWeight(entries, i, j, cot(t, c));
      addWeight(entries, j, i, cot(t, c));
    }
  }
  return assemble(points.rows(), entries);
}

SparseMatrix meanValueLaplacian(const PointsRef& points, const TrianglesRef& triangles)
{
  Triplets entries;
  entries.reserve(static_cast<std::size_t>(triangles.rows()) * 12);
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index i = triangles(t, c);
      const Index j = triangles(t, (c + 1) % 3);
      const Index k = triangles(t, (c + 2) % 3);
      const Eigen::RowVector3d u = points.row(j) - points.row(i);
      const Eigen::RowVector3d v = points.row(k) - points.row(i);
      const double lu = u.norm();
      const double lv = v.norm();
      // tan(a/2) = sin a / (1 + cos a)
      const double tangent = u.cross(v).norm() / (lu * lv + u.dot(v));
      if (!std::isfinite(tangent) || !(tangent > 0.0))
      {
        failFlat(t);
      }
      addWeight(entries, i, j, tangent / lu);
      addWeight(entries, i, k, tangent / lv);
    }
  }
  return assemble(points.rows(), entries);
}

SparseMatrix surfaceLaplacian(
  const PointsRef& points, const TrianglesRef& triangles, Weights weights)
{
  return weights == Weights::Cotangent ? cotangentLaplacian(points, triangles)
                                       : meanValueLaplacian(points, triangles);
}
}
