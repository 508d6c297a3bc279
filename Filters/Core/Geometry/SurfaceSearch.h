// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Nearest points of a triangulated surface, with normals.
 */
#ifndef hexsweep_SurfaceSearch_h
#define hexsweep_SurfaceSearch_h

#include "Core/Common/ParallelFor.h"
#include "Core/Geometry/TriangleSearch.h"

#include <optional>
#include <vector>

namespace hexsweep
{
/// Rows belong to the points that were asked for.
struct SurfacePlaces
{
  Points points;  ///< nearest points of the surface
  Points normals; ///< unit normals there, interpolated from angle-weighted ones at the vertices
  std::vector<Index> triangles; ///< that they lie on
};

/// The same of one point.
struct SurfacePlace
{
  Eigen::RowVector3d point;
  Eigen::RowVector3d normal;
  Index triangle;
};

class SurfaceSearch
{
public:
  explicit SurfaceSearch(const TriangleMesh& surface);
  /// The same bits with any number of threads and any starts.
  /// @param starts a triangle near each point where one is known, or -1; empty: none is.
  SurfacePlaces project(const PointsRef& points, const ParallelFor& parallelFor = {},
    const std::vector<Index>& starts = {}) const;

  /// The normals alone: where the surface is a plane, to rounding, no point is searched for.
  Points normals(const PointsRef& points, const ParallelFor& parallelFor = {}) const;

  /// @param start a triangle near the point if one is known, or -1.
  SurfacePlace project(const Eigen::RowVector3d& point, Index start) const;

private:
  /// The same triangle for each start.
  TrianglePoint nearest(const Eigen::RowVector3d& point, Index start) const;

  TriangleMesh Surface;
  Points VertexNormals; // unit
  TriangleSearch Search;
  std::optional<Eigen::RowVector3d> PlaneNormal; // of a surface that is one
};
}

#endif
