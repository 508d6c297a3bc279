// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/SurfaceLaplacian.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Surfaces/IntrinsicDelaunay.h"
#include "Core/Surfaces/TriangleAngles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace hexsweep
{
namespace
{
/// Directed weights that one triangle adds: w(i, j) from corner i to corner j.
using CornerWeights = Eigen::Matrix3d;

/**
 * Sums the triangles' weights: entry (i, j) is -w_ij, the diagonal their sum over j.
 *
 * Filled column by column without a detour over triplets, which would cost as much as factorising
 * the matrix. Two triangles share an edge, so that symmetric weights give a symmetric matrix bit
 * for bit: a + b is b + a.
 *
 * @param weights called once with each row of `triangles`.
 */
template <typename Weight>
SparseMatrix assemble(Index n, const TrianglesRef& triangles, const Weight& weights)
{
  struct Entry
  {
    int row;
    double weight;
  };
  std::vector<Index> next(static_cast<std::size_t>(n) + 1, 0);
  for (Index k = 0; k < triangles.size(); ++k)
  {
    next[static_cast<std::size_t>(triangles.data()[k]) + 1] += 2;
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  const std::vector<Index> columns = next;
  std::vector<Entry> entries(static_cast<std::size_t>(columns.back()));
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n);
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    const CornerWeights w = weights(t);
    for (Index c = 0; c < 3; ++c)
    {
      const Index j = triangles(t, c);
      for (Index r = 0; r < 3; ++r)
      {
        const Index i = triangles(t, r);
        // An intrinsic triangle may have a corner twice; the side between them weighs nothing.
        if (r != c && i != j)
        {
          Index& place = next[static_cast<std::size_t>(j)];
          entries[static_cast<std::size_t>(place++)] = { static_cast<int>(i), w(r, c) };
          diagonal[i] += w(r, c);
        }
      }
    }
  }

  SparseMatrix matrix(n, n);
  matrix.reserve(columns.back() / 2 + 2 * n); // an interior edge comes twice, a boundary edge once
  for (Index j = 0; j < n; ++j)
  {
    const auto begin = entries.begin() + columns[static_cast<std::size_t>(j)];
    const auto end = entries.begin() + next[static_cast<std::size_t>(j)];
    std::sort(begin, end, [](const Entry& a, const Entry& b) { return a.row < b.row; });
    matrix.startVec(j);
    bool diagonalDone = begin == end;
    for (auto it = begin; it != end;)
    {
      if (!diagonalDone && it->row > j)
      {
        matrix.insertBack(j, j) = diagonal[j];
        diagonalDone = true;
      }
      const int row = it->row;
      double weight = 0.0;
      for (; it != end && it->row == row; ++it)
      {
        weight += it->weight;
      }
      matrix.insertBack(row, j) = -weight;
    }
    if (!diagonalDone)
    {
      matrix.insertBack(j, j) = diagonal[j];
    }
  }
  matrix.finalize();
  return matrix;
}

/// Names places, not numbers: the triangulation may have been refined since the user saw it.
[[noreturn]] void failFlat(
  const PointsRef& points, const Eigen::Ref<const Eigen::Matrix<Index, 1, 3>>& triangle)
{
  throw InvalidInput("the triangle with the corners " + describe(points.row(triangle[0])) + ", " +
    describe(points.row(triangle[1])) + " and " + describe(points.row(triangle[2])) +
    " has no area, so that no angle is defined. Remove degenerate triangles (in ParaView: Clean) "
    "or triangulate again.");
}

CornerWeights cornerWeights(const Eigen::RowVector3d& cot)
{
  CornerWeights w;
  w << 0.0, cot[2], cot[1], cot[2], 0.0, cot[0], cot[1], cot[0], 0.0;
  return w;
}
}

SparseMatrix cotangentLaplacian(const PointsRef& points, const TrianglesRef& triangles)
{
  return assemble(points.rows(), triangles, [&](Index t) {
    const Eigen::RowVector3d cot = cornerCotangents(points, triangles.row(t));
    if (!cot.allFinite())
    {
      failFlat(points, triangles.row(t));
    }
    return cornerWeights(cot);
  });
}

SparseMatrix laplacianOfCotangents(
  Index numberOfPoints, const TrianglesRef& triangles, const PointsRef& cot)
{
  return assemble(numberOfPoints, triangles, [&](Index t) { return cornerWeights(cot.row(t)); });
}

SparseMatrix meanValueLaplacian(const PointsRef& points, const TrianglesRef& triangles)
{
  return assemble(points.rows(), triangles, [&](Index t) {
    CornerWeights w = CornerWeights::Zero();
    for (Index c = 0; c < 3; ++c)
    {
      const Index j = (c + 1) % 3;
      const Index k = (c + 2) % 3;
      const Eigen::RowVector3d apex = points.row(triangles(t, c));
      const Eigen::RowVector3d u = points.row(triangles(t, j)) - apex;
      const Eigen::RowVector3d v = points.row(triangles(t, k)) - apex;
      const double lu = u.norm();
      const double lv = v.norm();
      const double tangent = halfAngleTangent(u, v);
      if (!std::isfinite(tangent) || !(tangent > 0.0))
      {
        failFlat(points, triangles.row(t));
      }
      w(c, j) = tangent / lu;
      w(c, k) = tangent / lv;
    }
    return w;
  });
}

SparseMatrix intrinsicLaplacian(const PointsRef& points, const TrianglesRef& triangles)
{
  const IntrinsicTriangulation intrinsic = intrinsicDelaunay(points, triangles);
  return laplacianOfCotangents(points.rows(), intrinsic.triangles, intrinsic.cotangents);
}

SparseMatrix surfaceLaplacian(
  const PointsRef& points, const TrianglesRef& triangles, Weights weights)
{
  switch (weights)
  {
    case Weights::MeanValue:
      return meanValueLaplacian(points, triangles);
    case Weights::Intrinsic:
      return intrinsicLaplacian(points, triangles);
    default:
      return cotangentLaplacian(points, triangles);
  }
}

SparseMatrix symmetricLaplacian(
  const PointsRef& points, const TrianglesRef& triangles, Weights weights)
{
  return surfaceLaplacian(
    points, triangles, weights == Weights::MeanValue ? Weights::Cotangent : weights);
}
}
