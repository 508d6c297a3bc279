// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SolidMessages.h"

namespace hexsweep
{
std::string listIds(const std::vector<Index>& ids)
{
  constexpr std::size_t Longest = 10;
  std::string text;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    if (i == Longest)
    {
      return text + ", ... (" + std::to_string(ids.size()) + " in all)";
    }
    const bool last = i + 1 == ids.size() && i > 0;
    text += (i == 0 ? "" : last ? " and " : ", ") + std::to_string(ids[i]);
  }
  return text;
}

std::string listFaces(const std::vector<Index>& faceIds)
{
  return (faceIds.size() == 1 ? "face " : "faces ") + listIds(faceIds);
}

Eigen::RowVector3d triangleCenter(const SolidSurface& solid, Index triangle)
{
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (int c = 0; c < 3; ++c)
  {
    sum += solid.points.row(solid.triangles(triangle, c));
  }
  return sum / 3.0;
}

std::string describeCell(const SolidSurface& solid, Index triangle)
{
  const auto t = static_cast<std::size_t>(triangle);
  return "cell " + std::to_string(solid.cellIds[t]) +
    (solid.faceIds.empty() ? "" : " of face " + std::to_string(solid.faceIds[t]));
}

std::string countOf(std::size_t count, const std::string& thing)
{
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}
}
