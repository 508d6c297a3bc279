// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/FaceMeasures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>

namespace hexsweep
{
std::vector<FaceMeasure> measureFaces(const SolidSurface& solid)
{
  std::map<Index, FaceMeasure> faces;
  std::map<Index, Eigen::RowVector3d> areaVectors;
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = solid.points.row(solid.triangles(t, 0));
    const Eigen::RowVector3d b = solid.points.row(solid.triangles(t, 1));
    const Eigen::RowVector3d c = solid.points.row(solid.triangles(t, 2));
    const Eigen::RowVector3d areaVector = 0.5 * (b - a).cross(c - a);
    const Index id = solid.faceIds[static_cast<std::size_t>(t)];
    FaceMeasure& face = faces[id];
    face.id = id;
    ++face.triangles;
    face.area += areaVector.norm();
    face.center += areaVector.norm() * (a + b + c) / 3.0;
    areaVectors.try_emplace(id, Eigen::RowVector3d::Zero()).first->second += areaVector;
  }
  std::vector<FaceMeasure> result;
  for (auto& [id, face] : faces)
  {
    face.center /= face.area;
    face.flatness = std::min(areaVectors[id].norm() / face.area, 1.0);
    result.push_back(face);
  }
  return result;
}
}
