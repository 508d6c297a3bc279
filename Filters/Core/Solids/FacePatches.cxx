// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/FacePatches.h"

#include "Core/Common/DisjointSets.h"

#include <algorithm>
#include <unordered_map>

namespace hexsweep
{
FacePatches findFacePatches(const SolidSurface& solid, const HalfEdgeTriangles& halfEdges)
{
  FacePatches table;
  std::unordered_map<Index, std::size_t> numbers;
  const Index m = solid.triangles.rows();
  DisjointSets patches(m);
  for (Index t = 0; t < m; ++t)
  {
    const Index id = solid.faceIds[static_cast<std::size_t>(t)];
    const auto [known, isNew] = numbers.emplace(id, table.ids.size());
    if (isNew)
    {
      table.ids.push_back(id);
      table.triangles.emplace_back();
    }
    const std::size_t face = known->second;
    table.faceOfTriangle.push_back(face);
    table.triangles[face].push_back(t);
    for (Index half = 3 * t; half < 3 * t + 3; ++half)
    {
      const Index other = halfEdges.twin(half) / 3;
      if (other < t && solid.faceIds[static_cast<std::size_t>(other)] == id)
      {
        patches.join(t, other);
      }
    }
  }
  for (Index t = 0; t < m; ++t)
  {
    const Index first = patches.find(t);
    table.patchOfTriangle.push_back(first == t
        ? table.numberOfPatches++
        : table.patchOfTriangle[static_cast<std::size_t>(first)]);
  }
  return table;
}

std::vector<std::vector<Index>> patchNeighbors(
  const FacePatches& patches, const HalfEdgeTriangles& halfEdges)
{
  std::vector<std::vector<Index>> neighbors(static_cast<std::size_t>(patches.numberOfPatches));
  for (std::size_t t = 0; t < patches.patchOfTriangle.size(); ++t)
  {
    const Index own = patches.patchOfTriangle[t];
    for (Index half = 3 * static_cast<Index>(t); half < 3 * static_cast<Index>(t) + 3; ++half)
    {
      const Index other =
        patches.patchOfTriangle[static_cast<std::size_t>(halfEdges.twin(half) / 3)];
      if (other != own)
      {
        neighbors[static_cast<std::size_t>(own)].push_back(other);
      }
    }
  }
  for (std::vector<Index>& list : neighbors)
  {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbors;
}
}
