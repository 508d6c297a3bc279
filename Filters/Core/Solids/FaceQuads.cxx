// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/FaceQuads.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace hexsweep
{
namespace
{
/// The quad that two triangles with a common edge form, in their direction.
std::array<Index, 4> joinHalves(
  const Eigen::Matrix<Index, 1, 3>& first, const Eigen::Matrix<Index, 1, 3>& second)
{
  const auto isIn = [](const Eigen::Matrix<Index, 1, 3>& corners, Index p) {
    return (corners.array() == p).any();
  };
  Index apex = second[0];
  for (int c = 1; c < 3; ++c)
  {
    apex = isIn(first, second[c]) ? apex : second[c];
  }
  std::array<Index, 4> quad{};
  std::size_t next = 0;
  for (int c = 0; c < 3; ++c)
  {
    quad[next++] = first[c];
    if (isIn(second, first[c]) && isIn(second, first[(c + 1) % 3]))
    {
      quad[next++] = apex;
    }
  }
  return quad;
}

/// Quads on the solid's points as a mesh of their own. @param corners points of the solid, 4 a
/// quad.
FaceQuads onUsedPoints(const SolidInput& input, const SolidSurface& solid,
  const std::vector<Index>& corners, std::vector<Index> cellIds)
{
  FaceQuads result;
  result.cellIds = std::move(cellIds);
  std::vector<Index> used = corners;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  result.mesh.points.resize(static_cast<Index>(used.size()), 3);
  for (std::size_t p = 0; p < used.size(); ++p)
  {
    result.mesh.points.row(static_cast<Index>(p)) = solid.points.row(used[p]);
    const Index row = solid.pointRows[static_cast<std::size_t>(used[p])];
    result.pointIds.push_back(
      input.pointIds.empty() ? row : input.pointIds[static_cast<std::size_t>(row)]);
  }
  result.mesh.quads.resize(static_cast<Index>(corners.size()) / 4, 4);
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    result.mesh.quads.data()[c] =
      std::lower_bound(used.begin(), used.end(), corners[c]) - used.begin();
  }
  return result;
}
}

std::optional<FaceQuads> quadsOfFaces(
  const SolidInput& input, const SolidSurface& solid, const std::vector<Index>& faceIds)
{
  if (input.quadOfTriangle.empty())
  {
    return std::nullopt;
  }
  const std::vector<Index> triangles = trianglesOfFaces(solid, faceIds);
  const auto quadOf = [&](Index t) {
    const Index row = solid.triangleRows[static_cast<std::size_t>(t)];
    return input.quadOfTriangle[static_cast<std::size_t>(row)];
  };
  std::map<Index, std::vector<Index>> halves; // of each quad
  for (const Index t : triangles)
  {
    halves[quadOf(t)].push_back(t);
  }
  std::vector<Index> cellIds;
  std::vector<Index> corners; // points of the solid
  for (const auto& [quad, rows] : halves)
  {
    if (quad < 0 || rows.size() != 2)
    {
      return std::nullopt;
    }
    const std::array<Index, 4> joined =
      joinHalves(solid.triangles.row(rows[0]), solid.triangles.row(rows[1]));
    corners.insert(corners.end(), joined.begin(), joined.end());
    cellIds.push_back(input.quadCellIds[static_cast<std::size_t>(quad)]);
  }
  return onUsedPoints(input, solid, corners, std::move(cellIds));
}

std::vector<std::vector<QuadMesh>> sidePatches(
  const SolidInput& input, const SolidSurface& solid, const SweepTopology& topology)
{
  std::vector<std::vector<QuadMesh>> patches(topology.sides.size());
  if (input.quads.rows() == 0)
  {
    return patches;
  }
  for (std::size_t s = 0; s < topology.sides.size(); ++s)
  {
    for (const Index id : topology.sides[s].faceIds)
    {
      if (std::optional<FaceQuads> quads = quadsOfFaces(input, solid, { id }))
      {
        patches[s].push_back(std::move(quads->mesh));
      }
    }
  }
  return patches;
}
}
