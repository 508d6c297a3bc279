// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Nearest points of a triangulated surface, with normals.
 */
#ifndef hexsweep_SurfaceSearch_h
#define hexsweep_SurfaceSearch_h

#include "Core/Geometry/TriangleSearch.h"

namespace hexsweep
{
/// Rows belong to the points that were asked for.
struct SurfacePlaces
{
  Points points;  ///< nearest points of the surface
  Points normals; ///< unit normals there, interpolated from angle-weighted ones at the vertices
};

class SurfaceSearch
{
public:
  explicit SurfaceSearch(const TriangleMesh& surface);
  SurfacePlaces project(const PointsRef& points) const;

private:
  TriangleMesh Surface;
  Points VertexNormals; // unit
  TriangleSearch Search;
};
}

#endif
