// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Boxes of cubes that are meshed with quads.
 */
#ifndef QuadBox_h
#define QuadBox_h

#include "Support/SolidShapes.h"

#include <functional>

namespace test
{
/// Makes each pair of triangles of cubes() a quad where `isQuad` of its face says so. Quad q is
/// cell 100 + q.
inline SolidInput withQuads(
  SolidInput solid, const std::function<bool(Index faceId)>& isQuad = [](Index) { return true; })
{
  std::vector<Index> corners;
  for (Index t = 0; t < solid.triangles.rows(); t += 2)
  {
    const bool quad = isQuad(solid.faceIds[static_cast<std::size_t>(t)]);
    const Index row = static_cast<Index>(solid.quadCellIds.size());
    solid.quadOfTriangle.insert(solid.quadOfTriangle.end(), 2, quad ? row : -1);
    if (quad)
    {
      corners.insert(corners.end(),
        { solid.triangles(t, 0), solid.triangles(t, 1), solid.triangles(t, 2),
          solid.triangles(t + 1, 2) });
      solid.quadCellIds.push_back(100 + row);
    }
  }
  solid.quads = facesOf<Quads>(corners);
  return solid;
}

/// Area of a plane quad, as a vector along its normal.
inline Eigen::RowVector3d areaOf(const hexsweep::QuadMesh& mesh, Index q)
{
  const Eigen::RowVector3d a =
    mesh.points.row(mesh.quads(q, 2)) - mesh.points.row(mesh.quads(q, 0));
  const Eigen::RowVector3d b =
    mesh.points.row(mesh.quads(q, 3)) - mesh.points.row(mesh.quads(q, 1));
  return 0.5 * a.cross(b);
}
}

#endif
