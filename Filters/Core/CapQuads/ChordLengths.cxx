// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/ChordLengths.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace hexsweep
{
double chordLength(double share, double curvature)
{
  return curvature > 0.0 ? 8.0 * share / curvature : std::numeric_limits<double>::infinity();
}

ChordLengths::ChordLengths(
  const TriangleMesh& surface, const std::vector<Index>& faceIds, double share)
  : Search(surface.points, surface.triangles)
{
  const Index count = surface.triangles.rows();
  const auto faceOf = [&](Index t) {
    return faceIds.empty() ? Index{ 0 } : faceIds[static_cast<std::size_t>(t)];
  };
  // A point between faces has a normal in each.
  std::map<std::pair<Index, Index>, Eigen::RowVector3d> normals;
  for (Index t = 0; t < count; ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Eigen::RowVector3d a = surface.points.row(surface.triangles(t, c));
      const Eigen::RowVector3d b = surface.points.row(surface.triangles(t, (c + 1) % 3)) - a;
      const Eigen::RowVector3d d = surface.points.row(surface.triangles(t, (c + 2) % 3)) - a;
      const Eigen::RowVector3d area = b.cross(d);
      const double angle = std::atan2(area.norm(), b.dot(d));
      normals.try_emplace({ faceOf(t), surface.triangles(t, c) }, Eigen::RowVector3d::Zero())
        .first->second += angle * area.normalized();
    }
  }
  for (auto& [key, normal] : normals)
  {
    normal.normalize();
  }
  for (Index t = 0; t < count; ++t)
  {
    double curvature = 0.0;
    for (Index c = 0; c < 3; ++c)
    {
      const Index a = surface.triangles(t, c);
      const Index b = surface.triangles(t, (c + 1) % 3);
      const Eigen::RowVector3d& from = normals.at({ faceOf(t), a });
      const Eigen::RowVector3d& to = normals.at({ faceOf(t), b });
      const double turn = std::atan2(from.cross(to).norm(), from.dot(to));
      const double length = (surface.points.row(a) - surface.points.row(b)).norm();
      curvature = length > 0.0 ? std::max(curvature, turn / length) : curvature;
    }
    this->Lengths.push_back(chordLength(share, curvature));
  }
}

double ChordLengths::at(const Eigen::RowVector3d& place) const
{
  const Index triangle = this->Search.closest(place).triangle;
  return triangle < 0 ? std::numeric_limits<double>::infinity()
                      : this->Lengths[static_cast<std::size_t>(triangle)];
}
}
