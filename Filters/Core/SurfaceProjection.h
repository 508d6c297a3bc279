// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Nearest points of a triangulated surface, with normals.
 */
#ifndef hexsweep_SurfaceProjection_h
#define hexsweep_SurfaceProjection_h

#include "TriangleSearch.h"

namespace hexsweep
{
/// Rows belong to the points that were asked for.
struct SurfacePlaces
{
  Points points;  ///< nearest points of the surface
  Points normals; ///< unit normals there, interpolated from angle-weighted ones at the vertices
};

class SurfaceProjection
{
public:
  explicit SurfaceProjection(const TriangleMesh& surface);
  SurfacePlaces project(const PointsRef& points) const;

private:
  TriangleMesh Surface;
  Points VertexNormals; // unit
  TriangleSearch Search;
};
}

#endif
